"""``PUT``, ``GET``, ``HEAD`` and ``DELETE /v1/analyses/{sha256}``: analyses uploaded once and named by their digest."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from bnserve_protocol.wire import MSGPACK
from bnserve_service.evaluation.likelihoods import LikelihoodService
from bnserve_service.http.answers import data_response
from bnserve_service.http.body import BodyReader
from bnserve_service.http.front import context_of
from bnserve_service.http.requests import require_media_type
from bnserve_service.reference.documents import AnalysisDocument, analysis_document
from bnserve_service.reference.openapi import FOUND_OR_NOT, GONE, answers_with
from bnserve_service.reference.openapi_likelihoods import ANALYSIS_BODY
from bnserve_service.uploads.storage_quotas import StorageQuotas
from bnserve_service.uploads.stores import AnalysisStore


def analysis_router(
    analyses: AnalysisStore, service: LikelihoodService, bodies: BodyReader, limit: int, quotas: StorageQuotas
) -> APIRouter:
    """The paths of uploaded analyses."""
    router = APIRouter(tags=["likelihoods"], default_response_class=Response)

    @router.put(
        "/v1/analyses/{sha256}",
        responses=answers_with(AnalysisDocument, 201) | answers_with(AnalysisDocument),
        status_code=201,
        openapi_extra=ANALYSIS_BODY,
    )
    async def upload_analysis(request: Request, sha256: str) -> Response:
        """Upload an analysis. 201 when it is new to this caller, 200 when it was here."""
        context = context_of(request.scope)
        require_media_type(context.headers, MSGPACK, f"Send the analysis as {MSGPACK}.")
        with bodies.of(context) as incoming:
            body = await incoming.read(request.receive, limit)
            context.request_digest = await service.digest(body)
            with quotas.room(context.owner, "analysis", sha256.lower(), len(body)):
                stored, is_new = await service.keep(context.owner, sha256.lower(), body)
        return data_response(request, analysis_document(stored), 201 if is_new else 200)

    @router.get("/v1/analyses/{sha256}", responses=answers_with(AnalysisDocument))
    async def show_analysis(request: Request, sha256: str) -> Response:
        """What is known about an analysis of this caller; its data are not told."""
        return data_response(request, analysis_document(analyses.get(context_of(request.scope).owner, sha256.lower())))

    @router.head("/v1/analyses/{sha256}", responses=FOUND_OR_NOT)
    async def find_analysis(request: Request, sha256: str) -> Response:
        """Whether an analysis is here; 404 when it has to be uploaded."""
        analyses.get(context_of(request.scope).owner, sha256.lower())
        return Response(status_code=200)

    @router.delete("/v1/analyses/{sha256}", responses=GONE, status_code=204)
    async def forget_analysis(request: Request, sha256: str) -> Response:
        """Forget an analysis of this caller."""
        analyses.drop(context_of(request.scope).owner, sha256.lower())
        return Response(status_code=204)

    return router
