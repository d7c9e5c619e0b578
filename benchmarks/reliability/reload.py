"""A new version is served without anyone noticing: no error, no mixture, no pause.

Versions with other tensors are published and labelled ``stable`` one after another under a steady load. Every answer is
compared, by its digest, with what one version alone gives; latencies with those of the quiet times in between.
"""

from __future__ import annotations

import hashlib
import tempfile
import time
from concurrent.futures import Future
from pathlib import Path

import numpy as np

from benchmarks.reliability.asking import exchange
from benchmarks.reliability.load import Came, Stream, load_process, waveforms_request
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.serving import Server, serving
from benchmarks.reliability.stores import NAME, Versions

MECHANISM = """A new version is read, verified, built, warmed up and compared with a stored answer in a thread of
its own; then one reference is replaced. A request keeps the model that it found when it arrived."""
BAR = "100 reloads: 0 errors, no mixed versions, p99 <= 1.5 times that without reloads"
INJECTED_FAULTS = {
    "mixed-versions": "the tensors of the served model are replaced in place, its name afterwards",
    "reload-on-loop": "versions are loaded on the event loop",
}

RATE = 100.0


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes four minutes."""
    rounds, reloads = (1, 6) if short else (10, 10)
    seconds = 3.0 if short else 8.0
    came: dict[bool, list[Came]] = {False: [], True: []}
    expected: set[str] = set()
    with tempfile.TemporaryDirectory() as folder:
        versions = Versions(Path(folder) / "store", "default")
        versions.publish("0.0.0")
        settings = serving("--store", str(versions.folder), "--model", NAME, injected=injected, poll_seconds=0.1)
        with settings as server, load_process() as load:
            expected.add(_answer_of(server, "0.0.0"))
            stream = Stream("small", waveforms_request(server.url, 1, 64, model=NAME), RATE, with_digests=True)
            number = 0
            for turn in range(2 * rounds):
                busy = turn % 2 == 1
                under_way = load.begin(server.address, [stream], seconds, seed=turn)
                if busy:
                    number = _reload(versions, server, number, reloads, expected, under_way)
                came[busy].append(under_way.result()["small"])
                log(f"round {turn // 2 + 1}/{rounds}, {number} reloads: p99 "
                    f"{1e3 * came[busy][-1].quantile(0.99):.1f} ms, {came[busy][-1].errors} errors")  # fmt: skip
    return _judge(came, expected, number)


def _reload(
    versions: Versions, server: Server, number: int, count: int, expected: set[str], under_way: Future[dict[str, Came]]
) -> int:
    """Publish some versions, each when the last one is served; note what each answers."""
    for _ in range(count):
        if under_way.done():
            return number
        number += 1
        versions.publish(f"0.0.{number}", shipped=("default", "fast")[number % 2])
        while not (answer := _answer_of(server, f"0.0.{number}")) or _answer_of(server, None) != answer:
            time.sleep(0.02)
        expected.add(answer)
        versions.remove(f"0.0.{number - 1}")
    return number


def _answer_of(server: Server, version: str | None) -> str:
    """The digest of the answer to the question of the load; empty when that version is not served."""
    where = NAME if version is None else f"{NAME}/versions/{version}"
    answer = exchange(server.address, waveforms_request(server.url, 1, 64, model=where, Connection="close"))
    return hashlib.sha256(answer.body).hexdigest() if answer.status == 200 else ""


def _judge(came: dict[bool, list[Came]], expected: set[str], reloads: int) -> Outcome:
    everything = [*came[False], *came[True]]
    sent, errors = sum(each.sent for each in everything), sum(each.errors for each in everything)
    seen = {digest: 0 for each in everything for digest in each.digests}
    for each in everything:
        for digest, count in each.digests.items():
            seen[digest] += count
    mixed = sum(count for digest, count in seen.items() if digest not in expected)
    quiet, busy = (
        float(np.quantile(np.concatenate([each.seconds["200"] for each in came[which]]), 0.99))
        for which in (False, True)
    )
    figures = {
        "reloads": reloads,
        "requests": sent,
        "errors": errors,
        "versions seen in answers": len(seen),
        "answers of no version": mixed,
        "p99 without reloads, ms": 1e3 * quiet,
        "p99 with reloads, ms": 1e3 * busy,
        "ratio of p99": busy / quiet,
    }
    summary = (
        f"{reloads} reloads under {sent:,} requests: {errors} errors, {mixed} mixed answers, "
        f"p99 {1e3 * busy:.1f} ms against {1e3 * quiet:.1f} ms ({busy / quiet:.2f}x)"
    )
    return Outcome(figures, not errors and not mixed and busy <= 1.5 * quiet, summary)
