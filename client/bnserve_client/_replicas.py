"""Which of several addresses to ask next."""

from __future__ import annotations

import itertools
import os
import time
from collections.abc import Sequence

from bnserve_client._addresses import Address


class Replicas:
    """Takes turns over the addresses and leaves out those that failed a moment ago.

    Holds no lock: the worst that two threads can do to each other is to ask the same replica.
    """

    def __init__(self, addresses: Sequence[Address]) -> None:
        self.addresses = tuple(addresses)
        self._turn = itertools.count(int.from_bytes(os.urandom(2), "big"))
        self._resting_until = dict.fromkeys(self.addresses, 0.0)

    def choose(self) -> Address:
        """The next address that is not resting, or the one that will wake first."""
        if len(self.addresses) == 1:
            return self.addresses[0]
        now = time.monotonic()
        start = next(self._turn) + os.getpid()
        turned = [self.addresses[(start + step) % len(self.addresses)] for step in range(len(self.addresses))]
        awake = (address for address in turned if self._resting_until[address] <= now)
        return next(awake, min(turned, key=self._resting_until.__getitem__))

    def rest(self, address: Address, seconds: float) -> None:
        """Prefer the others for a while."""
        self._resting_until[address] = time.monotonic() + seconds

    def wake(self, address: Address) -> None:
        """The address answered."""
        self._resting_until[address] = 0.0

    def is_resting(self, address: Address) -> bool:
        """Whether the address failed a moment ago."""
        return self._resting_until[address] > time.monotonic()

    def any_awake(self) -> bool:
        """Whether some address has not failed a moment ago."""
        return any(not self.is_resting(address) for address in self.addresses)
