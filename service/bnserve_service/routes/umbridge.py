"""``/v1/umbridge/...``: what UM-Bridge clients ask before they evaluate, and what is not offered."""

from __future__ import annotations

from typing import TypeVar

import msgspec
from fastapi import APIRouter, Request, Response

from bnserve_protocol import check_model_of
from bnserve_protocol.wire import JSON
from bnserve_service.errors import UnsupportedFeature
from bnserve_service.evaluation.umbridge import ADVICE, address, inputs, names
from bnserve_service.evaluation.umbridge_bodies import (
    PREFIX,
    PROTOCOL_VERSION,
    Named,
    UmBridgeInfo,
    UmBridgeInputSizes,
    UmBridgeModelInfo,
    UmBridgeModelRequest,
    UmBridgeOutputSizes,
    UmBridgeSupport,
    decode,
)
from bnserve_service.http.answers import plain_response
from bnserve_service.http.body import BodyReader
from bnserve_service.http.requests import context_of, require_media_type
from bnserve_service.models.registry import LoadedModel, Registry
from bnserve_service.reference.openapi import json_answer, json_body
from bnserve_service.settings import Settings
from bnserve_service.uploads.analyses import AnalysisStore, StoredAnalysis

B = TypeVar("B", bound=msgspec.Struct)


class _Reader:
    """Reads what is asked about a model, and finds the model."""

    def __init__(self, registry: Registry, analyses: AnalysisStore, bodies: BodyReader, settings: Settings) -> None:
        self._registry, self._analyses, self._bodies = registry, analyses, bodies
        self._most = settings.body_limit(JSON)

    async def __call__(self, request: Request, form: type[B]) -> tuple[B, LoadedModel, StoredAnalysis]:
        context = context_of(request.scope)
        require_media_type(context.headers, JSON, ADVICE)
        with self._bodies.of(context) as incoming:
            body = await incoming.read(request.receive, self._most)
            await incoming.name(body)
            where = await self._bodies.work(len(body), address, body)
            model = self._registry.find(where["name"], where.get("version"))
            size = self._analyses.bytes_to_read(context.owner, where["sha256"])
            stored = await self._bodies.work(size, self._analyses.get, context.owner, where["sha256"])
            check_model_of(stored.analysis, model.model.description)
            return await self._bodies.work(len(body), decode, body, form), model, stored


def umbridge_router(registry: Registry, analyses: AnalysisStore, bodies: BodyReader, settings: Settings) -> APIRouter:
    """All but the evaluations."""
    router = APIRouter(tags=["umbridge"], default_response_class=Response)
    read = _Reader(registry, analyses, bodies, settings)

    @router.get(f"{PREFIX}Info", responses=json_answer(UmBridgeInfo))
    async def umbridge_info(request: Request) -> Response:
        """The models of this caller: every analysis, with every model that it can be evaluated with."""
        owner = context_of(request.scope).owner
        size = analyses.all_bytes_to_read(owner)
        models = await bodies.work(size, names, analyses, owner, registry.catalogue)
        return _answer(UmBridgeInfo(PROTOCOL_VERSION, models))

    @router.post(f"{PREFIX}ModelInfo", responses=json_answer(UmBridgeModelInfo), openapi_extra=json_body("Model"))
    async def umbridge_model_info(request: Request) -> Response:
        """What a model can be asked for."""
        _, model, _ = await read(request, UmBridgeModelRequest)
        derivatives = model.has_derivatives
        return _answer(UmBridgeModelInfo(UmBridgeSupport(True, derivatives, derivatives, False)))

    @router.post(f"{PREFIX}InputSizes", responses=json_answer(UmBridgeInputSizes), openapi_extra=json_body("Model"))
    async def umbridge_input_sizes(request: Request) -> Response:
        """The length of the input vector: of the parameters of the analysis, without those that are fixed."""
        asked, _, stored = await read(request, UmBridgeModelRequest)
        return _answer(UmBridgeInputSizes([len(inputs(stored, asked.config))]))

    @router.post(f"{PREFIX}OutputSizes", responses=json_answer(UmBridgeOutputSizes), openapi_extra=json_body("Model"))
    async def umbridge_output_sizes(request: Request) -> Response:
        """The length of the output vector."""
        await read(request, UmBridgeModelRequest)
        return _answer(UmBridgeOutputSizes([1]))

    @router.post(f"{PREFIX}ApplyHessian", responses=json_answer(), openapi_extra=json_body("Model"), status_code=400)
    async def umbridge_apply_hessian(request: Request) -> Response:
        """Not offered: answered with the error UnsupportedFeature."""
        await read(request, Named)
        raise UnsupportedFeature("Likelihoods have gradients here, and no Hessians: use Gradient or ApplyJacobian.")

    return router


def _answer(answer: msgspec.Struct) -> Response:
    return plain_response(msgspec.json.encode(answer), JSON)
