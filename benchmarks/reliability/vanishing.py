"""A client that went away costs nothing: its work leaves the queue before it is computed.

Many clients ask at once, so that one worker has seconds of work; half of them close their connections while they wait.
The server's own counters say when the last job was withdrawn and how many rows were computed for nobody.
"""

from __future__ import annotations

import random
import select
import socket
import time

import numpy as np

from benchmarks.reliability.asking import metric, read_answer
from benchmarks.reliability.load import waveforms_request
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.serving import Server, serving

MECHANISM = """The answer to a request that has to wait is awaited beside a task that reads the connection: when that
sees the end, the job is taken out of the queue. uvicorn itself lets handlers of vanished clients run to their end."""
BAR = "removed <= 100 ms after the connection closed; wasted compute <= 5 %"
INJECTED_FAULTS = {"no-watch": "nobody looks whether the caller is still there, as in plain uvicorn"}

ROWS, POINTS = 4096, 16
TIMEOUT = 0.6
"""Seconds without another withdrawal after which the last one has been seen."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes a minute."""
    rounds, clients = (1, 80) if short else (10, 160)
    draw = random.Random(1)
    removed: list[float] = []
    wasted, evaluated, errors, left = 0.0, 0.0, 0, 0
    with serving("--model", "default", "--workers-threads", "1", injected=injected, queue_samples=2**31) as server:
        for number in range(rounds):
            seconds, own_evaluated, answered, own_left = _round(server, clients, draw)
            removed.append(seconds)
            evaluated += own_evaluated
            wasted += own_evaluated - answered * ROWS
            errors += clients - answered - own_left
            left += own_left
            log(f"round {number + 1}/{rounds}: last removed after {1e3 * seconds:.0f} ms, "
                f"{own_evaluated:.0f} rows computed, {answered * ROWS} of them asked for")  # fmt: skip
    worst, share = 1e3 * max(removed), wasted / evaluated
    figures = {
        "rounds": rounds,
        "clients in a round": clients,
        "removed after, ms, median": 1e3 * float(np.median(removed)),
        "removed after, ms, worst": worst,
        "left while they waited": left,
        "rows computed": int(evaluated),
        "wasted share": share,
        "errors of those who stayed": errors,
    }
    summary = (
        f"{left} left, all removed within {worst:.0f} ms, {100 * share:.1f} % of the compute wasted, "
        f"{errors} errors of others"
    )
    return Outcome(figures, worst <= 100.0 and share <= 0.05 and not errors and left > 0, summary)


def _round(server: Server, clients: int, draw: random.Random) -> tuple[float, float, int, int]:
    """Seconds until the last job was withdrawn, rows computed, answers to those who stayed, how many left."""
    request = waveforms_request(server.url, ROWS, POINTS)
    before = metric(server.address, "bnserve_rows_total")
    connections = [socket.create_connection(server.address, timeout=60.0) for _ in range(clients)]
    for connection in connections:
        connection.sendall(request)
    time.sleep(0.2)  # all are queued, and few are answered
    draw.shuffle(connections)
    leaving = [each for each in connections[: clients // 2] if not _has_answer(each)]
    staying = [each for each in connections if each not in leaving]
    began = metric(server.address, "bnserve_withdrawn_total", reason="disconnect")
    for connection in leaving:
        connection.close()
    seconds = _last_withdrawal(server, began)
    answers = [read_answer(connection).status for connection in staying]
    for connection in staying:
        connection.close()
    _until_idle(server)
    rows = metric(server.address, "bnserve_rows_total") - before
    return seconds, rows, answers.count(200), len(leaving)


def _has_answer(connection: socket.socket) -> bool:
    return bool(select.select([connection], [], [], 0.0)[0])


def _last_withdrawal(server: Server, began: float) -> float:
    """Seconds from now to the last time that the counter of withdrawn jobs was seen to rise."""
    closed = last = time.monotonic()
    seen = began
    while time.monotonic() - last < TIMEOUT:
        count = metric(server.address, "bnserve_withdrawn_total", reason="disconnect")
        if count > seen:
            seen, last = count, time.monotonic()
        time.sleep(0.002)
    return last - closed


def _until_idle(server: Server) -> None:
    while metric(server.address, "bnserve_queue_samples"):
        time.sleep(0.05)
