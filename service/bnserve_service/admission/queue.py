"""Batching without a timer: idle workers take a request at once, busy workers find several waiting and take them
together.

The queue knows neither physics nor HTTP. A job is a payload with a key, a cost and an owner; jobs of one key may be
evaluated in one call. Owners are served in fair order, and one alone may fill the queue, until others come: then what
he has beyond his fair share is refused, the newest first. All but the evaluation itself happens on the event loop or
under one short lock; jobs whose evaluation takes less time than the hand-over to a worker are evaluated there too,
all that came in one turn of the loop together.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import os
import threading
import time
from collections import deque
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field
from typing import Any, Generic, TypeVar

from bnserve_protocol import DeadlineExceeded, Draining, Overloaded, QuotaExceeded
from bnserve_service.admission.capacity import Capacity
from bnserve_service.admission.fair_line import FairLine
from bnserve_service.admission.loop_turns import Beginning, LoopTurns
from bnserve_service.telemetry.metrics import Metrics

P = TypeVar("P")
R = TypeVar("R")

logger = logging.getLogger("bnserve.workers")

_ASSUMED_RATE = 1e8
"""Samples per second and worker assumed for Retry-After before anything was measured."""
_RATE_MEMORY = 0.2
_NICENESS = 5
"""Of the workers: a third of the weight of the event loop, which needs little."""


@dataclass(slots=True, eq=False)
class Job(Generic[P, R]):
    """A request waiting for evaluation; ``result`` is resolved on the event loop."""

    key: Hashable
    cost: int
    payload: P
    result: asyncio.Future[R]
    deadline: float | None = None
    submitted: float = field(default_factory=time.monotonic)
    quick: bool = False
    """Whether it is evaluated on the event loop."""
    owner: str = ""
    """Whose fair share it counts towards."""
    timer: asyncio.TimerHandle | None = None
    deliver: Callable[[R | BaseException], None] | None = None
    """Called with the outcome, in place of resolving ``result``."""


@dataclass(slots=True, eq=False)
class _Worker:
    thread: threading.Thread
    busy_since: float | None = None


class WorkQueue(Generic[P, R]):
    """A bounded queue in front of a pool of worker threads.

    Parameters
    ----------
    evaluate:
        Called in a worker thread with the payloads of one group; returns a result or an exception for each, in order.
    workers:
        Threads; as many as processors, because the evaluation releases the interpreter.
    capacity:
        The largest sum of costs that may wait or run. What does not fit is refused at once.
    group_cost:
        Groups stop growing at this cost; a group has at least one job.
    metrics:
        Where to count.
    """

    def __init__(
        self,
        evaluate: Callable[[Sequence[P]], Sequence[R | BaseException]],
        *,
        workers: int,
        capacity: int,
        group_cost: int,
        metrics: Metrics,
    ) -> None:
        self._evaluate = evaluate
        self._group_cost = group_cost
        self._metrics = metrics
        self._line: FairLine[Job[P, R]] = FairLine()
        self._turns: LoopTurns[Job[P, R] | Beginning] = LoopTurns()
        self._capacity = Capacity(capacity)
        self._rate = _ASSUMED_RATE * workers
        self._changed = threading.Condition()
        self._stopping = False
        self._loop: asyncio.AbstractEventLoop | None = None
        self._workers = [
            _Worker(threading.Thread(target=self._work, args=(index,), name=f"bnserve-worker-{index}", daemon=True))
            for index in range(workers)
        ]

    @property
    def cost(self) -> int:
        """Work waiting or running, in samples."""
        return self._capacity.total

    @property
    def waiting(self) -> int:
        """Jobs that no worker has taken yet."""
        with self._changed:
            return len(self._line)

    def longest_evaluation(self) -> float:
        """Seconds that the slowest worker has been in its present evaluation; 0 when all are idle."""
        now = time.monotonic()
        return max((now - since for worker in self._workers if (since := worker.busy_since) is not None), default=0.0)

    def start(self) -> None:
        """Start the workers; results are delivered to the running event loop."""
        self._loop = asyncio.get_running_loop()
        for worker in self._workers:
            worker.thread.start()

    def stop(self, timeout: float = 10.0) -> None:
        """Refuse what waits, and wait for what runs, seconds at the longest for each."""
        with self._changed:
            self._stopping = True
            waiting = self._line.clear()
            self._changed.notify_all()
        for job in waiting:
            self._release(job)
            _resolve(job, Draining("This server is shutting down; send the request to another replica."))
        for worker in self._workers:
            if worker.thread.is_alive():
                worker.thread.join(timeout)

    def submit(
        self,
        key: Hashable,
        cost: int,
        payload: P,
        deadline: float | None = None,
        *,
        quick: bool = False,
        owner: str = "",
    ) -> Job[P, R]:
        """Queue a job.

        Parameters
        ----------
        key:
            Jobs with equal keys may be evaluated together.
        cost:
            Its work in samples.
        payload:
            What ``evaluate`` gets.
        deadline:
            ``time.monotonic()`` after which the answer is of no use.
        quick:
            Its evaluation takes less time than handing it to a worker: it is done on the event loop, together with
            the others that this turn of the loop brought in.
        owner:
            Who asks; every owner gets a fair share of the workers and of the queue.

        Raises
        ------
        Overloaded
            The queue is full, or what waits before this job takes longer than its deadline allows; ``retry_after``
            says when there may be room, from the measured speed.
        QuotaExceeded
            The queue is full, others have work in it, and this owner has his fair share of it.
        DeadlineExceeded
            It has passed already.
        """
        assert self._loop is not None, "start() comes first"
        now = time.monotonic()
        if deadline is not None:
            self._check_deadline(deadline, now, owner, 0 if quick else cost)
        if not self._capacity.fits(cost):
            self._make_room(owner, cost)
        job: Job[P, R] = Job(key, cost, payload, self._loop.create_future(), deadline, now, quick, owner)
        if quick:  # not held: as many wait as there are connections, for as long as a few of them take
            if self._turns.add(job):
                self._loop.call_soon(self._take_turns)  # after all that this turn of the loop has brought in
            return job
        self._capacity.add(owner, cost)
        if deadline is not None:
            job.timer = self._loop.call_later(deadline - now, self._expire, job)
        with self._changed:
            self._line.add(job)
            self._changed.notify()
        return job

    def check_room(self, owner: str, cost: int, deadline: float | None) -> None:
        """Raise what :meth:`submit` would raise for a job of this cost, as things are; nothing changes."""
        if deadline is not None:
            self._check_deadline(deadline, time.monotonic(), owner, cost)
        if not self._capacity.fits(cost) and not self._capacity.may_displace(owner, cost):
            raise self._full(owner)

    def _check_deadline(self, deadline: float, now: float, owner: str, cost: int) -> None:
        """Refuse what would be finished too late: computed all the same, it would make others late as well."""
        if deadline <= now:
            raise _too_late()
        ahead = self._capacity.ahead_of(owner)
        if ahead and cost and now + (ahead + cost) / self._rate > deadline:
            raise Overloaded(
                "What waits on this server takes longer than this deadline allows; try another replica, or allow more.",
                retry_after=max(1.0, ahead / self._rate),
            )

    async def turn(self, owner: str) -> None:
        """Wait until a request of this owner may begin; at once unless others use the event loop, too."""
        if self._turns.is_shared(owner):
            assert self._loop is not None, "start() comes first"
            await self._its_turn(owner)

    def _its_turn(self, owner: str) -> asyncio.Future[None]:
        assert self._loop is not None, "start() comes first"
        beginning = Beginning(owner, self._loop.create_future())
        if self._turns.add(beginning):
            self._loop.call_soon(self._take_turns)
        return beginning.turn

    def refuse(self, owner: str, refusal: Callable[[], None]) -> None:
        """Call ``refusal`` when it is this owner's turn: what is refused must not keep others waiting either."""
        self._its_turn(owner).add_done_callback(lambda _: refusal())

    def _make_room(self, owner: str, cost: int) -> None:
        """Refuse what others have beyond their fair share, or else the job that does not fit."""
        capacity = self._capacity
        if not capacity.may_displace(owner, cost):
            raise self._full(owner)
        while not capacity.fits(cost):
            victim = self._newest_beyond_fair_share(owner)
            if victim is None or not self.withdraw(victim, "share"):
                raise self._full(owner)
            _resolve(victim, self._full(victim.owner))

    def _newest_beyond_fair_share(self, newcomer: str) -> Job[P, R] | None:
        with self._changed:
            for owner in self._capacity.beyond_fair_share(newcomer):
                job = self._line.newest(owner)
                if job is not None:
                    return job
        return None

    def _full(self, owner: str) -> Overloaded | QuotaExceeded:
        seconds = min(30.0, self._capacity.backlog(owner) / self._rate)
        if self._capacity.is_shared_by_others(owner):
            return QuotaExceeded(
                "This server is busy with the requests of several callers, and you have your fair share of its queue; "
                "try again when some of yours are answered.",
                retry_after=max(0.01, seconds),
            )
        return Overloaded(
            "The queue of this server is full; try again shortly, or another replica.", retry_after=max(1.0, seconds)
        )

    def withdraw(self, job: Job[P, R], reason: str) -> bool:
        """Remove a job that nobody waits for; False when a worker has it already. Call it on the event loop."""
        with self._changed:
            if not self._line.remove(job):
                return False
        self._release(job)
        self._metrics.withdrawn.labels(reason).inc()
        return True

    def _take_turns(self) -> None:
        """Do what is for this turn of the event loop."""
        jobs, later = self._turns.take()
        if later:
            assert self._loop is not None, "it has called this"
            self._loop.call_soon(self._take_turns)
        groups: dict[Hashable, deque[Job[P, R]]] = {}
        for job in jobs:
            if isinstance(job, Beginning):
                if not job.turn.done():  # or its caller went away
                    job.turn.set_result(None)
            elif not job.result.done():  # or its caller went away
                groups.setdefault(job.key, deque()).append(job)
        for group in groups.values():
            while group:
                together = self._next_of(group)
                started = time.monotonic()
                outcomes = self._evaluate_safely([job.payload for job in together])
                self._deliver(together, outcomes, started, time.monotonic())

    def _expire(self, job: Job[P, R]) -> None:
        if self.withdraw(job, "deadline"):
            _resolve(job, _too_late())

    def _release(self, job: Job[P, R]) -> None:
        if job.quick:
            return
        self._capacity.remove(job.owner, job.cost)
        if job.timer is not None:
            job.timer.cancel()

    def _work(self, index: int) -> None:
        _stand_back()
        while (jobs := self._take()) is not None:
            worker = self._workers[index]
            worker.busy_since = started = time.monotonic()
            outcomes = self._evaluate_safely([job.payload for job in jobs])
            finished = time.monotonic()
            worker.busy_since = None
            loop = self._loop
            if loop is None or loop.is_closed():
                return
            loop.call_soon_threadsafe(self._deliver, jobs, outcomes, started, finished)
            del jobs, outcomes  # or an idle worker would keep the last answer's memory

    def _take(self) -> list[Job[P, R]] | None:
        with self._changed:
            while not self._line:
                if self._stopping:
                    return None
                self._changed.wait()
            return self._line.take(self._group_cost)

    def _next_of(self, group: deque[Job[P, R]]) -> list[Job[P, R]]:
        """What is evaluated together next: the first job of a group, and those after it while they fit."""
        jobs = [group.popleft()]
        cost = jobs[0].cost
        while group and cost + group[0].cost <= self._group_cost:
            jobs.append(group.popleft())
            cost += jobs[-1].cost
        return jobs

    def _evaluate_safely(self, payloads: Sequence[P]) -> Sequence[Any]:
        try:
            return self._evaluate(payloads)
        except Exception as error:
            logger.exception("evaluation failed")
            return [error] * len(payloads)

    def _deliver(self, jobs: list[Job[P, R]], outcomes: Sequence[Any], started: float, finished: float) -> None:
        for job, outcome in zip(jobs, outcomes, strict=True):
            self._release(job)
            _resolve(job, outcome)
            self._metrics.queue_wait.observe(started - job.submitted)
        self._metrics.group_requests.observe(len(jobs))
        seconds = finished - started
        if seconds > 0.0:
            rate = len(self._workers) * sum(job.cost for job in jobs) / seconds
            self._rate += _RATE_MEMORY * (rate - self._rate)


def _stand_back() -> None:
    """Let the event loop go before this thread where there are not enough processors for both.

    Or whoever only wants to be refused, or has a small question, waits for the workers' time slices one after another.
    """
    with contextlib.suppress(OSError, AttributeError):  # where threads have no priority of their own
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _NICENESS)


def _resolve(job: Job[P, R], outcome: R | BaseException) -> None:
    if job.result.done():  # its caller was cancelled
        return
    if job.deliver is not None:
        job.deliver(outcome)
        return
    if isinstance(outcome, BaseException):
        job.result.set_exception(outcome)
        job.result.exception()  # retrieved: nobody may be waiting any more, which is not worth a warning
    else:
        job.result.set_result(outcome)


def _too_late() -> DeadlineExceeded:
    return DeadlineExceeded("The deadline of this request passed before its evaluation began; allow more time.")
