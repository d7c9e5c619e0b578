"""Memory for large request bodies: who has how much of it, and who makes room for whom."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass

from bnserve_protocol import Overloaded, QuotaExceeded
from bnserve_service.admission.capacity import Capacity

_MOMENT = 1.0
"""Seconds after which another body may have been read and decoded."""


@dataclass(slots=True, eq=False)
class Place:
    """That of one body in the room."""

    owner: str
    size: int = 0
    """Bytes that it takes."""
    reading: asyncio.Timeout | None = None
    """What ends the reading; None when the body is read."""
    displaced: bool = False
    """Whether it had to make room for others."""


class BodyRoom:
    """Memory for large bodies that are on their way or not decoded yet.

    They are counted as they arrive, so that a slow sender holds no more than it has sent. One owner alone may fill the
    room, until others come: then what he has beyond his fair share makes room for them, the newest first.

    Parameters
    ----------
    capacity:
        Bytes of all together.
    """

    def __init__(self, capacity: int) -> None:
        self._held = Capacity(capacity)
        self._places: dict[Place, None] = {}

    @property
    def held_bytes(self) -> int:
        """Bytes held now."""
        return self._held.total

    def expect(self, owner: str, size: int) -> None:
        """Refuse what :meth:`take` would refuse, as things are.

        Raises
        ------
        Overloaded, QuotaExceeded
        """
        if not (self._held.fits(size) or self._held.may_displace(owner, size)):
            raise self.refusal(owner)

    def take(self, place: Place, size: int) -> None:
        """So much more of a body has arrived.

        Raises
        ------
        Overloaded, QuotaExceeded
        """
        if place.displaced or size <= 0:
            return
        if not self._held.fits(size):
            self._make_room(place.owner, size)
        self._places[place] = None
        place.size += size
        self._held.add(place.owner, size)

    def leave(self, place: Place) -> None:
        """A body is not there any more."""
        if place.size:
            del self._places[place]
            self._held.remove(place.owner, place.size)
            place.size = 0

    def refusal(self, owner: str) -> Overloaded | QuotaExceeded:
        """The error for a body of this owner that there is no room for."""
        if self._held.is_shared_by_others(owner):
            return QuotaExceeded(
                "This server is reading large bodies of several callers, and you have your fair share of the memory "
                "for them; try again when some of yours are read.",
                retry_after=_MOMENT,
            )
        return Overloaded(
            "Too many large bodies are on their way to this server; try again shortly.", retry_after=_MOMENT
        )

    def _make_room(self, owner: str, size: int) -> None:
        """End the reading of what others have beyond their fair share, or refuse."""
        if not self._held.may_displace(owner, size):
            raise self.refusal(owner)
        while not self._held.fits(size):
            rich = self._held.beyond_fair_share(owner)
            victim = next((found for name in rich if (found := self._newest_of(name)) is not None), None)
            if victim is None or victim.reading is None:
                raise self.refusal(owner)
            victim.displaced = True
            victim.reading.reschedule(0.0)  # now
            self.leave(victim)

    def _newest_of(self, owner: str) -> Place | None:
        """What this owner began to send last, of what is still being read."""
        own = (each for each in reversed(self._places) if each.owner == owner)
        return next((each for each in own if each.reading and not each.reading.expired()), None)
