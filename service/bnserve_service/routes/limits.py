"""``GET /v1/limits``: what a client needs to size its batches."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from bnserve_service.http.answers import data_response
from bnserve_service.reference.openapi import answers_with
from bnserve_service.settings import ServiceLimits


def limits_router(limits: ServiceLimits) -> APIRouter:
    """The path of the limits."""
    router = APIRouter(tags=["limits"], default_response_class=Response)

    @router.get("/v1/limits", responses=answers_with(ServiceLimits))
    async def show_limits(request: Request) -> Response:
        """The limits of one request to this service; all are inclusive maxima."""
        return data_response(request, limits)

    return router
