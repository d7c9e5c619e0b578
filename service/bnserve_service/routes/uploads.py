"""``/v1/grids/{sha256}``, ``/v1/analyses/{sha256}`` and ``/v1/networks/{sha256}``: uploaded once, and named by their
digest."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import nullcontext
from typing import TypeVar

from fastapi import APIRouter, Request, Response

from bnserve_protocol.wire import JSON, MSGPACK
from bnserve_service.admission.control import Lifecycle
from bnserve_service.http.answers import data_response
from bnserve_service.http.body import OFF_LOOP, BodyReader
from bnserve_service.http.requests import OCTETS, context_of, require_media_type
from bnserve_service.reference.documents import (
    AnalysisDocument,
    GridDocument,
    NetworkDocument,
    analysis_document,
    network_document,
)
from bnserve_service.reference.openapi import FOUND_OR_NOT, GONE, answers_with, binary_body, named_body
from bnserve_service.settings import Settings
from bnserve_service.uploads.storage_quotas import Kind, StorageQuotas
from bnserve_service.uploads.stores import AnalysisStore, GridStore, NetworkStore, StoredAnalysis, StoredNetwork

T = TypeVar("T")


class Receiver:
    """Receives what is uploaded.

    Parameters
    ----------
    bodies
        Reads it.
    quotas
        How much each token may keep.
    """

    def __init__(self, bodies: BodyReader, quotas: StorageQuotas) -> None:
        self._bodies = bodies
        self._quotas = quotas
        self._large = asyncio.Lock()
        """Held by an upload that takes long: all of them have one thread, so that questions have one, too."""

    async def receive(
        self, request: Request, kind: Kind, limit: int, put: Callable[[str, str, bytes], T], more: int = 0
    ) -> T:
        """Read a body of at most ``limit`` bytes and ``put`` it under its owner and the digest in its path; to work
        through it takes as long as through so many bytes ``more``."""
        context = context_of(request.scope)
        sha256 = request.path_params["sha256"].lower()
        with self._bodies.of(context) as incoming:
            body = await incoming.read(request.receive, limit)
            await incoming.name(body)
            with self._quotas.room(context.owner, kind, sha256, len(body)):
                async with self._large if len(body) + more > OFF_LOOP else nullcontext():
                    return await self._bodies.work(len(body) + more, put, context.owner, sha256, body)


def grid_router(grids: GridStore, receiver: Receiver, settings: Settings) -> APIRouter:
    """``PUT`` and ``HEAD``."""
    router = APIRouter(tags=["grids"], default_response_class=Response)
    limit = min(settings.max_body_bytes, 8 * settings.max_frequencies)
    body = "The frequencies in Hz, raw little-endian float64, increasing; their SHA-256 is the path."

    @router.put(
        "/v1/grids/{sha256}",
        responses=answers_with(GridDocument, 201) | answers_with(GridDocument),
        status_code=201,
        openapi_extra=binary_body(OCTETS, body),
    )
    async def upload_grid(request: Request, sha256: str) -> Response:
        """Upload a grid: raw little-endian float64 in Hz, increasing. 201 when it is new, 200 when it was here."""
        advice = f"Send the grid as {OCTETS}: raw little-endian float64."
        require_media_type(context_of(request.scope).headers, OCTETS, advice)
        grid, is_new = await receiver.receive(request, "grid", limit, grids.put)
        return data_response(request, GridDocument(sha256.lower(), len(grid)), 201 if is_new else 200)

    @router.head("/v1/grids/{sha256}", responses=FOUND_OR_NOT)
    async def find_grid(request: Request, sha256: str) -> Response:
        """Whether a grid is here; 404 when it has to be uploaded."""
        grids.get(context_of(request.scope).owner, sha256.lower())
        return Response(status_code=200)

    return router


def analysis_router(analyses: AnalysisStore, receiver: Receiver, settings: Settings, lifecycle: Lifecycle) -> APIRouter:
    """``PUT``, ``GET``, ``HEAD`` and ``DELETE``."""
    router = APIRouter(tags=["likelihoods"], default_response_class=Response)

    def put(owner: str, sha256: str, content: bytes) -> tuple[StoredAnalysis, bool]:
        lifecycle.check_accepting()
        return analyses.put(owner, sha256, content)

    body = "The analysis as `bnserve_protocol.encode_analysis` writes it; its digest is the path."

    @router.put(
        "/v1/analyses/{sha256}",
        responses=answers_with(AnalysisDocument, 201) | answers_with(AnalysisDocument),
        status_code=201,
        openapi_extra=binary_body(MSGPACK, body),
    )
    async def upload_analysis(request: Request, sha256: str) -> Response:
        """Upload an analysis. 201 when it is new to this caller, 200 when it was here."""
        require_media_type(context_of(request.scope).headers, MSGPACK, f"Send the analysis as {MSGPACK}.")
        stored, is_new = await receiver.receive(request, "analysis", settings.max_analysis_bytes, put)
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


def network_router(networks: NetworkStore, receiver: Receiver, settings: Settings, lifecycle: Lifecycle) -> APIRouter:
    """``PUT``, ``GET``, ``HEAD`` and ``DELETE``."""
    router = APIRouter(tags=["forecasts"], default_response_class=Response)

    def put(owner: str, sha256: str, content: bytes) -> tuple[StoredNetwork, bool]:
        lifecycle.check_accepting()
        return networks.put(owner, sha256, content)

    async def find(request: Request, sha256: str) -> StoredNetwork:
        """In a thread: what another worker received is made anew."""
        return await asyncio.to_thread(networks.get, context_of(request.scope).owner, sha256.lower())

    body = "Detectors with their noise; the SHA-256 of these bytes is the path."

    @router.put(
        "/v1/networks/{sha256}",
        responses=answers_with(NetworkDocument, 201) | answers_with(NetworkDocument),
        status_code=201,
        openapi_extra=named_body("NetworkBody", body),
    )
    async def upload_network(request: Request, sha256: str) -> Response:
        """Upload a network of detectors. 201 when it is new to this caller, 200 when it was here."""
        headers, advice = context_of(request.scope).headers, f"Send the network as {MSGPACK} or {JSON}."
        require_media_type(headers, MSGPACK, advice, JSON)
        stored, is_new = await receiver.receive(request, "network", settings.max_network_bytes, put, OFF_LOOP)
        return data_response(request, network_document(stored), 201 if is_new else 200)

    @router.get("/v1/networks/{sha256}", responses=answers_with(NetworkDocument))
    async def show_network(request: Request, sha256: str) -> Response:
        """What a network of this caller is; its curves are not told."""
        return data_response(request, network_document(await find(request, sha256)))

    @router.head("/v1/networks/{sha256}", responses=FOUND_OR_NOT)
    async def find_network(request: Request, sha256: str) -> Response:
        """Whether a network is here; 404 when it has to be uploaded."""
        await find(request, sha256)
        return Response(status_code=200)

    @router.delete("/v1/networks/{sha256}", responses=GONE, status_code=204)
    async def forget_network(request: Request, sha256: str) -> Response:
        """Forget a network of this caller."""
        networks.drop(context_of(request.scope).owner, sha256.lower())
        return Response(status_code=204)

    return router
