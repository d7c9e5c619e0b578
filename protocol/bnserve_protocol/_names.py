"""Names that are not known: which one may be meant."""

from __future__ import annotations

import difflib
import functools
import inspect
from collections.abc import Collection
from typing import Any, TypeVar

from bnserve_protocol._errors import FieldError, InvalidParameters

_C = TypeVar("_C", bound=type[Any])


class UnknownKeyword(InvalidParameters, TypeError):
    """A keyword that a class does not take; also a ``TypeError``, as Python's own is."""


def nearest(name: object, known: Collection[str]) -> str:
    """What an unknown name may have meant: ``Did you mean 'mass_ratio'?``, or all names that are known.

    Parameters
    ----------
    name:
        Of anybody; no more than its beginning is compared, which takes seconds and gigabytes for megabytes.
    known:
        The names there are.
    """
    near = difflib.get_close_matches(str(name)[:80], known, n=1, cutoff=0.5)
    return f"Did you mean '{near[0]}'?" if near else f"Known names: {', '.join(known)}."


def suggesting(cls: _C) -> _C:
    """The same class, whose misspelt keywords are :class:`UnknownKeyword` that names the nearest one it takes."""
    plain = cls.__init__
    known = tuple(inspect.signature(plain).parameters)[1:]

    @functools.wraps(plain)
    def init(self: Any, *values: Any, **named: Any) -> None:
        try:
            plain(self, *values, **named)
        except TypeError as error:
            unknown = next((name for name in named if name not in known), None)
            if unknown is None:
                raise
            hint = nearest(unknown, known)
            raise UnknownKeyword(
                f"{cls.__name__} takes no '{unknown[:80]}'. {hint}",
                errors=[FieldError(reason=f"unknown. {hint}", parameter=unknown[:80])],
            ) from error

    cls.__init__ = init
    return cls
