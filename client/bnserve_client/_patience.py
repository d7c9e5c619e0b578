"""When to try again, where, and when to give up."""

from __future__ import annotations

import random
import time

from bnserve_client._addresses import Address
from bnserve_client._replicas import Replicas
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
    ShareExceeded,
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


class Patience:
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
        if isinstance(error, ShareExceeded):
            if error.retry_after:  # exact: a share is a sum, not a guess
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
