"""When to try again, where, and when to give up."""

from __future__ import annotations

import itertools
import os
import random
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

from bnserve_client._addresses import Address
from bnserve_client._resolver import Resolver
from bnserve_client._settings import Settings
from bnserve_protocol import (
    BnserveError,
    ConnectionFailed,
    DeadlineExceeded,
    DigestUnknown,
    Forbidden,
    ModelUnknown,
    NotAcceptable,
    Overloaded,
    PathUnknown,
    QuotaExceeded,
    TooLarge,
    Unauthorized,
    UndecodableBody,
    UnsupportedMediaType,
    UntrustedAnswer,
)

_FIRST_PAUSE = 0.05
_LONGEST_PAUSE = 5.0
_UNTRUSTED_ATTEMPTS = 6
"""An answer that is damaged this often in a row, within some seconds, is not bad luck."""
_DOUBTFUL = (
    UndecodableBody,
    UnsupportedMediaType,
    NotAcceptable,
    TooLarge,
    PathUnknown,
    ModelUnknown,
    Unauthorized,
    Forbidden,
    DeadlineExceeded,
)
"""What a sound question cannot deserve, and one whose head was damaged on the way does."""
_DOUBTS = 3
"""It is believed when it is said once more than that, in a row."""

_chance = random.SystemRandom()
"""Neither shared between forked processes nor drawn from the generator that a sampler may have seeded."""


_FIRST_REST = 1.0
_LONGEST_REST = 15.0


@dataclass(slots=True)
class _Record:
    """What is remembered of one replica."""

    failures: int = 0
    """In a row."""
    resting_until: float = 0.0
    """``time.monotonic()``; 0 when it is in use."""
    probing_until: float = 0.0
    """Until then somebody else is finding out whether it is back."""


class Replicas:
    """Asks the replica with the fewest requests of this process under way, in turns among equals.

    One that fails is left out, for one second and twice as long each further time. Then one caller asks whether it is
    ready, and only if so it gets work again: nobody's request waits for a host that hangs. Where all have failed, the
    one that would be tried first is asked all the same.

    Holds no lock: the worst that two threads can do to each other is to ask the same replica.

    Parameters
    ----------
    addresses:
        As the user gave them.
    resolver:
        Turns names that stand for several hosts into these; None asks no name service.
    """

    probe_seconds = 1.0
    """A replica that does not say within this time that it is ready is not."""

    def __init__(self, addresses: Sequence[Address], resolver: Resolver | None = None) -> None:
        self.resolver = resolver
        self._given = tuple(addresses)
        self._turn = itertools.count(int.from_bytes(os.urandom(2), "big"))
        self._records = {address: _Record() for address in self._given}
        self._busy: dict[tuple[int, Address], set[object]] = {}

    @property
    def addresses(self) -> tuple[Address, ...]:
        """Those that are asked now."""
        return self._given if self.resolver is None else self.resolver.addresses

    def choose(self) -> Address:
        """The next address that is not resting, or the one that will wake first."""
        addresses = self.addresses
        if len(addresses) == 1:
            return addresses[0]
        start = next(self._turn) + os.getpid()
        turned = [addresses[(start + step) % len(addresses)] for step in range(len(addresses))]
        in_use = [address for address in turned if not self._record(address).resting_until]
        if in_use:
            return min(in_use, key=self._under_way)
        return min(turned, key=lambda address: self._record(address).resting_until)

    @contextmanager
    def asking(self, address: Address) -> Iterator[None]:
        """While a request to the address is under way."""
        if len(self.addresses) == 1:
            yield
            return
        request, busy = object(), self._busy.setdefault((os.getpid(), address), set())
        busy.add(request)
        try:
            yield
        finally:
            busy.discard(request)

    def rest(self, address: Address, at_least: float = 0.0, *, broken: bool = True) -> None:
        """Leave the address out for a while; ``broken`` ones for longer each time."""
        record = self._record(address)
        record.failures = min(record.failures + broken, 30)
        seconds = min(_LONGEST_REST, _FIRST_REST * 2.0 ** max(0, record.failures - 1))
        record.resting_until, record.probing_until = time.monotonic() + max(seconds, at_least), 0.0
        if self.resolver is not None:
            self.resolver.look_again_soon()

    def wake(self, address: Address) -> None:
        """The address answered."""
        record = self._records.get(address)
        if record is not None and record.resting_until:
            record.failures, record.resting_until = 0, 0.0
        elif record is not None:
            record.failures = 0

    def to_probe(self) -> Address | None:
        """An address that has rested and of which it is to be found out now whether it is back, while others work."""
        addresses = self.addresses
        if len(addresses) == 1:
            return None
        now = time.monotonic()
        records = {address: self._record(address) for address in addresses}
        if all(record.resting_until for record in records.values()):
            return None
        for address, record in records.items():
            if 0.0 < record.resting_until <= now and record.probing_until <= now:
                record.probing_until = now + 2.0 * self.probe_seconds
                return address
        return None

    def is_resting(self, address: Address) -> bool:
        """Whether the address failed a moment ago."""
        return self._record(address).resting_until > time.monotonic()

    def any_awake(self) -> bool:
        """Whether some address has not failed a moment ago."""
        return any(not self.is_resting(address) for address in self.addresses)

    def _record(self, address: Address) -> _Record:
        record = self._records.get(address)
        return self._records.setdefault(address, _Record()) if record is None else record

    def _under_way(self, address: Address) -> int:
        return len(self._busy.get((os.getpid(), address), ()))


