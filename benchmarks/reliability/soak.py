"""Flat for days: neither memory nor open files grow.

A steady load of waveforms in all sizes, with reloads, uploaded grids, bodies that are broken and clients that vanish,
for more than an hour; memory and open files are read once a minute, while the server is idle for a moment.
"""

from __future__ import annotations

import random
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.reliability.churn import Churn
from benchmarks.reliability.load import Load, Stream, get_request, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from benchmarks.reliability.stores import NAME, Versions

MECHANISM = """Everything that callers can make the server keep is bounded (grids, analyses, answers under way, the
queue), connections that do nothing are closed, a version that is replaced is dropped with its last request, the
allocator of a server process has one arena, so that freed memory is used again, and what is free goes back to the
system every half minute. Nothing is restarted: the process that is measured is the one that serves."""
BAR = "slope of the memory <= 1 MB/h after warm-up, open files flat, no 5xx; an injected leak is caught"
INJECTED_FAULTS = {
    "leak": "the server keeps a quarter of every answer",
    "open-files": "every 20th request leaves a file open",
}


OPTIONS: tuple[str, ...] = ()
"""Of ``bnserve serve``; with ``("--workers", "2")``, the memory of the supervisor and its workers is added up."""


BURST = 8.0
"""How much faster the first two turns are: memory that many requests at the same time take is taken before the slope
is measured, and not whenever chance (or a machine that is busy elsewhere) brings many together."""


@dataclass(frozen=True, slots=True)
class Size:
    """How long and how hard: turns of load, seconds of each, how many of them warm up, and how much faster."""

    turns: int
    seconds: float
    warm_up: int
    pace: float
    growth: float
    """The bar: bytes per hour; a short run can only see a large leak."""


LONG = Size(turns=72, seconds=58.0, warm_up=10, pace=1.0, growth=1e6)
SHORT = Size(turns=6, seconds=1.0, warm_up=2, pace=12.0, growth=3e9)
INJECTED = Size(turns=12, seconds=13.0, warm_up=3, pace=4.0, growth=1e6)


@dataclass(slots=True)
class Reading:
    """What was seen at the end of one turn."""

    hours: float
    rss: int
    fds: int


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes 72 minutes."""
    size = SHORT if short else INJECTED if injected else LONG
    with tempfile.TemporaryDirectory() as folder:
        versions = Versions(Path(folder) / "store")
        versions.publish("1.0.0")
        server_of = serving(*OPTIONS, injected=injected, stores=[versions.folder], max_grids=16, poll_seconds=1.0)
        with server_of as server, load_process() as load:
            churn = Churn(server, versions, random.Random(1), size.pace)
            readings, counts = _soak(server, load, churn, size, log)
            status = server.stop()
    return _judge(readings, counts | churn.counts | {"exit status": status}, size)


def _soak(server: Server, load: Load, churn: Churn, size: Size, log: Log) -> tuple[list[Reading], dict[str, int]]:
    readings: list[Reading] = []
    counts = {"requests": 0, "5xx": 0, "failed": 0}
    for turn in range(size.turns):
        pace = size.pace * (BURST if turn < 2 else 1.0)
        under_way = load.begin(server.address, _streams(server, pace), size.seconds, timeout=120.0, seed=turn)
        churn.until(under_way)
        for came in under_way.result().values():
            counts["requests"] += came.sent
            counts["5xx"] += sum(came.count(status) for status in came.seconds if status.startswith("5"))
            counts["failed"] += came.count("failed", "timeout")
        churn.settle()
        readings.append(Reading(churn.seconds / 3600.0, server.rss(), server.fds()))
        log(f"turn {turn + 1}/{size.turns}: {readings[-1].rss / 1e6:.2f} MB, {readings[-1].fds} files, "
            f"{server.cpu_seconds():.0f} s of processor, {counts} {churn.counts}")  # fmt: skip
    return readings, counts


def _streams(server: Server, pace: float) -> list[Stream]:
    """All ways: on the event loop, in the worker threads, large answers, text."""
    small = waveforms_request(server.url, 1, 64, model=NAME)
    return [
        Stream("small", small, 4.0 * pace),
        Stream("middle", waveforms_request(server.url, 64, 512, model=NAME), 1.0 * pace),
        Stream("large", waveforms_request(server.url, 16, 2**14, model=NAME), 0.2 * pace),
        Stream("text", waveforms_request(server.url, 2, 32, model=NAME, Accept="application/json"), 0.5 * pace),
        Stream("ready", get_request(server.url, "/v2/health/ready"), 0.5 * pace),
        Stream("metrics", get_request(server.url, "/metrics"), 0.1 * pace),
    ]


def _judge(readings: list[Reading], counts: dict[str, int], size: Size) -> Outcome:
    later = readings[size.warm_up :]
    slope = theil_sen([each.hours for each in later], [float(each.rss) for each in later])
    open_files = max(each.fds for each in later[len(later) // 2 :]) - max(each.fds for each in later[: len(later) // 2])
    hours = later[-1].hours - later[0].hours
    figures: Figures = {
        "hours after warm-up": round(hours, 4),
        "memory slope, MB/h": slope / 1e6,
        "memory after warm-up, MB": later[0].rss / 1e6,
        "memory at the end, MB": later[-1].rss / 1e6,
        "growth of open files": open_files,
        "open files at the end": later[-1].fds,
    }
    passed = (
        slope <= size.growth and open_files <= 2 and counts["5xx"] == counts["failed"] == counts["exit status"] == 0
    )
    summary = (
        f"{slope / 1e6:+.2f} MB/h over {hours:.2f} h, {open_files:+d} open files, {counts['requests']:,} requests, "
        f"{counts['reloads']} reloads, {counts['bad bodies']:,} bad bodies, {counts['vanished']:,} vanished clients, "
        f"{counts['5xx'] + counts['failed']} errors"
    )
    return Outcome({**figures, **counts}, passed, summary)


def theil_sen(times: list[float], values: list[float]) -> float:
    """The median of the slopes between all pairs of points: one step or one outlier is no trend."""
    first, second = np.triu_indices(len(times), 1)
    t, v = np.array(times), np.array(values)
    return float(np.median((v[second] - v[first]) / (t[second] - t[first])))
