"""What goes on in the background: following the stores, checking the models, giving memory back."""

from __future__ import annotations

import asyncio
import logging
from concurrent.futures import ThreadPoolExecutor

from bnserve_service.models.health import Health
from bnserve_service.models.loading import Loader, RefreshReport
from bnserve_service.models.registry import Registry
from bnserve_service.process.allocator import give_back_freed_memory
from bnserve_service.telemetry.metrics import Metrics

logger = logging.getLogger("bnserve.models")

_MEMORY_SECONDS = 30.0
"""How often memory is given back: its pages cost a few milliseconds when they are used again."""


class Maintenance:
    """Loads the models once, then looks at the stores every few seconds or when poked, and checks what is served.

    Parameters
    ----------
    loader, registry, health, metrics:
        Who does the work and where it shows.
    poll_seconds, check_seconds:
        How often.
    """

    def __init__(
        self,
        loader: Loader,
        registry: Registry,
        health: Health,
        metrics: Metrics,
        poll_seconds: float,
        check_seconds: float,
    ) -> None:
        self._loader = loader
        self._registry = registry
        self._health = health
        self._metrics = metrics
        self._poll_seconds = poll_seconds
        self._check_seconds = check_seconds
        self._threads = ThreadPoolExecutor(2, thread_name_prefix="bnserve-maintenance")
        self._poked = asyncio.Event()
        self._first_look = asyncio.Event()
        self._tasks: list[asyncio.Task[None]] = []
        self._told: dict[str, str] = {}
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
        if report.changed:
            models = self._registry.catalogue.models
            self._metrics.show_models({key: loaded.identity for key, loaded in models.items()})
        outcome = "failed" if report.failures else "changed" if report.changed else "unchanged"
        self._metrics.reloads.labels(outcome).inc()
