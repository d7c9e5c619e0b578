"""The probes, under the names of the Open Inference Protocol. Answered from memory, never shed."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from bnserve_protocol import BnserveError
from bnserve_service.http.answers import data_response
from bnserve_service.models.maintenance import Health
from bnserve_service.reference.openapi import answers_with_flag


def health_router(health: Health) -> APIRouter:
    """The paths of the probes."""
    router = APIRouter(tags=["health"], default_response_class=Response)

    @router.get("/v2/health/live", responses=answers_with_flag("live"))
    async def live(request: Request) -> Response:
        """The process answers. A restart helps when this fails."""
        return data_response(request, {"live": True})

    @router.get("/v2/health/ready", responses=answers_with_flag("ready"))
    async def ready(request: Request) -> Response:
        """Models are loaded, warm and right, and the server is not stopping. Otherwise 503 with the reason."""
        _raise(health.reason_unready())
        return data_response(request, {"ready": True})

    @router.get("/v2/models/{name}/ready", responses=answers_with_flag("ready"))
    async def model_ready(request: Request, name: str) -> Response:
        """As above, and this model is served."""
        _raise(health.reason_model_unready(name))
        return data_response(request, {"name": name, "ready": True})

    return router


def _raise(reason: BnserveError | None) -> None:
    if reason is not None:
        raise reason
