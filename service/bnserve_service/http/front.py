"""The outermost middleware: names every request, measures it, and turns what went wrong into a problem answer."""

from __future__ import annotations

import logging
import os
import re
import time
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field

from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from bnserve_protocol import BnserveError, InvalidRequest
from bnserve_protocol.wire import PROBLEM_JSON
from bnserve_service.admission.control import Lifecycle
from bnserve_service.admission.quotas import RateQuota
from bnserve_service.errors import (
    ClientDisconnected,
    from_http_status,
    internal_error,
    problem_body,
    problem_headers,
)
from bnserve_service.http.answers import Header, body_headers, header_fields, send_answer
from bnserve_service.telemetry.log_words import log_word
from bnserve_service.telemetry.metrics import Metrics

logger = logging.getLogger("bnserve.service")
access_logger = logging.getLogger("bnserve.access")

_REQUEST_ID = re.compile(rb"[\x21-\x7e]{1,128}")
_METHODS = frozenset({"GET", "HEAD", "POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"})
"""Others are one, in metrics and log: callers may invent them, too."""
_KEY = "bnserve.request"
NO_ROUTE = "none"
_FREE = nullcontext()


@dataclass(slots=True)
class RequestContext:
    """What is known about one request beside its body."""

    request_id: str
    headers: dict[bytes, bytes]
    arrived: float
    """``time.monotonic()``."""
    route: str = NO_ROUTE
    """The route's template: what access and metrics go by. A path would let callers invent label values."""
    caller: str = "anonymous"
    owner: str = ""
    """To whom belongs what this request uploads: the digest of the token; without tokens, everybody is one."""
    quota: RateQuota | None = None
    """What the token may still do, if that is limited."""
    request_digest: str | None = None
    """SHA-256 of the request body, in hexadecimal, once it was read."""
    status: int = 0
    extra_headers: list[Header] = field(default_factory=list)

    @property
    def deadline(self) -> float | None:
        """When the caller stops waiting (``time.monotonic()``), from ``X-Request-Deadline-Ms``.

        Raises
        ------
        InvalidRequest
            Not a positive number.
        """
        text = self.headers.get(b"x-request-deadline-ms")
        if text is None:
            return None
        try:
            milliseconds = float(text)
        except ValueError:
            milliseconds = -1.0
        if not 0.0 <= milliseconds < 1e12:
            raise InvalidRequest("X-Request-Deadline-Ms must be a number of milliseconds from now.")
        return self.arrived + milliseconds / 1e3

    def paying(self, rows: int) -> AbstractContextManager[None]:
        """Charge rows to the caller's quota, if there is one; given back when they cannot be evaluated now.

        Raises
        ------
        QuotaExceeded
        """
        return _FREE if self.quota is None else self.quota.paying(rows)


def context_of(scope: Scope) -> RequestContext:
    """The context that :class:`RequestContextMiddleware` attached to a request."""
    context: RequestContext = scope[_KEY]
    return context


class RequestContextMiddleware:
    """Attach a :class:`RequestContext`; add the common headers; answer errors; count.

    Parameters
    ----------
    app:
        The rest of the service.
    find:
        Tells which route a request takes, by its template.
    metrics, lifecycle:
        Where to count, and whether connections are still kept open.
    log_requests:
        Write one line per request to the logger ``bnserve.access``.
    """

    def __init__(
        self, app: ASGIApp, find: Callable[[Scope], str], metrics: Metrics, lifecycle: Lifecycle, log_requests: bool
    ) -> None:
        self._app = app
        self._find = find
        self._metrics = metrics
        self._lifecycle = lifecycle
        self._log_requests = log_requests

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one HTTP request."""
        context = new_context(header_fields(scope["headers"]))
        scope[_KEY] = context

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                context.status = message["status"]
                message["headers"] = [*message["headers"], *self.common_headers(context)]
            await send(message)

        try:
            context.route = self._find(scope)
            await self._app(scope, receive, send_with_headers)
        except ClientDisconnected:
            context.status = 499  # the name nginx gave to "the client closed the request"
        except Exception as error:
            await self._answer_error(error, context, send_with_headers)
        finally:
            self.finish(scope["method"] if scope["method"] in _METHODS else "other", context)

    async def _answer_error(self, error: Exception, context: RequestContext, send: Send) -> None:
        if context.status:  # too late for an answer: break the connection, so that nobody takes half of it for a whole
            raise error
        status, headers, body = self.problem_answer(error, context)
        await send_answer(send, status, headers, [body])

    def problem_answer(self, error: BaseException, context: RequestContext) -> tuple[int, list[Header], bytes]:
        """What the caller is told about an error: status, headers and body."""
        status: int | None = None
        extra: list[Header] = []
        if isinstance(error, HTTPException):
            status = error.status_code
            extra = [(name.lower().encode(), value.encode()) for name, value in (error.headers or {}).items()]
            told = from_http_status(status)
        elif isinstance(error, BnserveError):
            told = error
        elif isinstance(error, RequestValidationError):
            told = InvalidRequest("The path, query or headers of this request are not valid; see /docs.")
        else:
            told = internal_error(context.request_id)
            logger.error("request %s failed", context.request_id, exc_info=error)
        status, body = problem_body(told, context.request_id, status)
        headers = [*body_headers([body], PROBLEM_JSON), *problem_headers(told), *extra]
        self._metrics.refused(told.code)
        return status, headers, body

    def common_headers(self, context: RequestContext) -> list[Header]:
        """What every answer has: the name of the request, the digest of its body, and whether the connection ends."""
        headers = [(b"x-request-id", context.request_id.encode("ascii")), *context.extra_headers]
        if context.request_digest is not None:
            headers.append((b"x-request-digest", context.request_digest.encode("ascii")))
        if self._lifecycle.draining:
            headers.append((b"connection", b"close"))
        return headers

    def finish(self, method: str, context: RequestContext) -> None:
        """Count and log a request that has been answered."""
        seconds = time.monotonic() - context.arrived
        self._metrics.observe_request(context.route, method, context.status, seconds)
        if self._log_requests:
            access_logger.info(
                "%s %s %s %d %.1f ms caller=%s traceparent=%s",
                context.request_id, method, context.route, context.status, seconds * 1e3, context.caller,
                log_word(context.headers.get(b"traceparent", b"-")),
            )  # fmt: skip


def new_context(headers: dict[bytes, bytes], route: str = NO_ROUTE) -> RequestContext:
    """The context of a request that arrives now; header names are lower case."""
    given = headers.get(b"x-request-id", b"")
    request_id = given.decode("ascii") if _REQUEST_ID.fullmatch(given) else os.urandom(16).hex()
    return RequestContext(request_id=request_id, headers=headers, arrived=time.monotonic(), route=route)
