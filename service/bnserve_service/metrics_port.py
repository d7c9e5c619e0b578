"""The metrics on a port of their own, answered by a thread of their own."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Generator, Iterable
from contextlib import contextmanager
from socketserver import ThreadingMixIn
from typing import Any
from wsgiref.simple_server import WSGIRequestHandler, WSGIServer

from bnserve_service.listening import address_of
from bnserve_service.metrics import CONTENT_TYPE


@contextmanager
def serving_metrics(listener: socket.socket | None, text: Callable[[], bytes]) -> Generator[str | None, None, None]:
    """Answer on ``listener`` with what ``text`` returns, whatever the path; yields the address.

    Several processes may do so on one socket.
    """
    if listener is None:
        yield None
        return
    listener.setblocking(False)  # another process may be faster
    server = _Server(listener, text)
    thread = threading.Thread(target=server.serve_forever, name="bnserve-metrics", daemon=True)
    thread.start()
    try:
        yield f"{address_of(listener)}/metrics"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


class _Handler(WSGIRequestHandler):
    timeout = 10.0  # a caller that says nothing does not keep a thread

    def log_message(self, format: str, *args: Any) -> None:
        """Say nothing."""


class _Server(ThreadingMixIn, WSGIServer):
    daemon_threads = True  # none is waited for at the end

    def __init__(self, listener: socket.socket, text: Callable[[], bytes]) -> None:
        host, port = listener.getsockname()[:2]
        super().__init__((host, port), _Handler, bind_and_activate=False)
        self.socket.close()
        self.socket = listener
        self.server_name, self.server_port = host, port
        self.setup_environ()
        self._text = text
        self.set_app(self._answer)

    def _answer(self, environ: dict[str, Any], start_response: Callable[..., Any]) -> Iterable[bytes]:
        body = self._text()
        start_response("200 OK", [("Content-Type", CONTENT_TYPE), ("Content-Length", str(len(body)))])
        return [body]

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A caller that went away is no error."""
