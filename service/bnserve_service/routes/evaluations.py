"""The way of requests for evaluations: straight to their endpoint, past the router and its middlewares."""

from __future__ import annotations

import re
from collections.abc import Mapping

from starlette.routing import Route
from starlette.types import ASGIApp, Receive, Scope, Send

from bnserve_service.transport.context import context_of

_PARAMETER = re.compile(r"{(\w+)}")


class StraightWay:
    """Hands POST requests straight to their endpoints: the router and its middlewares take 100 us for each.

    Parameters
    ----------
    app:
        Where all other requests go.
    endpoints:
        ASGI applications by the templates of their paths, such as ``/v1/models/{name}/waveforms``.
    """

    def __init__(self, app: ASGIApp, endpoints: Mapping[str, ASGIApp]) -> None:
        self._app = app
        self._endpoints = [
            (re.compile(_PARAMETER.sub(r"(?P<\1>[^/]+)", path)), path, endpoint) for path, endpoint in endpoints.items()
        ]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one HTTP request."""
        if scope["method"] == "POST":
            for pattern, path, endpoint in self._endpoints:
                match = pattern.fullmatch(scope["path"])
                if match is not None:
                    scope["path_params"] = match.groupdict()
                    context_of(scope).route = path
                    await endpoint(scope, receive, send)
                    return
        await self._app(scope, receive, send)


def evaluation_routes(endpoints: Mapping[str, ASGIApp]) -> list[Route]:
    """The same paths for the router, which says of other methods that they are not allowed."""
    return [Route(path, endpoint, methods=["POST"], name=path) for path, endpoint in endpoints.items()]
