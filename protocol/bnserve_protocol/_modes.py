"""Modes of a waveform, by their (l, m)."""

from __future__ import annotations

import math
import operator
from collections.abc import Iterable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import FieldError, InvalidRequest

Mode: TypeAlias = tuple[int, int]
"""Degree l and order m > 0 of a spin-weighted harmonic; it stands for (l, -m) as well, which symmetry gives."""

PHASE_AT_REFERENCE = 1.25 * math.pi
"""Radians; the continuous phase of the (2, 2) mode at the reference frequency where LAL's ``phiRef`` is zero. It is the
quarter of pi of the stationary phase and one of LAL's harmonics, whose azimuth is pi / 2 - phiRef; modulo 4 pi."""

MOST_MODES = 64
"""More than there are up to l = 10; still more are a mistake or an attack."""


def turn_to_reference(phase: NDArray[np.float64]) -> NDArray[np.float64]:
    """What is added to ``reference_phase`` for half of it to be the orbital phase at a reference frequency, in radians.

    So LAL's models of the frequency domain read ``f_ref`` and ``phiRef`` (``reference_phase`` is 2 phiRef): the phase
    of the (2, 2) mode's Fourier transform is fixed there, with time zero where the alignment has it and before any
    ``time_shift``. Mode m turns by m / 2 of the sum, so that its branch counts: the sum has a period of 4 pi, and
    ``phase`` must be the continuous one.

    Parameters
    ----------
    phase
        Of the (2, 2) mode at the reference frequency, in any shape, as ``predict_amplitude_phase`` has it, with
        ``reference_phase`` and ``time_shift`` zero and in the alignment that is asked for.
    """
    return np.asarray(PHASE_AT_REFERENCE - phase)


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
