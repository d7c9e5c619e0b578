"""Rate quotas: what each token may still do now: rows per second, and requests at the same time, in all processes."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from bnserve_protocol import QuotaExceeded, Unavailable
from bnserve_service.admission.tokens import Token
from bnserve_service.shared.counters import Counters, name_of

_BALANCE, _CHANGED, _UNDER_WAY = range(3)
_PER_TOKEN = 3
_MOMENT = 0.05
"""Seconds after which a request may have ended: what is said to a token that has as many under way as it may."""


class RateQuota:
    """What one token may ask for.

    Rows are paid from an account that fills at ``rows_per_second`` up to ``burst_rows``: a token bucket that may be in
    debt. A request is let through when there is a row in it, however many it has itself: what it takes beyond is paid
    off before the next. So nobody is let through more than his rate in the long run, and no request is too large.
    """

    def __init__(self, token: Token, counters: Counters, place: int) -> None:
        self._rate = token.rows_per_second
        self._burst = token.burst
        self._most_under_way = token.max_concurrent
        self._counters = counters
        self._place = place
        if self._rate is not None and counters[place + _CHANGED] == 0.0:
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

    def take(self, rows: int) -> None:
        """Pay for some rows.

        Raises
        ------
        QuotaExceeded
            There is no row in the account; ``retry_after`` says when there will be one.
        """
        if self._rate is None:
            return
        with self._counters.alone():
            balance = self._balance()
            self._refuse_in_debt(balance)
            self._settle(balance - rows)

    def give_back(self, rows: int) -> None:
        """Pay back rows that were not evaluated."""
        if self._rate is not None:
            with self._counters.alone():
                self._settle(min(self._burst, self._balance() + rows))

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
        under_way = self._place + _UNDER_WAY
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
            under_way = self._place + _UNDER_WAY
            self._counters.set_own(under_way, self._counters.own(under_way) - 1.0)

    def _balance(self) -> float:
        """Rows in the account now; negative while there is a debt."""
        assert self._rate is not None, "only such quotas have an account"
        passed = time.monotonic() - self._counters[self._place + _CHANGED]
        if passed < 0.0:  # the machine was started anew since
            return self._burst
        return min(self._burst, self._counters[self._place + _BALANCE] + passed * self._rate)

    def _settle(self, balance: float) -> None:
        self._counters[self._place + _BALANCE] = balance
        self._counters[self._place + _CHANGED] = time.monotonic()

    def _refuse_in_debt(self, balance: float) -> None:
        if balance < 1.0:
            assert self._rate is not None, "only such quotas have an account"
            raise QuotaExceeded(
                f"This token may have {self._rate:g} rows per second evaluated, and is over it; wait, or ask the "
                "operators for a larger quota.",
                retry_after=(1.0 - balance) / self._rate,
            )


def rate_quotas(tokens: Sequence[Token], shared: Path | None = None) -> dict[str, RateQuota]:
    """The quotas of those tokens that have limits, by the token's digest.

    Parameters
    ----------
    tokens
        The tokens of the settings.
    shared
        A folder that the processes of one server share; None for one process.
    """
    limited = [token for token in tokens if token.is_limited]
    if not limited:
        return {}
    counters = Counters(_PER_TOKEN * len(limited), shared, name_of([token.model_dump_json() for token in limited]))
    return {token.sha256: RateQuota(token, counters, _PER_TOKEN * number) for number, token in enumerate(limited)}
