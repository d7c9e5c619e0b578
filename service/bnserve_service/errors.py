"""The one place where errors become HTTP statuses."""

from __future__ import annotations

import math
from http import HTTPStatus

import msgspec

import bnserve_protocol as protocol
from bnserve_protocol import BnserveError, InternalError
from bnserve_protocol.wire import Problem

STATUS_OF: dict[type[BnserveError], int] = {
    protocol.UndecodableBody: 400,
    protocol.UnsupportedMediaType: 415,
    protocol.NotAcceptable: 406,
    protocol.TooLarge: 413,
    protocol.InvalidRequest: 422,
    protocol.Unauthorized: 401,
    protocol.AccessDenied: 403,
    protocol.NotFound: 404,
    protocol.QuotaExceeded: 429,
    protocol.DeadlineExceeded: 504,
    protocol.Unavailable: 503,
    BnserveError: 500,
}
"""The status of each error class; a class that is not listed takes that of its nearest ancestor."""

_LONGEST_DETAIL = 2000
_MOST_ERRORS = 64
"""A batch may hold thousands of bad rows and a body a megabyte of field name; the answer stays small."""


class SettingsInvalid(protocol.InvalidRequest):
    """A configuration file or command line that cannot be used; says which entry and why."""

    code = "settings-invalid"
    title = "Invalid settings"


class UnsupportedFeature(protocol.InvalidRequest):
    """An UM-Bridge client asks for what a model does not support."""

    code = "feature-unsupported"
    title = "Feature not supported"


class BodyTooSlow(protocol.UndecodableBody):
    """The body did not arrive in time; what may still come of it is not waited for."""


class ClientDisconnected(Exception):
    """The client went away before its answer was ready: there is nobody to tell."""


def status_of(error: BnserveError) -> int:
    """The HTTP status for an error."""
    return next(STATUS_OF[cls] for cls in type(error).__mro__ if cls in STATUS_OF)


def internal_error(request_id: str) -> InternalError:
    """What the caller is told about a defect of ours: nothing but how to find it in the log."""
    return InternalError(f"Something went wrong inside the service; report request id {request_id} to its operators.")


def from_http_status(status: int) -> BnserveError:
    """The error for a status that the web framework chose by itself (unknown path, wrong method)."""
    if status == 404:
        return protocol.PathUnknown("There is no such path on this service; /docs lists them.")
    if status == 405:
        return protocol.PathUnknown("This path does not offer that method; see the Allow header and /docs.")
    if status == 413:
        return protocol.TooLarge("The body is too large; /v1/limits states the limits.")
    return protocol.InvalidRequest(f"The request was refused: {HTTPStatus(status).phrase}.")


def problem_body(error: BnserveError, request_id: str, status: int | None = None) -> tuple[int, bytes]:
    """Status and ``application/problem+json`` body of an error."""
    chosen = status if status is not None else status_of(error)
    problem = Problem.from_error(error, chosen, request_id)
    if len(problem.detail) > _LONGEST_DETAIL or len(problem.errors) > _MOST_ERRORS:
        detail = problem.detail[:_LONGEST_DETAIL]
        problem = msgspec.structs.replace(problem, detail=detail, error=detail, errors=problem.errors[:_MOST_ERRORS])
    return chosen, msgspec.json.encode(problem)


UMBRIDGE = "/v1/umbridge/"
"""What routes begin with whose errors have the form of UM-Bridge."""
_UMBRIDGE_TYPES: tuple[tuple[type[BnserveError], str], ...] = (
    (UnsupportedFeature, "UnsupportedFeature"),
    (protocol.ModelUnknown, "ModelNotFound"),
    (protocol.AnalysisUnknown, "ModelNotFound"),
    (protocol.InvalidRequest, "InvalidInput"),
)
"""Those of UM-Bridge, which come with 400; of the others, the class says what is wrong, and the status is ours."""


def umbridge_body(error: BnserveError, status: int | None = None) -> tuple[int, bytes]:
    """Status and JSON body of an error for UM-Bridge clients: ``{"error": {"type", "message"}}`` and nothing else."""
    kind = next((name for cls, name in _UMBRIDGE_TYPES if isinstance(error, cls)), None)
    chosen = status or (400 if kind is not None else status_of(error))
    told = {"type": kind or type(error).__name__, "message": error.detail[:_LONGEST_DETAIL]}
    return chosen, msgspec.json.encode({"error": told})


def problem_headers(error: BnserveError) -> list[tuple[bytes, bytes]]:
    """The headers that go with an error: ``Retry-After``, ``WWW-Authenticate``, the end of the connection."""
    headers: list[tuple[bytes, bytes]] = []
    if isinstance(error, protocol.Unavailable) and error.retryable:
        headers.append((b"retry-after", b"%d" % max(1, math.ceil(error.retry_after or 1.0))))
    if isinstance(error, protocol.Unauthorized):
        headers.append((b"www-authenticate", b'Bearer realm="bnserve"'))
    if isinstance(error, BodyTooSlow):
        headers.append((b"connection", b"close"))
    return headers
