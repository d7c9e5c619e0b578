"""Running the service in a process: listening, signals, draining."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import signal
import socket
import threading
import time
from collections.abc import Callable, Generator
from typing import Any

import uvicorn
from prometheus_client import start_http_server

from bnserve_protocol import ModelLoading
from bnserve_service.app import Application, create_app
from bnserve_service.listening import BACKLOG, CannotListen, address_of, listen_tcp, listen_unix
from bnserve_service.loading import RefreshReport
from bnserve_service.settings import Settings
from bnserve_service.transport.protocol import bounded_protocol

logger = logging.getLogger("bnserve.server")

_TICK = 0.05


class _Uvicorn(uvicorn.Server):
    """uvicorn without its signal handling, which would end a drained process by the signal instead of with 0."""

    @contextlib.contextmanager
    def capture_signals(self) -> Generator[None, None, None]:
        yield


class BnserveServer:
    """One server process.

    Parameters
    ----------
    app:
        What to serve.
    announce:
        Called with one line when the server listens, and with another when its models are ready.
    """

    def __init__(self, app: Application, announce: Callable[[str], None]) -> None:
        self._app = app
        self._announce = announce
        self._settings = app.parts.settings
        self._failed: RefreshReport | None = None
        self._drain: asyncio.Task[None] | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self.metrics_address: str | None = None
        """Where the metrics are, when they have a port of their own."""
        self.ready = threading.Event()
        """Set when models are served."""
        self._uvicorn = _Uvicorn(
            uvicorn.Config(
                app,
                http=bounded_protocol(self._settings, app.quick_lane),
                ws="none",
                lifespan="on",
                log_config=None,
                access_log=False,
                server_header=False,
                proxy_headers=False,  # nothing here depends on who is behind a proxy
                backlog=BACKLOG,
                timeout_keep_alive=self._settings.keep_alive,  # type: ignore[arg-type]  # seconds; it takes fractions
                timeout_graceful_shutdown=self._settings.drain_timeout,  # type: ignore[arg-type]  # as above
            )
        )

    def run(self, listener: socket.socket, with_signals: bool = True) -> None:
        """Serve until told to stop: by SIGTERM or SIGINT; SIGHUP looks at the stores. Or by :meth:`stop` alone.

        Raises
        ------
        ModelLoading
            Not one model could be loaded at start.
        """
        factory = self._uvicorn.config.get_loop_factory()
        with _metrics_server(self._app) as self.metrics_address, asyncio.Runner(loop_factory=factory) as runner:
            runner.run(self._serve(listener, with_signals))
        if self._failed is not None:
            reasons = " ".join(f"{what}: {reason}" for what, reason in self._failed.failures.items())
            raise ModelLoading(
                "No model could be loaded, so there is nothing to serve. "
                + (reasons or "The stores hold no models; publish one with `bnserve models publish` or name another "
                   "store with --store.")
            )  # fmt: skip

    async def _serve(self, listener: socket.socket, with_signals: bool) -> None:
        loop = self._loop = asyncio.get_running_loop()
        if with_signals:
            for number in (signal.SIGTERM, signal.SIGINT):
                loop.add_signal_handler(number, self.stop)
            loop.add_signal_handler(signal.SIGHUP, self._app.parts.maintenance.poke)
        self._announce(f"bnserve listens on {address_of(listener)}")
        if self.metrics_address is not None:
            self._announce(f"bnserve metrics on {self.metrics_address}")
        watch = loop.create_task(self._watch_loading())
        try:
            await self._uvicorn.serve(sockets=[listener])
        finally:
            watch.cancel()

    async def _watch_loading(self) -> None:
        report = await self._app.parts.maintenance.first_look()
        models = self._app.parts.registry.catalogue.models
        if not models:
            self._failed = report
            self._uvicorn.should_exit = True
            return
        self.ready.set()
        self._announce("bnserve is ready: " + ", ".join(f"{name} {version}" for name, version in models))

    def stop(self) -> None:
        """Drain and stop; called a second time, stop at once."""
        if self._drain is None:
            logger.info("draining")
            self._drain = asyncio.get_running_loop().create_task(self._drain_and_exit())
        else:
            self._uvicorn.force_exit = self._uvicorn.should_exit = True

    def stop_from_thread(self) -> None:
        """:meth:`stop`, called from another thread."""
        if self._loop is not None and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self.stop)

    async def _drain_and_exit(self) -> None:
        lifecycle = self._app.parts.lifecycle
        lifecycle.begin_grace()
        until = time.monotonic() + self._settings.drain_grace
        while time.monotonic() < until and self._uvicorn.server_state.connections:
            await asyncio.sleep(_TICK)
        lifecycle.refuse()
        self._uvicorn.should_exit = True


def open_listener(settings: Settings) -> socket.socket:
    """The socket that the settings ask for.

    Raises
    ------
    CannotListen
    """
    return listen_unix(settings.uds) if settings.uds is not None else listen_tcp(settings.host, settings.port)


def serve(settings: Settings, announce: Callable[[str], None] = print, **parts: Any) -> None:
    """Run a server in this process until it is told to stop.

    Parameters
    ----------
    settings:
        How.
    announce:
        Gets a line with the address when the server listens, and one with the models when it is ready.
    **parts:
        ``source``, ``factory`` and ``bind`` of :func:`bnserve_service.create_app`.

    Raises
    ------
    CannotListen
        The port is in use, or similar.
    StoreUnknown
        A store that is not there.
    ModelLoading
        Not one model could be loaded.
    """
    listener = open_listener(settings)
    with listener:
        app = create_app(settings, wait_for_models=False, **parts)
        app.parts.maintenance.source_is_there()
        try:
            BnserveServer(app, announce).run(listener)
        finally:
            if settings.uds is not None:
                settings.uds.unlink(missing_ok=True)


@contextlib.contextmanager
def _metrics_server(app: Application) -> Generator[str | None, None, None]:
    """Serve the metrics on a port of their own, if the settings ask for one; yields its address."""
    settings = app.parts.settings
    if settings.metrics_port is None:
        yield None
        return
    try:
        server, thread = start_http_server(settings.metrics_port, settings.host, app.parts.metrics.registry)
    except OSError as error:
        raise CannotListen(
            f"The metrics port {settings.metrics_port} cannot be used: {error.strerror or error}; choose another with "
            "--metrics-port."
        ) from error
    try:
        yield f"http://{settings.host}:{server.server_port}/metrics"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
