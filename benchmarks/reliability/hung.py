"""Dead and hung workers are seen: they get no more requests, and others take their places.

A server of two workers under a steady load; every few seconds one of them is killed (SIGKILL) or stopped (SIGSTOP). No
request is sent twice, so that the last one that fails, or waits for more than a second, tells how long the worker was
still in rotation.
"""

from __future__ import annotations

import os
import random
import signal
import time
from pathlib import Path

import numpy as np

from benchmarks.reliability.asking import metric
from benchmarks.reliability.load import Came, Stream, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from benchmarks.servers import ServerFailed

MECHANISM = """Every worker gives a sign of life twice a second from its event loop; the supervisor kills those that
give none for four seconds, and has a new worker forked from a process that has everything loaded. The kernel
closes the connections of a killed worker at once."""
BAR = "out of rotation <= 5 s, replaced <= 10 s"
INJECTED_FAULTS = {"no-watchdog": "signs of life are waited for during ten minutes"}

WORKERS = 2
SECONDS = 12.0
SLOW = 1.0


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    faults = [signal.SIGSTOP] if short else [signal.SIGKILL, signal.SIGSTOP] * 6
    draw = random.Random(1)
    out: dict[signal.Signals, list[float]] = {fault: [] for fault in faults}
    back: dict[signal.Signals, list[float]] = {fault: [] for fault in faults}
    sent = failed = 0
    unwatched = {"hung_seconds": 600.0} if injected else {}
    options = "--model", "default", "--workers", str(WORKERS), "--workers-threads", "1"
    with serving(*options, **unwatched) as server, load_process() as load:  # type: ignore[arg-type]  # of the settings
        for number, fault in enumerate(faults, start=1):
            _wait_for_workers(server, 60.0)
            began = time.monotonic()
            under_way = load.begin(server.address, _streams(server), SECONDS, timeout=SECONDS, seed=number)
            time.sleep(1.0)
            victim, struck = draw.choice(sorted(server.workers())), time.monotonic()
            os.kill(victim, fault)
            back[fault].append(_replaced(server, victim, SECONDS))
            came = under_way.result().values()
            out[fault].append(max(map(_last_bad, came)) - (struck - began))
            lost = sum(each.errors for each in came)
            sent, failed = sent + sum(each.sent for each in came), failed + lost
            log(f"{number}/{len(faults)} {fault.name}: out of rotation after {max(0.0, out[fault][-1]):.1f} s, "
                f"replaced after {back[fault][-1]:.1f} s, {lost} requests lost")  # fmt: skip
            if Path(f"/proc/{victim}").exists():
                os.kill(victim, signal.SIGKILL)  # with the fault injected, nobody else does
    worst_out, worst_back = max(map(max, out.values())), max(map(max, back.values()))
    figures: Figures = {
        "faults": len(faults),
        **{f"out of rotation, s, {fault.name}, worst": max(0.0, *values) for fault, values in out.items()},
        **{f"replaced, s, {fault.name}, worst": max(values) for fault, values in back.items()},
        "requests": sent,
        "failed, of callers without retries": failed,
    }
    summary = (
        f"{len(faults)} workers killed or stopped: out of rotation within {max(0.0, worst_out):.1f} s, replaced within "
        f"{worst_back:.1f} s"
    )
    return Outcome(figures, worst_out <= 5.0 and worst_back <= 10.0, summary)


def _streams(server: Server) -> list[Stream]:
    """Callers who keep their connections, and callers who open one for each request."""
    return [
        Stream("kept", waveforms_request(server.url, 1, 64), 30.0),
        Stream("fresh", waveforms_request(server.url, 1, 64, Connection="close"), 30.0),
    ]


def _wait_for_workers(server: Server, timeout: float) -> None:
    until = time.monotonic() + timeout
    while len(server.workers()) != WORKERS or metric(server.address, "bnserve_workers_serving") != WORKERS:
        if time.monotonic() > until:
            raise ServerFailed(f"The server has {len(server.workers())} workers, and should have {WORKERS}.")
        time.sleep(0.1)


def _replaced(server: Server, victim: int, timeout: float) -> float:
    """Seconds until the victim is gone and as many as before serve; ``timeout`` if that does not happen."""
    began = time.monotonic()
    while (seconds := time.monotonic() - began) < timeout:
        workers = server.workers()
        complete = victim not in workers and len(workers) == WORKERS
        if complete and metric(server.address, "bnserve_workers_serving") == WORKERS:
            return time.monotonic() - began
        time.sleep(0.05)
    return seconds


def _last_bad(came: Came) -> float:
    """When the last request was due that failed or waited for long, from the beginning; 0 if there is none."""
    late = np.asarray(came.due.get("200", []))[np.asarray(came.seconds.get("200", [])) > SLOW]
    lost = [values for status, values in came.due.items() if status != "200"]
    return max([0.0, *(float(due) for values in (late, *lost) for due in values)])
