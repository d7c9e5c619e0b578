"""The OpenAPI document. Bodies are decoded by schema, not by FastAPI: what it cannot know is written here."""

from __future__ import annotations

import copy
import re
from collections.abc import Mapping
from typing import Any

import msgspec
from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from bnserve_protocol import PARAMETER_DEFAULTS, PARAMETER_NAMES, RunManifest, __version__
from bnserve_protocol.wire import JSON, MSGPACK, PROBLEM_JSON, Problem
from bnserve_service.models.documents import AnalysisDocument, GridDocument, ModelDocument, ModelList, ReloadDocument
from bnserve_service.settings import ServiceLimits

_REF = "#/components/schemas/{name}"
_STRUCTS = [
    Problem, ModelDocument, ModelList, GridDocument, AnalysisDocument, ServiceLimits, RunManifest, ReloadDocument,
]  # fmt: skip

_DESCRIPTION = """Gravitational waveforms of binary neutron stars from trained surrogates.

Requests and answers are MessagePack (`application/msgpack`) or, for small ones, JSON. In MessagePack an array is the
map that msgpack-numpy writes: `{nd: true, type: "<c16", kind: "", shape: [N, M], data: <bytes>}`; vectors and
rows may also be plain lists. In JSON a complex array is `{"re": [...], "im": [...]}`.
Errors are RFC 9457 `application/problem+json`; `code` says what happened, `retryable` whether to try again.
Answers carry `Content-Digest` (RFC 9530) and, where there was a request body, its SHA-256 as `X-Request-Digest`.
"""

_STATUSES = {
    "400": "The body cannot be decoded",
    "404": "Unknown model, version, grid, analysis or path",
    "406": "No acceptable media type",
    "413": "Over a limit, which the body states",
    "415": "Media type not offered",
    "422": "Understood but invalid: row, parameter, value, reason",
    "429": "This caller is over its share; see Retry-After",
    "503": "Full, draining or loading; see Retry-After",
    "504": "The deadline passed before the evaluation",
}


def reference(name: str) -> dict[str, Any]:
    """A reference to the schema of that name."""
    return {"$ref": _REF.format(name=name)}


def _json_content(name: str) -> dict[str, Any]:
    schema = {"$ref": _REF.format(name=name)}
    return {JSON: {"schema": schema}, MSGPACK: {"schema": schema}}


def _problem(description: str) -> dict[str, Any]:
    return {
        "description": description,
        "headers": {"Retry-After": {"description": "Seconds (429 and 503)", "schema": {"type": "integer"}}},
        "content": {PROBLEM_JSON: {"schema": {"$ref": _REF.format(name="Problem")}}},
    }


_PROBLEMS: dict[int | str, dict[str, Any]] = {"default": _problem("Any error")}


def answers_with(struct: type[msgspec.Struct], status: int = 200) -> dict[int | str, dict[str, Any]]:
    """The ``responses`` of a route that answers with a structure, or with a problem."""
    return {status: {"description": _first_line(struct), "content": _json_content(struct.__name__)}} | _PROBLEMS


def answers_with_flag(name: str) -> dict[int | str, dict[str, Any]]:
    """The ``responses`` of a probe."""
    schema = {"type": "object", "properties": {name: {"type": "boolean"}}, "required": [name]}
    return {200: {"description": "Yes", "content": {JSON: {"schema": schema}}}, 503: _problem("No, and why")} | (
        _PROBLEMS
    )


def answers_with_text(media_type: str) -> dict[int | str, dict[str, Any]]:
    """The ``responses`` of a route that answers with text."""
    return {200: {"description": "The text", "content": {media_type: {"schema": {"type": "string"}}}}} | _PROBLEMS


FOUND_OR_NOT: dict[int | str, dict[str, Any]] = {
    200: {"description": "It is here"},
    404: {"description": "It is not"},
    "default": {"description": "Any error; without a body, as always with HEAD"},
}
"""The ``responses`` of a question without a body."""

GONE: dict[int | str, dict[str, Any]] = {204: {"description": "It is forgotten"}, **_PROBLEMS}
"""The ``responses`` of a ``DELETE``."""

GRID_BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "description": "The frequencies in Hz, raw little-endian float64, increasing; their SHA-256 is the path.",
        "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}},
    }
}


