"""What operators and their tools ask for: the probes, the metrics, and a look at the stores."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter, Request, Response

from bnserve_protocol import BnserveError
from bnserve_service.http.answers import data_response, plain_response
from bnserve_service.models.maintenance import Health, Maintenance
from bnserve_service.process.renewals import Renewals
from bnserve_service.reference.documents import ReloadDocument, reload_document
from bnserve_service.reference.openapi import answers_with, answers_with_flag, answers_with_text
from bnserve_service.telemetry.metrics import CONTENT_TYPE, Metrics


def health_router(health: Health) -> APIRouter:
    """The probes, under the names of the Open Inference Protocol. Answered from memory, never shed."""
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


def reload_router(maintenance: Maintenance, renewals: Renewals) -> APIRouter:
    """``POST /v1/reload``."""
    router = APIRouter(tags=["service"], default_response_class=Response)

    @router.post("/v1/reload", responses=answers_with(ReloadDocument))
    async def reload_models(request: Request) -> Response:
        """Look at the model stores now, also at what was refused before, and read tokens and certificate again.

        Where tokens are asked for: scope admin.
        """
        await renewals.now()
        return data_response(request, reload_document(await maintenance.refresh(force=True)))

    return router


def metrics_router(metrics: Metrics) -> APIRouter:
    """``GET /metrics`` for Prometheus."""
    router = APIRouter(tags=["metrics"], default_response_class=Response)

    @router.get("/metrics", responses=answers_with_text("text/plain"))
    async def show_metrics() -> Response:
        """The instruments of this server, all of its workers together, in Prometheus' text format."""
        text = await asyncio.get_running_loop().run_in_executor(None, metrics.exposition)  # milliseconds, with workers
        return plain_response(text, CONTENT_TYPE)

    return router
