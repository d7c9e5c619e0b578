"""Whether this server should get traffic, and what goes on in the background: following stores, checking models."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from bnserve_protocol import BnserveError, Draining, ModelLoading, Overloaded, Unavailable
from bnserve_service.admission.control import Lifecycle
from bnserve_service.models.loading import Loader, RefreshReport
from bnserve_service.models.registry import Catalogue, LoadedModel, Registry
from bnserve_service.process.allocator import give_back_freed_memory
from bnserve_service.settings import Settings
from bnserve_service.telemetry.metrics import Metrics

logger = logging.getLogger("bnserve.models")

_MEMORY_SECONDS = 30.0
"""How often memory is given back: its pages cost a few milliseconds when they are used again."""
STALE_CHECKS = 6.0
"""Missed self checks after which the last good one counts no more."""
LEAST_STALE_SECONDS = 10.0
"""However often it is checked: busy machines pause."""


class Health:
    """Answers the probes from memory, so that they are never shed, whatever the load.

    Parameters
    ----------
    settings
        How often the models are checked, and which evaluation will not come back.
    registry, lifecycle
        What is served, and whether the server is stopping.
    longest_evaluation
        Seconds that the slowest worker has been busy.
    missing
        Says what this server cannot do without and has lost.
    """

    def __init__(
        self,
        settings: Settings,
        registry: Registry,
        lifecycle: Lifecycle,
        longest_evaluation: Callable[[], float],
        missing: Callable[[], BnserveError | None],
    ) -> None:
        self._missing = missing
        self._registry = registry
        self._lifecycle = lifecycle
        self._longest_evaluation = longest_evaluation
        self._stuck_seconds = settings.stuck_seconds
        self._stale_after = max(STALE_CHECKS * settings.self_check_seconds, LEAST_STALE_SECONDS)
        self._wrong: dict[LoadedModel, str] = {}
        self._checked = time.monotonic()

    def check_models(self) -> None:
        """Evaluate every default model's stored example; what is wrong stays unready until it is right again."""
        wrong: dict[LoadedModel, str] = {}
        for loaded in self._registry.catalogue.defaults():
            try:
                if not loaded.model.self_check():
                    wrong[loaded] = "does not reproduce the answer stored with it"
            except Exception:
                logger.exception("the self check of %s failed", loaded.identity.name)
                wrong[loaded] = "fails its self check"
        self._wrong = wrong
        self._checked = time.monotonic()

    def reason_unready(self) -> BnserveError | None:
        """Why this server should not get traffic, or None."""
        if self._lifecycle.draining:
            return Draining("This server is shutting down.")
        missing = self._missing()
        if missing is not None:
            return missing
        if not self._registry.loaded:
            return ModelLoading("The models are being loaded.")
        if not self._registry.catalogue.models:
            return ModelLoading("No model could be loaded; the log and `bnserve models verify` say why.")
        if time.monotonic() - self._checked > self._stale_after:
            return Unavailable("The self check of the models has not run for too long.")
        if self._longest_evaluation() > self._stuck_seconds:
            return Overloaded("A worker does not come back from its evaluation.")
        for loaded, reason in self._wrong.items():
            return Unavailable(f"Model '{loaded.identity.name}' {reason}.")
        return None

    def reason_model_unready(self, name: str) -> BnserveError | None:
        """Why this model should not get traffic here, or None."""
        reason = self.reason_unready()
        if reason is not None:
            return reason
        try:
            self._registry.find(name)
        except BnserveError as error:
            return error
        return None


class Maintenance:
    """Loads the models once, then looks at the stores every few seconds or when poked, and checks what is served.

    Parameters
    ----------
    loader, registry, health, metrics
        Who does the work and where it shows.
    settings
        How often.
    """

    def __init__(
        self, loader: Loader, registry: Registry, health: Health, metrics: Metrics, settings: Settings
    ) -> None:
        self._loader = loader
        self._registry = registry
        self._health = health
        self._metrics = metrics
        self._poll_seconds = settings.poll_seconds
        self._check_seconds = settings.self_check_seconds
        self._threads = ThreadPoolExecutor(2, thread_name_prefix="bnserve-maintenance")
        self._poked = asyncio.Event()
        self._first_look = asyncio.Event()
        self._tasks: list[asyncio.Task[None]] = []
        self._told: dict[str, str] = {}
        self._shown: Catalogue | None = None
        self.last_report = RefreshReport()
        """What the latest look at the stores found."""

    def source_is_there(self) -> None:
        """Raise ``StoreUnknown`` when the stores cannot be listed, before anything is started."""
        self._loader.list_source()

    def start(self) -> None:
        """Begin loading."""
        loop = asyncio.get_running_loop()
        work = (self._follow_stores, self._check_models, self._give_memory_back)
        self._tasks = [loop.create_task(each()) for each in work]

    async def first_look(self) -> RefreshReport:
        """Wait until the stores have been read once; the report says what came of it."""
        await self._first_look.wait()
        return self.last_report

    def poke(self) -> None:
        """Look at the stores now, and again at what was refused before."""
        self._poked.set()

    async def stop(self) -> None:
        """End the background work."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        self._threads.shutdown(wait=False, cancel_futures=True)

    async def refresh(self, force: bool = False) -> RefreshReport:
        """Look at the stores once."""
        loop = asyncio.get_running_loop()
        report = await loop.run_in_executor(self._threads, self._loader.refresh, force)
        self.last_report = report
        self._tell(report)
        return report

    async def _follow_stores(self) -> None:
        force = False
        while True:
            try:
                await self.refresh(force)
            except Exception:
                logger.exception("looking at the model stores failed; what was served goes on being served")
                self.last_report = RefreshReport(failures={"store": "it cannot be read; the log says why."})
            if not self._first_look.is_set():  # or what took long to load would be stale until the first check
                await asyncio.get_running_loop().run_in_executor(self._threads, self._health.check_models)
                self._first_look.set()
            try:
                async with asyncio.timeout(self._poll_seconds):
                    await self._poked.wait()
                force = True
                self._poked.clear()
            except TimeoutError:
                force = False

    async def _check_models(self) -> None:
        loop = asyncio.get_running_loop()
        await self._first_look.wait()
        while True:
            await asyncio.sleep(self._check_seconds)
            await loop.run_in_executor(self._threads, self._health.check_models)

    async def _give_memory_back(self) -> None:
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(_MEMORY_SECONDS)
            await loop.run_in_executor(self._threads, give_back_freed_memory)

    def _tell(self, report: RefreshReport) -> None:
        for identity in report.loaded:
            logger.info("serving %s %s (%s)", identity.name, identity.version, identity.digest)
        for identity in report.dropped:
            logger.info("no longer serving %s %s", identity.name, identity.version)
        for what, reason in report.failures.items():
            if self._told.get(what) != reason:
                logger.error("not serving %s: %s", what, reason)
        self._told = dict(report.failures)
        catalogue = self._registry.catalogue
        if catalogue is not self._shown:  # at the first look, too: a worker has its models before it looks
            self._shown = catalogue
            self._metrics.show_models({key: loaded.identity for key, loaded in catalogue.models.items()})
        outcome = "failed" if report.failures else "changed" if report.changed else "unchanged"
        self._metrics.reloads.labels(outcome).inc()
