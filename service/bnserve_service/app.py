"""The composition root: every part of the service is made here, by its room, and given to those who need it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
from fastapi import APIRouter, FastAPI
from starlette.routing import Route
from starlette.types import Receive, Scope, Send

from bnserve_protocol import BnserveError, Unavailable
from bnserve_service.admission.control import Lifecycle, Phase
from bnserve_service.admission.token_book import TokenBook
from bnserve_service.evaluation.endpoint import EvaluationEndpoint, FastPath
from bnserve_service.evaluation.kinds import all_kinds
from bnserve_service.evaluation.questions import Kind
from bnserve_service.evaluation.service import EvaluationService
from bnserve_service.http.access import METRICS, HostCheck, TokenCheck, is_public
from bnserve_service.http.access_log import AccessLog
from bnserve_service.http.body import BodyReader
from bnserve_service.http.cors import CrossOrigin
from bnserve_service.http.front import Front, Listener, places_of
from bnserve_service.http.tracing import Tracing
from bnserve_service.models.loading import loader_of
from bnserve_service.models.maintenance import Health, Maintenance
from bnserve_service.models.registry import ModelFactory, ModelSource, Registry, SharedModels
from bnserve_service.process.renewals import Renewals
from bnserve_service.reference.explorer import explorer_router
from bnserve_service.reference.openapi import openapi_document
from bnserve_service.routes.models import model_router
from bnserve_service.routes.operations import health_router, metrics_router, reload_router
from bnserve_service.routes.umbridge import umbridge_router
from bnserve_service.routes.uploads import Receiver, analysis_router, grid_router, network_router
from bnserve_service.settings import Settings
from bnserve_service.shared.metrics import SharedMetrics
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.analyses import LikelihoodFactory
from bnserve_service.uploads.blobs import gone
from bnserve_service.uploads.storage_quotas import StorageQuotas
from bnserve_service.uploads.uploads import Uploads


@dataclass(frozen=True, slots=True)
class Parts:
    """Everything a running service consists of."""

    settings: Settings
    registry: Registry
    uploads: Uploads
    kinds: tuple[Kind[Any], ...]
    evaluation: EvaluationService
    lifecycle: Lifecycle
    health: Health
    maintenance: Maintenance
    metrics: Metrics
    bodies: BodyReader
    tokens: TokenBook | None
    renewals: Renewals
    tracing: Tracing | None
    shared: Path | None = None
    """What all worker processes of one server share, and which of them this is, as :func:`create_app` says."""
    worker: int = 0

    def look_again(self) -> None:
        """Read now what is read from time to time: stores, tokens, certificates. For the event loop."""
        self.maintenance.poke()
        self.renewals.poke()


class Application(FastAPI):
    """The ASGI application; ``parts`` gives operators and tests what is inside.

    Parameters
    ----------
    parts
        What it serves with.
    wait_for_models
        Whether start-up waits for the models; a server listens at once and says ``model-loading`` meanwhile.
    follow
        Whether it looks at the stores at all.
    """

    def __init__(self, parts: Parts, wait_for_models: bool, follow: bool = True) -> None:
        super().__init__(
            title="bnserve",
            docs_url=None,  # ours works offline
            redoc_url=None,
            openapi_url=None,  # ours knows the bodies
            redirect_slashes=False,
            max_body_size=None,  # bodies are counted by their reader, which answers in our own form
            lifespan=_lifespan,
        )
        self.parts = parts
        self.wait_for_models = wait_for_models
        self.follow = follow
        settings = parts.settings
        self.front = _front(parts, self._routers(), parts.kinds, HostCheck.of(settings), parts.tokens)
        """What a server calls: HTTP is served by ourselves, the rest (the lifespan) by FastAPI."""
        self.front.others = super().__call__
        beside = [metrics_router(parts.metrics)]
        if settings.reload_is_apart:
            beside.append(reload_router(parts.maintenance, parts.renewals))
        tokens = None if settings.metrics_uds is not None else parts.tokens
        self.metrics = _front(parts, beside, (), HostCheck.of_metrics(settings), tokens, lambda route: route == METRICS)
        """The application of the metrics port, if there is one."""
        self.fast_path = FastPath(parts.kinds, parts.evaluation, parts.lifecycle, self.front)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve, in a server of somebody else's."""
        await self.front(scope, receive, send)

    def _routers(self) -> list[APIRouter]:
        """The routers of all paths but those of evaluations, which FastAPI describes and does not serve.

        Its router would match every path again, and its exception middlewares answer errors in a form of their own.
        """
        parts, settings, uploads = self.parts, self.parts.settings, self.parts.uploads
        most = parts.tokens.stored_bytes if parts.tokens is not None else _no_limit
        receiver = Receiver(parts.bodies, StorageQuotas(most, uploads.by_kind, parts.shared), parts.lifecycle)
        routers = [
            model_router(parts.registry, settings.limits()),
            grid_router(uploads.grids, receiver, settings),
            analysis_router(uploads.analyses, receiver, settings),
            network_router(uploads.networks, receiver, settings),
            umbridge_router(parts.registry, uploads.analyses, parts.bodies, settings),
            health_router(parts.health),
        ]
        if not settings.reload_is_apart:
            routers.insert(1, reload_router(parts.maintenance, parts.renewals))
        if settings.metrics_uds is None and settings.metrics_port is None:
            routers.append(metrics_router(parts.metrics))
        for router in routers:
            self.include_router(router)
        operations = {path: kind.operation for kind in parts.kinds for path in kind.paths}
        document = openapi_document(self, operations, settings.asks_for_tokens)
        return [*routers, explorer_router(msgspec.json.encode(document))]


