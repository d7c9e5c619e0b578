"""``GET /v1/models...``: what is served, in which ranges, how accurate."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from bnserve_service.http.answers import data_response
from bnserve_service.models.registry import Registry
from bnserve_service.reference.documents import ModelDocument, ModelList, model_document, model_list
from bnserve_service.reference.openapi import answers_with
from bnserve_service.settings import ServiceLimits


def model_router(registry: Registry, limits: ServiceLimits) -> APIRouter:
    """The paths of models and versions."""
    router = APIRouter(tags=["models"], default_response_class=Response)

    @router.get("/v1/models", responses=answers_with(ModelList))
    async def list_models(request: Request) -> Response:
        """Every model served here, with its ranges, band and measured accuracy."""
        return data_response(request, model_list(registry.catalogue, limits))

    @router.get("/v1/models/{name}", responses=answers_with(ModelDocument))
    async def show_model(request: Request, name: str) -> Response:
        """The stable version of one model."""
        return data_response(request, model_document(registry.find(name), registry.catalogue, limits))

    @router.get("/v1/models/{name}/versions/{version}", responses=answers_with(ModelDocument))
    async def show_version(request: Request, name: str, version: str) -> Response:
        """One version (or label) of one model."""
        return data_response(request, model_document(registry.find(name, version), registry.catalogue, limits))

    return router
