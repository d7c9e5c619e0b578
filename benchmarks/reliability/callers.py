"""Sampler processes: each asks one question after another, and compares every answer with that of the local model."""

from __future__ import annotations

import hashlib
import multiprocessing
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Self

import numpy as np

from benchmarks.reliability.client_faults import injecting
from benchmarks.reliability.outcome import Figures
from benchmarks.reliability.questions import EXPLICIT, SHORT, UNIFORM, UPLOADED, Question, Questions
from benchmarks.servers import ServerFailed
from bnserve_client import BnserveError, Model
from bnserve_surrogate import Model as LocalModel

_fork = multiprocessing.get_context("fork")
_CONNECTING = 120.0


@dataclass(frozen=True, slots=True)
class Task:
    """What every caller does.

    Parameters
    ----------
    name:
        Of the model.
    store:
        Where the local model is, if it is none of those that ship.
    options:
        Of ``Model.connect``.
    injected:
        A fault of :mod:`.client_faults`.
    pool:
        How many different questions there are, the same for all callers; 0 for ever new ones.
    reconnect:
        After how many questions a caller connects again, and follows the label.
    pause:
        Seconds between questions.
    """

    name: str = "default"
    store: Path | None = None
    options: dict[str, Any] = field(default_factory=dict)
    injected: str | None = None
    pool: int = 0
    reconnect: int = 0
    pause: float = 0.0


@dataclass(slots=True)
class Log:
    """What came of the questions of one caller, or of several."""

    asked: int = 0
    right: int = 0
    wrong: int = 0
    failures: Counter[str] = field(default_factory=Counter)
    """Questions that were lost, by the error."""
    seconds: list[float] = field(default_factory=list)
    answers: Counter[tuple[str, str, str]] = field(default_factory=Counter)
    """Digests of question, model and answer, where questions come from a pool."""

    @property
    def lost(self) -> int:
        """Questions without an answer."""
        return self.asked - self.right - self.wrong

    def add(self, other: Log) -> None:
        """Add another log to this one."""
        self.asked += other.asked
        self.right += other.right
        self.wrong += other.wrong
        self.failures += other.failures
        self.seconds += other.seconds
        self.answers += other.answers

    def figures(self) -> Figures:
        """The counts, and the times in milliseconds."""
        times = np.quantile(self.seconds or [0.0], [0.5, 0.99, 0.999, 1.0]) * 1e3
        found: Figures = {"requests": self.asked, "wrong": self.wrong, "lost": self.lost}
        found |= dict(zip(("p50 ms", "p99 ms", "p99.9 ms", "slowest ms"), (float(time) for time in times), strict=True))
        return found | {f"lost: {name}": count for name, count in self.failures.items()}


class Callers:
    """Processes that ask from when the context is entered, and until it is left; then ``log`` is complete.

    Parameters
    ----------
    addresses:
        Of each caller; as many callers as addresses.
    task:
        What they do.

    Raises
    ------
    ServerFailed
        When entered: some caller could not connect.
    """

    def __init__(self, addresses: Sequence[str | list[str]], task: Task) -> None:
        _local(task.name, "stable", task.store)  # once, before the forks
        self.log = Log()
        self._stop = _fork.Event()
        self._pipes: list[Connection] = []
        self._processes = []
        self._addresses = addresses
        for number in range(len(addresses)):
            here, there = _fork.Pipe()
            self._pipes.append(here)
            self._processes.append(_fork.Process(target=_call, args=(number, task, self._stop, there)))

    def __enter__(self) -> Self:
        for process in self._processes:
            process.start()
        for pipe, address in zip(self._pipes, self._addresses, strict=True):
            pipe.send(address)  # only now, so that none inherits what a proxy in this process has accepted from another
        for pipe in self._pipes:
            said = pipe.recv() if pipe.poll(_CONNECTING) else "nothing"
            if said != "ready":
                self._end()
                raise ServerFailed(f"A caller could not connect: {said}.")
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        for pipe in self._pipes:
            self.log.add(pipe.recv())
        self._end()

    def _end(self) -> None:
        self._stop.set()
        for process in self._processes:
            process.join(10.0)
            process.kill()


@cache
def _local(name: str, version: str, store: Path | None) -> LocalModel:
    model = LocalModel.load(name, version=version, store=store)
    model.warm_up()
    return model


def _call(number: int, task: Task, stop: Any, out: Connection) -> None:
    """The life of a caller."""
    log, address = Log(), out.recv()
    with injecting(task.injected):
        try:
            model = Model.connect(address, task.name, **task.options)
            out.send("ready")
        except BnserveError as error:
            out.send(error.detail)
            return
        questions = _questions(number, model, task)
        while not stop.is_set():
            if task.reconnect and log.asked % task.reconnect == task.reconnect - 1:
                model = _connect_again(model, address, task, log)
            _ask(next(questions), model, task, log)
            time.sleep(task.pause)
        model.close()
    out.send(log)


def _questions(number: int, model: Model, task: Task) -> Any:
    grids = (UNIFORM, SHORT, EXPLICIT, UPLOADED)
    if not task.pool:
        endless = Questions(model, seed=(1, number), grids=grids)
        while True:
            yield endless.next()
    common = Questions(model, seed=0, grids=grids)
    pool = [common.next() for _ in range(task.pool)]
    random = np.random.default_rng(number)
    while True:
        yield pool[int(random.integers(len(pool)))]


def _connect_again(model: Model, address: str | list[str], task: Task, log: Log) -> Model:
    try:
        fresh = Model.connect(address, task.name, **task.options)
    except BnserveError as error:
        log.failures[f"{type(error).__name__} when connecting"] += 1
        log.asked += 1
        return model
    model.close()
    return fresh


def _ask(question: Question, model: Model, task: Task, log: Log) -> None:
    log.asked += 1
    started = time.perf_counter()
    try:
        found = question.ask(model)
    except Exception as error:  # whatever reaches a sampler ends it
        log.failures[type(error).__name__] += 1
        return
    log.seconds.append(time.perf_counter() - started)
    local = _local(task.name, model.description.version, task.store)
    right = found == question.ask(local)
    log.right += right
    log.wrong += not right
    if task.pool:
        log.answers[question.key, model.description.digest, hashlib.sha256(found).hexdigest()] += 1
