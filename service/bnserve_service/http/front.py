"""The front of the service: every request is named, its route found, and whoever asks let in; then it is handed to its
endpoint, and what went wrong becomes a problem answer.

The route is found once, and before all else: access, hosts, metrics and the endpoint go by it. Two matchers of one path
are a door, however alike they look: the patterns of starlette end in ``$``, which also matches before a newline, so
that its router takes ``/metrics%0A`` for ``/metrics`` where a comparison of strings does not.
"""

from __future__ import annotations

import logging
import re
import time
from collections.abc import Awaitable, Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from fastapi.exceptions import RequestValidationError
from fastapi.middleware.asyncexitstack import AsyncExitStackMiddleware
from starlette.exceptions import HTTPException
from starlette.routing import Route
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from bnserve_protocol import BnserveError, InvalidRequest, UndecodableBody
from bnserve_protocol.wire import JSON, PROBLEM_JSON
from bnserve_service.admission.control import Lifecycle
from bnserve_service.errors import (
    UMBRIDGE,
    ClientDisconnected,
    from_http_status,
    internal_error,
    problem_body,
    problem_headers,
    umbridge_body,
)
from bnserve_service.http.access import HostCheck, TokenCheck, is_public
from bnserve_service.http.answers import body_headers, send_answer
from bnserve_service.http.cors import CrossOrigin
from bnserve_service.http.requests import CONTEXT, Header, RequestContext, header_fields, new_context
from bnserve_service.telemetry.metrics import Metrics

logger = logging.getLogger("bnserve.service")

_METHODS = frozenset({"GET", "HEAD", "POST", "PUT", "DELETE", "OPTIONS", "PATCH"})
"""Others are one, in metrics and log: callers may invent them, too."""
_PARAMETER = re.compile(r"{(\w+)}")
_NOT_IN_PATHS = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ufffd]")
"""Controls, the other ends of lines, and what a decoder puts in the place of bytes that are not UTF-8."""


@dataclass(frozen=True, slots=True)
class Place:
    """A path of the service and who answers there, by method."""

    template: str
    pattern: re.Pattern[str]
    endpoints: Mapping[str, ASGIApp]


def places_of(evaluations: Mapping[str, ASGIApp], routes: Iterable[Route]) -> list[Place]:
    """All paths; where there is GET, there is HEAD (RFC 9110, 9.1), of which the server leaves the content out.

    Parameters
    ----------
    evaluations
        ASGI applications by the templates of their paths, such as ``/v1/models/{name}/waveforms``, for POST. They are
        called as they are: what FastAPI's routes have around them takes 100 us for each request.
    routes
        All others.
    """
    places: dict[str, dict[str, ASGIApp]] = {path: {"POST": endpoint} for path, endpoint in evaluations.items()}
    for route in routes:
        endpoint = AsyncExitStackMiddleware(route.app)  # the one middleware that FastAPI's routes rely on
        places.setdefault(route.path, {}).update(dict.fromkeys(route.methods or (), endpoint))
    for endpoints in places.values():
        if "GET" in endpoints:
            endpoints.setdefault("HEAD", endpoints["GET"])
    return [Place(path, _pattern(path), endpoints) for path, endpoints in places.items()]


def _pattern(template: str) -> re.Pattern[str]:
    """Of the paths that a template stands for."""
    literals = _PARAMETER.split(template)
    return re.compile("".join(f"(?P<{text}>[^/]+)" if i % 2 else re.escape(text) for i, text in enumerate(literals)))


class Listener(Protocol):
    """Who is told of requests that have been answered."""

    def tell(self, method: str, context: RequestContext, seconds: float) -> None:
        """One took so many seconds, from its headers to the end of its answer."""


