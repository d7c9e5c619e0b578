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
import logging
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, Generic, TypeVar

from bnserve_protocol import Draining
from bnserve_service.admission.control import Backlog, too_late
from bnserve_service.admission.workers import WorkerPool
from bnserve_service.telemetry.metrics import Metrics

J = TypeVar("J")
P = TypeVar("P")
R = TypeVar("R")

logger = logging.getLogger("bnserve.workers")

SHARED_SECONDS = 5.0
"""So long after two owners asked by turns, the loop counts as shared."""


class LoopTurns(Generic[J]):
    """Turns of the event loop, which is a worker, too: it decodes, evaluates what is quick, and refuses.

    While one owner asks, all that came in one turn is done in the next, which is cheapest. While several do, one thing
    is done in each turn, of all owners alternately: whoever has a hundred connections would have a hundred things done
    before the one of somebody else.

    Parameters
    ----------
    evaluate
        Called with the jobs of one turn.
    """

    def __init__(self, evaluate: Callable[[list[J]], None]) -> None:
        self._evaluate = evaluate
        self._alone: list[J | asyncio.Future[None]] = []
        """While one owner asks: his jobs, and what is resolved when a request of his may begin."""
        self._lines: OrderedDict[str, deque[J | asyncio.Future[None]]] = OrderedDict()
        """While several do: by owner, in the order in which they take turns."""
        self._last_owner: str | None = None
        self._shared_until = 0.0
        """0 while one owner asks."""

    async def turn(self, owner: str) -> None:
        """Wait until a request of this owner may begin; at once unless others use the event loop, too."""
        if self._is_shared(owner):
            await self._its_turn(owner)

    def refuse(self, owner: str, refusal: Callable[[], None]) -> None:
        """Call ``refusal`` when it is this owner's turn: what is refused must not keep others waiting either."""
        self._its_turn(owner).add_done_callback(lambda _: refusal())

    def add(self, owner: str, thing: J | asyncio.Future[None]) -> None:
        """Do something when it is this owner's turn, after all that this turn of the loop has brought in."""
        if (self._shared_until == 0.0 and owner == self._last_owner) or not self._is_shared(owner):
            self._alone.append(thing)
            is_first = len(self._alone) == 1
        else:
            is_first = not self._lines
            self._lines.setdefault(owner, deque()).append(thing)
        if is_first:
            asyncio.get_running_loop().call_soon(self._take)

    def _its_turn(self, owner: str) -> asyncio.Future[None]:
        turn = asyncio.get_running_loop().create_future()
        self.add(owner, turn)
        return turn

    def _is_shared(self, owner: str) -> bool:
        """Note that this owner asks; whether others did a short time ago."""
        if owner != self._last_owner:
            if self._last_owner is not None:
                self._shared_until = time.monotonic() + SHARED_SECONDS
                if self._alone:
                    self._lines[self._last_owner] = deque(self._alone)
                self._alone = []
            self._last_owner = owner
        return self._shared_until > 0.0

    def _take(self) -> None:
        """Do what is for this turn."""
        if self._shared_until == 0.0:
            things, self._alone = self._alone, []
        else:
            things = [self._next()]
        jobs = []
        for thing in things:
            if not isinstance(thing, asyncio.Future):
                jobs.append(thing)
            elif not thing.done():  # or its caller went away
                thing.set_result(None)
        if jobs:
            self._evaluate(jobs)

    def _next(self) -> J | asyncio.Future[None]:
        """What is done in this turn while several owners ask."""
        owner, line = next(iter(self._lines.items()))
        thing = line.popleft()
        if line:
            self._lines.move_to_end(owner)
        else:
            del self._lines[owner]
        if self._lines:
            asyncio.get_running_loop().call_soon(self._take)
        elif time.monotonic() >= self._shared_until:
            self._shared_until = 0.0
        return thing


@dataclass(slots=True, eq=False)
class Job(Generic[P, R]):
    """A request waiting for evaluation; ``result`` is resolved on the event loop."""

    key: Hashable
    cost: int
    payload: P
    result: asyncio.Future[R]
    submitted: float = field(default_factory=time.monotonic)
    quick: bool = False
    """Whether it is evaluated on the event loop."""
    owner: str = ""
    """Whose fair share it counts towards."""
    timer: asyncio.TimerHandle | None = None
    deliver: Callable[[R | BaseException], None] | None = None
    """Called with the outcome, in place of resolving ``result``."""

    def resolve(self, outcome: R | BaseException) -> None:
        """Tell whoever waits for this job what came of it."""
        if self.result.done():  # its caller was cancelled
            return
        if self.deliver is not None:
            self.deliver(outcome)
        elif isinstance(outcome, BaseException):
            self.result.set_exception(outcome)
            self.result.exception()  # retrieved: nobody may be waiting any more, which is not worth a warning
        else:
            self.result.set_result(outcome)