def _front(
    parts: Parts,
    routers: list[APIRouter],
    kinds: tuple[Kind[Any], ...],
    hosts: HostCheck,
    tokens: TokenBook | None,
    public: Callable[[str], bool] = is_public,
) -> Front:
    evaluations = {
        path: EvaluationEndpoint(kind, parts.evaluation, parts.settings, parts.bodies)
        for kind in kinds
        for path in kind.paths
    }
    routes = [route for router in routers for route in router.routes if isinstance(route, Route)]
    listeners: list[Listener] = [AccessLog()] if parts.settings.access_log else []
    if parts.tracing is not None and kinds:  # of what callers ask, not of the metrics beside it
        listeners.append(parts.tracing)
    return Front(
        places_of(evaluations, routes),
        hosts,
        TokenCheck(tokens) if tokens is not None else None,
        parts.evaluation.queue.turns.turn,
        parts.metrics,
        parts.lifecycle,
        listeners,
        CrossOrigin(parts.settings.cors_origins) if parts.settings.cors_origins else None,
        public,
    )


@asynccontextmanager
async def _lifespan(app: Any) -> AsyncIterator[None]:
    parts: Parts = app.parts
    parts.evaluation.queue.start()
    parts.renewals.start()
    if parts.tracing is not None:
        parts.tracing.start()
    if app.follow:
        parts.maintenance.start()
    if app.wait_for_models:
        await parts.maintenance.first_look()
    try:
        yield
    finally:
        await parts.maintenance.stop()
        await parts.renewals.stop()
        parts.evaluation.queue.stop(timeout=0.0 if parts.lifecycle.phase is Phase.ABORTING else 10.0)
        parts.bodies.close()
        if parts.tracing is not None and parts.lifecycle.phase is not Phase.ABORTING:
            await asyncio.to_thread(parts.tracing.stop)


def create_app(
    settings: Settings | None = None,
    *,
    source: ModelSource | None = None,
    factory: ModelFactory | None = None,
    bind: LikelihoodFactory | None = None,
    wait_for_models: bool = True,
    shared: Path | None = None,
    worker: int = 0,
    registry: Registry | None = None,
    follow: bool = True,
) -> Application:
    """Build the service.

    Parameters
    ----------
    settings
        By default, those of :class:`Settings`.
    source
        Where models come from; by default the stores of the settings and the models shipped with bnserve.
    factory
        Builds a model from what the source loads; by default ``bnserve_surrogate.Model.from_artifact``. Any
        ``WaveformModel`` that has ``warm_up`` and ``self_check`` can be served.
    bind
        Makes the likelihood of an analysis with a model; by default ``bnserve_inference.likelihood``.
    wait_for_models
        Whether start-up (the ASGI lifespan) waits until the models are loaded.
    shared
        A folder, in memory where there is such a thing, that all worker processes of one server share and that outlives
        each of them; None for a server of one process.
    worker
        Which of those processes this is; it goes on counting where the one with the same number before it ended.
    registry
        Models that are there already.
    follow
        Whether the stores are looked at; otherwise there are no models but those of ``registry``.
    """
    settings, registry = settings or Settings(), registry or Registry()
    metrics = Metrics(SharedMetrics(shared, worker) if shared is not None else None)
    lifecycle, bodies = Lifecycle(), BodyReader(settings.incoming_bytes, settings.body_timeout)
    uploads = Uploads.of(settings, shared)
    evaluation = EvaluationService(settings, registry, lifecycle, bodies, metrics)
    longest, missing = evaluation.queue.workers.longest_evaluation, partial(_missing, settings, shared)
    health = Health(settings, registry, lifecycle, longest, missing)
    maintenance = Maintenance(loader_of(settings, registry, source, factory), registry, health, metrics, settings)
    if shared is not None:
        registry.join(SharedModels(shared, worker), maintenance.poke)
    tokens = TokenBook(settings.token_files(), shared, settings.issuers) if settings.asks_for_tokens else None
    renewals = Renewals(settings.poll_seconds)
    for renew in tokens.renewals if tokens is not None else ():
        renewals.add(renew)
    parts = Parts(
        settings=settings,
        registry=registry,
        uploads=uploads,
        kinds=all_kinds(uploads, settings.limits(), metrics, bind),
        evaluation=evaluation,
        lifecycle=lifecycle,
        health=health,
        maintenance=maintenance,
        metrics=metrics,
        bodies=bodies,
        tokens=tokens,
        renewals=renewals,
        tracing=Tracing.of(settings),
        shared=shared,
        worker=worker,
    )
    _watch(parts)
    return Application(parts, wait_for_models, follow)


def _no_limit(owner: str) -> None:
    """How much somebody may keep who is nobody in particular."""


def _missing(settings: Settings, shared: Path | None) -> BnserveError | None:
    """What somebody has removed of what this server needs."""
    if shared is not None and not shared.is_dir():
        return gone()
    if settings.uds is not None and not settings.uds.exists():
        return Unavailable("The file of this server's Unix socket is gone, and nobody can connect: start it again.")
    return None


def _watch(parts: Parts) -> None:
    """Show what operators look at, the first things first."""
    metrics, ready = parts.metrics, "1 when the ready path answers 200"
    metrics.watch("bnserve_ready", ready, lambda: float(parts.health.reason_unready() is None), is_common=True)
    parts.evaluation.watch(metrics)
    parts.uploads.watch(metrics)
    metrics.watch("bnserve_uploads_bytes", "Memory of large bodies on their way", lambda: parts.bodies.held_bytes)
    metrics.watch_each(
        "bnserve_token_expires_timestamp_seconds",
        "When a token of the settings or of a file ends, as Unix time, for those that do",
        "token",
        parts.tokens.ends if parts.tokens is not None else dict,
    )
    if parts.shared is None:
        metrics.watch("bnserve_workers", "Worker processes", lambda: 1.0)
