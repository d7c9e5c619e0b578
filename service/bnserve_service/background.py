"""A server in a thread of this process."""

from __future__ import annotations

import contextlib
import logging
import threading
from typing import Any, Self

from bnserve_service.app import create_app
from bnserve_service.process.listening import address_of, listening, listening_for_metrics
from bnserve_service.server import BnserveServer, check_one_process
from bnserve_service.settings import Settings

logger = logging.getLogger("bnserve.server")


class BackgroundServer:
    """A server in a thread of this process, for notebooks and tests: a context manager, ready when entered.

    Parameters
    ----------
    settings
        How; port 0 is a good choice.
    **parts
        ``source``, ``factory`` and ``bind`` of :func:`bnserve_service.create_app`.

    Raises
    ------
    SettingsInvalid
        It should have several processes.
    CannotListen, StoreUnknown, ModelLoading
        When entered, as :func:`serve`.
    """

    def __init__(self, settings: Settings, **parts: Any) -> None:
        check_one_process(settings)
        self.settings = settings
        self.app = create_app(settings, wait_for_models=False, **parts)
        self.address = ""
        """What a client connects to, once entered."""
        self._failure: Exception | None = None
        self._server = BnserveServer(self.app, logger.info)
        self._thread = threading.Thread(target=self._run, name="bnserve-server", daemon=True)

    @property
    def metrics_address(self) -> str | None:
        """Where the metrics are, when they have a port of their own."""
        return self._server.metrics_address

    def stop(self) -> None:
        """Begin to drain, as SIGTERM would; leaving the context does so too, and waits."""
        self._server.stop_from_thread()

    def join(self, timeout: float | None = None) -> bool:
        """Wait until the server has ended; whether it has."""
        self._thread.join(timeout)
        return not self._thread.is_alive()

    def __enter__(self) -> Self:
        with contextlib.ExitStack() as stack:
            self._listener = stack.enter_context(listening(self.settings))
            self._metrics_listener = stack.enter_context(listening_for_metrics(self.settings))
            self.address = address_of(self._listener, self.settings.speaks_tls)
            self._sockets = stack.pop_all()
        self._thread.start()
        self._server.ready.wait()
        if self._failure is not None:
            self._thread.join()
            raise self._failure
        return self

    def __exit__(self, *_: object) -> None:
        self._server.stop_from_thread()
        self._thread.join()

    def _run(self) -> None:
        try:
            with self._sockets:
                self._server.run(self._listener, with_signals=False, metrics_listener=self._metrics_listener)
        except Exception as error:
            self._failure = error
        finally:
            self._server.ready.set()