def _first_line(struct: type[msgspec.Struct]) -> str:
    return (struct.__doc__ or struct.__name__).strip().partition("\n")[0]


_NUMBERS = {"type": "array", "items": {"type": "number"}}
_VECTOR = {"oneOf": [{"type": "number"}, _NUMBERS, {"$ref": _REF.format(name="Array")}]}
_MATRIX = {"type": "array", "items": _NUMBERS}
_PART = {"type": "array", "items": {"type": "array", "items": {"type": ["number", "null"]}}}
"""In JSON, NaN is null."""
_COMPLEX = {
    "oneOf": [
        {"type": "object", "properties": {"re": _PART, "im": _PART}, "required": ["re", "im"]},
        {"$ref": _REF.format(name="Array")},
    ]
}
_REAL = {"oneOf": [_PART, {"$ref": _REF.format(name="Array")}]}

_ARRAY = {
    "type": "object",
    "description": "MessagePack only: a numpy array as msgpack-numpy writes it.",
    "properties": {
        "nd": {"const": True},
        "type": {"enum": ["<f8", "<f4", "<c16", "<c8", "|u1"]},
        "kind": {"const": ""},
        "shape": {"type": "array", "items": {"type": "integer", "minimum": 0}, "maxItems": 2},
        "data": {"type": "string", "format": "binary"},
    },
    "required": ["nd", "type", "kind", "shape", "data"],
}

_REQUEST = {
    "type": "object",
    "additionalProperties": False,
    "required": ["parameters", "grid"],
    "properties": {
        "parameters": {
            "description": "A map of named numbers or vectors, or with 'names' one [N, P] array.",
            "oneOf": [
                {
                    "type": "object",
                    "additionalProperties": False,
                    "properties": dict.fromkeys(PARAMETER_NAMES, _VECTOR),
                    "required": [name for name in PARAMETER_NAMES if name not in PARAMETER_DEFAULTS],
                },
                _MATRIX,
                {"$ref": _REF.format(name="Array")},
            ],
        },
        "names": {"type": "array", "items": {"enum": list(PARAMETER_NAMES)}, "uniqueItems": True},
        "grid": {
            "oneOf": [
                {
                    "type": "object",
                    "additionalProperties": False,
                    "properties": {key: {"type": "number", "exclusiveMinimum": 0} for key in
                                   ("f_min", "f_max", "delta_f")},
                    "required": ["f_min", "f_max", "delta_f"],
                },
                {
                    "type": "object",
                    "additionalProperties": False,
                    "properties": {"frequencies": {"oneOf": [_NUMBERS, {"$ref": _REF.format(name="Array")}]}},
                    "required": ["frequencies"],
                },
                {
                    "type": "object",
                    "additionalProperties": False,
                    "properties": {"sha256": {"type": "string"}},
                    "required": ["sha256"],
                },
            ]
        },
        "output": {
            "enum": ["polarizations", "factored", "amplitude_phase", "modes"],
            "default": "polarizations",
            "description": "'modes': h_22 is the mode at the given distance, without the factors of the inclination; "
            "'factored': h_plus = plus * h and h_cross = cross * h.",
        },
        "dtype": {
            "enum": ["complex128", "complex64"],
            "default": "complex128",
            "description": "complex64 has a relative error of 2.5e-8, and |h| is so small (1e-24 1/Hz) that its square "
            "underflows in single precision: convert to double precision, or multiply by 1e22, before squaring. "
            "Amplitude and phase are float64 in any case.",
        },
        "out_of_domain": {
            "enum": ["error", "flag"],
            "default": "error",
            "description": "'flag': rows outside the trained range come back NaN, with a status.",
        },
        "below_band": {
            "enum": ["extend", "error"],
            "default": "extend",
            "description": "'extend': the post-Newtonian continuation at every frequency below the band; 'error': a "
            "frequency below it is an error.",
        },
        "above_band": {
            "enum": ["zero", "error"],
            "default": "zero",
            "description": "'zero': zeros at every frequency above the band, also where all are; 'error': a frequency "
            "above it is an error.",
        },
        "alignment": {"enum": ["post_newtonian", "merger"], "default": "post_newtonian"},
    },
}  # fmt: skip

