"""Overload degrades, it never collapses: what is too much is refused at once, what is accepted is answered in time.

An open loop sends requests with a deadline at 1, 2, 5 and 10 times what the server can do, whatever comes back; only
answers within the deadline count. Health is asked all the time. The levels take turns, so that a change of the machine
meets all of them.
"""

from __future__ import annotations

import time
from statistics import median

import numpy as np

from benchmarks.reliability.load import REFUSALS, Came, Load, Stream, get_request, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from bnserve_service.bench.load import Target, answers_per_second

MECHANISM = """The queue is bounded in samples of work, about a third of a second for one worker, and takes nothing
whose deadline ends before its turn would come; what does not fit is refused at once with Retry-After, and what waited
beyond its deadline is dropped before it is computed. Health is answered from memory, outside of the queue."""
BAR = "goodput at 10x >= 95 % of the peak; refusals within 10 ms (p99), all with Retry-After; health never shed"
INJECTED_FAULTS = {"endless-queue": "the queue takes everything, and computes it whatever its deadline"}

LEVELS = (1, 2, 5, 10)
ROWS, POINTS = 4096, 16
"""A request whose evaluation takes a hundred times as long as refusing it, and whose answer is small beside that."""
DEADLINE = 2.0
SETTLE = 0.5
"""Seconds of each level that do not count: the load opens its connections."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    rounds, seconds = (1, 2.0) if short else (5, 6.0)
    levels = (1, 10) if short else LEVELS
    came: dict[int, list[Came]] = {level: [] for level in levels}
    health: list[Came] = []
    capacities: list[float] = []
    with serving("--model", "default", "--workers-threads", "1", injected=injected) as server, load_process() as load:
        for _ in range(rounds):
            capacities.append(_capacity(server, seconds / 2))
            for level in levels:
                own = _send(server, load, level * capacities[-1], seconds)
                came[level].append(own["work"])
                health.append(own["health"])
                work = own["work"]
                ends = ", ".join(f"{len(values)} {status}" for status, values in work.seconds.items())
                log(f"{level:2d} x {capacities[-1]:.0f}/s: {_goodput(work, seconds):.1f} good answers/s ({ends}), "
                    f"refusals p99 {1e3 * work.quantile(0.99, *REFUSALS):.1f} ms")  # fmt: skip
    return _judge(came, health, capacities, seconds)


def _capacity(server: Server, seconds: float) -> float:
    """Answers per second when eight clients wait for theirs."""
    requests = [waveforms_request(server.url, ROWS, POINTS, delta=0.001 * number) for number in range(8)]
    return answers_per_second(Target(server.address), requests, seconds)


def _send(server: Server, load: Load, rate: float, seconds: float) -> dict[str, Came]:
    work = waveforms_request(server.url, ROWS, POINTS, X_Request_Deadline_Ms=f"{1e3 * DEADLINE:.0f}")
    streams = [
        Stream("work", work, rate),
        Stream("health", get_request(server.url, "/v2/health/ready"), 10.0),
    ]
    came = load.send(server.address, streams, seconds + SETTLE, timeout=3.0 * DEADLINE, seed=int(rate))
    time.sleep(0.5)
    return {name: each.since(SETTLE) for name, each in came.items()}


def _goodput(came: Came, seconds: float) -> float:
    return came.within(DEADLINE) / seconds


def _judge(came: dict[int, list[Came]], health: list[Came], capacities: list[float], seconds: float) -> Outcome:
    goodput = {level: median(_goodput(each, seconds) for each in own) for level, own in came.items()}
    peak, most = max(goodput.values()), max(came)
    everything = [each for own in came.values() for each in own]
    refused = np.concatenate([[], *(each.seconds.get(status, ()) for each in everything for status in REFUSALS)])
    p99 = 1e3 * float(np.quantile(refused, 0.99)) if len(refused) else float("nan")
    unexplained = sum(each.unexplained for each in everything)
    shed = sum(each.errors for each in health)
    figures: Figures = {
        "capacity, answers/s": median(capacities),
        **{f"good answers/s at {level}x": value for level, value in goodput.items()},
        f"goodput at {most}x of the peak": goodput[most] / peak,
        "refused": len(refused),
        "p50 of refusals, ms": 1e3 * float(np.median(refused)) if len(refused) else float("nan"),
        "p99 of refusals, ms": p99,
        "refusals without Retry-After": unexplained,
        "late, dropped or lost": sum(each.errors - each.count(*REFUSALS) for each in everything),
        "health asked": sum(each.sent for each in health),
        "health not answered": shed,
    }
    summary = (
        f"goodput at {most}x is {100 * goodput[most] / peak:.0f} % of the peak; refusals p99 {p99:.1f} ms, "
        f"{unexplained} without Retry-After; health shed {shed} times"
    )
    passed = goodput[most] >= 0.95 * peak and p99 <= 10.0 and not unexplained and not shed
    return Outcome(figures, passed, summary)
