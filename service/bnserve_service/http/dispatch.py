"""Which route a request takes: found once, before all else; access, hosts, metrics and the endpoint go by it.

Two matchers of one path are a door, however alike they look: the patterns of starlette end in ``$``, which also matches
before a newline, so that its router takes ``/metrics%0A`` for ``/metrics`` where a comparison of strings does not.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from fastapi.middleware.asyncexitstack import AsyncExitStackMiddleware
from starlette.exceptions import HTTPException
from starlette.routing import Route
from starlette.types import ASGIApp, Receive, Scope, Send

from bnserve_protocol import UndecodableBody
from bnserve_service.http.front import NO_ROUTE

_PARAMETER = re.compile(r"{(\w+)}")
_NOT_IN_PATHS = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ufffd]")
"""Controls, the other ends of lines, and what a decoder puts in the place of bytes that are not UTF-8."""
_FOUND = "bnserve.place"


@dataclass(frozen=True, slots=True)
class _Place:
    """A path of the service and who answers there, by method."""

    template: str
    pattern: re.Pattern[str]
    endpoints: Mapping[str, ASGIApp]


class Dispatcher:
    """Finds the route of a request, and hands the request to its endpoint.

    Where there is GET, there is HEAD (RFC 9110, 9.1): the server leaves the content out.

    Parameters
    ----------
    evaluations:
        ASGI applications by the templates of their paths, such as ``/v1/models/{name}/waveforms``, for POST. They are
        called as they are: what FastAPI's routes have around them takes 100 us for each request.
    routes:
        All others.
    """

    def __init__(self, evaluations: Mapping[str, ASGIApp], routes: Iterable[Route]) -> None:
        places: dict[str, dict[str, ASGIApp]] = {path: {"POST": endpoint} for path, endpoint in evaluations.items()}
        for route in routes:
            endpoint = AsyncExitStackMiddleware(route.app)  # the one middleware that FastAPI's routes rely on
            places.setdefault(route.path, {}).update(dict.fromkeys(route.methods or (), endpoint))
        for endpoints in places.values():
            if "GET" in endpoints:
                endpoints.setdefault("HEAD", endpoints["GET"])
        self._places = [_Place(path, _pattern(path), endpoints) for path, endpoints in places.items()]

    def find(self, scope: Scope) -> str:
        """The template of the route that a request takes, whatever its method; ``NO_ROUTE`` if there is none.

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
                scope[_FOUND] = place
                return place.template
        scope[_FOUND] = None
        return NO_ROUTE

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one HTTP request whose route was found."""
        place: _Place | None = scope[_FOUND]
        if place is None:
            raise HTTPException(404)
        endpoint = place.endpoints.get(scope["method"])
        if endpoint is None:
            raise HTTPException(405, headers={"Allow": ", ".join(sorted(place.endpoints))})
        await endpoint(scope, receive, send)


def _pattern(template: str) -> re.Pattern[str]:
    """Of the paths that a template stands for."""
    literals = _PARAMETER.split(template)
    return re.compile("".join(f"(?P<{text}>[^/]+)" if i % 2 else re.escape(text) for i, text in enumerate(literals)))
