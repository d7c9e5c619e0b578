"""Modes of a waveform, by their (l, m)."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any, TypeAlias

from bnserve_protocol._errors import FieldError, InvalidRequest

Mode: TypeAlias = tuple[int, int]
"""Degree l and order m > 0 of a spin-weighted harmonic; it stands for (l, -m) as well, which symmetry gives."""

MOST_MODES = 64
"""More than there are up to l = 10; still more are a mistake or an attack."""


def as_modes(given: Any) -> tuple[Mode, ...]:
    """Pairs of whole numbers, in whatever sequences, as a tuple of tuples.

    Raises
    ------
    InvalidRequest
        None, too many, one twice, or what is no such pair.
    """
    if isinstance(given, str | bytes) or not isinstance(given, Iterable):
        raise _no_modes(f"got {repr(given)[:80]}")
    modes: list[Mode] = []
    for mode in given:
        if len(modes) == MOST_MODES:
            raise _no_modes(f"got more than {MOST_MODES}")
        modes.append(_pair(mode))
    if not modes:
        raise _no_modes("got none; leave 'modes' out for all that the model has")
    twice = next((mode for mode in modes if modes.count(mode) > 1), None)
    if twice is not None:
        raise _no_modes(f"got {twice} twice")
    return tuple(modes)


def _pair(mode: Any) -> Mode:
    try:
        degree, order = map(operator.index, mode)
    except (TypeError, ValueError):
        raise _no_modes(f"one of them is {repr(mode)[:80]}") from None
    return degree, order


def _no_modes(why: str) -> InvalidRequest:
    return InvalidRequest(
        f"'modes' are pairs (l, m) such as [(2, 2), (3, 3)]; {why}.",
        errors=[FieldError(reason=why, parameter="modes")],
    )
