"""The pages, and the files they are made of: ``/``, ``/models``, ``/state`` and ``/docs``. They need nothing from
elsewhere, so that they work offline; ``/openapi.json``, which the last draws."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from importlib.resources import files

from fastapi import APIRouter, Response
from starlette.exceptions import HTTPException

from bnserve_service.http.answers import plain_response

PAGES = {"/": "explorer.html", "/models": "models.html", "/state": "state.html", "/docs": "reference.html"}
"""By path."""
FILES_ROUTE = "/pages/{folder}/{name}"
"""Where what they are made of is."""
_HTML = "text/html; charset=utf-8"
_MEDIA_TYPES = {
    "css": "text/css; charset=utf-8",
    "js": "text/javascript; charset=utf-8",
    "json": "application/json",
    "svg": "image/svg+xml",
}
_POLICY = (
    "default-src 'none'; style-src 'self'; script-src 'self'; connect-src 'self'; img-src 'self' data: blob:; "
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
)
"""No script but those of this server runs, and none that stands in a page."""


def explorer_router(document: bytes) -> APIRouter:
    """The paths of the pages, of their files and of the OpenAPI document."""
    router = APIRouter(include_in_schema=False)
    folder = files("bnserve_service") / "pages"
    for path, name in PAGES.items():
        router.add_api_route(path, _page((folder / name).read_bytes()), methods=["GET"])
    kept = {
        (inner.name, file.name): (file.read_bytes(), _MEDIA_TYPES[file.name.rpartition(".")[2]])
        for inner in folder.iterdir()
        if inner.is_dir()
        for file in inner.iterdir()
    }

    @router.get(FILES_ROUTE)
    async def show_file(folder: str, name: str) -> Response:
        """A style, a script or the numbers of a page."""
        if (folder, name) not in kept:
            raise HTTPException(404)
        return _guarded(*kept[folder, name])

    @router.get("/openapi.json")
    async def show_openapi() -> Response:
        """The OpenAPI document."""
        return plain_response(document, "application/json")

    return router


def _page(body: bytes) -> Callable[[], Awaitable[Response]]:
    async def show() -> Response:
        return _guarded(body, _HTML)

    return show


def _guarded(body: bytes, media_type: str) -> Response:
    response = plain_response(body, media_type)
    response.headers["content-security-policy"] = _POLICY
    response.headers["x-content-type-options"] = "nosniff"
    response.headers["cache-control"] = "no-cache"  # another version of the server has other files under these names
    return response
