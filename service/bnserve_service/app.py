"""The composition root: every part of the service is made here and given to those who need it."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
from fastapi import APIRouter, FastAPI
from starlette.routing import Route
from starlette.types import ASGIApp, Receive, Scope, Send

from bnserve_protocol import Analysis, BnserveError, Likelihood, Unavailable, WaveformModel, decode_analysis
from bnserve_service.admission.control import Lifecycle, Phase
from bnserve_service.admission.queue import WorkQueue
from bnserve_service.admission.quotas import rate_quotas
from bnserve_service.evaluation.endpoint import PATHS, WaveformEndpoint
from bnserve_service.evaluation.fast_path import FastPath
from bnserve_service.evaluation.likelihood_endpoint import PATHS as LIKELIHOOD_PATHS
from bnserve_service.evaluation.likelihood_endpoint import LikelihoodEndpoint
from bnserve_service.evaluation.likelihood_evaluator import LikelihoodEvaluator, evaluating_both
from bnserve_service.evaluation.likelihoods import LikelihoodService
from bnserve_service.evaluation.service import WaveformService
from bnserve_service.evaluation.waveforms import Evaluator
from bnserve_service.http.access import AccessMiddleware
from bnserve_service.http.body import BodyReader
from bnserve_service.http.dispatch import Dispatcher
from bnserve_service.http.front import RequestContextMiddleware
from bnserve_service.http.hosts import HostCheck, HostMiddleware
from bnserve_service.models.loading import Loader, Selection
from bnserve_service.models.maintenance import Health, Maintenance
from bnserve_service.models.registry import ModelFactory, ModelSource, Registry, SharedModels
from bnserve_service.process.cpu import available_cpus
from bnserve_service.reference.explorer import explorer_router
from bnserve_service.reference.openapi import openapi_document
from bnserve_service.reference.openapi_likelihoods import with_likelihoods
from bnserve_service.routes.analyses import analysis_router
from bnserve_service.routes.grids import grid_router
from bnserve_service.routes.health import health_router
from bnserve_service.routes.limits import limits_router
from bnserve_service.routes.manifests import manifest_router
from bnserve_service.routes.metrics import metrics_router
from bnserve_service.routes.models import model_router
from bnserve_service.settings import Settings
from bnserve_service.shared.metrics import SharedMetrics
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.blobs import gone
from bnserve_service.uploads.storage_quotas import StorageQuotas
from bnserve_service.uploads.stores import AnalysisStore, GridStore, LikelihoodFactory


@dataclass(frozen=True, slots=True)
class Parts:
    """Everything a running service consists of."""

    settings: Settings
    registry: Registry
    grids: GridStore
    analyses: AnalysisStore
    queue: WorkQueue[Any, Any]
    waveforms: WaveformService
    likelihoods: LikelihoodService
    lifecycle: Lifecycle
    health: Health
    maintenance: Maintenance
    metrics: Metrics
    bodies: BodyReader
    shared: Path | None = None
    """What all worker processes of one server share, as :func:`create_app` says."""


class Application(FastAPI):
    """The ASGI application; ``parts`` gives operators and tests what is inside.

    Parameters
    ----------
    parts:
        What it serves with.
    wait_for_models:
        Whether start-up waits for the models; a server listens at once and says ``model-loading`` meanwhile.
    follow:
        Whether it looks at the stores at all.
    """

    def __init__(self, parts: Parts, wait_for_models: bool, follow: bool = True) -> None:
        super().__init__(
            title="bnserve",
            docs_url=None,  # ours works offline
            redoc_url=None,
            openapi_url=None,  # ours knows the bodies
            redirect_slashes=False,
            max_body_size=None,  # read_body counts, and answers in our own form
            lifespan=_lifespan,
        )
        self.parts = parts
        self.wait_for_models = wait_for_models
        self.follow = follow
        evaluations = dict.fromkeys(
            PATHS, WaveformEndpoint(parts.waveforms, parts.settings, parts.bodies)
        ) | dict.fromkeys(LIKELIHOOD_PATHS, LikelihoodEndpoint(parts.likelihoods, parts.settings, parts.bodies))
        routers = self._routers()
        routes = [route for router in routers for route in router.routes if isinstance(route, Route)]
        dispatcher = Dispatcher(evaluations, routes)
        tokens = parts.settings.tokens
        quotas = rate_quotas(tokens, parts.shared)
        access = AccessMiddleware(dispatcher, tokens, quotas, parts.queue.turns.turn) if tokens else None
        hosts = HostCheck.of(parts.settings)
        self._front = RequestContextMiddleware(
            HostMiddleware(access or dispatcher, hosts),
            dispatcher.find,
            parts.metrics,
            parts.lifecycle,
            parts.settings.access_log,
        )
        self.metrics = _metrics_alone(parts)
        """The application of the metrics port, if there is one."""
        self.fast_path = FastPath(parts.waveforms, parts.lifecycle, self._front, hosts, access)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve: HTTP through our own middlewares, the rest (the lifespan) through FastAPI's."""
        await (self._front if scope["type"] == "http" else super().__call__)(scope, receive, send)

    def _routers(self) -> list[APIRouter]:
        """The routers of all paths but those of evaluations, which FastAPI describes and does not serve.

        Its router would match every path again, and its exception middlewares answer errors in a form of their own.
        """
        parts, limits = self.parts, self.parts.settings.limits()
        stored = StorageQuotas(parts.settings.tokens, {"grid": parts.grids, "analysis": parts.analyses}, parts.shared)
        largest_grid = min(parts.settings.max_body_bytes, 8 * parts.settings.max_frequencies)
        largest_analysis = parts.settings.max_analysis_bytes
        routers = [
            model_router(parts.registry, limits),
            limits_router(limits),
            manifest_router(parts.registry, limits, parts.maintenance),
            grid_router(parts.grids, parts.waveforms, parts.bodies, largest_grid, stored),
            analysis_router(parts.analyses, parts.likelihoods, parts.bodies, largest_analysis, stored),
            health_router(parts.health),
        ]
        if parts.settings.metrics_port is None:
            routers.append(metrics_router(parts.metrics))
        for router in routers:
            self.include_router(router)
        described = openapi_document(self, PATHS, bool(parts.settings.tokens))
        document = msgspec.json.encode(with_likelihoods(described, LIKELIHOOD_PATHS))
        return [*routers, explorer_router(document)]


