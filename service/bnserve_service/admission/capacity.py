"""Who has how much of a bounded room, and what is everybody's fair share of it."""

from __future__ import annotations


class Capacity:
    """A room of a given size, divided among those who are in it.

    One owner alone may fill it. The fair share of several is the room divided by how many have something in it.

    Parameters
    ----------
    size:
        That of the room.
    """

    def __init__(self, size: int) -> None:
        self.size = size
        self.total = 0
        """What all have together."""
        self._of: dict[str, int] = {}

    def add(self, owner: str, size: int) -> None:
        """Something of this owner came in."""
        self.total += size
        self._of[owner] = self._of.get(owner, 0) + size

    def remove(self, owner: str, size: int) -> None:
        """Something of this owner is gone."""
        self.total -= size
        left = self._of.get(owner, 0) - size
        if left > 0:
            self._of[owner] = left
        else:
            self._of.pop(owner, None)

    def fits(self, size: int) -> bool:
        """Whether there is room for so much."""
        return self.total + size <= self.size

    def may_displace(self, owner: str, size: int) -> bool:
        """Whether others have to make room for this owner: he has nothing yet, or stays within his fair share."""
        has = self._of.get(owner, 0)
        return size <= self.size and (has == 0 or has + size <= self._fair_share(owner))

    def beyond_fair_share(self, newcomer: str) -> list[str]:
        """Those who have more than their fair share once ``newcomer`` is there, whoever has most first."""
        fair = self._fair_share(newcomer)
        found = [name for name, size in self._of.items() if size > fair and name != newcomer]
        return sorted(found, key=lambda name: -self._of[name])

    def is_shared_by_others(self, owner: str) -> bool:
        """Whether anybody but this owner has something here."""
        return any(name != owner for name in self._of)

    def backlog(self, owner: str) -> int:
        """Work before this owner has room again: his own, times how many take turns with him."""
        return min(self.total, self._of.get(owner, 0) * len(self._of)) or self.total

    def ahead_of(self, owner: str) -> int:
        """Work that is done before something that this owner adds now: his own, times how many take turns with him."""
        return min(self.total, self._of.get(owner, 0) * len(self._of))

    def _fair_share(self, newcomer: str) -> int:
        return self.size // len({*self._of, newcomer})
