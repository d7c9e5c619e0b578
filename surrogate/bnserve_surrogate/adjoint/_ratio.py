"""The ratio of a mode to its carrier, backwards."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.adjoint._layout import Z_IMAGINARY, Z_REAL, Place
from bnserve_surrogate.adjoint._splines import along_cubics, cells_back, clear
from bnserve_surrogate.adjoint._sums import add_moments, total
from bnserve_surrogate.kernel._layout import ANY, LANES, Argument, PlanMode
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_in
from bnserve_surrogate.kernel._row import prepared_grid
from bnserve_surrogate.tangents._layout import MASS, TANGENTS
from bnserve_surrogate.tangents._ratio import _cubics, _views
from bnserve_surrogate.tangents._room import Row, buffer

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_EDGES = 2
"""The derivative whose cubics' place holds, of the real and of the imaginary part, bars at both ends."""


@njit(inline="always")
def bars_at(mode: Integers, count: int) -> int:
    """Where the bars of the linear synthesis of a ratio stand, ``(4 count, 8)``: after its values."""
    return TANGENTS * mode[PlanMode.LINEAR_AT] + 4 * LANES * count


@njit(**JIT_OPTIONS)
def clear_ratio(state: Row, mode: Integers) -> None:
    """No bars yet of a row."""
    room, _, _, _, count, _ = _views(state, mode)
    clear(_cubics(room, count, 1)[0], count)
    clear(_cubics(room, count, 1)[1], count)
    edges = _cubics(room, count, _EDGES)[0]
    for k in range(4):
        edges[k] = 0.0


@njit(**JIT_OPTIONS)
def ratio_block_back(state: Row, mode: Integers, start: int, inside: int, shift: float) -> None:
    """Add the bars of R in the buffers at the frequencies ``start`` to ``inside``."""
    room, places, ends, knots, count, _ = _views(state, mode)
    grid, _ = prepared_grid(state.arguments)
    log_f, cell = floats_in(grid, state.arguments[Argument.STRIDE], ANY), places[2]
    first, last = min(max(places[0], start), inside), min(max(places[1], start), inside)
    edges = _cubics(room, count, _EDGES)[0]
    for part in range(2):
        bars, out = buffer(state.buffers, Z_REAL + part), _cubics(room, count, 1)[part]
        edges[part] += total(bars, 0, first - start, state.tail)
        edges[2 + part] += total(bars, last - start, inside - start, state.tail)
        places[2] = add_moments(log_f, first, last, shift, knots, ends, cell, bars, start, count, out, state.tail)


@njit(**JIT_OPTIONS)
def ratio_back(state: Row, mode: Integers, sums: Floats) -> None:
    """After the last block: bars of what is linear in the regressor's outputs, and the derivative along the mass."""
    room, _, _, knots, count, nodes = _views(state, mode)
    edges, place = _cubics(room, count, _EDGES)[0], bars_at(mode, count)
    out = floats_in(state.ratios, place, 4 * LANES * count)
    for part in range(2):
        bars, slopes = _cubics(room, count, 1)[part], _cubics(room, count, 1 + MASS)[part]
        sums[Place.OWN + MASS] += along_cubics(bars, slopes, nodes, count, state.tail)
        cells_back(bars, knots, nodes, count, state.lane, 2 * count * part, out)
        out[LANES * 2 * count * part + state.lane] += edges[part]
        out[LANES * (2 * count * part + nodes - 1) + state.lane] += edges[2 + part]


assert Z_IMAGINARY == Z_REAL + 1
