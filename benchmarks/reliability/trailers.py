"""What does not end is cut off, whichever part of a request it is: no flood of trailers fills memory or stops a worker.

Connections without a token pour in trailers by the million, one trailer without an end, and one chunk extension without
an end, to a server with two workers, while others ask at a steady rate.
"""

from __future__ import annotations

import json
import socket
import sys
import threading
import time
from collections import Counter
from contextlib import suppress
from typing import Any, Self

import numpy as np

from benchmarks.reliability.asking import metric
from benchmarks.reliability.load import Came, Stream, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from benchmarks.workers import Worker

MECHANISM = """Whatever is not body (head, trailers, chunk extensions, empty lines) is counted as it arrives, refused
with 400 beyond 64 KiB, and parsed in pieces of that size, so that its cost is linear. Trailers are dropped once they
are counted: they are neither kept nor headers. What comes before the refusal is read is thrown away, up to 1 MiB."""
BAR = "every flood refused within 2 MiB, memory <= +32 MiB, no worker replaced, errors of others 0, p99 <= 1.5 times"
INJECTED_FAULTS = {"endless-frames": "nothing but bodies is counted"}

MIB = 2**20
RATE = 4.0
"""Floods of each kind that begin in a second."""
LARGEST = 2 * MIB
"""The limit, what is thrown away until its sender has read that it is refused, and what waits in the kernel."""
HEAD = (
    b"POST /v1/models/default/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/msgpack\r\n"
    b"transfer-encoding: chunked\r\n\r\n"
)
KINDS = {
    "many trailers": (HEAD + b"0\r\n", b"x-a: %b\r\n" % (b"a" * 100) * 600),
    "a trailer without end": (HEAD + b"0\r\nx-a: ", b"a" * 2**16),
    "an extension without end": (HEAD + b"5;", b"a" * 2**16),
}


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    seconds, turns, size = (4.0, 1, 16 * MIB) if short else (20.0, 2, 512 * MIB)
    came: dict[bool, list[Came]] = {False: [], True: []}
    told: dict[str, Any] = {"floods": 0, "refused": 0, "largest": 0, "statuses": {}}
    command = [sys.executable, "-m", "benchmarks.reliability.trailers"]
    options = "--model", "default", "--workers", "2", "--workers-threads", "1"
    with serving(*options, injected=injected) as server, load_process() as load, Worker(command) as flood:
        stream = Stream("small", waveforms_request(server.url, 1, 64), 100.0)
        load.send(server.address, [stream], 2.0)
        with _Memory(server) as memory:
            for turn in range(turns):
                came[False].append(load.send(server.address, [stream], seconds / 2, seed=turn)["small"])
                under_way = load.begin(server.address, [stream], seconds, seed=turn)
                found = flood.ask("flood", address=server.address, seconds=seconds, size=size)
                came[True].append(under_way.result()["small"])
                came[False].append(load.send(server.address, [stream], seconds / 2, seed=turn + 100)["small"])
                told = _together(told, found)
                log(f"turn {turn + 1}/{turns}: {found}, memory {memory.grown / MIB:+.1f} MiB")
        replaced = sum(
            metric(server.address, "bnserve_worker_restarts_total", reason=why) for why in ("hung", "killed")
        )
    return _judge(came, told, memory.grown, int(replaced))


class _Memory:
    """The highest memory of a server's processes beyond that at the beginning, looked at all the time; a context."""

    def __init__(self, server: Server) -> None:
        self._server, self._before = server, server.rss()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._look)
        self.grown = 0

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()

    def _look(self) -> None:
        while not self._ended.wait(0.2):
            with suppress(OSError):  # a process has just ended
                self.grown = max(self.grown, self._server.rss() - self._before)


def _together(one: dict[str, Any], other: dict[str, Any]) -> dict[str, Any]:
    return {
        "floods": one["floods"] + other["floods"],
        "refused": one["refused"] + other["refused"],
        "largest": max(one["largest"], other["largest"]),
        "statuses": dict(Counter(one["statuses"]) + Counter(other["statuses"])),
    }


def _judge(came: dict[bool, list[Came]], told: dict[str, Any], grown: int, replaced: int) -> Outcome:
    quiet, busy = (
        float(np.quantile(np.concatenate([each.seconds["200"] for each in came[which]]), 0.99))
        for which in (False, True)
    )
    errors = sum(each.errors for own in came.values() for each in own)
    figures: Figures = {
        "floods": told["floods"],
        "floods refused": told["refused"],
        "largest part that was taken, KiB": told["largest"] // 2**10,
        "memory at most, MiB more": grown / MIB,
        "workers replaced": replaced,
        "requests of others": sum(each.sent for own in came.values() for each in own),
        "errors of others": errors,
        "p99 of others without floods, ms": 1e3 * quiet,
        "p99 of others with them, ms": 1e3 * busy,
        "ratio of p99": busy / quiet,
        **{f"status {status}": count for status, count in sorted(told["statuses"].items())},
    }
    summary = (
        f"{told['refused']:,} of {told['floods']:,} floods refused, at most {told['largest'] // 2**10} KiB taken, "
        f"{grown / MIB:+.1f} MiB, {replaced} workers replaced, p99 of others {busy / quiet:.2f}x, {errors} errors"
    )
    bounded = told["refused"] == told["floods"] and told["largest"] <= LARGEST and grown <= 32 * MIB
    return Outcome(figures, bounded and not replaced and not errors and busy <= 1.5 * quiet, summary)


def flood(address: tuple[str, int], seconds: float, size: int) -> dict[str, Any]:
    """Pour in one flood after another, of all kinds in turns; what became of them."""
    statuses: Counter[str] = Counter()
    floods, refused, largest = 0, 0, 0
    until = time.monotonic() + seconds
    following = time.monotonic()
    while time.monotonic() < until:
        for begin, again in KINDS.values():
            time.sleep(max(0.0, following - time.monotonic()))
            following = max(following + 1.0 / (RATE * len(KINDS)), time.monotonic())
            taken, status = _pour(address, begin, again, size)
            floods += 1
            refused += status == "400"
            largest = max(largest, taken)
            statuses[status] += 1
    return {"floods": floods, "refused": refused, "largest": largest, "statuses": dict(statuses)}


def _pour(address: tuple[str, int], begin: bytes, again: bytes, size: int) -> tuple[int, str]:
    """Send until the server answers or ends, or all is sent; how much it took before, and the status ("" for none)."""
    said, taken = b"", 0
    with socket.create_connection(address, timeout=10.0) as connection, suppress(OSError):
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 2**14)  # what waits here was not taken
        connection.sendall(begin)
        while taken < size and not said:
            connection.sendall(again)
            taken += len(again)
            connection.setblocking(False)
            with suppress(BlockingIOError):
                said = connection.recv(2**16)
                if not said:
                    break
            connection.settimeout(10.0)
        connection.settimeout(10.0)
        said = said or connection.recv(2**16)
    return taken, said[9:12].decode("latin-1")


if __name__ == "__main__":
    for line in sys.stdin:
        command = json.loads(line)
        print(json.dumps(flood(tuple(command["address"]), command["seconds"], command["size"])), flush=True)
