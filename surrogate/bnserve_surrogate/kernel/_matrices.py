"""The product of a few rows with a matrix that is arranged in blocks of columns."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import LANES, WIDE
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_in, load, store
from bnserve_surrogate.kernel._simd import fma, splat

Floats = NDArray[np.float64]


@njit(inline="always")
def _store_wide(out: Floats, place: int, v0: Any, v1: Any, v2: Any, v3: Any) -> None:
    store(out, place, v0)
    store(out, place + LANES, v1)
    store(out, place + 2 * LANES, v2)
    store(out, place + 3 * LANES, v3)


@njit(inline="always")
def _multiply_wide(
    count: int, scalars: Floats, row: int, step: int, matrix: Floats, position: int, out: Floats, out_row: int
) -> None:
    """:func:`multiply` for a block of 32 columns that begins at ``position`` of the matrix."""
    a00 = a01 = a02 = a03 = splat(0.0)
    a10 = a11 = a12 = a13 = splat(0.0)
    a20 = a21 = a22 = a23 = splat(0.0)
    a30 = a31 = a32 = a33 = splat(0.0)
    for k in range(count):
        v0, v1 = load(matrix, position), load(matrix, position + LANES)
        v2, v3 = load(matrix, position + 2 * LANES), load(matrix, position + 3 * LANES)
        position += WIDE
        s = at(scalars, k * step)
        a00, a01 = fma(v0, s, a00), fma(v1, s, a01)
        a02, a03 = fma(v2, s, a02), fma(v3, s, a03)
        s = at(scalars, row + k * step)
        a10, a11 = fma(v0, s, a10), fma(v1, s, a11)
        a12, a13 = fma(v2, s, a12), fma(v3, s, a13)
        s = at(scalars, 2 * row + k * step)
        a20, a21 = fma(v0, s, a20), fma(v1, s, a21)
        a22, a23 = fma(v2, s, a22), fma(v3, s, a23)
        s = at(scalars, 3 * row + k * step)
        a30, a31 = fma(v0, s, a30), fma(v1, s, a31)
        a32, a33 = fma(v2, s, a32), fma(v3, s, a33)
    _store_wide(out, 0, a00, a01, a02, a03)
    _store_wide(out, out_row, a10, a11, a12, a13)
    _store_wide(out, 2 * out_row, a20, a21, a22, a23)
    _store_wide(out, 3 * out_row, a30, a31, a32, a33)


@njit(**JIT_OPTIONS)
def multiply(
    count: int, scalars: Floats, row: int, step: int, matrix: Floats, columns: int, out: Floats, out_row: int
) -> None:
    """A product with four rows: ``out[i, j] = sum_k scalars[i, k] * matrix[k, j]``.

    Parameters
    ----------
    count
        Number of terms; every sum runs over them in this order.
    scalars, row, step
        ``scalars[i, k]`` stands at ``i * row + k * step``.
    matrix, columns
        As :func:`bnserve_surrogate.kernel._mode.by_columns` arranges it; ``columns`` are whole vectors.
    out, out_row
        ``out[i, j]`` stands at ``i * out_row + j``.
    """
    position = 0
    for column in range(0, columns // WIDE * WIDE, WIDE):
        _multiply_wide(count, scalars, row, step, matrix, position, floats_in(out, column, WIDE), out_row)
        position += count * WIDE
    for column in range(columns // WIDE * WIDE, columns, LANES):
        b0 = b1 = b2 = b3 = splat(0.0)
        for k in range(count):
            v = load(matrix, position)
            position += LANES
            b0 = fma(v, at(scalars, k * step), b0)
            b1 = fma(v, at(scalars, row + k * step), b1)
            b2 = fma(v, at(scalars, 2 * row + k * step), b2)
            b3 = fma(v, at(scalars, 3 * row + k * step), b3)
        store(out, column, b0)
        store(out, out_row + column, b1)
        store(out, 2 * out_row + column, b2)
        store(out, 3 * out_row + column, b3)
