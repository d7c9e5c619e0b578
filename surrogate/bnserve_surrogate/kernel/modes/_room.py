"""Where everything of a row stands in the scratch."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, LANES, MODE_BLOCK, Entry, PlanMode
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, integers_in, padded
from bnserve_surrogate.kernel.modes._carriers import CARRIER

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

BUFFER = MODE_BLOCK + LANES
MODE_PLACES = 8
"""Integers that a mode has for itself, beside its cubics and the ends of its cells: where its first node and its last
lie on the grid, and the last cell that was used."""


class State(NamedTuple):
    """What is known of a row on every block of frequencies."""

    arguments: Integers
    contents: Integers
    weights: Floats
    linear: Floats
    """The linear synthesis of the carrier, and for eight rows that of the ratios."""
    ratios: Floats
    sizes: tuple[int, int]
    """Padded numbers of knots and of cells."""
    dense: bool
    cubics: tuple[Floats, Floats]
    """Of the carrier, as its polynomials, and its amplitude and phase where the band ends."""
    fitted: tuple[Floats, Floats]
    top: tuple[float, float, float]
    buffers: tuple[Floats, ...]
    sums: tuple[Floats, Floats, Floats, Floats]
    carriers: Floats
    """What carriers have for themselves, and modes."""
    modes: Floats
    tail: Floats


@njit(inline="always")
def row_views(scratch: Floats, n_p: int, n_c: int, orders: int) -> Any:
    """A row's working memory, for n_p knots and n_c cells; :func:`..modes._plan.scratch_size` counts it.

    Cubics, polynomials, room to fit them, room for a series, six buffers, four sums, a tail, the carriers, the modes.
    """
    cells = LANES * n_c
    fitted = 8 * n_p
    buffers = fitted + 4 * cells + 128
    carriers = buffers + 10 * BUFFER + 2 * LANES
    return (
        (floats_in(scratch, 0, 4 * n_p), floats_in(scratch, 4 * n_p, 4 * n_p)),
        (floats_in(scratch, fitted, cells), floats_in(scratch, fitted + cells, cells)),
        floats_in(scratch, fitted + 2 * cells, 2 * cells),
        (floats_in(scratch, buffers - 128, 64), floats_in(scratch, buffers - 64, 64)),
        (
            floats_in(scratch, buffers, BUFFER),
            floats_in(scratch, buffers + BUFFER, BUFFER),
            floats_in(scratch, buffers + 2 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 3 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 4 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 5 * BUFFER, BUFFER),
        ),
        (
            floats_in(scratch, buffers + 6 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 7 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 8 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 9 * BUFFER, BUFFER),
        ),
        floats_in(scratch, carriers - 2 * LANES, 2 * LANES),
        floats_in(scratch, carriers, orders * (CARRIER + max(n_p, n_c))),
        floats_in(scratch, carriers + orders * (CARRIER + max(n_p, n_c)), ANY),
    )


@njit(inline="always")
def mode_views(modes: Floats, mode: Integers) -> Any:
    """A mode's cubics, places and ends of cells; its knots and how many there are, padded."""
    contents, weights = integers_at(mode[PlanMode.CONTENTS], ANY), floats_at(mode[PlanMode.WEIGHTS], ANY)
    count = padded(contents[Entry.PHASE_NODES])
    room = floats_in(modes, mode[PlanMode.LINEAR_AT] >> 1, ANY)
    return (
        (floats_in(room, 0, 4 * count), floats_in(room, 4 * count, 4 * count)),
        integers_in(room, 8 * count, MODE_PLACES),
        integers_in(room, 8 * count + MODE_PLACES, count),
        floats_in(weights, contents[Entry.PHASE_KNOTS_AT], ANY),
        count,
        contents[Entry.PHASE_NODES],
    )