def _metrics_alone(parts: Parts) -> ASGIApp:
    dispatcher = Dispatcher({}, [route for route in metrics_router(parts.metrics).routes if isinstance(route, Route)])
    return RequestContextMiddleware(
        HostMiddleware(dispatcher, HostCheck.of_metrics(parts.settings)),
        dispatcher.find,
        parts.metrics,
        parts.lifecycle,
        parts.settings.access_log,
    )


@asynccontextmanager
async def _lifespan(app: Any) -> AsyncIterator[None]:
    parts: Parts = app.parts
    parts.queue.start()
    if app.follow:
        parts.maintenance.start()
    if app.wait_for_models:
        await parts.maintenance.first_look()
    try:
        yield
    finally:
        await parts.maintenance.stop()
        parts.queue.stop(timeout=0.0 if parts.lifecycle.phase is Phase.ABORTING else 10.0)
        parts.waveforms.close()
        parts.likelihoods.close()


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
    settings:
        By default, those of :class:`Settings`.
    source:
        Where models come from; by default the stores of the settings and the models shipped with bnserve.
    factory:
        Builds a model from what the source loads; by default ``bnserve_surrogate.Model.from_artifact``. Any
        ``WaveformModel`` that has ``warm_up`` and ``self_check`` can be served.
    bind:
        Makes the likelihood of an analysis with a model; by default ``bnserve_inference.likelihood``.
    wait_for_models:
        Whether start-up (the ASGI lifespan) waits until the models are loaded.
    shared:
        A folder, in memory where there is such a thing, that all worker processes of one server share and that outlives
        each of them; None for a server of one process.
    worker:
        Which of those processes this is; it goes on counting where the one with the same number before it ended.
    registry:
        Models that are there already.
    follow:
        Whether the stores are looked at; otherwise there are no models but those of ``registry``.
    """
    settings, registry = settings or Settings(), registry or Registry()
    loader = loader_of(settings, registry, source, factory)
    parts = _parts(settings, registry, loader, bind or _likelihood, shared, worker)
    _watch(parts)
    return Application(parts, wait_for_models, follow)


def _parts(
    settings: Settings,
    registry: Registry,
    loader: Loader,
    bind: LikelihoodFactory,
    shared: Path | None,
    worker: int,
) -> Parts:
    lifecycle = Lifecycle()
    metrics = Metrics(SharedMetrics(shared, worker) if shared is not None else None)
    grids = GridStore(settings, shared)
    analyses = AnalysisStore(settings, decode_analysis, shared)
    workers = settings.threads or available_cpus()
    queue = _queue(settings, metrics, bind, workers)
    health = _health(settings, registry, lifecycle, queue, shared)
    maintenance = Maintenance(loader, registry, health, metrics, settings.poll_seconds, settings.self_check_seconds)
    if shared is not None:
        registry.join(SharedModels(shared, worker), maintenance.poke)
    return Parts(
        settings=settings,
        registry=registry,
        grids=grids,
        analyses=analyses,
        queue=queue,
        waveforms=WaveformService(settings, registry, grids, queue, lifecycle),
        likelihoods=LikelihoodService(settings, registry, analyses, queue, lifecycle, workers),
        lifecycle=lifecycle,
        health=health,
        maintenance=maintenance,
        metrics=metrics,
        bodies=BodyReader(settings.incoming_bytes, settings.body_timeout),
        shared=shared,
    )


def _queue(settings: Settings, metrics: Metrics, bind: LikelihoodFactory, workers: int) -> WorkQueue[Any, Any]:
    return WorkQueue(
        evaluating_both(Evaluator(metrics), LikelihoodEvaluator(metrics, bind)),
        workers=workers,
        capacity=settings.queue_samples,
        group_cost=settings.group_samples,
        metrics=metrics,
    )


def _health(
    settings: Settings, registry: Registry, lifecycle: Lifecycle, queue: WorkQueue[Any, Any], shared: Path | None
) -> Health:
    return Health(
        registry,
        lifecycle,
        queue.workers.longest_evaluation,
        settings.self_check_seconds,
        settings.stuck_seconds,
        lambda: _missing(settings, shared),
    )


def _missing(settings: Settings, shared: Path | None) -> BnserveError | None:
    """What somebody has removed of what this server needs."""
    if shared is not None and not shared.is_dir():
        return gone()
    if settings.uds is not None and not settings.uds.exists():
        return Unavailable("The file of this server's Unix socket is gone, and nobody can connect: start it again.")
    return None


def loader_of(
    settings: Settings, registry: Registry, source: ModelSource | None = None, factory: ModelFactory | None = None
) -> Loader:
    """What loads the models of the settings into a registry; ``source`` and ``factory`` as for :func:`create_app`."""
    return Loader(registry, source or _stores(settings), factory or _surrogate, Selection(settings.models))


def _watch(parts: Parts) -> None:
    """Show what operators look at, the first things first."""
    metrics, queue, analyses = parts.metrics, parts.queue, parts.analyses
    ready = "1 when the ready path answers 200"
    metrics.watch("bnserve_ready", ready, lambda: float(parts.health.reason_unready() is None), is_common=True)
    metrics.watch("bnserve_queue_samples", "Work waiting or running, in samples", lambda: queue.cost)
    metrics.watch("bnserve_queue_jobs", "Requests that no worker has taken yet", lambda: queue.workers.waiting)
    metrics.watch("bnserve_queue_capacity_samples", "Work that may wait or run", lambda: parts.settings.queue_samples)
    metrics.watch("bnserve_answers_bytes", "Memory of answers under way", lambda: parts.waveforms.answer_bytes)
    metrics.watch("bnserve_grids_bytes", "Memory of uploaded grids", lambda: parts.grids.stored_bytes, is_common=True)
    metrics.watch("bnserve_analyses", "Uploaded analyses", lambda: len(analyses), is_common=True)
    metrics.watch(
        "bnserve_analyses_bytes", "Memory of uploaded analyses", lambda: analyses.stored_bytes, is_common=True
    )
    metrics.watch("bnserve_uploads_bytes", "Memory of large bodies on their way", lambda: parts.bodies.held_bytes)
    if parts.shared is None:
        metrics.watch("bnserve_workers", "Worker processes", lambda: 1.0)


def _stores(settings: Settings) -> ModelSource:
    from bnserve_store import ModelStore

    return ModelStore.default(settings.stores)


def _surrogate(artifact: Any) -> Any:
    from bnserve_surrogate import Model  # here, because it compiles: a custom factory need not pay for it

    return Model.from_artifact(artifact)


def _likelihood(model: WaveformModel, analysis: Analysis) -> Likelihood:
    from bnserve_inference import likelihood  # here, because a server that only serves waveforms need not load it

    return likelihood(model, analysis)