class RetryPolicy:
    """The retry state of one request: its deadline, its failures, and the replica it is talking to.

    Evaluations change nothing on the server, so every request may be sent again.
    """

    def __init__(self, settings: Settings, replicas: Replicas) -> None:
        self._timeout = settings.timeout
        self._retries = settings.retries
        self._replicas = replicas
        self._failures = 0
        self._untrusted = 0
        self._doubts = 0
        self.deadline = time.monotonic() + settings.timeout
        self._address: Address | None = None

    @property
    def address(self) -> Address:
        """The replica to ask: the same one until it fails."""
        if self._address is None:
            self._address = self._replicas.choose()
        return self._address

    def follow(self) -> None:
        """Choose another replica if the one to ask is none any more, because its name stands for other hosts now."""
        if self._address is not None and self._address not in self._replicas.addresses:
            self._address = None

    @property
    def seconds_left(self) -> float:
        """Seconds until the deadline, never negative."""
        return max(0.0, self.deadline - time.monotonic())

    def succeeded(self) -> None:
        """The replica gave an answer that can be used."""
        self._doubts = 0
        self._replicas.wake(self.address)

    def pause_after(self, error: BnserveError) -> float:
        """Seconds to wait before asking again (:attr:`address` may have moved on to another replica).

        Raises
        ------
        BnserveError
            ``error`` itself where asking again cannot help, or the retries or the time are used up.
        """
        untrusted = isinstance(error, UntrustedAnswer) or self._another_may_have_it(error)
        doubtful = isinstance(error, _DOUBTFUL) and not untrusted
        self._doubts = self._doubts + 1 if doubtful else 0
        doubted = doubtful and self._doubts <= _DOUBTS
        if not (error.retryable or untrusted or doubted):
            raise error
        self._failures += 1
        self._untrusted += untrusted
        if self._untrusted >= _UNTRUSTED_ATTEMPTS or (self._retries is not None and self._failures > self._retries):
            raise error
        if doubted:
            return 0.0
        pause = self._pause(error)
        if pause >= self.seconds_left:
            raise self._out_of_time(error) from error
        return pause

    def _another_may_have_it(self, error: BnserveError) -> bool:
        """Whether a replica lacks a model that others may have: while they are replaced one by one, some do."""
        return isinstance(error, DigestUnknown) or (
            isinstance(error, ModelUnknown) and len(self._replicas.addresses) > 1
        )

    def _pause(self, error: BnserveError) -> float:
        if isinstance(error, QuotaExceeded):
            if error.retry_after:  # exact: a quota is a sum, not a guess
                return error.retry_after * _chance.uniform(1.0, 1.25)
        else:
            self._replicas.rest(self.address, error.retry_after or 0.0, broken=not isinstance(error, Overloaded))
            self._address = self._replicas.choose()
            if self._replicas.any_awake():
                return 0.0
        pause = min(_LONGEST_PAUSE, _FIRST_PAUSE * 2.0 ** min(self._failures, 30)) * _chance.uniform(0.5, 1.0)
        return max(pause, (error.retry_after or 0.0) * _chance.uniform(1.0, 1.25))

    def _out_of_time(self, error: BnserveError) -> BnserveError:
        if self.seconds_left > 0.0 or not isinstance(error, ConnectionFailed):
            return error
        return DeadlineExceeded(
            f"No answer within the timeout of {self._timeout:g} s. {error.detail}", request_id=error.request_id
        )
