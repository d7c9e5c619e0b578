"""Worker threads, and what waits for them in fair order over owners: who has had least comes first.

Start-time fair queueing: every owner has a clock that runs on by the cost of what is taken for it, and whoever's clock
is furthest behind is next. An owner who comes back from a pause starts with the others: time is not saved up. Jobs of
one key are taken together, those of other owners too, which costs nobody anything.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import threading
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Hashable, Iterable, Iterator
from typing import Generic, Protocol, TypeVar

_NICENESS = 5
"""Of the workers: a third of the weight of the event loop, which needs little."""


class Waiting(Protocol):
    """What a line needs to know of a job."""

    key: Hashable
    """Jobs with equal keys may be taken together."""
    cost: int
    """Its work."""
    owner: str
    """Who asked for it."""


J = TypeVar("J", bound=Waiting)


class _Owner(Generic[J]):
    """What waits for one owner."""

    def __init__(self) -> None:
        self.groups: OrderedDict[Hashable, deque[J]] = OrderedDict()
        """By key; every key gets its turn."""
        self.jobs: dict[J, None] = {}
        """In order of arrival."""
        self.clock = 0.0
        """The work that was done for this owner, in terms of the line's clock."""

    def remove(self, job: J) -> None:
        """Take a job out."""
        del self.jobs[job]
        group = self.groups[job.key]
        group.remove(job)
        if not group:
            del self.groups[job.key]


class FairLine(Generic[J]):
    """Jobs in fair order. Not safe for threads: whoever uses it holds a lock.

    There are as many owners as callers can be told apart: the tokens of the settings, or one. All are remembered.
    """

    def __init__(self) -> None:
        self._owners: dict[str, _Owner[J]] = {}
        self._waiting: dict[str, _Owner[J]] = {}
        """Those who have jobs here."""
        self._clock = 0.0
        """That of the owner who was served last, when he was served."""

    def __len__(self) -> int:
        return sum(len(owner.jobs) for owner in self._waiting.values())

    def __bool__(self) -> bool:
        return bool(self._waiting)

    def __iter__(self) -> Iterator[J]:
        for owner in self._waiting.values():
            yield from owner.jobs

    def add(self, job: J) -> None:
        """Put a job at the end of its owner's line."""
        owner = self._waiting.get(job.owner)
        if owner is None:
            owner = self._owners.setdefault(job.owner, _Owner())
            owner.clock = max(owner.clock, self._clock)
            self._waiting[job.owner] = owner
        owner.jobs[job] = None
        owner.groups.setdefault(job.key, deque()).append(job)

    def remove(self, job: J) -> bool:
        """Take a job out; False when it is not here."""
        owner = self._waiting.get(job.owner)
        if owner is None or job not in owner.jobs:
            return False
        owner.remove(job)
        self._forget_if_idle(job.owner)
        return True

    def newest(self, owners: Iterable[str]) -> J | None:
        """The job that came last of those of the first of these owners who has any here."""
        waiting = next((self._waiting[owner] for owner in owners if owner in self._waiting), None)
        return None if waiting is None else next(reversed(waiting.jobs))

    def take(self, most: int) -> list[J]:
        """What is evaluated together next: the job whose turn it is, and those of its key that fit into ``most``."""
        names = sorted(self._waiting, key=lambda name: self._waiting[name].clock)
        first = self._waiting[names[0]]
        self._clock = first.clock
        key = next(iter(first.groups))
        jobs: list[J] = []
        cost = 0
        for name in names:  # the first himself, then whoever has had least
            owner = self._waiting[name]
            group = owner.groups.get(key)
            while group and (not jobs or cost + group[0].cost <= most):
                jobs.append(group[0])
                cost += group[0].cost
                owner.clock += group[0].cost
                owner.remove(group[0])
            self._forget_if_idle(name)
        if key in first.groups:
            first.groups.move_to_end(key)
        return jobs

    def _forget_if_idle(self, name: str) -> None:
        if not self._waiting[name].jobs:
            del self._waiting[name]


class WorkerPool(Generic[J]):
    """Threads that evaluate what waits: an idle one takes a job at once, a busy one finds several waiting.

    Parameters
    ----------
    evaluate
        Called in a thread with jobs of one key; what it returns is called on the event loop.
    threads
        As many as processors, because the evaluation releases the interpreter.
    group_cost
        Jobs that are taken together cost at most this; it is at least one job.
    """

    def __init__(self, evaluate: Callable[[list[J]], Callable[[], None]], threads: int, group_cost: int) -> None:
        self._evaluate = evaluate
        self._group_cost = group_cost
        self._line: FairLine[J] = FairLine()
        self._changed = threading.Condition()
        self._stopping = False
        self._threads: list[threading.Thread] = []
        self._busy_since: list[float | None] = [None] * threads

    @property
    def waiting(self) -> int:
        """Jobs that no thread has taken yet."""
        with self._changed:
            return len(self._line)

    def longest_evaluation(self) -> float:
        """Seconds that the slowest thread has been in its present evaluation; 0 when all are idle."""
        now = time.monotonic()
        return max((now - since for since in self._busy_since if since is not None), default=0.0)

    def start(self) -> None:
        """Start the threads; they deliver to the running event loop."""
        loop = asyncio.get_running_loop()
        for index in range(len(self._busy_since)):
            name = f"bnserve-worker-{index}"
            self._threads.append(threading.Thread(target=self._work, args=(index, loop), name=name, daemon=True))
            self._threads[-1].start()

    def stop(self, timeout: float) -> list[J]:
        """Wait for what runs, seconds at the longest for each thread; returns what waited and will not be evaluated."""
        with self._changed:
            self._stopping = True
            waiting, self._line = list(self._line), FairLine()
            self._changed.notify_all()
        for thread in self._threads:
            thread.join(timeout)
        return waiting

    def add(self, job: J) -> None:
        """Have a job evaluated."""
        with self._changed:
            self._line.add(job)
            self._changed.notify()

    def remove(self, job: J) -> bool:
        """Take a job out; False when a thread has it already."""
        with self._changed:
            return self._line.remove(job)

    def newest(self, owners: list[str]) -> J | None:
        """See :meth:`FairLine.newest`."""
        with self._changed:
            return self._line.newest(owners)

    def _work(self, index: int, loop: asyncio.AbstractEventLoop) -> None:
        _stand_back()
        while (jobs := self._take()) is not None:
            self._busy_since[index] = time.monotonic()
            deliver = self._evaluate(jobs)
            self._busy_since[index] = None
            if loop.is_closed():
                return
            loop.call_soon_threadsafe(deliver)
            del jobs, deliver  # or an idle thread would keep the last answer's memory

    def _take(self) -> list[J] | None:
        with self._changed:
            self._changed.wait_for(lambda: self._line or self._stopping)
            return self._line.take(self._group_cost) if self._line else None


def _stand_back() -> None:
    """Let the event loop go before this thread where there are not enough processors for both.

    Or whoever only wants to be refused, or has a small question, waits for the workers' time slices one after another.
    """
    with contextlib.suppress(OSError, AttributeError):  # where threads have no priority of their own
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _NICENESS)
