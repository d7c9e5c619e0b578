"""``GET /v1/manifest``: what the appendix of a paper needs, and ``POST /v1/reload``: look at the stores now."""

from __future__ import annotations

import asyncio

import msgspec
from fastapi import APIRouter, Request, Response

from bnserve_protocol import ManifestModel, RunManifest
from bnserve_service.http.answers import data_response
from bnserve_service.models.maintenance import Maintenance
from bnserve_service.models.registry import Catalogue, Registry
from bnserve_service.reference.documents import ReloadDocument, reload_document
from bnserve_service.reference.openapi import answers_with
from bnserve_service.settings import ServiceLimits

SOFTWARE = ("fastapi", "uvicorn", "uvloop", "httptools", "pydantic")
"""Distributions between a model and the wire."""


def manifest_router(registry: Registry, limits: ServiceLimits, maintenance: Maintenance) -> APIRouter:
    """The paths that tell and change what is served as a whole."""
    router = APIRouter(tags=["service"], default_response_class=Response)

    @router.get("/v1/manifest", responses=answers_with(RunManifest))
    async def show_manifest(request: Request) -> Response:
        """Versions, digests, processor and limits; equal manifests have equal digests."""
        loop = asyncio.get_running_loop()
        manifest = await loop.run_in_executor(None, describe_service, registry.catalogue, limits)
        return data_response(request, manifest)

    @router.post("/v1/reload", responses=answers_with(ReloadDocument))
    async def reload_models(request: Request) -> Response:
        """Look at the model stores now, also at what was refused before. Where tokens are asked for: scope admin."""
        return data_response(request, reload_document(await maintenance.refresh(force=True)))

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
