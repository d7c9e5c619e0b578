"""Rate quotas: what each token may still do, in all processes: rows per second and day, requests at the same time.

How much is left is told with every evaluation, in the headers of draft-ietf-httpapi-ratelimit-headers-10.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from weakref import WeakValueDictionary

from bnserve_protocol import QuotaExceeded, Unavailable
from bnserve_service.admission.tokens import Token
from bnserve_service.shared.counters import Counters, Processes, name_of

_BALANCE, _CHANGED, _UNDER_WAY, _DAY, _USED = range(5)
_PER_TOKEN = 5
_DAY_SECONDS = 86_400
_MOMENT = 0.05
"""Seconds after which a request may have ended: what is said to a token that has as many under way as it may."""


class RateQuota:
    """What one token may ask for.

    Rows are paid from an account that fills at ``rows_per_second`` up to ``burst_rows``: a token bucket that may be in
    debt. A request is let through when there is a row in it, however many it has itself: what it takes beyond is paid
    off before the next. So nobody is let through more than his rate in the long run, and no request is too large. Those
    of a day are the same with an account that is full at midnight, UTC.
    """

    def __init__(self, token: Token, counters: Counters) -> None:
        self._rate = token.rows_per_second
        self._burst = token.burst
        self._per_day = token.rows_per_day
        self._most_under_way = token.max_concurrent
        self._counters = counters
        self._policies = _policies(token)
        if self._rate is not None and counters[_CHANGED] == 0.0:
            self._settle(self._burst)

    def check(self) -> None:
        """Refuse early what :meth:`take` would refuse.

        Raises
        ------
        QuotaExceeded
            There is no row in the account.
        """
        if self._rate is not None:
            self._refuse_in_debt(self._balance())
        if self._per_day is not None:
            self._refuse_until_midnight(self._used())

    def take(self, rows: int) -> None:
        """Pay for some rows.

        Raises
        ------
        QuotaExceeded
            There is no row in the account; ``retry_after`` says when there will be one.
        """
        if self._rate is None and self._per_day is None:
            return
        with self._counters.alone():
            used = self._used()
            if self._per_day is not None:
                self._refuse_until_midnight(used)
            if self._rate is not None:
                balance = self._balance()
                self._refuse_in_debt(balance)
                self._settle(balance - rows)
            self._use(used + rows)

    def give_back(self, rows: int) -> None:
        """Pay back rows that were not evaluated."""
        if self._rate is None and self._per_day is None:
            return
        with self._counters.alone():
            if self._rate is not None:
                self._settle(min(self._burst, self._balance() + rows))
            self._use(max(0.0, self._used() - rows))

    @contextmanager
    def paying(self, rows: int) -> Iterator[None]:
        """Pay for rows, and get them back if they are not evaluated because the server cannot now."""
        self.take(rows)
        try:
            yield
        except Unavailable:
            self.give_back(rows)
            raise

    @contextmanager
    def under_way(self) -> Iterator[None]:
        """One request, from its beginning to its end; raises as :meth:`begin`."""
        self.begin()
        try:
            yield
        finally:
            self.end()

    def begin(self) -> None:
        """A request begins.

        Raises
        ------
        QuotaExceeded
            As many as allowed are under way.
        """
        if self._most_under_way is None:
            return
        under_way = _UNDER_WAY
        with self._counters.alone():
            # Counted before it is compared: two processes that both go on without the lock refuse one too many then.
            self._counters.set_own(under_way, self._counters.own(under_way) + 1.0)
            if self._counters.over_processes(under_way) > self._most_under_way:
                self.end()
                raise QuotaExceeded(
                    f"This token may have {self._most_under_way} requests under way at the same time, and has as many; "
                    "send the next when one is answered.",
                    retry_after=_MOMENT,
                )

    def end(self) -> None:
        """A request that began is over."""
        if self._most_under_way is not None:
            under_way = _UNDER_WAY
            self._counters.set_own(under_way, self._counters.own(under_way) - 1.0)

    def headers(self) -> list[tuple[bytes, bytes]]:
        """The limits, and how much is left of them now; none where rows are not limited."""
        left = []
        if self._rate is not None:
            balance = self._balance()
            left.append(b'"rows";r=%d;t=%d' % (max(0.0, balance), math.ceil((self._burst - balance) / self._rate)))
        if self._per_day is not None:
            left.append(b'"day";r=%d;t=%d' % (max(0.0, self._per_day - self._used()), math.ceil(_until_midnight())))
        return [(b"ratelimit-policy", self._policies), (b"ratelimit", b", ".join(left))] if left else []

    def _used(self) -> float:
        """Rows of today."""
        return self._counters[_USED] if time.time() // _DAY_SECONDS <= self._counters[_DAY] else 0.0

    def _use(self, rows: float) -> None:
        self._counters[_USED] = rows
        self._counters[_DAY] = max(time.time() // _DAY_SECONDS, self._counters[_DAY])  # it may be set back

    def _refuse_until_midnight(self, used: float) -> None:
        assert self._per_day is not None, "only such quotas end with the day"
        if used >= self._per_day:
            raise QuotaExceeded(
                f"This token may have {self._per_day} rows evaluated per day, and has had as many; wait for midnight "
                "(UTC), or ask the operators for a larger quota.",
                retry_after=_until_midnight(),
            )

    def _balance(self) -> float:
        """Rows in the account now; negative while there is a debt."""
        assert self._rate is not None, "only such quotas have an account"
        passed = time.monotonic() - self._counters[_CHANGED]
        if passed < 0.0:  # the machine was started anew since
            return self._burst
        return min(self._burst, self._counters[_BALANCE] + passed * self._rate)

    def _settle(self, balance: float) -> None:
        self._counters[_BALANCE] = balance
        self._counters[_CHANGED] = time.monotonic()

    def _refuse_in_debt(self, balance: float) -> None:
        if balance < 1.0:
            assert self._rate is not None, "only such quotas have an account"
            raise QuotaExceeded(
                f"This token may have {self._rate:g} rows per second evaluated, and is over it; wait, or ask the "
                "operators for a larger quota.",
                retry_after=(1.0 - balance) / self._rate,
            )


def _until_midnight() -> float:
    return _DAY_SECONDS - time.time() % _DAY_SECONDS


def _policies(token: Token) -> bytes:
    """The limits of a token, as the header ``RateLimit-Policy`` has them."""
    found = []
    if token.rows_per_second is not None:
        window = max(1, math.ceil(token.burst / token.rows_per_second))
        found.append(b'"rows";q=%d;qu="rows";w=%d' % (token.burst, window))
    if token.rows_per_day is not None:
        found.append(b'"day";q=%d;qu="rows";w=%d' % (token.rows_per_day, _DAY_SECONDS))
    return b", ".join(found)


class RateQuotas:
    """The quotas of tokens. One that has other limits now finds its account as it was; where several processes share
    them, one that comes back does, too.

    Parameters
    ----------
    shared
        A folder that the processes of one server share; None for one process.
    """

    def __init__(self, shared: Path | None = None) -> None:
        self._processes = Processes(shared)
        self._counters: WeakValueDictionary[str, Counters] = WeakValueDictionary()  # an open file each

    def of(self, token: Token) -> RateQuota | None:
        """That of a token, if it has limits.

        Raises
        ------
        OSError
            The shared folder is full, or gone.
        """
        if not token.is_limited:
            return None
        counters = self._counters.get(token.sha256)
        if counters is None:
            counters = Counters(_PER_TOKEN, self._processes, name_of([token.sha256]))
            self._counters[token.sha256] = counters
        return RateQuota(token, counters)
