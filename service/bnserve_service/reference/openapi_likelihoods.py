"""What the OpenAPI document says of analyses and likelihoods."""

from __future__ import annotations

from typing import Any

from bnserve_protocol.wire import MSGPACK
from bnserve_service.reference.openapi import post_operation

ANALYSIS_BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "description": "The analysis as `bnserve_protocol.encode_analysis` writes it; its digest is the path.",
        "content": {MSGPACK: {"schema": {"type": "string", "format": "binary"}}},
    }
}

_EXAMPLE = {
    "parameters": {
        "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0.01, "chi_2": 0, "inclination": 2.5,
        "total_mass": 2.76, "right_ascension": 3.45, "declination": -0.41, "polarization_angle": [0.1, 0.2],
        "distance_mpc": 40, "coalescence_time": 0,
    }
}  # fmt: skip


def with_likelihoods(document: dict[str, Any], paths: tuple[str, ...]) -> dict[str, Any]:
    """The document with the paths that evaluate likelihoods."""
    what = ("log_likelihood", "Evaluate the likelihood of an uploaded analysis in batches")
    for path in paths:
        document["paths"][path] = post_operation(path, "likelihoods", what, "Likelihood", _EXAMPLE)
    return document
