"""Real sockets in front of a :class:`ReferenceService`, with faults on demand."""

import socket
import struct
import threading
import time
from collections import deque
from contextlib import contextmanager

from tests.client.reference_service import QuietServer, ReferenceService, Reply, handler_for, tie


class ScriptedServer:
    """One replica. ``faults`` are used up, one for each request; a fault is a function of (handler, reply)."""

    def __init__(self, service=None, place=("127.0.0.1", 0)):
        self.service = service or ReferenceService()
        self._place = place
        self.faults = deque()
        self.connections = 0

    @property
    def address(self):
        return "http://{}:{}".format(*self._server.server_address)

    @contextmanager
    def serving(self):
        outer = self

        class Handler(handler_for(self.service)):
            def setup(self):
                outer.connections += 1
                super().setup()

            def send(self, reply):
                fault = outer.faults.popleft() if outer.faults else None
                if fault is None:
                    super().send(reply)
                else:
                    fault(self, reply)

        self._server = QuietServer(self._place, Handler)
        thread = threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True)
        thread.start()
        try:
            yield self
        finally:
            self._server.shutdown()
            self._server.server_close()
            thread.join()


def raw(handler, reply):
    """The bytes of a well-formed answer."""
    head = [f"HTTP/1.1 {reply.status} Status", *(f"{name}: {value}" for name, value in reply.headers.items())]
    return "\r\n".join([*head, "", ""]).encode() + reply.body


def send_bytes(data, *, close=True):
    """Answer with these bytes, whatever they are."""

    def fault(handler, reply):
        handler.wfile.write(data)
        handler.close_connection = close

    return fault


def reset(handler, reply):
    """Break the connection with a TCP reset."""
    handler.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    handler.close_connection = True
    handler.connection.close()


def close_silently(handler, reply):
    """End the connection without an answer."""
    handler.close_connection = True


def truncate(handler, reply):
    """Stop in the middle of the answer."""
    data = raw(handler, reply)
    handler.wfile.write(data[: -len(reply.body) // 2])
    handler.close_connection = True


def hang(seconds):
    """Say nothing for a while, then end the connection."""

    def fault(handler, reply):
        time.sleep(seconds)
        handler.close_connection = True

    return fault


class Drip:
    """Sends the head, or the body after it, byte by byte, until the client is gone."""

    def __init__(self, *, of_head, seconds=0.02):
        self._of_head, self._seconds = of_head, seconds
        self.begun, self.ended = threading.Event(), threading.Event()
        self.was_cut_off = False

    def __call__(self, handler, reply):
        data = raw(handler, reply)
        head = len(data) - len(reply.body)
        start, stop = (0, head) if self._of_head else (head, len(data))
        handler.close_connection = True
        try:
            handler.wfile.write(data[:start])
            for byte in data[start:stop]:
                handler.wfile.write(bytes([byte]))
                self.begun.set()
                time.sleep(self._seconds)
            handler.wfile.write(data[stop:])
        except OSError:
            self.was_cut_off = True
        self.ended.set()


def flip_bit(position):
    """Flip one bit of the answer, counted from its first byte (negative: from its end)."""

    def fault(handler, reply):
        data = bytearray(raw(handler, reply))
        data[position] ^= 0x10
        handler.wfile.write(data)
        handler.close_connection = True

    return fault


def change(**changes):
    """Send the answer with other headers (underscores are hyphens; None removes) but keep the connection."""

    def fault(handler, reply):
        headers = reply.headers | {name.replace("_", "-"): value for name, value in changes.items()}
        kept = {name: value for name, value in headers.items() if value is not None}
        handler.wfile.write(raw(handler, Reply(reply.status, kept, reply.body)))

    return fault


def instead(status, body, **headers):
    """Another answer, tied to the question as bnserve's are."""

    def fault(handler, reply):
        asked = reply.headers.get("x-request-digest")
        tied = tie(None, body) | ({} if asked is None else {"x-request-digest": asked})
        named = tied | {name.replace("_", "-"): value for name, value in headers.items()}
        kept = {name: value for name, value in named.items() if value is not None}
        handler.wfile.write(raw(handler, Reply(status, kept, body)))

    return fault


def chunked(handler, reply):
    """The same answer in chunks of seven hundred bytes, as a proxy may send it."""
    headers = {name: value for name, value in reply.headers.items() if name != "content-length"}
    head = raw(handler, Reply(reply.status, headers | {"transfer-encoding": "chunked"}, b""))
    pieces = [reply.body[start : start + 700] for start in range(0, len(reply.body), 700)]
    handler.wfile.write(head + b"".join(b"%x\r\n%s\r\n" % (len(piece), piece) for piece in pieces) + b"0\r\n\r\n")