class WorkQueue(Generic[P, R]):
    """What asks for an evaluation: admitted within bounds, evaluated by worker threads or by the event loop.

    Parameters
    ----------
    function
        Called with the payloads of one group; returns a result or an exception for each, in order.
    workers
        Threads; as many as processors, because the evaluation releases the interpreter.
    capacity
        The largest sum of costs that may wait or run. What does not fit is refused at once.
    group_cost
        Groups stop growing at this cost; a group has at least one job.
    metrics
        Where to count.
    """

    def __init__(
        self,
        function: Callable[[Sequence[P]], Sequence[R | BaseException]],
        *,
        workers: int,
        capacity: int,
        group_cost: int,
        metrics: Metrics,
    ) -> None:
        self._function = function
        self._group_cost = group_cost
        self._metrics = metrics
        self._backlog = Backlog(capacity, workers)
        self.turns: LoopTurns[Job[P, R]] = LoopTurns(self._evaluate_here)
        """Of the event loop: also for requests that are to begin, or to be refused."""
        self.workers: WorkerPool[Job[P, R]] = WorkerPool(self._evaluate, workers, group_cost)
        """The threads, and what waits for them."""

    @property
    def cost(self) -> int:
        """Work waiting or running, in samples."""
        return self._backlog.total

    def start(self) -> None:
        """Start the workers; results are delivered to the running event loop."""
        self.workers.start()

    def stop(self, timeout: float = 10.0) -> None:
        """Refuse what waits, and wait for what runs, seconds at the longest for each worker."""
        for job in self.workers.stop(timeout):
            self._release(job)
            job.resolve(Draining("This server is shutting down; send the request to another replica."))

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
        key
            Jobs with equal keys may be evaluated together.
        cost
            Its work in samples.
        payload
            What the function gets.
        deadline
            ``time.monotonic()`` after which the answer is of no use.
        quick
            Its evaluation takes less time than handing it to a worker: it is done on the event loop, together with
            the others that this turn of the loop brought in.
        owner
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
        loop = asyncio.get_running_loop()
        now = time.monotonic()
        if deadline is not None:
            self._backlog.check_deadline(deadline, now, owner, 0 if quick else cost)
        if not self._backlog.fits(cost):
            self._make_room(owner, cost)
        job: Job[P, R] = Job(key, cost, payload, loop.create_future(), now, quick, owner)
        if quick:  # not held: as many wait as there are connections, for as long as a few of them take
            self.turns.add(owner, job)
            return job
        self._backlog.add(owner, cost)
        if deadline is not None:
            job.timer = loop.call_later(deadline - now, self._expire, job)
        self.workers.add(job)
        return job

    def check_room(self, owner: str, cost: int, deadline: float | None) -> None:
        """Raise what :meth:`submit` would raise for a job of this cost, as things are; nothing changes."""
        if deadline is not None:
            self._backlog.check_deadline(deadline, time.monotonic(), owner, cost)
        if not self._backlog.fits(cost) and not self._backlog.may_displace(owner, cost):
            raise self._backlog.refusal(owner)

    def withdraw(self, job: Job[P, R], reason: str) -> bool:
        """Remove a job that nobody waits for; False when a worker has it already. Call it on the event loop."""
        if not self.workers.remove(job):
            return False
        self._release(job)
        self._metrics.withdrawn.labels(reason).inc()
        return True

    def _make_room(self, owner: str, cost: int) -> None:
        """Refuse what others have beyond their fair share, or else the job that does not fit."""
        backlog = self._backlog
        if not backlog.may_displace(owner, cost):
            raise backlog.refusal(owner)
        while not backlog.fits(cost):
            victim = self.workers.newest(backlog.beyond_fair_share(owner))
            if victim is None or not self.withdraw(victim, "share"):
                raise backlog.refusal(owner)
            victim.resolve(backlog.refusal(victim.owner))

    def _expire(self, job: Job[P, R]) -> None:
        if self.withdraw(job, "deadline"):
            job.resolve(too_late())

    def _release(self, job: Job[P, R]) -> None:
        if job.quick:
            return
        self._backlog.remove(job.owner, job.cost)
        if job.timer is not None:
            job.timer.cancel()

    def _evaluate_here(self, jobs: list[Job[P, R]]) -> None:
        """Evaluate quick jobs: those of one key together, as many as fit."""
        groups: list[list[Job[P, R]]] = []
        growing: dict[Hashable, tuple[list[Job[P, R]], int]] = {}
        for job in jobs:
            if job.result.done():  # its caller went away
                continue
            group, cost = growing.get(job.key, ([], 0))
            if not group or cost + job.cost > self._group_cost:
                group, cost = [], 0
                groups.append(group)
            group.append(job)
            growing[job.key] = group, cost + job.cost
        for group in groups:
            self._evaluate(group)()

    def _evaluate(self, jobs: list[Job[P, R]]) -> Callable[[], None]:
        """Evaluate jobs of one key; what is returned tells their callers."""
        started = time.monotonic()
        outcomes: Sequence[Any]
        try:
            outcomes = self._function([job.payload for job in jobs])
        except Exception as error:
            logger.exception("evaluation failed")
            outcomes = [error] * len(jobs)
        return partial(self._deliver, jobs, outcomes, started, time.monotonic())

    def _deliver(self, jobs: list[Job[P, R]], outcomes: Sequence[Any], started: float, finished: float) -> None:
        for job, outcome in zip(jobs, outcomes, strict=True):
            self._release(job)
            job.resolve(outcome)
            self._metrics.queue_wait.observe(started - job.submitted)
        self._metrics.group_requests.observe(len(jobs))
        self._backlog.measure(sum(job.cost for job in jobs), finished - started)
