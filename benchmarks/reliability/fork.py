"""The client survives fork, threads and pickling."""

from __future__ import annotations

import multiprocessing
import threading
from collections import Counter
from contextlib import suppress
from typing import Any

import numpy as np

from benchmarks.reliability.client_faults import injecting
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.questions import UNIFORM, Questions
from benchmarks.reliability.serving import serving
from bnserve_client import BnserveError, Model
from bnserve_surrogate import Model as LocalModel

MECHANISM = (
    "Connections belong to the process that opened them: every call looks at the process number, and a forked child "
    "closes its copies of the sockets without a word on the wire and opens its own. No lock is held that a fork could "
    "find taken, and a pickled model is its settings and the version it is pinned to. Retries are off here, so that "
    "nothing is put right silently."
)
BAR = "wrong 0, errors 0"
INJECTED_FAULTS = {
    "shared-sockets": "children go on with the connections of their parent; the digests notice, so there are errors",
    "shared-unchecked": "the same without digests, as other clients do it: answers reach the wrong process",
}
CHILDREN, REQUESTS, TIMES = 8, 200, 12
_CLIENT_FAULTS = {"shared-sockets": ("shared-sockets",), "shared-unchecked": ("shared-sockets", "no-digests")}


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """One client, used before, in forked children, while a thread uses it, too; then in spawned processes."""
    times, requests = (1, 20) if short else (TIMES, REQUESTS)
    local = LocalModel.default()
    local.warm_up()
    counts: Counter[str] = Counter()
    first, second = (*_CLIENT_FAULTS.get(injected or "", ()), None, None)[:2]
    with serving("--model", "default") as server, injecting(first), injecting(second):
        silence = 2.0 if injected else 30.0
        with Model.connect(server.url, retries=0, silence=silence, timeout=4.0 * silence) as model:
            _ask(model, local, 0, 3, counts)
            for number in range(times):
                counts += _round(model, local, number, requests)
                log(f"{CHILDREN} children, {number + 1} of {times}: {dict(counts)}")
            if injected is None:
                counts += _spawned(model, requests)
                log(f"2 spawned processes: {dict(counts)}")
    wrong, errors = counts["wrong"], sum(count for name, count in counts.items() if name not in ("right", "wrong"))
    figures: Figures = {"children": CHILDREN, "requests of each": requests, "times": times, **counts}
    figures |= {"wrong": wrong, "errors": errors}
    asked = counts.total()
    summary = f"{CHILDREN} children x {requests} requests x {times}, with threads and pickling: {asked:,} requests, "
    return Outcome(figures, wrong == errors == 0 and counts["right"] > 0, summary + f"wrong {wrong}, errors {errors}")


def _ask(model: Model, local: LocalModel, seed: int, requests: int, counts: Counter[str]) -> None:
    """Questions that nobody else asks; stops when it is plain that nothing works."""
    questions = Questions(model, seed=(6, seed), grids=(UNIFORM,), most_rows=1)  # answers of one size can be mistaken
    for _ in range(requests):
        question = questions.next()
        try:
            found = question.ask(model)
        except BnserveError as error:
            counts[type(error).__name__] += 1
            if counts[type(error).__name__] > 3:
                return
            continue
        counts["right" if found == question.ask(local) else "wrong"] += 1


def _round(model: Model, local: LocalModel, number: int, requests: int) -> Counter[str]:
    """Children are forked while a thread of this process is in the middle of its own requests."""
    context = multiprocessing.get_context("fork")
    results, counts = context.SimpleQueue(), Counter[str]()
    seeds = np.arange(1, CHILDREN + 2) + 100 * number
    thread = threading.Thread(target=_ask, args=(model, local, int(seeds[-1]), requests, counts))
    children = [
        context.Process(target=_child, args=(model, local, int(seed), requests, results)) for seed in seeds[:-1]
    ]
    thread.start()
    for child in children:
        child.start()
    found = [results.get() for _ in children]
    for child in children:
        child.join()
    thread.join()
    return sum(found, counts)


def _child(model: Model, local: LocalModel, seed: int, requests: int, results: Any) -> None:
    counts: Counter[str] = Counter()
    try:
        _ask(model, local, seed, requests, counts)
    except Exception as error:
        counts[type(error).__name__] += 1
    results.put(counts)


def _spawned(model: Model, requests: int) -> Counter[str]:
    """Processes that share nothing with this one: the model is pickled on its way."""
    context = multiprocessing.get_context("spawn")
    results = context.SimpleQueue()
    processes = [context.Process(target=_elsewhere, args=(model, seed, requests, results)) for seed in (1, 2)]
    for process in processes:
        process.start()
    found = [results.get() for _ in processes]
    for process in processes:
        process.join()
    return sum(found, Counter[str]())


def _elsewhere(model: Model, seed: int, requests: int, results: Any) -> None:
    local = LocalModel.default()
    with suppress(BrokenPipeError):
        _child(model, local, -seed % 2**31, requests, results)