class Front:
    """Attaches a :class:`~bnserve_service.http.requests.RequestContext` to each request; lets it in and hands it on;
    adds the common headers, answers errors, counts.

    Parameters
    ----------
    places
        Who answers where.
    hosts, tokens
        Under which names; and who is let in, None for everybody.
    turn
        Waits until it is the turn of a token, by its digest.
    metrics, lifecycle
        Where to count, and whether connections are still kept open.
    listeners
        Who is told of every request: the access log, and whoever makes spans of them.
    cross_origin
        Pages of other sites that may ask; None for none.
    public
        Whether a route needs no token.
    """

    def __init__(
        self,
        places: Sequence[Place],
        hosts: HostCheck,
        tokens: TokenCheck | None,
        turn: Callable[[str], Awaitable[None]],
        metrics: Metrics,
        lifecycle: Lifecycle,
        listeners: Sequence[Listener] = (),
        cross_origin: CrossOrigin | None = None,
        public: Callable[[str], bool] = is_public,
    ) -> None:
        self._public = public
        self._places = places
        self.others: ASGIApp | None = None
        """Who serves what is not HTTP, if anybody."""
        self.hosts = hosts
        self.tokens = tokens
        self._turn = turn
        self._metrics = metrics
        self._lifecycle = lifecycle
        self._listeners = listeners
        self._cross_origin = cross_origin

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one HTTP request."""
        if scope["type"] != "http":
            assert self.others is not None, "what serves metrics has no lifespan"
            await self.others(scope, receive, send)
            return
        context = scope[CONTEXT] = new_context(header_fields(scope["headers"]))
        if scope.get("client"):
            context.peer = scope["client"][0]

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                context.status = message["status"]
                message["headers"] = [*message["headers"], *self.common_headers(context)]
            else:
                context.bytes_out += len(message.get("body", b""))
            await send(message)

        try:
            await self._hand_on(context, scope, receive, send_with_headers)
        except ClientDisconnected:
            context.status = 499  # the name nginx gave to "the client closed the request"
        except Exception as error:
            if context.status:  # too late: break the connection, so that nobody takes half an answer for a whole
                raise
            status, headers, body = self.problem_answer(error, context)
            await send_answer(send_with_headers, status, headers, [body])
        finally:
            self.finish(scope["method"] if scope["method"] in _METHODS else "other", context)

    async def _hand_on(self, context: RequestContext, scope: Scope, receive: Receive, send: Send) -> None:
        place = self._find(scope)
        if place is not None:
            context.route, context.path = place.template, scope["path_params"]
        method = scope["method"]
        self.hosts.check(context.headers, method, context.route)
        if self._cross_origin is not None:
            preflight = self._cross_origin.preflight(method, context.headers)
            if preflight is not None:
                await send_answer(send, 204, preflight, [])
                return
        if self.tokens is not None and not self._public(context.route):
            self.tokens.check(context, scope["headers"], method)
            await self._turn(context.owner)
            context.check_quota()  # before the body is read
        if place is None:
            raise HTTPException(404)
        endpoint = place.endpoints.get(method)
        if endpoint is None:
            raise HTTPException(405, headers={"Allow": ", ".join(sorted(place.endpoints))})
        with context.under_way():
            await endpoint(scope, receive, send)

    def _find(self, scope: Scope) -> Place | None:
        """The place that a request takes, whatever its method.

        Raises
        ------
        UndecodableBody
            Its path has control characters, or is not UTF-8.
        """
        path: str = scope["path"]
        if _NOT_IN_PATHS.search(path):
            raise UndecodableBody("The path has control characters, or bytes that are not UTF-8: none here has.")
        root = scope.get("root_path", "")  # of another application that this one is a part of
        path = path.removeprefix(root) if path.startswith(f"{root}/") else path
        for place in self._places:
            match = place.pattern.fullmatch(path)
            if match is not None:
                scope["path_params"] = match.groupdict()
                return place
        return None

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
        if context.route.startswith(UMBRIDGE):
            status, body = umbridge_body(told, status)
            media_type = JSON
        else:
            status, body = problem_body(told, context.request_id, status)
            media_type = PROBLEM_JSON
        headers = [*body_headers([body], media_type), *problem_headers(told), *extra]
        self._metrics.refused(told.code)
        context.error = told.code
        return status, headers, body

    def common_headers(self, context: RequestContext) -> list[Header]:
        """What every answer has: the name of the request, the digest of its body, and whether the connection ends."""
        headers = [(b"x-request-id", context.request_id.encode("ascii"))]
        if context.request_digest is not None:
            headers.append((b"x-request-digest", context.request_digest.encode("ascii")))
        if self._cross_origin is not None:
            headers += self._cross_origin.headers(context.headers)
        if context.quota is not None and context.pays:
            headers += context.quota.headers()
        if self._lifecycle.draining:
            headers.append((b"connection", b"close"))
        return headers

    def finish(self, method: str, context: RequestContext) -> None:
        """Count and log a request that has been answered."""
        seconds = time.monotonic() - context.arrived
        self._metrics.observe_request(context.route, method, context.status, seconds)
        if context.owner:
            self._metrics.callers.count(context.caller, context.rows, context.bytes_out, seconds)
        for listener in self._listeners:
            listener.tell(method, context, seconds)