_ANSWER = {
    "type": "object",
    "required": ["model", "status"],
    "description": "The arrays of the requested output, [N, M] unless stated.",
    "properties": {
        "model": {
            "type": "object",
            "properties": {key: {"type": "string"} for key in ("name", "version", "digest")},
            "required": ["name", "version", "digest"],
        },
        "status": {
            "oneOf": [{"type": "array", "items": {"enum": [0, 1, 2, 3]}}, {"$ref": _REF.format(name="Array")}],
            "description": "[N]: 0 fine, 1 not finite, 2 out of domain, 3 out of band.",
        },
        "h_plus": _COMPLEX,
        "h_cross": _COMPLEX,
        "h": _COMPLEX,
        "plus": _VECTOR | {"description": "[N], with 'h'"},
        "cross": {"description": "[N], complex, with 'h'"},
        "amplitude": _REAL,
        "phase": _REAL,
        "h_22": _COMPLEX,
        "estimated_mismatch": _VECTOR | {"description": "[N], the model's own estimate, if it has one"},
    },
}

_EXAMPLE = {
    "parameters": {
        "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0.01, "chi_2": 0, "distance_mpc": 40,
        "inclination": 2.5, "total_mass": 2.76,
    },
    "grid": {"f_min": 20, "f_max": 2048, "delta_f": 4},
}  # fmt: skip

_HEADERS_IN = {
    "X-Request-ID": ("string", "Echoed; names the request in logs"),
    "X-Request-Deadline-Ms": ("number", "Milliseconds after which the answer is of no use"),
    "Want-Content-Digest": ("string", "RFC 9530; waveforms carry crc32c where it is preferred, all else sha-256"),
}


def post_operation(path: str, described: Mapping[str, Any], schemas: tuple[str, str], example: Any) -> dict[str, Any]:
    """The path item of a ``POST`` that evaluates.

    Parameters
    ----------
    path:
        Its template.
    described:
        ``tags``, ``summary``, ``operationId``.
    schemas:
        Names of the request and of the answer.
    example:
        A request in JSON.
    """
    request, answer = ({"schema": {"$ref": _REF.format(name=name)}} for name in schemas)
    names = re.findall(r"\{(\w+)\}", path)
    return {
        "post": {
            **described,
            "parameters": [
                {"name": name, "in": "path", "required": True, "schema": {"type": "string"}} for name in names
            ]
            + [
                {"name": name, "in": "header", "required": False, "schema": {"type": kind}, "description": text}
                for name, (kind, text) in _HEADERS_IN.items()
            ],
            "requestBody": {"required": True, "content": {MSGPACK: request, JSON: request | {"example": example}}},
            "responses": {
                "200": {
                    "description": "The answer",
                    "headers": {
                        "Content-Digest": {"schema": {"type": "string"}},
                        "X-Request-Digest": {"schema": {"type": "string"}},
                        "Server-Timing": {"schema": {"type": "string"}},
                    },
                    "content": {MSGPACK: answer, JSON: answer},
                },
                **{status: _problem(text) for status, text in _STATUSES.items()},
                "default": _problem("Any other error"),
            },
        }
    }


def _waveform_operation(path: str) -> dict[str, Any]:
    versioned = "{version}" in path
    described = {
        "tags": ["waveforms"],
        "summary": "Evaluate a batch of waveforms" + (" with a given version" if versioned else ""),
        "operationId": "evaluate" + ("_version" if versioned else ""),
    }
    return post_operation(path, described, ("WaveformRequest", "WaveformAnswer"), _EXAMPLE)


def openapi_document(app: FastAPI, waveform_paths: tuple[str, ...], with_tokens: bool) -> dict[str, Any]:
    """The document: FastAPI's account of its routes, and ours of the bodies it does not decode."""
    document = get_openapi(title="bnserve", version=__version__, description=_DESCRIPTION, routes=app.routes)
    document["paths"] |= {path: _waveform_operation(path) for path in waveform_paths}
    _, schemas = msgspec.json.schema_components(_STRUCTS, ref_template=_REF)
    schemas |= copy.deepcopy({"WaveformRequest": _REQUEST, "WaveformAnswer": _ANSWER, "Array": _ARRAY})
    components = document.setdefault("components", {})
    components["schemas"] = schemas
    if with_tokens:
        components["securitySchemes"] = {"token": {"type": "http", "scheme": "bearer"}}
        document["security"] = [{"token": []}]
    return document
