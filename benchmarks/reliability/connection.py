"""One connection of a load: a request goes out, an answer comes in, nothing blocks."""

from __future__ import annotations

import contextlib
import re
import select
import socket
from typing import Any

_LENGTH = re.compile(rb"\r\ncontent-length:\s*(\d+)")
_SCRATCH = memoryview(bytearray(2**20))


class Ended(Exception):
    """The connection, or the load, is over."""


class Connection:
    """A connection to an address, with at most one request under way."""

    def __init__(self, address: tuple[str, int]) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        self._socket.setblocking(False)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket.connect_ex(address)
        self.number = self._socket.fileno()
        self.asked = 0
        """Requests so far."""
        self.busy = False
        self._outgoing = memoryview(b"")

    @property
    def wants(self) -> int:
        """What to poll for."""
        return select.EPOLLIN | (select.EPOLLOUT if self._outgoing else 0)

    def begin(self, stream: Any, due: float, request: bytes) -> None:
        """Send a request."""
        self.stream, self.due = stream, due
        self.asked += 1
        self.busy = True
        self.head, self.body = b"", b""
        self._received = bytearray()
        self._missing = -1
        self._outgoing = memoryview(request)
        self.write()

    def write(self) -> None:
        """Send what fits."""
        with contextlib.suppress(BlockingIOError):
            self._outgoing = self._outgoing[self._socket.send(self._outgoing) :]

    def read(self) -> bool:
        """Take what is there; whether the answer is complete."""
        try:
            count = self._socket.recv_into(_SCRATCH)
        except BlockingIOError:
            return False
        if not count:
            raise Ended("the server closed the connection")
        if not self.busy:
            raise Ended("bytes that nobody asked for")
        keeps = self._missing < 0 or self.stream.with_digests
        if keeps:
            self._received += _SCRATCH[:count]
        if self._missing >= 0:
            self._missing -= count
        elif (end := self._received.find(b"\r\n\r\n")) >= 0:
            self.head = bytes(self._received[: end + 2]).lower()
            length = _LENGTH.search(self.head)
            if length is None:
                raise Ended("an answer without a length")
            del self._received[: end + 4]
            self._missing = int(length[1]) - len(self._received)
        if self._missing == 0:
            self.body = bytes(self._received)
        return self._missing == 0

    @property
    def status(self) -> str:
        """Of the answer, three digits."""
        return self.head[9:12].decode("ascii", "replace")

    @property
    def closes(self) -> bool:
        """Whether the server ends the connection after this answer."""
        return b"\r\nconnection: close" in self.head

    def end(self) -> None:
        """The answer was noted."""
        self.busy = False

    def close(self) -> None:
        """Hang up."""
        self.busy = False
        self._socket.close()
