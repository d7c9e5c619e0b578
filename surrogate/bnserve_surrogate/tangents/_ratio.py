"""Derivatives of the ratio R of a mode to its carrier."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, LANES, Argument, Column, Entry, PlanMode
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_at, floats_in, integers_at, integers_in, padded
from bnserve_surrogate.kernel._places import find_ends, locate
from bnserve_surrogate.kernel._points import fill_cells
from bnserve_surrogate.kernel._row import prepared_grid
from bnserve_surrogate.kernel.modes._sums import fill_ratio
from bnserve_surrogate.tangents._carrier import fill_slopes
from bnserve_surrogate.tangents._layout import INTRINSIC, MASS, TANGENTS, Buffer
from bnserve_surrogate.tangents._room import Row, buffer

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_PLACES = LANES
"""Integers of where a ratio's knots begin and end on the grid, and the last cell that was used."""


@njit(inline="always")
def _views(state: Row, mode: Integers) -> Any:
    """Cubics of the value and its derivatives, places, ends of the cells, knots, their number in whole vectors, and in
    truth."""
    contents, weights = integers_at(mode[PlanMode.CONTENTS], ANY), floats_at(mode[PlanMode.WEIGHTS], ANY)
    count = padded(contents[Entry.PHASE_NODES])
    room = floats_in(state.modes, 2 * mode[PlanMode.LINEAR_AT], ANY)
    return (
        room,
        integers_in(room, 56 * count, _PLACES),
        integers_in(room, 56 * count + _PLACES, count),
        floats_in(weights, contents[Entry.PHASE_KNOTS_AT], ANY),
        count,
        contents[Entry.PHASE_NODES],
    )


@njit(inline="always")
def _linear(state: Row, mode: Integers, count: int, which: int) -> Floats:
    """The linear synthesis of the value, or of a derivative."""
    first = TANGENTS * mode[PlanMode.LINEAR_AT] + (which * LANES + state.lane) * 4 * count
    return floats_in(state.ratios, first, 4 * count)


@njit(inline="always")
def _cubics(room: Floats, count: int, which: int) -> tuple[Floats, Floats]:
    first = 8 * count * which
    return floats_in(room, first, 4 * count), floats_in(room, first + 4 * count, 4 * count)


@njit(**JIT_OPTIONS)
def prepare_ratio(state: Row, mode: Integers, shift: float, stop: int, sets: int) -> None:
    """Cubics of a ratio, of so many of the value and its derivatives and of that with respect to the total mass, and
    where on the grid its knots lie."""
    room, places, ends, knots, count, nodes = _views(state, mode)
    for which in range(sets):
        linear, cubics = _linear(state, mode, count, which), _cubics(room, count, which)
        fill_cells(linear, floats_in(linear, count, count), knots, nodes - 1, count, cubics[0])
        values, curvatures = floats_in(linear, 2 * count, count), floats_in(linear, 3 * count, count)
        fill_cells(values, curvatures, knots, nodes - 1, count, cubics[1])
    value, slopes = _cubics(room, count, 0), _cubics(room, count, 1 + MASS)
    over_mass = 1.0 / state.row[Column.TOTAL_MASS]
    fill_slopes(value[0], count, over_mass, slopes[0])
    fill_slopes(value[1], count, over_mass, slopes[1])
    _, grid_places = prepared_grid(state.arguments)
    places[0] = min(locate(*grid_places, at(knots, 0) - shift), stop)
    places[1] = min(locate(*grid_places, at(knots, nodes - 1) - shift), stop)
    places[2] = 0
    find_ends(grid_places, floats_in(knots, 1, count), nodes - 1, shift, places[1], ends)


@njit(**JIT_OPTIONS)
def fill_ratio_tangent(state: Row, mode: Integers, p: int, start: int, inside: int, shift: float) -> None:
    """The derivative of R with respect to parameter p: constant outside the nodes, as R is."""
    room, places, ends, knots, count, nodes = _views(state, mode)
    linear, edges = _linear(state, mode, count, min(1 + p, INTRINSIC)), (0.0, 0.0, 0.0, 0.0)
    if p != MASS:
        edges = (linear[0], linear[2 * count], linear[nodes - 1], linear[2 * count + nodes - 1])
    grid, _ = prepared_grid(state.arguments)
    log_f, cell = floats_in(grid, state.arguments[Argument.STRIDE], ANY), places[2]
    real, imaginary = buffer(state.buffers, Buffer.RATIO_REAL), buffer(state.buffers, Buffer.RATIO_IMAGINARY)
    fill_ratio(
        log_f, start, inside, places, shift, knots, ends, _cubics(room, count, 1 + p), count, edges, real, imaginary
    )
    if p < MASS:  # the next derivative begins in the same cell
        places[2] = cell
