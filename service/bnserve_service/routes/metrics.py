"""``GET /metrics`` for Prometheus."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter, Response

from bnserve_service.http.answers import plain_response
from bnserve_service.reference.openapi import answers_with_text
from bnserve_service.telemetry.metrics import CONTENT_TYPE, Metrics


def metrics_router(metrics: Metrics) -> APIRouter:
    """The path of the metrics."""
    router = APIRouter(tags=["metrics"], default_response_class=Response)

    @router.get("/metrics", responses=answers_with_text("text/plain"))
    async def show_metrics() -> Response:
        """The instruments of this server, all of its workers together, in Prometheus' text format."""
        text = await asyncio.get_running_loop().run_in_executor(None, metrics.exposition)  # milliseconds, with workers
        return plain_response(text, CONTENT_TYPE)

    return router
