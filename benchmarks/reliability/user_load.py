"""Many clients of several users, each with one request under way, from one process: how long each user's take.

``python -m benchmarks.reliability.user_load`` answers the command of :func:`take_turns`. Clients ask again at once, or
after a pause, and never wait for ``Retry-After``: the greediest that there are.
"""

from __future__ import annotations

import base64
import heapq
import json
import select
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.reliability.connection import Connection
from benchmarks.workers import Worker


@dataclass(frozen=True, slots=True)
class User:
    """One user's clients."""

    name: str
    request: bytes
    clients: int
    pause: float = 0.0
    """Seconds between an answer and the next request."""


@dataclass(slots=True, eq=False)
class _Client:
    """One connection; what :class:`Connection` knows as its stream."""

    user: str
    request: bytes
    pause: float
    connection: Connection
    with_digests: bool = False
    seconds: dict[str, list[float]] = field(default_factory=dict)


Times = dict[str, NDArray[np.float64]]
"""By status: seconds of each answer."""


class UserLoad:
    """The other process; made by :func:`user_load`."""

    def __init__(self, worker: Worker) -> None:
        self._worker = worker

    def ask(self, address: tuple[str, int], users: Sequence[User], seconds: float) -> dict[str, Times]:
        """Have all ask for some seconds; by name, how long their answers took."""
        told = self._worker.ask(
            "ask",
            address=address,
            seconds=seconds,
            users=[[u.name, base64.b64encode(u.request).decode(), u.clients, u.pause] for u in users],
        )
        return {
            name: {status: np.array(each) for status, each in times.items()} for name, times in told["times"].items()
        }


@contextmanager
def user_load(cpus: set[int] | None = None) -> Iterator[UserLoad]:
    """A process that asks, on these processors."""
    with Worker([sys.executable, "-m", "benchmarks.reliability.user_load"], cpus=cpus) as worker:
        yield UserLoad(worker)


class _Asking:
    def __init__(self, address: tuple[str, int], users: list[list[Any]]) -> None:
        self._poll = select.epoll()
        self._clients = {}
        for name, request, clients, pause in users:
            for _ in range(clients):
                connection = Connection(address)
                client = _Client(name, base64.b64decode(request), pause, connection)
                self._clients[connection.number] = client
                self._poll.register(connection.number, connection.wants)
        self._due: list[tuple[float, int]] = []

    def run(self, seconds: float) -> dict[str, dict[str, list[float]]]:
        """Ask until the time is over, and leave."""
        end = time.monotonic() + seconds
        for place, number in enumerate(self._clients):
            heapq.heappush(self._due, (time.monotonic() + 1e-4 * place, number))
        while (now := time.monotonic()) < end:
            while self._due and self._due[0][0] <= now:
                self._begin(heapq.heappop(self._due)[1])
            wait = max(0.0, min(self._due[0][0] if self._due else end, end) - time.monotonic())
            for number, events in self._poll.poll(wait):
                self._serve(self._clients[number], events)
        times: dict[str, dict[str, list[float]]] = {}
        for client in self._clients.values():
            for status, found in client.seconds.items():
                times.setdefault(client.user, {}).setdefault(status, []).extend(found)
            client.connection.close()
        return times

    def _begin(self, number: int) -> None:
        client = self._clients[number]
        client.connection.begin(client, time.monotonic(), client.request)
        self._poll.modify(number, client.connection.wants)

    def _serve(self, client: _Client, events: int) -> None:
        connection = client.connection
        if events & select.EPOLLOUT:
            connection.write()
            self._poll.modify(connection.number, connection.wants)
        if events & select.EPOLLIN and connection.read():
            now = time.monotonic()
            client.seconds.setdefault(connection.status, []).append(now - connection.due)
            connection.end()
            heapq.heappush(self._due, (now + client.pause, connection.number))


if __name__ == "__main__":
    for line in sys.stdin:
        command = json.loads(line)
        host, port = command["address"]
        asking = _Asking((host, port), command["users"])
        print(json.dumps({"times": asking.run(command["seconds"])}), flush=True)
