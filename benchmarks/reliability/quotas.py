"""One greedy token at a hundredfold leaves the others' times as they were.

Two users ask now and then; a third has a hundred clients that ask without pause and never heed ``Retry-After``.
Windows with and without the greedy one alternate, so that whatever else the machine does meets both alike. Once every
token has a quota of rows per second, which the greedy one exceeds a hundredfold and is refused; once none has, and the
queue alone keeps order, for requests that are answered on the event loop and for batches that keep a worker busy. The
server has one worker, because on two processors the clients need the other.
"""

from __future__ import annotations

import hashlib
import secrets
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.reliability.load import waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import serving
from benchmarks.reliability.user_load import Times, User, user_load

MECHANISM = """Every token has an account of rows per second and a number of requests under way; what is over it is
refused before the body is read. Workers take the work of whoever has had least, the event loop begins and refuses by
turns, and when the queue is full, the newest of whoever has more than a fair share of it makes room."""
BAR = "the others' p99 <= 2x that without the greedy token; none of theirs refused"
INJECTED_FAULTS = {
    "one-owner": "all callers use one token, so that there is nothing to be fair between",
}

GREEDY_CLIENTS = 100
QUOTA = 50.0
"""Rows per second of each token, where quotas are set; the others ask for less."""
_AHEAD = 0.3
"""Seconds by which the greedy one begins earlier and ends later."""
_PAUSE = 0.05
"""Seconds between a light user's answer and the next request: at most 20 a second."""


@dataclass(frozen=True, slots=True)
class Case:
    """What is asked, and whether tokens have quotas."""

    name: str
    rows: int
    points: int
    quota: float | None = None


CASES = (
    Case("quotas", 1, 277, QUOTA),
    Case("quick", 1, 277),
    Case("batches", 256, 16),
)


@dataclass(slots=True)
class _Pool:
    alone: list[float] = field(default_factory=list)
    beside: list[float] = field(default_factory=list)
    greedy: list[float] = field(default_factory=list)
    refused: list[float] = field(default_factory=list)
    light_refused: int = 0


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    rounds, seconds = (2, 1.5) if short else (8, 3.0)
    figures: Figures = {}
    ratios, passed = [], True
    for case in CASES:
        pool = _measure(case, rounds, seconds, log, injected)
        ratio = quantile(pool.beside, 0.99) / quantile(pool.alone, 0.99)
        refused = 1e3 * quantile(pool.refused, 0.99) if pool.refused else 0.0
        figures |= {
            f"{case.name}: p99 alone, ms": 1e3 * quantile(pool.alone, 0.99),
            f"{case.name}: p99 beside the greedy one, ms": 1e3 * quantile(pool.beside, 0.99),
            f"{case.name}: p99, ratio": ratio,
            f"{case.name}: median, ratio": quantile(pool.beside, 0.5) / quantile(pool.alone, 0.5),
            f"{case.name}: others' answers": len(pool.alone) + len(pool.beside),
            f"{case.name}: others' refusals": pool.light_refused,
            f"{case.name}: greedy answers": len(pool.greedy),
            f"{case.name}: greedy refusals": len(pool.refused),
            f"{case.name}: refused within, p99, ms": refused,
        }
        passed &= ratio <= 2.0 and not pool.light_refused
        ratios.append(f"{case.name} {ratio:.2f}x")
    return Outcome(figures, passed, f"p99 of the others beside a greedy token: {', '.join(ratios)} that without it")


def _measure(case: Case, rounds: int, seconds: float, log: Log, injected: str | None) -> _Pool:
    texts = {name: secrets.token_urlsafe(24) for name in ("greedy", "first", "second")}
    if injected == "one-owner":
        texts = dict.fromkeys(texts, texts["greedy"])
    pool = _Pool()
    with (
        serving("--model", "default", "--workers-threads", "1", tokens=_tokens(texts, case.quota)) as server,
        user_load() as load,
        user_load() as crowd,  # a process of its own, so that the others need not wait for it
        ThreadPoolExecutor(1) as background,
    ):
        greedy, *light = (
            User(
                name,
                waveforms_request(server.url, case.rows, case.points, token=text),
                GREEDY_CLIENTS if name == "greedy" else 1,
                0.0 if name == "greedy" else _PAUSE,
            )
            for name, text in texts.items()
        )
        load.ask(server.address, light, 0.5)
        for number in range(rounds):
            alone = load.ask(server.address, light, seconds)
            asking = background.submit(crowd.ask, server.address, [greedy], seconds + 2.0 * _AHEAD)
            time.sleep(_AHEAD)
            beside = load.ask(server.address, light, seconds) | asking.result()
            pool.alone += _answers(alone, light)
            pool.beside += _answers(beside, light)
            pool.greedy += beside.get("greedy", {}).get("200", np.empty(0)).tolist()
            pool.refused += _refusals(beside.get("greedy", {})).tolist()
            pool.light_refused += sum(len(_refusals(told.get(u.name, {}))) for told in (alone, beside) for u in light)
            log(f"{case.name}, round {number + 1}/{rounds}: others' p99 {1e3 * quantile(pool.alone, 0.99):.1f} ms, "
                f"{1e3 * quantile(pool.beside, 0.99):.1f} ms beside {len(pool.greedy)} greedy answers and "
                f"{len(pool.refused)} refusals")  # fmt: skip
    return pool


def _tokens(texts: dict[str, str], quota: float | None) -> list[dict[str, Any]]:
    limits = {} if quota is None else {"rows_per_second": quota}
    digests = {hashlib.sha256(text.encode()).hexdigest(): name for name, text in texts.items()}
    return [{"name": name, "sha256": digest, **limits} for digest, name in digests.items()]


def _answers(told: dict[str, Times], users: list[User]) -> list[float]:
    return [second for user in users for second in told.get(user.name, {}).get("200", ())]


def _refusals(times: Times) -> NDArray[np.float64]:
    return np.concatenate([[], *(each for status, each in times.items() if status != "200")])


def quantile(seconds: list[float], fraction: float) -> float:
    """A quantile of some times; not a number when there are none."""
    return float(np.quantile(seconds, fraction)) if seconds else float("nan")
