"""A load that does not wait for answers: requests leave when they are due, however long the others take.

``python -m benchmarks.reliability.open_loop`` is a process of its own that answers the commands of
:mod:`benchmarks.reliability.load`. Requests are encoded before and answers are not decoded, so that it costs little
beside the server.
"""

from __future__ import annotations

import base64
import hashlib
import heapq
import json
import random
import select
import sys
import time
from collections import deque
from dataclasses import dataclass, field
from typing import Any

from benchmarks.reliability.connection import Connection, Ended

MOST_CONNECTIONS = 3000


@dataclass(slots=True, eq=False)
class Stream:
    """Requests of one kind, and what came of them."""

    name: str
    request: bytes
    rate: float
    with_digests: bool = False
    sent: int = 0
    seconds: dict[str, list[float]] = field(default_factory=dict)
    """By status (``failed`` and ``timeout`` beside the numbers): from when each was due to its last byte."""
    due: dict[str, list[float]] = field(default_factory=dict)
    """By status: when each was due, from the beginning."""
    failures: dict[str, int] = field(default_factory=dict)
    digests: dict[str, int] = field(default_factory=dict)
    unexplained: int = 0
    """Refusals without ``Retry-After``."""

    def note(self, what: str, due: float, began: float, now: float) -> None:
        """Count one that is over."""
        self.seconds.setdefault(what, []).append(now - due)
        self.due.setdefault(what, []).append(due - began)


class OpenLoop:
    """Sends streams of requests at their rates, with gaps as of independent callers, to one address."""

    def __init__(self, address: tuple[str, int], streams: list[Stream], timeout: float, seed: int) -> None:
        self._address = address
        self._streams = streams
        self._timeout = timeout
        self._random = random.Random(seed)
        self._poll = select.epoll()
        self._connections: dict[int, Connection] = {}
        self._idle: list[Connection] = []
        self._under_way: deque[tuple[float, Connection, int]] = deque()

    def run(self, seconds: float) -> float:
        """Send for some seconds, then wait for what is under way; the largest delay of the sender itself."""
        self._began = began = time.monotonic()
        dues = [(began + self._gap(stream), index) for index, stream in enumerate(self._streams)]
        heapq.heapify(dues)
        late = 0.0
        while dues or any(connection.busy for connection in self._connections.values()):
            now = time.monotonic()
            while dues and dues[0][0] <= now:
                due, index = heapq.heappop(dues)
                late = max(late, now - due)
                self._send(self._streams[index], due)
                if (following := due + self._gap(self._streams[index])) < began + seconds:
                    heapq.heappush(dues, (following, index))
            wait = min(dues[0][0] - time.monotonic(), 0.1) if dues else 0.1
            for number, events in self._poll.poll(max(wait, 0.0)):
                self._serve(self._connections[number], events)
            self._give_up(time.monotonic())
        for connection in list(self._connections.values()):
            self._drop(connection)
        return late

    def _gap(self, stream: Stream) -> float:
        return self._random.expovariate(stream.rate)

    def _send(self, stream: Stream, due: float) -> None:
        stream.sent += 1
        try:
            connection = self._idle.pop() if self._idle else self._connect()
            connection.begin(stream, due, stream.request)
        except (OSError, Ended) as error:
            self._fail(stream, due, str(error))
            return
        self._under_way.append((due + self._timeout, connection, connection.asked))
        self._poll.modify(connection.number, connection.wants)

    def _connect(self) -> Connection:
        if len(self._connections) >= MOST_CONNECTIONS:
            raise Ended("no more connections")
        connection = Connection(self._address)
        self._connections[connection.number] = connection
        self._poll.register(connection.number, connection.wants)
        return connection

    def _serve(self, connection: Connection, events: int) -> None:
        try:
            if events & select.EPOLLOUT:
                connection.write()
                self._poll.modify(connection.number, connection.wants)
            if events & (select.EPOLLIN | select.EPOLLHUP | select.EPOLLERR) and connection.read():
                self._finish(connection)
        except (OSError, Ended) as error:
            if connection.busy:
                self._fail(connection.stream, connection.due, str(error))
            self._drop(connection)

    def _finish(self, connection: Connection) -> None:
        stream: Stream = connection.stream
        status = connection.status
        stream.note(status, connection.due, self._began, time.monotonic())
        if status in ("429", "503") and b"\r\nretry-after:" not in connection.head:
            stream.unexplained += 1
        if stream.with_digests and status == "200":
            digest = hashlib.sha256(connection.body).hexdigest()
            stream.digests[digest] = stream.digests.get(digest, 0) + 1
        connection.end()
        if connection.closes:
            self._drop(connection)
        else:
            self._idle.append(connection)

    def _fail(self, stream: Stream, due: float, reason: str) -> None:
        stream.note("failed", due, self._began, time.monotonic())
        stream.failures[reason] = stream.failures.get(reason, 0) + 1

    def _give_up(self, now: float) -> None:
        while self._under_way and self._under_way[0][0] <= now:
            _, connection, asked = self._under_way.popleft()
            if connection.busy and connection.asked == asked:
                connection.stream.note("timeout", connection.due, self._began, now)
                self._drop(connection)

    def _drop(self, connection: Connection) -> None:
        if connection in self._idle:
            self._idle.remove(connection)
        self._connections.pop(connection.number, None)
        connection.close()


def answer(command: dict[str, Any]) -> dict[str, Any]:
    """Do one command."""
    streams = [
        Stream(each["name"], base64.b64decode(each["request"]), each["rate"], each["with_digests"])
        for each in command["streams"]
    ]
    host, port = command["address"]
    loop = OpenLoop((host, port), streams, command["timeout"], command["seed"])
    late = loop.run(command["seconds"])
    told = [
        {
            "name": each.name, "sent": each.sent, "seconds": each.seconds, "due": each.due, "failures": each.failures,
            "digests": each.digests, "unexplained": each.unexplained,
        }
        for each in streams
    ]  # fmt: skip
    return {"streams": told, "late": late}


if __name__ == "__main__":
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line))), flush=True)
