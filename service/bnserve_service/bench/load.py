"""Many clients at once, each with one request under way, from one thread that does little else: what a server can take.

Requests are encoded before and answers are read but not decoded, so that the load costs next to nothing beside the
server, even on the same core.
"""

from __future__ import annotations

import re
import selectors
import socket
import ssl
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeAlias
from urllib.parse import urlsplit

from bnserve_protocol import BnserveError

Address: TypeAlias = tuple[str, int] | str
"""Host and port, or the path of a Unix socket."""

_LENGTH = re.compile(rb"\r\ncontent-length:\s*(\d+)", re.IGNORECASE)
_SCRATCH = 2**20
_TIMEOUT = 30.0


class LoadFailed(BnserveError):
    """A server answered with an error, or not at all."""

    code = "load-failed"
    title = "The server did not stand the load"


@dataclass(frozen=True, slots=True)
class Target:
    """Where requests go, and what is the same in all of them."""

    address: Address
    host: str = "localhost"
    prefix: str = ""
    tls: bool = False
    token: str | None = None

    @classmethod
    def parse(cls, url: str, token: str | None = None) -> Target:
        """From ``http://host:8000``, ``https://host/prefix`` or ``unix:/path``."""
        if url.startswith("unix:"):
            return cls(url.removeprefix("unix:").removeprefix("//"), token=token)
        parts = urlsplit(url)
        tls, host = parts.scheme == "https", parts.hostname or "localhost"
        return cls((host, parts.port or (443 if tls else 80)), parts.netloc, parts.path.rstrip("/"), tls, token)

    def connect(self) -> socket.socket:
        """A connection."""
        connection = open_connection(self.address)
        if not self.tls:
            return connection
        return ssl.create_default_context().wrap_socket(connection, server_hostname=self.address[0])

    def request(self, path: str, body: bytes, headers: dict[str, str], method: str = "POST") -> bytes:
        """The bytes of a request over HTTP/1.1."""
        lines = [f"{method} {self.prefix}{path} HTTP/1.1", f"Host: {self.host}", f"Content-Length: {len(body)}"]
        lines += [f"Authorization: Bearer {self.token}"] if self.token else []
        lines += [f"{name}: {value}" for name, value in headers.items()]
        return "\r\n".join([*lines, "", ""]).encode("latin-1") + body


def open_connection(address: Address) -> socket.socket:
    """A connection to a host and port, or to the path of a Unix socket."""
    if isinstance(address, str):
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        connection.settimeout(_TIMEOUT)
        try:
            connection.connect(address)
        except OSError:
            connection.close()
            raise
    else:
        connection = socket.create_connection(address, timeout=_TIMEOUT)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


def exchange(connection: socket.socket, request: bytes) -> tuple[bytes, bytes]:
    """Send a request and read all of its answer: head and body.

    Raises
    ------
    LoadFailed
        The answer is not a success, or the connection ended.
    """
    scratch, answer = memoryview(bytearray(_SCRATCH)), bytearray()
    connection.sendall(request)
    while (end := answer.find(b"\r\n\r\n")) < 0:
        answer += scratch[: _received(connection, scratch)]
    head = bytes(answer[:end])
    missing = _body_length(head) - (len(answer) - end - 4)
    while missing > 0:
        count = _received(connection, scratch)
        answer += scratch[:count]
        missing -= count
    return head, bytes(answer[end + 4 :])


def round_trips(target: Target, request: bytes, calls: int) -> tuple[list[float], bytes]:
    """Seconds from sending to having all of each of some answers, on one connection; and the last answer's body."""
    seconds, body = [], b""
    with target.connect() as connection:
        for _ in range(calls):
            started = time.perf_counter()
            _, body = exchange(connection, request)
            seconds.append(time.perf_counter() - started)
    return seconds, body


@dataclass(slots=True)
class _Client:
    """A connection, its request, and how much of the answer is missing (-1: its head is not complete)."""

    connection: socket.socket
    request: bytes
    head: bytearray = field(default_factory=bytearray)
    missing: int = -1


def answers_per_second(target: Target, requests: Sequence[bytes], seconds: float) -> float:
    """Answers per second when as many clients as there are requests repeat theirs for some seconds.

    With a slow server it takes longer: until there are as many answers as clients.

    Raises
    ------
    LoadFailed
        An answer was not a success, or a connection ended.
    """
    scratch = memoryview(bytearray(_SCRATCH))
    with selectors.DefaultSelector() as selector:
        clients = [_Client(target.connect(), request) for request in requests]
        try:
            for client in clients:
                selector.register(client.connection, selectors.EVENT_READ, client)
                client.connection.sendall(client.request)
            started, answers = time.perf_counter(), 0
            while (elapsed := time.perf_counter() - started) < seconds or answers < len(clients):
                ready = selector.select(_TIMEOUT)
                if not ready:
                    raise LoadFailed(f"The server did not answer for {_TIMEOUT:g} s.")
                for key, _ in ready:
                    if _receive(key.data, scratch):
                        answers += 1
                        key.data.connection.sendall(key.data.request)
            return answers / elapsed
        finally:
            for client in clients:
                client.connection.close()


def _receive(client: _Client, scratch: memoryview) -> bool:
    """Read what is there; whether the answer is complete."""
    while True:
        count = _received(client.connection, scratch)
        if client.missing < 0:
            client.head += scratch[:count]
            end = client.head.find(b"\r\n\r\n")
            if end >= 0:
                client.missing = _body_length(bytes(client.head[:end])) + end + 4 - len(client.head)
                client.head.clear()
        else:
            client.missing -= count
        if client.missing == 0:
            client.missing = -1
            return True
        if not (isinstance(client.connection, ssl.SSLSocket) and client.connection.pending()):
            return False


def _received(connection: socket.socket, scratch: memoryview) -> int:
    count = connection.recv_into(scratch)
    if count == 0:
        raise LoadFailed("The server closed a connection.")
    return count


def _body_length(head: bytes) -> int:
    status = head[9:12]
    if not status.startswith(b"2"):
        raise LoadFailed(f"The server answered {status.decode(errors='replace')}.")
    length = _LENGTH.search(head)
    if length is None:
        raise LoadFailed("The server's answer has no Content-Length.")
    return int(length.group(1))
