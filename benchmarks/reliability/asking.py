"""Single requests, one after another: what a measurement asks beside its load."""

from __future__ import annotations

import http.client
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Answer:
    """A status (0: the connection ended without one), headers in lower case, a body."""

    status: int
    headers: dict[str, str]
    body: bytes


def exchange(address: tuple[str, int], request: bytes, timeout: float = 30.0) -> Answer:
    """Send the bytes of a request on a connection of its own and read the answer."""
    try:
        with connected(address, timeout) as connection:
            with suppress(ConnectionError):  # refused while it was still sending: the answer is there nevertheless
                connection.sendall(request)
            return read_answer(connection)
    except (OSError, http.client.HTTPException):
        return Answer(0, {}, b"")


def read_answer(connection: socket.socket) -> Answer:
    """The next answer on a connection."""
    response = http.client.HTTPResponse(connection)
    response.begin()
    body = response.read()
    return Answer(response.status, {name.lower(): value for name, value in response.getheaders()}, body)


@contextmanager
def connected(address: tuple[str, int], timeout: float = 30.0) -> Iterator[socket.socket]:
    """A connection."""
    with socket.create_connection(address, timeout=timeout) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        yield connection


def status_of(address: tuple[str, int], path: str, timeout: float = 30.0) -> int:
    """The status of a GET; 0 when nobody answers."""
    return exchange(
        address, f"GET {path} HTTP/1.1\r\nhost: localhost\r\nconnection: close\r\n\r\n".encode(), timeout
    ).status


def metric(address: tuple[str, int], name: str, **labels: str) -> float:
    """The sum of a metric over all its labels that match."""
    page = exchange(address, b"GET /metrics HTTP/1.1\r\nhost: localhost\r\nconnection: close\r\n\r\n").body.decode()
    wanted = [f'{key}="{value}"' for key, value in labels.items()]
    total = 0.0
    for line in page.splitlines():
        series, _, value = line.rpartition(" ")
        if series.partition("{")[0] == name and all(each in series for each in wanted):
            total += float(value)
    return total
