"""What a user chooses when connecting, and the token, which no pickle holds: where it is taken from travels alone."""

from __future__ import annotations

import operator
import os
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeAlias

from bnserve_client._addresses import Address, parse_addresses
from bnserve_client._trust import verification
from bnserve_protocol import InvalidRequest, NotNumbers, Unauthorized, as_real_number, require

VARIABLE, FILE_VARIABLE = "BNSERVE_TOKEN", "BNSERVE_TOKEN_FILE"

TokenLike: TypeAlias = str | os.PathLike[str] | Callable[[], str] | None
"""A token, a file that holds one, a function that returns one; None for the environment's, where there is one."""


class _Hidden(str):
    """Text that nobody sees in a list of headers, or in the variables that a report of an error shows."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "'(hidden)'"


class Token:
    """A token and the place it is taken from: a file, a function, or the environment.

    That is the variable ``BNSERVE_TOKEN``, or the file that ``BNSERVE_TOKEN_FILE`` names. It is read when it is first
    needed, in every process anew, and again after :meth:`forget`. A pickle holds the place alone. A token that was
    given itself has the environment as its place for other processes; copies in the same process keep it.

    Parameters
    ----------
    given
        As the user gave it.

    Raises
    ------
    InvalidRequest
        What could be no token.
    """

    __slots__ = ("_is_given", "_known", "_must_be", "_place")

    def __init__(self, given: TokenLike = None) -> None:
        self._place: Path | Callable[[], str] | None = None
        self._must_be = given is not None
        """Whether there is a token at all; without it, a missing one in the environment is none."""
        self._known: _Hidden | None = None
        self._is_given = isinstance(given, str)
        if isinstance(given, str):
            self._known = _authorization(given, "token")
        elif isinstance(given, os.PathLike):
            self._place = Path(given).absolute()
        elif callable(given):
            self._place = given
        elif given is not None:
            raise InvalidRequest(
                f"'token' is a string, a path of a file that holds it, or a function that returns it; got "
                f"{type(given).__name__}."
            )

    def headers(self) -> tuple[tuple[str, str], ...]:
        """The header ``Authorization``, or none.

        Raises
        ------
        InvalidRequest
            What is there is no token.
        Unauthorized
            There is none where it is to be taken from.
        """
        if self._known is None:
            found = self._read()
            if found is None and self._place is None:
                return ()
            self._known = _authorization(found, self._where())
        return (("Authorization", self._known),)

    def forget(self) -> None:
        """The service refuses it: there may be another where it is taken from. One that was given itself stays."""
        if not self._is_given:
            self._known = None

    def _read(self) -> Any:
        if isinstance(self._place, Path):
            return self._read_file(self._place)
        if self._place is not None:
            return self._place()
        found = os.environ.get(VARIABLE)
        if not found and (named := os.environ.get(FILE_VARIABLE)):
            return self._read_file(Path(named))
        if not found and self._must_be:
            raise Unauthorized(
                f"This model was connected with token='...', which does not travel to other processes. Set {VARIABLE} "
                "in their environment, or connect with token=pathlib.Path('a file that holds it') or with token= a "
                "module-level function that returns it: these are read again there."
            )
        return found or None

    def _read_file(self, path: Path) -> str:
        try:
            return path.read_text(encoding="utf-8").strip()
        except (OSError, UnicodeDecodeError) as error:
            reason = getattr(error, "strerror", None) or "it is no text"
            raise Unauthorized(f"The token cannot be read from {self._where()}: {reason}.") from error

    def _where(self) -> str:
        if isinstance(self._place, Path):
            return f"the file '{self._place}'"
        if self._place is not None:
            return "the function given as 'token'"
        named = os.environ.get(FILE_VARIABLE)
        return f"the file '{named}' (${FILE_VARIABLE})" if named and not os.environ.get(VARIABLE) else f"${VARIABLE}"

    def __reduce__(self) -> tuple[Any, ...]:
        return _taken_from, (self._place, self._must_be)

    def __copy__(self) -> Token:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Token:
        return self

    def __repr__(self) -> str:
        return f"<Token from {self._where()}>"


def _taken_from(place: Path | Callable[[], str] | None, must_be: bool) -> Token:
    token = Token(place)
    token._must_be = must_be
    return token


def _authorization(token: Any, where: str) -> _Hidden:
    if not isinstance(token, str) or not (token.isascii() and token.isprintable() and token.strip()):
        raise InvalidRequest(
            f"The token in {where} must be printable ASCII without line breaks; check how it was read."
        )
    return _Hidden(f"Bearer {token}")


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
    verify: bool | Path = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "verify", verification(self.verify))
        for name in ("timeout", "silence"):
            object.__setattr__(self, name, _seconds(name, getattr(self, name)))
        for name, least in (("parallel", 1), ("chunk_samples", 1), ("retries", 0)):
            if name != "retries" or self.retries is not None:
                object.__setattr__(self, name, _count(name, getattr(self, name), least))

    def with_retries(self, retries: int) -> Settings:
        """The same with another number of retries."""
        return replace(self, retries=retries)


def settings_from(address: str | Sequence[str], progress: bool, **chosen: Any) -> Settings:
    """Settings from the arguments of ``connect``; InvalidRequest for what none of them can be."""
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


def require_tqdm() -> Any:
    """The package tqdm; PackageMissing, before anything is asked, if there is none."""
    return require("tqdm", "progress=True", "progress")


def progress_bar(rows: int, wanted: bool) -> AbstractContextManager[Any]:
    """A tqdm bar that counts waveforms; a context of None when it is not wanted."""
    if not wanted:
        return nullcontext(None)
    bar: AbstractContextManager[Any] = require_tqdm().tqdm(total=rows, unit="waveform", unit_scale=True)
    return bar
