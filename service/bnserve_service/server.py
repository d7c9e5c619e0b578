"""Running the service in a process: listening, signals, draining."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import signal
import socket
import ssl
import threading
from collections.abc import Callable, Coroutine
from functools import partial
from typing import Any, TypeAlias

import uvicorn

from bnserve_protocol import ModelLoading
from bnserve_service.app import Application, create_app
from bnserve_service.errors import SettingsInvalid
from bnserve_service.evaluation.endpoint import FastPath
from bnserve_service.http.metrics_port import serving_metrics
from bnserve_service.http.protocol import UvicornServer, bounded_protocol, connections_beside
from bnserve_service.models.loading import RefreshReport
from bnserve_service.process.accepting import Acceptor, Intake
from bnserve_service.process.certificate import Certificate
from bnserve_service.process.given_sockets import GivenSockets, opened
from bnserve_service.process.listening import BACKLOG, address_of
from bnserve_service.process.output import tell_service_manager
from bnserve_service.settings import Settings
from bnserve_service.shared.addresses import Addresses

logger = logging.getLogger("bnserve.server")


AcceptorFactory: TypeAlias = Callable[[Intake], Acceptor]


class BnserveServer:
    """One server process.

    Parameters
    ----------
    app
        What to serve.
    announce
        Called with one line when the server listens, and with another when its models are ready.
    beside
        What else runs on its event loop, from before it listens until it has drained.
    acceptor
        Makes who takes the connections.
    on_ready
        Called when models are served.
    kept
        Whether a service manager keeps the sockets open: connections that come after the signal to stop are left to the
        next server.

    Raises
    ------
    SettingsInvalid
        The certificate cannot be used.
    """

    def __init__(
        self,
        app: Application,
        announce: Callable[[str], None],
        beside: Callable[[], Coroutine[Any, Any, None]] | None = None,
        acceptor: AcceptorFactory = Acceptor,
        on_ready: Callable[[], None] = lambda: None,
        kept: bool = False,
    ) -> None:
        self._kept = kept
        self._on_ready = on_ready
        self._acceptor = acceptor
        self._app = app
        self._beside = beside
        self._announce = announce
        self._settings = app.parts.settings
        self._failed: RefreshReport | None = None
        self._drain: asyncio.Task[None] | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self.metrics_address: str | None = None
        """Where the metrics are, when they have a port of their own."""
        self.ready = threading.Event()
        """Set when models are served."""
        most, parts = self._settings.max_connections_per_address, app.parts
        self._addresses = Addresses(most, parts.shared, parts.worker) if most is not None else None
        self._certificate = Certificate.of(self._settings)
        if self._certificate is not None:
            certificate = self._certificate
            app.parts.renewals.add(certificate.renew)
            app.parts.metrics.certificate_ends.set_function(lambda: certificate.ends)
        self._uvicorn = UvicornServer(_configuration(app.front, self._settings, app.fast_path))

    @property
    def accepts(self) -> bool:
        """Whether connections are taken."""
        return self._uvicorn.started

    def run(
        self, listener: socket.socket, with_signals: bool = True, metrics_listener: socket.socket | None = None
    ) -> None:
        """Serve until told to stop: by SIGTERM or SIGINT; SIGHUP looks at the stores. Or by :meth:`stop` alone.

        Parameters
        ----------
        listener
            Where callers connect to.
        with_signals
            Whether signals are listened to; only possible in the main thread.
        metrics_listener
            Where the metrics are, when they have a port of their own.

        Raises
        ------
        ModelLoading
            Not one model could be loaded at start.
        """
        if metrics_listener is not None:
            self.metrics_address = f"{address_of(metrics_listener, self._settings.metrics_speak_tls)}/metrics"
        with asyncio.Runner(loop_factory=self._uvicorn.config.get_loop_factory()) as runner:
            runner.run(self._serve(listener, metrics_listener, with_signals))
        if self._failed is not None:
            raise models_missing(self._failed)

    async def _serve(self, listener: socket.socket, metrics_listener: socket.socket | None, with_signals: bool) -> None:
        loop = self._loop = asyncio.get_running_loop()
        if with_signals:
            for number in (signal.SIGTERM, signal.SIGINT):
                loop.add_signal_handler(number, self.stop)
            loop.add_signal_handler(signal.SIGHUP, self._app.parts.look_again)
        self._uvicorn.acceptor = self._acceptor(self._intake(listener))
        self._announce(f"bnserve listens on {address_of(listener, self._settings.speaks_tls)}")
        if self.metrics_address is not None:
            self._announce(f"bnserve metrics on {self.metrics_address}")
        others = [loop.create_task(self._watch_loading())]
        if self._beside is not None:
            others.append(loop.create_task(self._beside()))
        try:
            metrics = _configuration(self._app.metrics, self._settings, None)
            tls = self._context() if self._settings.metrics_speak_tls else None
            timeout = self._settings.header_timeout
            async with serving_metrics(connections_beside(metrics), metrics_listener, tls, timeout):
                await self._uvicorn.serve(sockets=[listener])
            if self._uvicorn.force_exit:  # uvicorn leaves the lifespan as it is then, to be cancelled with a traceback
                await self._uvicorn.lifespan.shutdown()
        finally:
            for task in others:
                task.cancel()

    def _intake(self, listener: socket.socket) -> Intake:
        connections = self._uvicorn.server_state.connections
        return Intake(
            listener,
            self._uvicorn.connection,
            lambda: len(connections),
            self._context() if self._settings.speaks_tls else None,
            self._settings.header_timeout,
            self._enter if self._addresses is not None else None,
            self._kept,
        )

    def _context(self) -> ssl.SSLContext | None:
        return self._certificate.context if self._certificate is not None else None

    def _enter(self, address: str) -> Callable[[], None] | None:
        assert self._addresses is not None, "it is only asked where there is a limit"
        leave = self._addresses.enter(address)
        if leave is None:
            self._app.parts.metrics.connections_refused.inc()
        return leave

    async def _watch_loading(self) -> None:
        report = await self._app.parts.maintenance.first_look()
        models = self._app.parts.registry.catalogue.models
        if not models:
            self._failed = report
            self._uvicorn.should_exit = True
            return
        self.ready.set()
        self._on_ready()
        self._announce("bnserve is ready: " + ", ".join(f"{name} {version}" for name, version in models))

    def stop(self) -> None:
        """Drain and stop; called a second time, stop at once."""
        if self._drain is None:
            self.drain()
        else:
            self.stop_now()

    def drain(self, grace: float | None = None) -> None:
        """Drain and stop, however often it is called; ``grace`` in place of the setting ``drain_grace``."""
        if self._drain is None:
            logger.info("draining")
            seconds = self._settings.drain_grace if grace is None else grace
            self._drain = asyncio.get_running_loop().create_task(self._drain_and_exit(seconds))

    def stop_now(self) -> None:
        """Stop without waiting for what is in flight."""
        self._app.parts.lifecycle.abort()
        self._uvicorn.force_exit = self._uvicorn.should_exit = True

    def stop_from_thread(self) -> None:
        """:meth:`stop`, called from another thread."""
        if self._loop is not None and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self.stop)

    async def _drain_and_exit(self, grace: float) -> None:
        lifecycle = self._app.parts.lifecycle
        lifecycle.begin_grace()
        if self._kept:
            self._uvicorn.acceptor.stop()
        # In full, even when nobody is connected: a balancer that has not looked again yet still sends callers here.
        await asyncio.sleep(grace)
        self._uvicorn.acceptor.stop()  # another worker, if there is one, takes who comes now, and does not refuse
        lifecycle.refuse()
        self._uvicorn.should_exit = True


def _configuration(app: Any, settings: Settings, fast_path: FastPath | None) -> uvicorn.Config:
    """How whatever this server listens on is served."""
    return uvicorn.Config(
        app,
        http=bounded_protocol(settings, fast_path),
        ws="none",
        lifespan="on",
        log_config=None,
        access_log=False,
        server_header=False,
        proxy_headers=False,  # nothing here depends on who is behind a proxy
        backlog=BACKLOG,
        timeout_keep_alive=settings.keep_alive,  # type: ignore[arg-type]  # seconds; it takes fractions
        timeout_graceful_shutdown=settings.drain_timeout,  # type: ignore[arg-type]  # as above
    )


def models_missing(report: RefreshReport) -> ModelLoading:
    """The error of a look at the stores that found nothing to serve."""
    reasons = " ".join(f"{what}: {reason}" for what, reason in report.failures.items())
    return ModelLoading(
        "No model could be loaded, so there is nothing to serve. "
        + (reasons or "The stores hold no models; publish one with `bnserve models publish` or name another "
           "store with --store.")
    )  # fmt: skip


def check_one_process(settings: Settings) -> None:
    """Refuse settings of several processes, which cannot all be this one.

    Raises
    ------
    SettingsInvalid
        ``workers`` is more than one.
    """
    if settings.workers > 1:
        raise SettingsInvalid(
            f"This process is one worker, and workers is {settings.workers}: use the command `bnserve serve`."
        )


def serve(
    settings: Settings, announce: Callable[[str], None] = print, given: GivenSockets | None = None, **parts: Any
) -> None:
    """Run a server in this process until it is told to stop.

    Parameters
    ----------
    settings
        How.
    announce
        Gets a line with the address when the server listens, and one with the models when it is ready.
    given
        Sockets of a service manager to listen on; the settings are to describe them (:meth:`GivenSockets.settings`).
    **parts
        ``source``, ``factory`` and ``bind`` of :func:`bnserve_service.create_app`.

    Raises
    ------
    CannotListen
        The port is in use, or similar.
    SettingsInvalid
        It should have several processes: for those, there is the command ``bnserve serve``.
    StoreUnknown
        A store that is not there.
    ModelLoading
        Not one model could be loaded.
    """
    check_one_process(settings)
    with contextlib.ExitStack() as stack:
        kept = given is not None  # then callers wait in the queue, as they did while nobody was there
        app = create_app(settings, wait_for_models=kept, **parts)
        app.parts.maintenance.source_is_there()  # before anybody connects to what will not serve
        server = BnserveServer(app, announce, on_ready=partial(tell_service_manager, "READY=1"), kept=kept)
        listener, metrics_listener = stack.enter_context(opened(settings, given))
        server.run(listener, metrics_listener=metrics_listener)
