"""Who is let in now, and what each may still do: tokens of the settings, and of files that change meanwhile."""

from __future__ import annotations

import logging
import math
import time
from collections import OrderedDict
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from bnserve_service.admission.issuers import MOST_KNOWN, Issuer, Issuers
from bnserve_service.admission.quotas import RateQuota, RateQuotas
from bnserve_service.admission.token_files import TokenFiles
from bnserve_service.admission.tokens import Token
from bnserve_service.errors import SettingsInvalid

logger = logging.getLogger("bnserve.tokens")

_MOST_TOLD = 256
"""Tokens whose ends the metrics tell: each is a series."""


class Entry(NamedTuple):
    """A token that is let in."""

    token: Token
    ends: float
    """``time.time()`` from which it is not, any more."""
    quota: RateQuota | None
    """What it may still do, if that is limited."""


class TokenBook:
    """The tokens that are let in.

    Parameters
    ----------
    files
        Which.
    issuers
        Who may vouch for others.
    shared
        A folder that the processes of one server share; None for one process.

    Raises
    ------
    SettingsInvalid
        A file cannot be used.
    """

    def __init__(self, files: TokenFiles, shared: Path | None = None, issuers: Sequence[Issuer] = ()) -> None:
        self._files = files
        self._issuers = Issuers(issuers) if issuers else None
        self._quotas = RateQuotas(shared)
        self._of_issued: OrderedDict[str, RateQuota | None] = OrderedDict()
        self._told = ""
        self.entries: Sequence[Entry] = ()
        """One for each; replaced as a whole."""
        self._take(self._files.changed() or ())

    @property
    def renewals(self) -> tuple[Callable[[], object], ...]:
        """What is to be called from time to time."""
        return (self.renew, *(self._issuers.renewals if self._issuers is not None else ()))

    def issued(self, text: bytes) -> Entry | None:
        """Who presents a token that is not in the files, if an issuer vouches for him.

        Raises
        ------
        Unauthorized
            It is of one of the issuers, and not valid.
        Unavailable
            The issuer's keys are not there at this moment.
        """
        found = None if self._issuers is None else self._issuers.find(text)
        if found is None:
            return None
        token, ends = found
        if token.is_limited and token.sha256 not in self._of_issued:
            self._of_issued[token.sha256] = self._quotas.of(token)
            if len(self._of_issued) > MOST_KNOWN:
                self._of_issued.popitem(last=False)
        return Entry(token, ends, self._of_issued.get(token.sha256))

    def renew(self) -> None:
        """Read the files again. What is wrong with them is logged, and who was let in before still is."""
        try:
            tokens = self._files.changed()
        except SettingsInvalid as error:
            if error.detail != self._told:
                logger.error("who is let in stays as it was: %s", error.detail)
            self._told = error.detail
            return
        self._told = ""
        if tokens is not None:
            before = self._named()
            self._take(tokens)
            now = self._named()
            logger.info("tokens were read again: %d are let in; new: %s; gone: %s", len(now), _names(now, before),
                        _names(before, now))  # fmt: skip

    def ends(self) -> dict[str, float]:
        """``time.time()`` at which tokens of the files end, those that do, by name; of one name, the first."""
        known: dict[str, float] = {}
        for each in self.entries[:_MOST_TOLD]:
            if each.ends < math.inf:
                known[each.token.name] = min(each.ends, known.get(each.token.name, math.inf))
        return known

    def stored_bytes(self, owner: str) -> int | None:
        """How much an owner may keep uploaded; None where that is not limited, or he is not known."""
        for each in self.entries:
            if each.token.sha256 == owner:
                return each.token.max_stored_bytes
        return None if self._issuers is None else self._issuers.stored_bytes(owner)

    def _named(self) -> dict[str, str]:
        return {each.token.sha256: each.token.name for each in self.entries}

    def _take(self, tokens: Sequence[Token]) -> None:
        entries = []
        for token in tokens:
            try:
                entries.append(Entry(token, token.ends, self._quotas.of(token)))
            except OSError as error:  # no room for its counts, and without them it would be unlimited
                logger.error("the token %s is not let in: %s", token.name, error.strerror or error)
        self.entries = tuple(entries)
        ended = [entry.token.name for entry in entries if entry.ends <= time.time()]
        if ended:
            logger.warning("tokens that have ended, and are not let in: %s", ", ".join(ended))
        if not tokens and self._issuers is None:
            logger.warning("there is no token any more in the files of tokens: nobody is let in")


def _names(some: dict[str, str], others: dict[str, str]) -> str:
    return ", ".join(name for sha256, name in some.items() if sha256 not in others) or "none"
