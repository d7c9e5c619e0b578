"""Turns of the event loop: while several owners ask, a few things are begun in each, of all owners alternately.

The loop is a worker, too: it decodes, evaluates what is quick, and refuses. Whoever has a hundred connections would
have a hundred things done before the one of somebody else.
"""

from __future__ import annotations

import asyncio
import time
from collections import OrderedDict, deque
from typing import Generic, Protocol, TypeVar

PER_TURN = 1
"""Things begun in one turn while several owners ask. Then nobody waits longer for the loop than one of each owner
takes, however many connections they have; done all together they are cheaper."""
SHARED_SECONDS = 5.0
"""So long after two owners asked by turns, the loop counts as shared."""


class Owned(Protocol):
    """What is looked at of a thing to do."""

    @property
    def owner(self) -> str:
        """Who asked for it."""


J = TypeVar("J", bound=Owned)


class Beginning:
    """The place of a request that is to begin; ``turn`` is resolved when it may."""

    def __init__(self, owner: str, turn: asyncio.Future[None]) -> None:
        self.owner = owner
        self.turn = turn


class LoopTurns(Generic[J]):
    """Collects what is to be done on the event loop and says what is done in this turn."""

    def __init__(self) -> None:
        self._alone: list[J] = []
        """While one owner asks: what came in this turn."""
        self._lines: OrderedDict[str, deque[J]] = OrderedDict()
        """While several do: by owner, in the order in which they take turns."""
        self._last_owner: str | None = None
        self._shared_until = 0.0
        """0 while one owner asks."""

    def is_shared(self, owner: str) -> bool:
        """Note that this owner asks; whether others did a short time ago."""
        if owner != self._last_owner:
            if self._last_owner is not None:
                self._shared_until = time.monotonic() + SHARED_SECONDS
                for job in self._alone:
                    self._lines.setdefault(job.owner, deque()).append(job)
                self._alone = []
            self._last_owner = owner
        return self._shared_until > 0.0

    def add(self, job: J) -> bool:
        """Keep something to do; true when it is the first, so that a turn has to be called."""
        if (self._shared_until == 0.0 and job.owner == self._last_owner) or not self.is_shared(job.owner):
            self._alone.append(job)
            return len(self._alone) == 1
        is_first = not self._lines
        self._lines.setdefault(job.owner, deque()).append(job)
        return is_first

    def take(self) -> tuple[list[J], bool]:
        """What is done in this turn, and whether another has to follow. While the loop is shared, owners take turns."""
        if self._shared_until == 0.0:
            jobs, self._alone = self._alone, []
            return jobs, False
        jobs = []
        while self._lines and len(jobs) < PER_TURN:
            owner, line = next(iter(self._lines.items()))
            jobs.append(line.popleft())
            if line:
                self._lines.move_to_end(owner)
            else:
                del self._lines[owner]
        if not self._lines and time.monotonic() >= self._shared_until:
            self._shared_until = 0.0
        return jobs, bool(self._lines)
