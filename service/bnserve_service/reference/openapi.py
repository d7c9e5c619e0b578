"""The OpenAPI document. Bodies are decoded by schema, not by FastAPI: what it cannot know is written here."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import msgspec
from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from bnserve_protocol import __version__
from bnserve_protocol.wire import JSON, MSGPACK, PROBLEM_JSON
from bnserve_service.evaluation.questions import Operation
from bnserve_service.reference.schemas import reference, schemas

_DESCRIPTION = """Gravitational waveforms of binary neutron stars from trained surrogates.

Requests and answers are MessagePack (`application/msgpack`) or, for small ones, JSON. In MessagePack an array is the
map `{nd: true, type: "<c16", kind: "", shape: [N, M], data: <bytes>}` of msgpack-numpy with keys of text, of bytes for
`Accept: application/msgpack;keys=bytes`; vectors and rows may also be plain lists. In JSON a complex array is
`{"re": [...], "im": [...]}`.
Errors are RFC 9457 `application/problem+json`; `code` says what happened, `retryable` whether to try again.
Answers carry `Content-Digest` (RFC 9530) and, where there was a request body, its SHA-256 as `X-Request-Digest`.
"""

_STATUSES = {
    "400": "The body cannot be decoded",
    "404": "Unknown model, version, grid, analysis, network or path",
    "406": "No acceptable media type",
    "413": "Over a limit, which the body states",
    "415": "Media type not offered",
    "422": "Understood but invalid: row, parameter, value, reason",
    "429": "This caller is over its quota; see Retry-After",
    "503": "Full, draining or loading; see Retry-After",
    "504": "The deadline passed before the evaluation",
}


def _json_content(name: str) -> dict[str, Any]:
    schema = reference(name)
    return {JSON: {"schema": schema}, MSGPACK: {"schema": schema}}


def _problem(description: str) -> dict[str, Any]:
    return {
        "description": description,
        "headers": {"Retry-After": {"description": "Seconds (429 and 503)", "schema": {"type": "integer"}}},
        "content": {PROBLEM_JSON: {"schema": reference("Problem")}},
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


_UMBRIDGE_PROBLEM = {
    "description": "Any error: InvalidInput, ModelNotFound and UnsupportedFeature of UM-Bridge with 400, and others",
    "content": {JSON: {"schema": reference("UmBridgeProblem")}},
}


def json_answer(struct: type[msgspec.Struct] | None = None) -> dict[int | str, dict[str, Any]]:
    """The ``responses`` of a route for UM-Bridge; without a structure, of one that is not offered."""
    answers: dict[int | str, dict[str, Any]] = {"default": _UMBRIDGE_PROBLEM}
    if struct is None:
        return answers | {400: _UMBRIDGE_PROBLEM}
    content = {JSON: {"schema": reference(struct.__name__)}}
    return answers | {200: {"description": _first_line(struct), "content": content}}


def json_body(name: str) -> dict[str, Any]:
    """The ``openapi_extra`` of a route for UM-Bridge that takes an ``UmBridge<name>Request``."""
    return {"requestBody": {"required": True, "content": {JSON: {"schema": reference(f"UmBridge{name}Request")}}}}


FOUND_OR_NOT: dict[int | str, dict[str, Any]] = {
    200: {"description": "It is here"},
    404: {"description": "It is not"},
    "default": {"description": "Any error; without a body, as always with HEAD"},
}
"""The ``responses`` of a question without a body."""

GONE: dict[int | str, dict[str, Any]] = {204: {"description": "It is forgotten"}, **_PROBLEMS}
"""The ``responses`` of a ``DELETE``."""


def binary_body(media_type: str, description: str) -> dict[str, Any]:
    """The ``openapi_extra`` of a route that takes bytes."""
    content = {media_type: {"schema": {"type": "string", "format": "binary"}}}
    return {"requestBody": {"required": True, "description": description, "content": content}}


def named_body(schema: str, description: str) -> dict[str, Any]:
    """The ``openapi_extra`` of a route that takes a structure, as MessagePack or JSON."""
    body = {"required": True, "description": description, "content": _json_content(schema)}
    return {"requestBody": body}


def _first_line(struct: type[msgspec.Struct]) -> str:
    return (struct.__doc__ or struct.__name__).strip().partition("\n")[0]


_HEADERS_IN = {
    "X-Request-ID": ("string", "Echoed; names the request in logs"),
    "X-Request-Deadline-Ms": ("number", "Milliseconds after which the answer is of no use"),
    "Want-Content-Digest": ("string", "RFC 9530; evaluations carry crc32c where it is preferred, all else sha-256"),
}
_HEADERS_OUT = {
    name: {"schema": {"type": "string"}} for name in ("Content-Digest", "X-Request-Digest", "Server-Timing")
}


def _post(path: str, operation: Operation) -> dict[str, Any]:
    """The path item of a ``POST`` that evaluates; of a given version where its path has one."""
    identifier, summary = operation.identifier, operation.summary
    if "{version}" in path:
        identifier, summary = f"{identifier}_version", f"{summary} with a given version"
    request, answer = ({"schema": reference(operation.bodies + kind)} for kind in ("Request", "Answer"))
    problems = {status: _problem(text) for status, text in _STATUSES.items()} | {"default": _problem("Any other error")}
    example = request | {"example": operation.example}
    bodies, answers = {MSGPACK: request, JSON: example}, {MSGPACK: answer, JSON: answer}
    if operation.json_alone:
        del bodies[MSGPACK], answers[MSGPACK]
        problems = {"default": _UMBRIDGE_PROBLEM}
    described = {
        "tags": [operation.tag],
        "summary": summary,
        "operationId": identifier,
        "parameters": _parameters(path),
        "requestBody": {"required": True, "content": bodies},
        "responses": {"200": {"description": "The answer", "headers": _HEADERS_OUT, "content": answers}, **problems},
    }
    return {"post": described}


def _parameters(path: str) -> list[dict[str, Any]]:
    return [
        {"name": name, "in": "path", "required": True, "schema": {"type": "string"}}
        for name in re.findall(r"\{(\w+)\}", path)
    ] + [
        {"name": name, "in": "header", "required": False, "schema": {"type": kind}, "description": text}
        for name, (kind, text) in _HEADERS_IN.items()
    ]


def openapi_document(app: FastAPI, operations: Mapping[str, Operation], with_tokens: bool) -> dict[str, Any]:
    """The document: FastAPI's account of its routes, and ours of those that evaluate, by their paths."""
    document = get_openapi(title="bnserve", version=__version__, description=_DESCRIPTION, routes=app.routes)
    document["paths"] |= {path: _post(path, operation) for path, operation in operations.items()}
    components = document.setdefault("components", {})
    components["schemas"] = schemas()
    if with_tokens:
        components["securitySchemes"] = {"token": {"type": "http", "scheme": "bearer"}}
        document["security"] = [{"token": []}]
    return document
