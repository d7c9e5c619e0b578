"""The token of a model: where it is taken from travels to other processes, the token itself never does."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeAlias

from bnserve_protocol import InvalidRequest, Unauthorized

VARIABLE = "BNSERVE_TOKEN"

TokenLike: TypeAlias = str | os.PathLike[str] | Callable[[], str] | None
"""A token, a file that holds one, a function that returns one; None for the environment's, where there is one."""


class _Hidden(str):
    """Text that nobody sees in a list of headers, or in the variables that a report of an error shows."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "'(hidden)'"


class Token:
    """A token and the place it is taken from: a file, a function or the environment variable ``BNSERVE_TOKEN``.

    It is read when it is first needed, in every process anew. A pickle holds the place alone. A token that was given
    itself has the environment as its place for other processes; copies in the same process keep it.

    Parameters
    ----------
    given:
        As the user gave it.

    Raises
    ------
    InvalidRequest
        What could be no token.
    """

    __slots__ = ("_known", "_must_be", "_place")

    def __init__(self, given: TokenLike = None) -> None:
        self._place: Path | Callable[[], str] | None = None
        self._must_be = given is not None
        """Whether there is a token at all; without it, a missing one in the environment is none."""
        self._known: _Hidden | None = None
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

    def _read(self) -> Any:
        if isinstance(self._place, Path):
            try:
                return self._place.read_text(encoding="utf-8").strip()
            except (OSError, UnicodeDecodeError) as error:
                reason = getattr(error, "strerror", None) or "it is no text"
                raise Unauthorized(f"The token cannot be read from {self._where()}: {reason}.") from error
        if self._place is not None:
            return self._place()
        found = os.environ.get(VARIABLE)
        if not found and self._must_be:
            raise Unauthorized(
                f"This model was connected with token='...', which does not travel to other processes. Set {VARIABLE} "
                "in their environment, or connect with token=pathlib.Path('a file that holds it') or with token= a "
                "module-level function that returns it: these are read again there."
            )
        return found or None

    def _where(self) -> str:
        if isinstance(self._place, Path):
            return f"the file '{self._place}'"
        return f"${VARIABLE}" if self._place is None else "the function given as 'token'"

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
