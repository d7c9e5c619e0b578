"""What a network does to a connection is not noticed."""

from __future__ import annotations

import time
from contextlib import ExitStack

from benchmarks.reliability.callers import Callers, Task
from benchmarks.reliability.callers import Log as Found
from benchmarks.reliability.network import KINDS, Weather
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.proxy import Address, FaultyProxy
from benchmarks.reliability.serving import serving

MECHANISM = (
    "An attempt ends when the connection does, when its answer is damaged, belongs to another question or is none, or "
    "when nothing came for `silence` seconds; then the client asks again on another connection, another replica first. "
    "A refusal that a sound question cannot deserve (its head may be damaged) is believed when it is said 4 times. "
    "Here a proxy in front of each of 2 servers makes every kind of fault in turn, in 5 % of the exchanges."
)
BAR = "lost 0 and wrong 0 with every kind of fault"
INJECTED_FAULTS = {
    "no-retries": "the client asks once",
    "no-digests": "the client believes every answer",
}

_OFTEN = 0.05


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Each kind of fault for some seconds, with several clients on two addresses."""
    few = ["reset in an answer", "half-open", "bits of answers", "bits of questions", "answers to others"]
    count, seconds, kinds = (3, 0.7, few) if short else (6, 9.0, list(KINDS))
    options = {"silence": 0.5, "timeout": 120.0, "retries": 0 if injected == "no-retries" else None}
    task = Task(options=options, injected=injected)
    total, met = Found(), 0
    figures: dict[str, float | int | str] = {}
    with ExitStack() as stack:
        servers = [stack.enter_context(serving("--model", "default")).address for _ in range(2)]
        for kind in kinds:
            found, faults = _measure(kind, servers, count, seconds, task)
            total.add(found)
            met += faults
            slow = found.figures()["p99.9 ms"]
            figures |= {f"{kind}: faults": faults, f"{kind}: lost": found.lost, f"{kind}: wrong": found.wrong}
            figures[f"{kind}: p99.9 ms"] = slow
            log(f"{kind}: {found.asked} asked, {faults} faults, lost {found.lost}, wrong {found.wrong}, {slow:.0f} ms")
    summary = (
        f"{len(kinds)} kinds of faults, {met:,} faults in {total.asked:,} requests: "
        f"lost {total.lost}, wrong {total.wrong}"
    )
    passed = total.lost == total.wrong == 0 and met > 0
    return Outcome({"faults": met} | total.figures() | figures, passed, summary)


def _measure(kind: str, servers: list[Address], count: int, seconds: float, task: Task) -> tuple[Found, int]:
    """One kind of fault; how many of them there were."""
    weather = [Weather([], _OFTEN, seed) for seed in range(len(servers))]
    with ExitStack() as stack:
        proxies = [stack.enter_context(FaultyProxy(*each)) for each in zip(servers, weather, strict=True)]
        with Callers([[proxy.url for proxy in proxies]] * count, task) as callers:
            for each in weather:
                each.kinds = [kind]
            time.sleep(seconds)
            for each in weather:
                each.kinds = []
    return callers.log, sum(proxy.counts[kind] for proxy in proxies)
