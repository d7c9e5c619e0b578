"""What a user chooses when connecting."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from bnserve_client._addresses import Address, parse_addresses
from bnserve_client._progress import require_tqdm
from bnserve_client._tokens import Token
from bnserve_protocol import InvalidRequest, NotNumbers, as_real_number

_FOR_EVER = 1e9
"""Seconds; sockets take no more, and certainly not infinity."""


@dataclass(frozen=True, slots=True)
class Settings:
    """Closed and immutable; :meth:`Model.connect` documents each field."""

    addresses: tuple[Address, ...]
    token: Token = field(default_factory=Token)
    timeout: float = 300.0
    silence: float = 30.0
    retries: int | None = None
    parallel: int = 2
    chunk_samples: int = 2**21
    progress: bool = False
    resolve: bool = True
    """Whether names that stand for several hosts are looked up here: not where the user's transport does it."""

    def __post_init__(self) -> None:
        for name in ("timeout", "silence"):
            object.__setattr__(self, name, _seconds(name, getattr(self, name)))
        for name, least in (("parallel", 1), ("chunk_samples", 1), ("retries", 0)):
            if name != "retries" or self.retries is not None:
                object.__setattr__(self, name, _count(name, getattr(self, name), least))

    def with_retries(self, retries: int) -> Settings:
        """The same with another number of retries."""
        return replace(self, retries=retries)


def settings_from(address: str | Sequence[str], progress: bool, **chosen: Any) -> Settings:
    """Settings from the arguments of ``connect``.

    Raises
    ------
    InvalidRequest
    """
    if progress:
        require_tqdm()
    return Settings(addresses=parse_addresses(address), progress=progress, **chosen)


def _seconds(name: str, value: Any) -> float:
    try:
        seconds = as_real_number(value, "s")
    except NotNumbers as error:
        raise InvalidRequest(f"'{name}' must be a positive number of seconds; it {error}.") from error
    if not seconds > 0.0:
        raise InvalidRequest(f"'{name}' must be a positive number of seconds; got {value!r}.")
    return min(seconds, _FOR_EVER)


def _count(name: str, value: Any, least: int) -> int:
    try:
        count = operator.index(value)
    except TypeError as error:
        raise InvalidRequest(f"'{name}' must be a whole number; got {type(value).__name__}.") from error
    if count < least:
        raise InvalidRequest(f"'{name}' must be at least {least}; got {value!r}.")
    return count
