"""Servers that say that they are ready, and do with everything else what a test wants."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer


class FakeServer:
    """Keeps what it was asked; ``answer`` gets the handler once the request was read."""

    def __init__(self, answer: Callable[[BaseHTTPRequestHandler], None], ready: int = 200) -> None:
        self.requests: list[tuple[str, str]] = []
        self.ready = ready
        self._answer = answer

    @contextmanager
    def serving(self) -> Iterator[str]:
        """The address at which it serves meanwhile."""
        outer = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_GET(self) -> None:
                self.rfile.read(int(self.headers.get("content-length", 0)))
                if self.path == "/v2/health/ready":
                    reply(outer.ready)(self)
                    return
                outer.requests.append((self.command, self.path))
                outer._answer(self)

            do_POST = do_PUT = do_DELETE = do_GET  # noqa: N815

            def log_message(self, *arguments) -> None:
                """Quiet."""

        server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        server.daemon_threads = True
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02})
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_address[1]}"
        finally:
            server.shutdown()
            server.server_close()
            thread.join()


def reply(status: int) -> Callable[[BaseHTTPRequestHandler], None]:
    """Answer with a status and a short body."""

    def answer(handler: BaseHTTPRequestHandler) -> None:
        handler.send_response(status)
        handler.send_header("content-length", "2")
        handler.end_headers()
        handler.wfile.write(b"ok")

    return answer


def break_off(handler: BaseHTTPRequestHandler) -> None:
    """Close the connection without a word, as a server does that is killed."""
    handler.close_connection = True
