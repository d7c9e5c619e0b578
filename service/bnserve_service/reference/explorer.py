"""``/`` and ``/docs``: two pages that need nothing from elsewhere, so that they work offline; ``/openapi.json``, which
the second draws."""

from __future__ import annotations

from importlib.resources import files

from fastapi import APIRouter, Response

from bnserve_service.http.answers import plain_response

_HTML = "text/html; charset=utf-8"


def explorer_router(document: bytes) -> APIRouter:
    """The paths of the pages and of the OpenAPI document."""
    router = APIRouter(include_in_schema=False)
    pages = files("bnserve_service") / "pages"
    explorer = (pages / "explorer.html").read_bytes()
    reference = (pages / "reference.html").read_bytes()

    @router.get("/")
    async def show_explorer() -> Response:
        """Try the models in a browser."""
        return _page(explorer)

    @router.get("/docs")
    async def show_reference() -> Response:
        """The reference, drawn from ``/openapi.json``."""
        return _page(reference)

    @router.get("/openapi.json")
    async def show_openapi() -> Response:
        """The OpenAPI document."""
        return plain_response(document, "application/json")

    return router


def _page(body: bytes) -> Response:
    response = plain_response(body, _HTML)
    response.headers["content-security-policy"] = (
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; "
        "img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
    )
    response.headers["x-content-type-options"] = "nosniff"
    return response
