"""Modes of a waveform, by their (l, m): which are asked for, and which of them there are."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from bnserve_protocol._errors import FieldError, InvalidRequest

if TYPE_CHECKING:
    from bnserve_protocol._options import EvaluationOptions

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


def chosen_modes(options: EvaluationOptions, known: Sequence[Mode]) -> tuple[Mode, ...]:
    """The modes that the options ask for, in their order; all that are ``known`` where they name none.

    Raises
    ------
    InvalidRequest
        One is not among the known.
    """
    if options.modes is None:
        return tuple(known)
    for mode in options.modes:
        if mode not in known:
            there = ", ".join(map(str, known))
            hint = f" {(mode[0], -mode[1])} stands for it, too." if (mode[0], -mode[1]) in known else ""
            raise InvalidRequest(
                f"This model has no mode {mode}; it has {there}.{hint}",
                errors=[FieldError(reason=f"not among {there}", parameter="modes", value=str(mode))],
            )
    return options.modes


def the_mode(options: EvaluationOptions, known: Sequence[Mode], what: str) -> Mode:
    """The one mode that the options ask for, of those that are ``known``, for what has no meaning for several.

    Parameters
    ----------
    options, known
        As for :func:`chosen_modes`.
    what
        Has no meaning for several: the beginning of a sentence, such as ``"An amplitude and a phase"``.

    Raises
    ------
    InvalidRequest
        Several; or one that is not among the known.
    """
    chosen = chosen_modes(options, known)
    if len(chosen) != 1:
        asked = "this model has" if options.modes is None else "you chose"
        raise InvalidRequest(
            f"{what} belong to one mode, and {asked} {len(chosen)}: choose one with modes=[(2, 2)], or ask for "
            "all of them with predict_modes.",
            errors=[FieldError(reason="not exactly one", parameter="modes")],
        )
    return chosen[0]
