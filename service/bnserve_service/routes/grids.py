"""``PUT`` and ``HEAD /v1/grids/{sha256}``: frequencies uploaded once and named by their digest."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from bnserve_service.evaluation.service import WaveformService
from bnserve_service.http.answers import data_response
from bnserve_service.http.body import BodyReader
from bnserve_service.http.front import context_of
from bnserve_service.http.requests import OCTETS, require_media_type
from bnserve_service.reference.documents import GridDocument
from bnserve_service.reference.openapi import FOUND_OR_NOT, GRID_BODY, answers_with
from bnserve_service.uploads.storage_quotas import StorageQuotas
from bnserve_service.uploads.stores import GridStore


def grid_router(
    grids: GridStore, service: WaveformService, bodies: BodyReader, limit: int, stored: StorageQuotas
) -> APIRouter:
    """The paths of uploaded grids."""
    router = APIRouter(tags=["grids"], default_response_class=Response)

    @router.put(
        "/v1/grids/{sha256}",
        responses=answers_with(GridDocument, 201) | answers_with(GridDocument),
        status_code=201,
        openapi_extra=GRID_BODY,
    )
    async def upload_grid(request: Request, sha256: str) -> Response:
        """Upload a grid: raw little-endian float64 in Hz, increasing. 201 when it is new, 200 when it was here."""
        context = context_of(request.scope)
        require_media_type(context.headers, OCTETS, f"Send the grid as {OCTETS}: raw little-endian float64.")
        with bodies.of(context) as incoming:
            body = await incoming.read(request.receive, limit)
            context.request_digest = await service.digest(body)
            with stored.room(context.owner, "grid", sha256.lower(), len(body)):
                grid, is_new = await service.large_or_small(len(body), grids.put, context.owner, sha256.lower(), body)
        return data_response(request, GridDocument(sha256.lower(), len(grid)), 201 if is_new else 200)

    @router.head("/v1/grids/{sha256}", responses=FOUND_OR_NOT)
    async def find_grid(request: Request, sha256: str) -> Response:
        """Whether a grid is here; 404 when it has to be uploaded."""
        grids.get(context_of(request.scope).owner, sha256.lower())
        return Response(status_code=200)

    return router
