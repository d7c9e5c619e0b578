"""Many clients at once, each with one request under way, from one thread that does little else: what a server can take.

Requests are encoded before and answers are read but not decoded, so that the load costs next to nothing beside the
server, even on the same core. Standard library alone, so that it can run in any environment.
"""

from __future__ import annotations

import re
import selectors
import socket
import time
from collections.abc import Sequence
from dataclasses import dataclass, field

_LENGTH = re.compile(rb"\r\ncontent-length:\s*(\d+)", re.IGNORECASE)
_SCRATCH = 2**20


@dataclass(slots=True)
class _Client:
    """A connection, its request, and how much of the answer is missing (-1: its head is not complete)."""

    connection: socket.socket
    request: bytes
    head: bytearray = field(default_factory=bytearray)
    missing: int = -1


class LoadFailed(Exception):
    """A server answered with an error, or not at all."""


def http_request(path: str, body: bytes, headers: dict[str, str], host: str = "localhost") -> bytes:
    """The bytes of a POST over HTTP/1.1."""
    lines = [f"POST {path} HTTP/1.1", f"Host: {host}", f"Content-Length: {len(body)}"]
    lines += [f"{name}: {value}" for name, value in headers.items()]
    return "\r\n".join([*lines, "", ""]).encode() + body


def open_connection(address: tuple[str, int] | str) -> socket.socket:
    """A connection to a host and port, or to the path of a Unix socket."""
    if isinstance(address, str):
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        connection.connect(address)
    else:
        connection = socket.create_connection(address)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


def round_trips(address: tuple[str, int] | str, request: bytes, calls: int) -> tuple[list[float], bytes]:
    """Seconds from sending to having all of each of some answers, on one connection; and the last answer's body.

    Raises
    ------
    LoadFailed
        An answer was not 200, or the connection ended.
    """
    scratch, seconds, body = memoryview(bytearray(_SCRATCH)), [], bytearray()
    with open_connection(address) as connection:
        for _ in range(calls):
            body.clear()
            missing, started = -1, time.perf_counter()
            connection.sendall(request)
            while missing:
                count = connection.recv_into(scratch)
                if count == 0:
                    raise LoadFailed("The server closed a connection.")
                body += scratch[:count]
                if missing < 0:
                    if (end := body.find(b"\r\n\r\n")) < 0:
                        continue
                    missing = _body_length(bytes(body[:end])) + end + 4 - len(body)
                    del body[: end + 4]
                else:
                    missing -= count
            seconds.append(time.perf_counter() - started)
    return seconds, bytes(body)


def answers_per_second(address: tuple[str, int] | str, requests: Sequence[bytes], seconds: float) -> float:
    """Answers per second when as many clients as there are requests repeat theirs for some seconds.

    Raises
    ------
    LoadFailed
        An answer was not 200, or a connection ended.
    """
    scratch = bytearray(_SCRATCH)
    with selectors.DefaultSelector() as selector:
        clients = [_Client(open_connection(address), request) for request in requests]
        try:
            for client in clients:
                selector.register(client.connection, selectors.EVENT_READ, client)
                client.connection.sendall(client.request)
            started, answers = time.perf_counter(), 0
            while (elapsed := time.perf_counter() - started) < seconds:
                for key, _ in selector.select(timeout=30.0) or _silent():
                    if _receive(key.data, scratch):
                        answers += 1
                        key.data.connection.sendall(key.data.request)
            return answers / elapsed
        finally:
            for client in clients:
                client.connection.close()


def _receive(client: _Client, scratch: bytearray) -> bool:
    """Read what is there; whether the answer is complete."""
    count = client.connection.recv_into(scratch)
    if count == 0:
        raise LoadFailed("The server closed a connection.")
    if client.missing < 0:
        client.head += scratch[:count]
        end = client.head.find(b"\r\n\r\n")
        if end < 0:
            return False
        client.missing = _body_length(bytes(client.head[:end])) + end + 4 - len(client.head)
        client.head.clear()
    else:
        client.missing -= count
    if client.missing > 0:
        return False
    client.missing = -1
    return True


def _body_length(head: bytes) -> int:
    status = head[9:12]
    if status != b"200":
        raise LoadFailed(f"The server answered {status.decode(errors='replace')}.")
    length = _LENGTH.search(head)
    if length is None:
        raise LoadFailed("The server's answer has no Content-Length.")
    return int(length.group(1))


def _silent() -> list[tuple[selectors.SelectorKey, int]]:
    raise LoadFailed("No answer for 30 s.")
