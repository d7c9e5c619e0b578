"""Quick jobs of one turn of the event loop: all of them while one owner asks, a few of each while several do."""

from __future__ import annotations

import time
from collections import OrderedDict, deque
from typing import Generic, Protocol, TypeVar

PER_TURN = 2
"""Jobs of one turn while several owners ask. Then nobody waits longer for the loop than these take, however many
connections another has; taken all together they are up to twice as cheap."""
SHARED_SECONDS = 5.0
"""So long after two owners asked by turns, the loop counts as shared."""


class Owned(Protocol):
    """What is looked at of a job."""

    @property
    def owner(self) -> str:
        """Who asked for it."""


J = TypeVar("J", bound=Owned)


class QuickTurns(Generic[J]):
    """Collects quick jobs and says which are evaluated in this turn."""

    def __init__(self) -> None:
        self._lines: OrderedDict[str, deque[J]] = OrderedDict()
        """By owner, in the order in which they take turns."""
        self._last_owner: str | None = None
        self._shared_until = 0.0

    def add(self, job: J) -> bool:
        """Keep a job; true when it is the first, so that a turn has to be called."""
        if job.owner != self._last_owner:
            if self._last_owner is not None:
                self._shared_until = time.monotonic() + SHARED_SECONDS
            self._last_owner = job.owner
        is_first = not self._lines
        line = self._lines.get(job.owner)
        if line is None:
            self._lines[job.owner] = deque((job,))
        else:
            line.append(job)
        return is_first

    def take(self) -> tuple[list[J], bool]:
        """The jobs of this turn, and whether another has to follow. While the loop is shared, owners take turns."""
        jobs: list[J] = []
        if time.monotonic() >= self._shared_until:
            for line in self._lines.values():
                jobs += line
            self._lines.clear()
            return jobs, False
        while self._lines and len(jobs) < PER_TURN:
            owner, line = next(iter(self._lines.items()))
            jobs.append(line.popleft())
            if line:
                self._lines.move_to_end(owner)
            else:
                del self._lines[owner]
        return jobs, bool(self._lines)
