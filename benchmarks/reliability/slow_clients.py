"""Slow clients cannot hold the server: they are cut off, and nobody else notices them.

A thousand connections that send their headers, and a thousand that send their bodies, a byte every few seconds, while
others ask at a steady rate; how long each is let be, and the others' latencies with and without them in turns.
"""

from __future__ import annotations

import json
import select
import socket
import sys
import time
from dataclasses import dataclass

import numpy as np

from benchmarks.reliability.load import Came, Stream, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import serving
from benchmarks.workers import Worker

MECHANISM = """The protocol of each connection has one timer for what it waits for: headers, a body, or room for the
answer; a byte now and then does not start it again. A slow connection is a few kilobytes of memory and no thread."""
BAR = "headers cut off after 10 s and bodies after 30 s (0.5 s more at most), others' p99 <= 1.2 times"
INJECTED_FAULTS = {"no-timers": "connections may take their time, as in plain uvicorn"}

HEAD = b"POST /v1/models/default/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/msgpack\r\n"
TOLERANCE = 0.5
EVERY = 5.0
"""Seconds between two bytes of one connection."""


@dataclass(frozen=True, slots=True)
class Size:
    """How many clients of each kind, how long the server lets them be, how often it is measured."""

    clients: int
    header_timeout: float
    body_timeout: float
    turns: int


LONG, SHORT = Size(1000, 10.0, 30.0, 2), Size(100, 0.5, 1.0, 1)


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    size = SHORT if short else LONG
    seconds = size.body_timeout + (4.0 if size is LONG else 2.0)
    came: dict[bool, list[Came]] = {False: [], True: []}
    held: dict[str, list[float]] = {"headers": [], "bodies": []}
    command = [sys.executable, "-m", "benchmarks.reliability.slow_clients"]
    options = "--model", "default", "--workers-threads", "1"
    serve = serving(*options, injected=injected, header_timeout=size.header_timeout, body_timeout=size.body_timeout)
    with serve as server, load_process() as load, Worker(command) as slow:
        stream = Stream("small", waveforms_request(server.url, 1, 64), 100.0)
        load.send(server.address, [stream], 1.0)
        for turn in range(size.turns):
            came[False].append(load.send(server.address, [stream], seconds / 2, seed=turn)["small"])
            under_way = load.begin(server.address, [stream], seconds, seed=turn)
            told = slow.ask("hold", address=server.address, clients=size.clients, timeout=seconds)
            came[True].append(under_way.result()["small"])
            came[False].append(load.send(server.address, [stream], seconds / 2, seed=turn + 100)["small"])
            for kind, own in held.items():
                own += told[kind]
            log(f"turn {turn + 1}/{size.turns}: headers held {max(told['headers']):.2f} s, "
                f"bodies {max(told['bodies']):.2f} s, p99 {1e3 * came[True][-1].quantile(0.99):.1f} ms "
                f"({1e3 * came[False][-1].quantile(0.99):.1f} ms without)")  # fmt: skip
        memory = server.rss()
    return _judge(size, came, held, memory)


def _judge(size: Size, came: dict[bool, list[Came]], held: dict[str, list[float]], memory: int) -> Outcome:
    quiet, busy = (
        float(np.quantile(np.concatenate([each.seconds["200"] for each in came[which]]), 0.99))
        for which in (False, True)
    )
    errors = sum(each.errors for own in came.values() for each in own)
    headers, bodies = max(held["headers"]), max(held["bodies"])
    figures: Figures = {
        "slow connections at a time": 2 * size.clients,
        "slow headers held, s, longest": headers,
        "slow bodies held, s, longest": bodies,
        "requests of others": sum(each.sent for own in came.values() for each in own),
        "errors of others": errors,
        "p99 of others without them, ms": 1e3 * quiet,
        "p99 of others with them, ms": 1e3 * busy,
        "ratio of p99": busy / quiet,
        "memory at the end, MB": memory / 1e6,
    }
    in_time = headers <= size.header_timeout + TOLERANCE and bodies <= size.body_timeout + TOLERANCE
    summary = (
        f"{2 * size.clients:,} slow connections: headers cut off after {headers:.1f} s, bodies after {bodies:.1f} s, "
        f"p99 of others {busy / quiet:.2f}x, {errors} errors"
    )
    return Outcome(figures, in_time and not errors and busy <= 1.2 * quiet, summary)


class _Slow:
    """One slow connection."""

    def __init__(self, address: tuple[str, int], kind: str, start: bytes, piece: bytes) -> None:
        self.kind, self._piece = kind, piece
        self.socket = socket.create_connection(address)
        self.socket.sendall(start)
        self.began = time.monotonic()

    def send(self) -> None:
        """One more byte."""
        try:
            self.socket.send(self._piece)
        except OSError:  # the server has closed it; its end is noted where it is read
            return

    def has_ended(self) -> bool:
        """Read; whether the server has closed it."""
        try:
            return not self.socket.recv(2**16)
        except OSError:
            return True


def hold(address: tuple[str, int], clients: int, timeout: float) -> dict[str, list[float]]:
    """Open so many connections of both kinds; for how long each was let be, in seconds."""
    poll = select.epoll()
    slow: dict[int, _Slow] = {}
    for _ in range(clients):
        body = HEAD + b"content-length: 1000\r\n\r\n"
        for each in (_Slow(address, "headers", HEAD, b"x"), _Slow(address, "bodies", body, b"\x81")):
            slow[each.socket.fileno()] = each
            poll.register(each.socket, select.EPOLLIN)
    seconds: dict[str, list[float]] = {"headers": [], "bodies": []}
    until = time.monotonic() + timeout
    following = time.monotonic() + EVERY
    while slow and time.monotonic() < until:
        for number, _ in poll.poll(0.05):
            if slow[number].has_ended():
                poll.unregister(number)
                each = slow.pop(number)
                seconds[each.kind].append(time.monotonic() - each.began)
                each.socket.close()
        if time.monotonic() > following:
            following += EVERY
            for each in slow.values():
                each.send()
    for each in slow.values():
        seconds[each.kind].append(time.monotonic() - each.began)
        each.socket.close()
    return seconds


if __name__ == "__main__":
    for line in sys.stdin:
        command = json.loads(line)
        print(json.dumps(hold(tuple(command["address"]), command["clients"], command["timeout"])), flush=True)
