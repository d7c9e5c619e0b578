"""Admission control: whether new work is accepted, how much of it, and what it will cost."""

from __future__ import annotations

import enum
from collections import OrderedDict
from collections.abc import Hashable

from bnserve_protocol import DeadlineExceeded, Draining, Overloaded, QuotaExceeded

_ASSUMED_RATE = 1e8
"""Samples per second and worker assumed for Retry-After before anything was measured."""
_RATE_MEMORY = 0.2
WORTH_IT = 2**12
"""Bodies below this are decoded in less time than it takes to think about it."""
_KINDS = 4096
_FORGET = 0.1


class Phase(enum.Enum):
    """The phases of a server, in order."""

    SERVING = "serving"
    GRACE = "grace"
    """Told to stop: not ready any more, yet everything is answered, each answer closing its connection."""
    REFUSING = "refusing"
    """What is in flight finishes; what is new is refused with ``Draining``."""
    ABORTING = "aborting"
    """Told so twice: nothing is waited for."""


class Lifecycle:
    """The phase of one server, from start to exit. Only ever moves forward."""

    def __init__(self) -> None:
        self.phase = Phase.SERVING

    @property
    def draining(self) -> bool:
        """Whether the server has been told to stop; its answers ask their callers to connect elsewhere next time."""
        return self.phase is not Phase.SERVING

    def begin_grace(self) -> None:
        """Become unready."""
        if self.phase is Phase.SERVING:
            self.phase = Phase.GRACE

    def refuse(self) -> None:
        """Accept no new work."""
        if self.phase is not Phase.ABORTING:
            self.phase = Phase.REFUSING

    def abort(self) -> None:
        """Wait for nothing."""
        self.phase = Phase.ABORTING

    def check_accepting(self) -> None:
        """Raise ``Draining`` once new work is refused."""
        if self.phase in (Phase.REFUSING, Phase.ABORTING):
            raise Draining("This server is shutting down; send the request to another replica.", retry_after=1.0)


class Capacity:
    """A room of a given size, divided among those who are in it.

    One owner alone may fill it. The fair share of several is the room divided by how many have something in it.

    Parameters
    ----------
    size
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

    def ahead_of(self, owner: str) -> int:
        """Work that is done before something that this owner adds now: his own, times how many take turns with him."""
        return min(self.total, self._of.get(owner, 0) * len(self._of))

    def _fair_share(self, newcomer: str) -> int:
        return self.size // len({*self._of, newcomer})


class Backlog(Capacity):
    """The work that waits or runs, in samples, and the speed at which it is done.

    Parameters
    ----------
    size
        The largest sum of costs.
    workers
        How many work at the same time.
    """

    def __init__(self, size: int, workers: int) -> None:
        super().__init__(size)
        self._workers = workers
        self._rate = _ASSUMED_RATE * workers

    def measure(self, cost: int, seconds: float) -> None:
        """One worker has done so much in so many seconds."""
        if seconds > 0.0:
            self._rate += _RATE_MEMORY * (self._workers * cost / seconds - self._rate)

    def check_deadline(self, deadline: float, now: float, owner: str, cost: int) -> None:
        """Refuse what would be finished too late: computed all the same, it would make others late as well.

        Raises
        ------
        DeadlineExceeded
            It has passed.
        Overloaded
            What waits before work of this owner takes longer.
        """
        if deadline <= now:
            raise too_late()
        ahead = self.ahead_of(owner)
        if ahead and cost and now + (ahead + cost) / self._rate > deadline:
            raise Overloaded(
                "What waits on this server takes longer than this deadline allows; try another replica, or allow more.",
                retry_after=max(1.0, ahead / self._rate),
            )

    def refusal(self, owner: str) -> Overloaded | QuotaExceeded:
        """The error for work of this owner that there is no room for; it says when there may be some."""
        seconds = min(30.0, (self.ahead_of(owner) or self.total) / self._rate)
        if self.is_shared_by_others(owner):
            return QuotaExceeded(
                "This server is busy with the requests of several callers, and you have your fair share of its queue; "
                "try again when some of yours are answered.",
                retry_after=max(0.01, seconds),
            )
        return Overloaded(
            "The queue of this server is full; try again shortly, or another replica.", retry_after=max(1.0, seconds)
        )


def too_late() -> DeadlineExceeded:
    """The error for work that was not begun in time."""
    return DeadlineExceeded("The deadline of this request passed before its evaluation began; allow more time.")


class CostEstimates:
    """What bodies of about the same size that ask the same kind of thing cost, leaning towards the cheapest.

    Refusing is only cheap when it comes before the work: decoding a batch of thousands of rows costs several times as
    much as all the rest of a refusal, and a server under ten times its load does little else.
    """

    def __init__(self) -> None:
        self._costs: OrderedDict[tuple[Hashable, int], float] = OrderedDict()

    def cost(self, kind: Hashable, size: int) -> int | None:
        """What a body of ``size`` bytes may cost; None when nothing is known."""
        known = self._costs.get((kind, size.bit_length())) if size >= WORTH_IT else None
        return None if known is None else int(known)

    def learn(self, kind: Hashable, size: int, cost: int) -> None:
        """One was decoded, and cost so much."""
        if size < WORTH_IT:
            return
        like = kind, size.bit_length()
        known = self._costs.pop(like, cost)
        self._costs[like] = cost if cost < known else known + _FORGET * (cost - known)
        if len(self._costs) > _KINDS:
            self._costs.popitem(last=False)
