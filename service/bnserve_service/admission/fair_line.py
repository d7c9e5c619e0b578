"""What waits for a worker, in fair order over owners: who has had least comes first.

Start-time fair queueing: every owner has a clock that runs on by the cost of what is taken for it, and whoever's clock
is furthest behind is next. An owner who comes back from a pause starts with the others: time is not saved up. Jobs of
one key are taken together, those of other owners too, which costs nobody anything.
"""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Hashable, Iterator
from typing import Generic, Protocol, TypeVar


class Waiting(Protocol):
    """What a line needs to know of a job."""

    @property
    def key(self) -> Hashable:
        """Jobs with equal keys may be taken together."""

    @property
    def cost(self) -> int:
        """Its work."""

    @property
    def owner(self) -> str:
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

    def pop(self, key: Hashable) -> J:
        """The first job of a key."""
        group = self.groups[key]
        job = group.popleft()
        del self.jobs[job]
        if not group:
            del self.groups[key]
        return job


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
        del owner.jobs[job]
        group = owner.groups[job.key]
        group.remove(job)
        if not group:
            del owner.groups[job.key]
        self._forget_if_idle(job.owner)
        return True

    def newest(self, owner: str) -> J | None:
        """The job that came last of those that wait for an owner."""
        waiting = self._waiting.get(owner)
        return None if waiting is None else next(reversed(waiting.jobs))

    def clear(self) -> list[J]:
        """Take everything out."""
        jobs = list(self)
        self._waiting.clear()
        for owner in self._owners.values():
            owner.groups.clear()
            owner.jobs.clear()
        return jobs

    def take(self, most: int) -> list[J]:
        """What is evaluated together next: the job whose turn it is, and those of its key while they cost at most
        ``most`` together.
        """
        names = sorted(self._waiting, key=lambda name: self._waiting[name].clock)
        first = self._waiting[names[0]]
        self._clock = first.clock
        key = next(iter(first.groups))
        jobs = [first.pop(key)]
        cost = jobs[0].cost
        for name in names:  # the first himself, then whoever has had least
            group = self._waiting[name].groups.get(key)
            while group and cost + group[0].cost <= most:
                jobs.append(self._waiting[name].pop(key))
                cost += jobs[-1].cost
        if key in first.groups:
            first.groups.move_to_end(key)
        self._charge(jobs)
        return jobs

    def _charge(self, jobs: list[J]) -> None:
        for job in jobs:
            self._owners[job.owner].clock += job.cost
        for name in {job.owner for job in jobs}:
            self._forget_if_idle(name)

    def _forget_if_idle(self, name: str) -> None:
        if not self._waiting[name].jobs:
            del self._waiting[name]
