"""Where on the grid something begins."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def locate(log_f: Floats, points: int, table: Integers, bins: int, density: float, bound: float) -> int:
    """The first frequency whose logarithm is above ``bound``; ``density`` is bins per unit of log f."""
    if bound < at(log_f, 0):
        return 0
    if bound >= at(log_f, points - 1):
        return points
    place = min(max(int((bound - at(log_f, 0)) * density), 0), bins - 1)
    low, high = at(table, place), at(table, place + 1)
    # Rounding may have put the bound into the neighbouring bin.
    while low > 0 and at(log_f, low - 1) > bound:
        low -= 1
    while high < points and at(log_f, high) <= bound:
        high += 1
    while low < high:
        middle = (low + high) >> 1
        if at(log_f, middle) <= bound:
            low = middle + 1
        else:
            high = middle
    return low


@njit(**JIT_OPTIONS)
def find_ends(
    grid: tuple[Floats, int, Integers, int, float], edges: Floats, cells: int, shift: float, stop: int, out: Integers
) -> None:
    """The first frequency beyond each cell, to rounding of its upper edge; the last cell ends with the band."""
    log_f, _, table, bins, density = grid
    first = at(log_f, 0)
    end = 0
    for cell in range(cells - 1):
        bound = at(edges, cell) - shift
        if bound >= first:
            end = max(end, at(table, min(int((bound - first) * density), bins)))
            while end < stop and at(log_f, end) <= bound:
                end += 1
        out[cell] = min(end, stop)
    out[cells - 1] = stop


@njit(**JIT_OPTIONS)
def find_ends_apart(
    grid: tuple[Floats, int, Integers, int, float], edges: Floats, cells: int, shift: float, stop: int, out: Integers
) -> None:
    """:func:`find_ends`, each on its own: quicker where lists of several masses take turns, whose steps no processor
    guesses."""
    log_f, _, table, bins, density = grid
    first = at(log_f, 0)
    for cell in range(cells - 1):
        bound = at(edges, cell) - shift
        end = 0
        if bound >= first:
            end = at(table, min(int((bound - first) * density), bins))
            # Nearly always within three steps, which are taken without a branch that could be guessed wrongly.
            end += at(log_f, end) <= bound
            end += at(log_f, end) <= bound
            end += at(log_f, end) <= bound
            while end < stop and at(log_f, end) <= bound:
                end += 1
        out[cell] = min(end, stop)
    out[cells - 1] = stop


@njit(**JIT_OPTIONS)
def first_not_below(values: Floats, bound: float, size: int) -> int:
    """The first of increasing values that is not below ``bound``."""
    low, high = 0, size
    while low < high:
        middle = (low + high) >> 1
        if at(values, middle) < bound:
            low = middle + 1
        else:
            high = middle
    return low
