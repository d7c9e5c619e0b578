"""In-process figures, through worker processes: bnserve, its predecessor, and a jitted TaylorF2."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any, TypeAlias

from benchmarks.environments import find_python
from benchmarks.speed.setup import Setup
from benchmarks.workers import ROOT, Worker, WorkerFailed
from bnserve_service.bench.timing import fit_cost

PEERS = ROOT / "benchmarks" / "peers"
SIZES = (10, 30, 100, 277, 1_000, 3_000, 10_000, 30_000, 100_000, 253_056)
BATCHES = ((256, 277), (256, 1_000), (256, 10_000))
OURS, OUR_MODES, PREDECESSOR, RIPPLE = "bnserve", "bnserve, all modes", "mlgw_bns", "ripple"
_WHERE: dict[str, tuple[str, ...]] = {
    OURS: ("", "bnserve_local.py", "default"),
    OUR_MODES: ("", "bnserve_local.py", "default", "all"),
    PREDECESSOR: ("mlgw_bns-0.12.1", "mlgw_bns_0.py", "default"),
    RIPPLE: ("ripple", "ripple_taylorf2.py", "5"),
}
"""Environment, script, arguments."""

Case: TypeAlias = tuple[str, int, int]
"""Who, rows, points."""
Cases: TypeAlias = dict[Any, Callable[[], Sequence[float]]]


@contextmanager
def local_workers(setup: Setup) -> Iterator[dict[str, Worker]]:
    """Start everybody who is installed; who is not is noted."""
    with ExitStack() as stack:
        workers = {}
        for name, (environment, script, *arguments) in _WHERE.items():
            python = find_python(setup.peers, environment)
            if python is None:
                setup.notes.append(f"{name} is not installed: see benchmarks/peers/{script}")
                continue
            worker = stack.enter_context(Worker([python, PEERS / script, *arguments], cpus=setup.cpus))
            try:
                worker.ask("about")
            except WorkerFailed as error:
                setup.notes.append(f"{name}: {error.detail}")
                continue
            workers[name] = worker
        yield workers


def local_cases(workers: dict[str, Worker]) -> Cases:
    """Single waveforms of bnserve and its predecessor, batches of bnserve and ripple."""
    cases: Cases = {}
    for name in (OURS, PREDECESSOR):
        for points in SIZES if name in workers else ():
            calls = 5 if points <= 10_000 else 2
            cases[name, 1, points] = partial(_ask, workers[name], points=points, calls=calls)
    for name in (OURS, OUR_MODES, RIPPLE):
        for rows, points in BATCHES if name in workers else ():
            cases[name, rows, points] = partial(_ask, workers[name], points=points, rows=rows, calls=1)
    return cases


def _ask(worker: Worker, **request: Any) -> list[float]:
    found: list[float] = worker.ask("time", **request)["seconds"]
    return found


def local_figures(seconds: dict[Any, float]) -> dict[str, dict[str, Any]]:
    """The local rows from the median seconds of all cases, each with the peers' figures beside it."""
    fits = {
        name: fit_cost(SIZES, [seconds[name, 1, points] for points in SIZES])
        for name in (OURS, PREDECESSOR)
        if (name, 1, SIZES[0]) in seconds
    }
    slopes = {name: (seconds[name, 1, SIZES[-1]] - seconds[name, 1, 10_000]) / (SIZES[-1] - 10_000) for name in fits}
    figures = {
        "overhead": _beside({name: 1e6 * fit.overhead for name, fit in fits.items()}),
        "per_point": _beside({name: 1e9 * slope for name, slope in slopes.items()}),
    }
    for rows, points in BATCHES:
        each = {
            name: 1e6 * seconds[case] / rows for name in (OURS, RIPPLE) if (case := (name, rows, points)) in seconds
        }
        if (PREDECESSOR, 1, points) in seconds:
            each[PREDECESSOR] = 1e6 * seconds[PREDECESSOR, 1, points]
        figures[f"batch_{points}"] = _beside(each)
    of_all = {points: 1e6 * seconds[OUR_MODES, rows, points] / rows for rows, points in BATCHES}
    ratios = {points: of_all[points] / figures[f"batch_{points}"]["value"] for points in of_all}
    others = {f"{points:,} points": ratio for points, ratio in ratios.items() if points != 1_000}
    figures["all_modes"] = {"value": ratios[1_000], "ours": of_all[1_000], "others": others, "peers": {}}
    return figures


def _beside(values: dict[str, float]) -> dict[str, Any]:
    return {"value": values.pop(OURS), "peers": values}


def two_cores(setup: Setup, repetitions: int) -> dict[str, Any] | None:
    """How many times the batches of one thread on one core two threads on two cores get done.

    Beside it, what two processes reach that know nothing of each other: all that these two cores have to give.
    """
    if len(setup.all_cpus) < 2:
        setup.notes.append("two cores against one: this process may use one processor alone")
        return None
    script: list[str | Path] = [sys.executable, PEERS / "bnserve_local.py", "default"]
    pair = sorted(setup.all_cpus)[-2:]
    request = {"points": 1_000, "rows": 256, "calls": 8}
    ratios, limits = [], []
    with ExitStack() as stack:
        first, second = (stack.enter_context(Worker(script, cpus={cpu})) for cpu in pair)
        both = stack.enter_context(Worker(script, cpus=set(pair)))
        at_once = stack.enter_context(ThreadPoolExecutor(2))
        for _ in range(repetitions):
            [one] = second.ask("threads", cpus=pair[1:], **request)["seconds"]
            ratios.append(sum(one / own for own in both.ask("threads", cpus=pair, **request)["seconds"]))
            asked = [
                at_once.submit(worker.ask, "threads", cpus=[cpu], **request)
                for worker, cpu in zip((first, second), pair, strict=True)
            ]
            limits.append(sum(one / answer.result()["seconds"][0] for answer in asked))
    return {"value": median(ratios), "peers": {}, "others": {"two processes": median(limits)}}
