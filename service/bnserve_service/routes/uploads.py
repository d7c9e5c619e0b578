"""``/v1/grids/{sha256}``, ``/v1/analyses/{sha256}`` and ``/v1/networks/{sha256}``: uploaded once, and named by their
digest."""

from __future__ import annotations

import asyncio
from contextlib import nullcontext
from typing import Any, TypeVar

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
from bnserve_service.uploads.analyses import AnalysisStore
from bnserve_service.uploads.grids import GridStore
from bnserve_service.uploads.networks import NetworkStore
from bnserve_service.uploads.storage_quotas import StorageQuotas
from bnserve_service.uploads.stores import UploadStore

T = TypeVar("T")


class Receiver:
    """Receives what is uploaded, and finds it.

    Parameters
    ----------
    bodies
        Reads it.
    quotas
        How much each token may keep.
    lifecycle
        Whether anything is accepted.
    """

    def __init__(self, bodies: BodyReader, quotas: StorageQuotas, lifecycle: Lifecycle) -> None:
        self._bodies = bodies
        self._quotas = quotas
        self._lifecycle = lifecycle
        self._large = asyncio.Lock()
        """Held by an upload that takes long: all of them have one thread, so that questions have one, too."""

    async def receive(self, request: Request, store: UploadStore[T], limit: int) -> tuple[T, bool]:
        """Read a body of at most ``limit`` bytes and keep it under its owner and the digest in its path; also whether
        it is new."""
        context = context_of(request.scope)
        sha256 = _digest(request)
        with self._bodies.of(context) as incoming:
            body = await incoming.read(request.receive, limit)
            await incoming.name(body)
            work = len(body) + store.further_work
            with self._quotas.room(context.owner, store.kind, sha256, len(body)):
                async with self._large if work > OFF_LOOP else nullcontext():
                    self._lifecycle.check_accepting()
                    return await self._bodies.work(work, store.put, context.owner, sha256, body)

    async def find(self, request: Request, store: UploadStore[T]) -> T:
        """What this caller means, in a thread if another worker received it and it is large."""
        owner, sha256 = context_of(request.scope).owner, _digest(request)
        return await self._bodies.work(store.bytes_to_read(owner, sha256), store.get, owner, sha256)


def _digest(request: Request) -> str:
    sha256: str = request.path_params["sha256"]
    return sha256.lower()


def grid_router(grids: GridStore, receiver: Receiver, settings: Settings) -> APIRouter:
    """``PUT`` and ``HEAD``."""
    router, path = APIRouter(tags=["grids"], default_response_class=Response), "/v1/grids/{sha256}"
    limit = min(settings.max_body_bytes, 8 * settings.max_frequencies)
    body = "The frequencies in Hz, raw little-endian float64, increasing; their SHA-256 is the path."

    @router.put(
        path,
        responses=answers_with(GridDocument, 201) | answers_with(GridDocument),
        status_code=201,
        openapi_extra=binary_body(OCTETS, body),
    )
    async def upload_grid(request: Request, sha256: str) -> Response:
        """Upload a grid: raw little-endian float64 in Hz, increasing. 201 when it is new, 200 when it was here."""
        advice = f"Send the grid as {OCTETS}: raw little-endian float64."
        require_media_type(context_of(request.scope).headers, OCTETS, advice)
        grid, is_new = await receiver.receive(request, grids, limit)
        return data_response(request, GridDocument(_digest(request), len(grid)), 201 if is_new else 200)

    _add_head(router, path, "a grid", grids, receiver)
    return router


def analysis_router(analyses: AnalysisStore, receiver: Receiver, settings: Settings) -> APIRouter:
    """``PUT``, ``GET``, ``HEAD`` and ``DELETE``."""
    router, path = APIRouter(tags=["likelihoods"], default_response_class=Response), "/v1/analyses/{sha256}"
    body = "The analysis as `bnserve_protocol.encode_analysis` writes it; its digest is the path."

    @router.put(
        path,
        responses=answers_with(AnalysisDocument, 201) | answers_with(AnalysisDocument),
        status_code=201,
        openapi_extra=binary_body(MSGPACK, body),
    )
    async def upload_analysis(request: Request, sha256: str) -> Response:
        """Upload an analysis. 201 when it is new to this caller, 200 when it was here."""
        require_media_type(context_of(request.scope).headers, MSGPACK, f"Send the analysis as {MSGPACK}.")
        stored, is_new = await receiver.receive(request, analyses, settings.max_analysis_bytes)
        return data_response(request, analysis_document(stored), 201 if is_new else 200)

    @router.get(path, responses=answers_with(AnalysisDocument))
    async def show_analysis(request: Request, sha256: str) -> Response:
        """What is known about an analysis of this caller; its data are not told."""
        return data_response(request, analysis_document(await receiver.find(request, analyses)))

    _add_head(router, path, "an analysis", analyses, receiver)
    _add_delete(router, path, "an analysis", analyses)
    return router


def network_router(networks: NetworkStore, receiver: Receiver, settings: Settings) -> APIRouter:
    """``PUT``, ``GET``, ``HEAD`` and ``DELETE``."""
    router, path = APIRouter(tags=["forecasts"], default_response_class=Response), "/v1/networks/{sha256}"
    body = "Detectors with their noise; the SHA-256 of these bytes is the path."

    @router.put(
        path,
        responses=answers_with(NetworkDocument, 201) | answers_with(NetworkDocument),
        status_code=201,
        openapi_extra=named_body("NetworkBody", body),
    )
    async def upload_network(request: Request, sha256: str) -> Response:
        """Upload a network of detectors. 201 when it is new to this caller, 200 when it was here."""
        headers, advice = context_of(request.scope).headers, f"Send the network as {MSGPACK} or {JSON}."
        require_media_type(headers, MSGPACK, advice, JSON)
        stored, is_new = await receiver.receive(request, networks, settings.max_network_bytes)
        return data_response(request, network_document(stored), 201 if is_new else 200)

    @router.get(path, responses=answers_with(NetworkDocument))
    async def show_network(request: Request, sha256: str) -> Response:
        """What a network of this caller is; its curves are not told."""
        return data_response(request, network_document(await receiver.find(request, networks)))

    _add_head(router, path, "a network", networks, receiver)
    _add_delete(router, path, "a network", networks)
    return router


def _add_head(router: APIRouter, path: str, noun: str, store: UploadStore[Any], receiver: Receiver) -> None:
    says = f"Whether {noun} is here; 404 when it has to be uploaded."

    @router.head(path, responses=FOUND_OR_NOT, name=f"find_{store.kind}", description=says)
    async def find(request: Request, sha256: str) -> Response:
        await receiver.find(request, store)
        return Response(status_code=200)


def _add_delete(router: APIRouter, path: str, noun: str, store: UploadStore[Any]) -> None:
    says = f"Forget {noun} of this caller."

    @router.delete(path, responses=GONE, status_code=204, name=f"forget_{store.kind}", description=says)
    async def forget(request: Request, sha256: str) -> Response:
        store.drop(context_of(request.scope).owner, _digest(request))
        return Response(status_code=204)
