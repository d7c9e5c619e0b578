"""Source of the compiled factorisation: rows folded into a triangle by Householder's reflections.

Each reflection takes the rows of a block under one column of the triangle to zero. The triangle is that of a QR
factorisation of all rows that were folded (Golub, Van Loan 2013, *Matrix Computations*, section 5.2), with a diagonal
that is not negative.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_inference.fisher_kernel._layout import COLUMNS
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_in, load, store
from bnserve_surrogate.kernel._simd import fma, splat

Floats = NDArray[np.float64]

_LEAST = 1e-280
"""Of a sum of squares: below, it is nothing."""


@njit(inline="always")
def lane_sum(values: Any, room: Floats) -> float:
    """The sum of a vector's lanes, in a fixed order."""
    store(room, 0, values)
    return ((room[0] + room[1]) + (room[2] + room[3])) + ((room[4] + room[5]) + (room[6] + room[7]))


@njit(inline="always")
def _reflect_four(
    v: Floats, a: tuple[Floats, Floats, Floats, Floats], count: int, u: float, tau: float, line: Floats, room: Floats
) -> None:
    """Reflect four columns; ``line`` are their elements in the row of the triangle."""
    s0 = s1 = s2 = s3 = splat(0.0)
    for j in range(0, count, LANES):
        x = load(v, j)
        s0, s1 = fma(x, load(a[0], j), s0), fma(x, load(a[1], j), s1)
        s2, s3 = fma(x, load(a[2], j), s2), fma(x, load(a[3], j), s3)
    w0, w1 = tau * (u * line[0] + lane_sum(s0, room)), tau * (u * line[1] + lane_sum(s1, room))
    w2, w3 = tau * (u * line[2] + lane_sum(s2, room)), tau * (u * line[3] + lane_sum(s3, room))
    line[0] -= w0 * u
    line[1] -= w1 * u
    line[2] -= w2 * u
    line[3] -= w3 * u
    for j in range(0, count, LANES):
        x = load(v, j)
        store(a[0], j, fma(x, -w0, load(a[0], j)))
        store(a[1], j, fma(x, -w1, load(a[1], j)))
        store(a[2], j, fma(x, -w2, load(a[2], j)))
        store(a[3], j, fma(x, -w3, load(a[3], j)))


@njit(inline="always")
def _reflect(v: Floats, a: Floats, count: int, u: float, tau: float, line: Floats, room: Floats) -> None:
    total = splat(0.0)
    for j in range(0, count, LANES):
        total = fma(load(v, j), load(a, j), total)
    w = tau * (u * line[0] + lane_sum(total, room))
    line[0] -= w * u
    for j in range(0, count, LANES):
        store(a, j, fma(load(v, j), -w, load(a, j)))


@njit(**JIT_OPTIONS)
def fold(block: Floats, capacity: int, vectors: int, root: Floats, room: Floats) -> None:
    """Fold ``vectors`` times eight rows of ``block``, ``(13, capacity, 8)``, into the triangle ``(13, 13)``."""
    count, width = LANES * vectors, LANES * capacity
    for k in range(COLUMNS):
        v = floats_in(block, k * width, count)
        even = odd = splat(0.0)
        for j in range(0, count - LANES, 2 * LANES):
            x, y = load(v, j), load(v, j + LANES)
            even, odd = fma(x, x, even), fma(y, y, odd)
        if vectors % 2 == 1:
            x = load(v, count - LANES)
            even = fma(x, x, even)
        sigma = lane_sum(even + odd, room)
        if not sigma < _LEAST:  # what is no number stays none
            alpha = root[k * COLUMNS + k]
            mu = np.sqrt(alpha * alpha + sigma)
            u = -sigma / (alpha + mu)
            tau = -1.0 / (mu * u)
            root[k * COLUMNS + k] = mu
            column = k + 1
            while column < COLUMNS:
                line = floats_in(root, k * COLUMNS + column, 4)
                first = floats_in(block, column * width, count)
                if column + 4 <= COLUMNS:
                    three = (
                        floats_in(block, (column + 1) * width, count),
                        floats_in(block, (column + 2) * width, count),
                        floats_in(block, (column + 3) * width, count),
                    )
                    _reflect_four(v, (first, three[0], three[1], three[2]), count, u, tau, line, room)
                    column += 4
                else:
                    _reflect(v, first, count, u, tau, line, room)
                    column += 1
