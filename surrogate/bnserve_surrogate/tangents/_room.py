"""Where everything of a row stands in the scratch."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit, types
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, LANES
from bnserve_surrogate.kernel._memory import _view, floats_in, integers_in
from bnserve_surrogate.tangents._layout import (
    BUFFER,
    BUFFERS,
    OF_AMPLITUDE,
    OF_PHASE,
    SERIES,
    SETS,
    TOP,
)

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


_, complexes_in = _view(types.complex128)


class Row(NamedTuple):
    """What is known of a row, on all blocks of frequencies."""

    arguments: Integers
    contents: Integers
    weights: Floats
    linear: Floats
    """The linear synthesis of eight rows and its derivatives, ``(6, 8, width)``; then of the ratios."""
    ratios: Floats
    lane: int
    row: Floats
    """Its parameters."""
    sizes: tuple[int, int, int]
    """Padded numbers of knots of amplitude and phase, and the width of the synthesis."""
    cubics: tuple[Floats, Floats]
    """``(7, 4, n)`` each: of the value, of its derivatives."""
    ends: tuple[Integers, Integers]
    coefficients: tuple[Floats, Floats]
    series: Floats
    """``(7, 36)``."""
    tail: Floats
    one: Floats
    """One frequency, eight times, with its powers; and room for its phase."""
    top: Floats
    buffers: Floats
    modes: Floats


@njit(inline="always")
def row_of(
    arguments: Integers, contents: Integers, weights: Floats, linear: Floats, ratios: Floats, lane: int, row: Floats,
    sizes: tuple[int, int, int], scratch: Floats,
) -> Any:  # fmt: skip
    """A row with its working memory; :func:`~bnserve_surrogate.tangents._layout.row_size` counts it."""
    n_a, n_p = sizes[0], sizes[1]
    cubics = OF_PHASE + OF_AMPLITUDE
    ends = cubics + 4 * SETS * (n_a + n_p)
    series = ends + n_a + n_p
    tail = series + SETS * SERIES
    top = tail + 10 * LANES
    buffers = top + TOP
    return Row(
        arguments, contents, weights, linear, ratios, lane, row, sizes,
        (floats_in(scratch, cubics, 4 * SETS * n_a), floats_in(scratch, cubics + 4 * SETS * n_a, 4 * SETS * n_p)),
        (integers_in(scratch, ends, n_a), integers_in(scratch, ends + n_a, n_p)),
        (floats_in(scratch, 0, OF_PHASE), floats_in(scratch, OF_PHASE, OF_AMPLITUDE)),
        floats_in(scratch, series, SETS * SERIES),
        floats_in(scratch, tail, 2 * LANES),
        floats_in(scratch, tail + 2 * LANES, 8 * LANES),
        floats_in(scratch, top, TOP),
        floats_in(scratch, buffers, BUFFERS * BUFFER),
        floats_in(scratch, buffers + BUFFERS * BUFFER, ANY),
    )  # fmt: skip


@njit(inline="always")
def buffer(room: Floats, number: int) -> Floats:
    """One of the buffers of a block."""
    return floats_in(room, number * BUFFER, BUFFER)
