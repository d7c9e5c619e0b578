"""What the OpenAPI document says of analyses and likelihoods."""

from __future__ import annotations

import copy
from typing import Any

from bnserve_protocol import LIKELIHOOD_NAMES
from bnserve_protocol.wire import MSGPACK
from bnserve_service.reference.openapi import post_operation, reference

ANALYSIS_BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "description": "The analysis as `bnserve_protocol.encode_analysis` writes it; its digest is the path.",
        "content": {MSGPACK: {"schema": {"type": "string", "format": "binary"}}},
    }
}

_OPTIONAL = ("distance_mpc", "coalescence_time", "reference_phase")
_ARRAY = reference("Array")
_VECTOR = {"oneOf": [{"type": "number"}, {"type": "array", "items": {"type": "number"}}, _ARRAY]}
_ROWS = {"type": "array", "items": {"type": "array", "items": {"type": "number"}}}
_CALIBRATION = {
    "type": "object",
    "maxProperties": 64,
    "additionalProperties": {"oneOf": [_ROWS, _ARRAY]},
    "description": "By detector, [N, nodes]: errors at the calibration nodes of the analysis.",
}

_REQUEST = {
    "type": "object",
    "additionalProperties": False,
    "required": ["parameters"],
    "properties": {
        "parameters": {
            "description": "A map of named numbers or vectors, or with 'names' one [N, P] array. What is marginalised "
            "may be left out.",
            "oneOf": [
                {
                    "type": "object",
                    "additionalProperties": False,
                    "properties": dict.fromkeys(LIKELIHOOD_NAMES, _VECTOR),
                    "required": [name for name in LIKELIHOOD_NAMES if name not in _OPTIONAL],
                },
                _ROWS,
                _ARRAY,
            ],
        },
        "names": {"type": "array", "items": {"enum": list(LIKELIHOOD_NAMES)}, "uniqueItems": True},
        "calibration_amplitude": _CALIBRATION,
        "calibration_phase": _CALIBRATION,
        "analysis": {"type": "string", "description": "Repeats the digest of the path, as 'sha256:...'."},
    },
}

_ANSWER = {
    "type": "object",
    "required": ["model", "analysis", "log_likelihood", "status"],
    "properties": {
        "model": {
            "type": "object",
            "properties": {key: {"type": "string"} for key in ("name", "version", "digest")},
            "required": ["name", "version", "digest"],
        },
        "analysis": {"type": "string"},
        "log_likelihood": {
            "oneOf": [{"type": "array", "items": {"type": ["number", "null"]}}, _ARRAY],
            "description": "[N]: natural logarithm of the ratio to the likelihood of no signal. -inf, in JSON null, "
            "wherever 'status' is not 0.",
        },
        "status": {
            "oneOf": [{"type": "array", "items": {"enum": [0, 1, 2, 3, 4]}}, _ARRAY],
            "description": "[N]: 0 fine, 1 not finite, 2 out of domain, 3 out of band, 4 out of the analysis' prior.",
        },
    },
}

_EXAMPLE = {
    "parameters": {
        "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0.01, "chi_2": 0, "inclination": 2.5,
        "total_mass": 2.76, "right_ascension": 3.45, "declination": -0.41, "polarization_angle": [0.1, 0.2],
        "distance_mpc": 40, "coalescence_time": 0,
    }
}  # fmt: skip


def with_likelihoods(document: dict[str, Any], paths: tuple[str, ...]) -> dict[str, Any]:
    """The document with the paths that evaluate likelihoods, and the schemas of their bodies."""
    for path in paths:
        versioned = "{version}" in path
        described = {
            "tags": ["likelihoods"],
            "summary": "Evaluate the likelihood of an uploaded analysis in batches"
            + (" with a given version" if versioned else ""),
            "operationId": "log_likelihood" + ("_version" if versioned else ""),
        }
        schemas = ("LikelihoodRequest", "LikelihoodAnswer")
        document["paths"][path] = post_operation(path, described, schemas, _EXAMPLE)
    document["components"]["schemas"] |= copy.deepcopy({"LikelihoodRequest": _REQUEST, "LikelihoodAnswer": _ANSWER})
    return document
