"""What is served: ``GET /v1/models...``, ``/v1/limits``, and ``/v1/manifest`` for the appendix of a paper."""

from __future__ import annotations

import asyncio

import msgspec
from fastapi import APIRouter, Request, Response

from bnserve_protocol import ManifestModel, RunManifest
from bnserve_service.http.answers import data_response
from bnserve_service.models.registry import Catalogue, Registry
from bnserve_service.reference.documents import ModelDocument, ModelList, model_document, model_list
from bnserve_service.reference.openapi import answers_with
from bnserve_service.settings import ServiceLimits

SOFTWARE = ("fastapi", "uvicorn", "uvloop", "httptools", "pydantic")
"""Distributions between a model and the wire."""


def model_router(registry: Registry, limits: ServiceLimits) -> APIRouter:
    """The paths of what is served."""
    router = APIRouter(default_response_class=Response)

    @router.get("/v1/models", tags=["models"], responses=answers_with(ModelList))
    async def list_models(request: Request) -> Response:
        """Every model served here, with its ranges, band and measured accuracy."""
        return data_response(request, model_list(registry.catalogue, limits))

    @router.get("/v1/models/{name}", tags=["models"], responses=answers_with(ModelDocument))
    async def show_model(request: Request, name: str) -> Response:
        """The stable version of one model."""
        return data_response(request, model_document(registry.find(name), registry.catalogue, limits))

    @router.get("/v1/models/{name}/versions/{version}", tags=["models"], responses=answers_with(ModelDocument))
    async def show_version(request: Request, name: str, version: str) -> Response:
        """One version (or label) of one model."""
        return data_response(request, model_document(registry.find(name, version), registry.catalogue, limits))

    @router.get("/v1/limits", tags=["limits"], responses=answers_with(ServiceLimits))
    async def show_limits(request: Request) -> Response:
        """The limits of one request to this service; all are inclusive maxima."""
        return data_response(request, limits)

    @router.get("/v1/manifest", tags=["service"], responses=answers_with(RunManifest))
    async def show_manifest(request: Request) -> Response:
        """Versions, digests, processor and limits; equal manifests have equal digests."""
        loop = asyncio.get_running_loop()
        manifest = await loop.run_in_executor(None, describe_service, registry.catalogue, limits)
        return data_response(request, manifest)

    return router


def describe_service(catalogue: Catalogue, limits: ServiceLimits) -> RunManifest:
    """The manifest of a service that serves ``catalogue``."""
    from bnserve_surrogate import describe_run  # here, because start-up need not wait for it

    models = [
        ManifestModel(
            name=name,
            version=version,
            digest=loaded.identity.digest,
            labels=sorted(label for label, target in catalogue.labels.get(name, {}).items() if target == version),
        )
        for (name, version), loaded in catalogue.models.items()
    ]
    return describe_run(models, msgspec.to_builtins(limits), SOFTWARE)
