"""Polarisations at the frequencies of a grid: the observer's spinor there, and what the harmonics make of the modes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import load, store
from bnserve_surrogate.kernel._simd import fma, smaller
from bnserve_surrogate.precession._layout import BEND, LANES, LAST, NODE, WIDTH
from bnserve_surrogate.precession._vectors import folded, halves, load_complex, square_root

Floats = NDArray[np.float64]


@njit(**JIT_OPTIONS)
def directions(
    f: Floats, size: int, unit: float, scale: float, origin: float, nodes: Floats, count: int, position: Floats,
    out: Floats,
) -> None:  # fmt: skip
    """The observer's spinor when a mode passes ``f``: four sections of ``out``, by Hermite's cubics between steps.

    ``unit`` / f is 1 / omega, the first node is at the step ``origin``, and there are ``count``.
    """
    for j in range(0, size, LANES):
        y = 0.0 - smaller((0.0 - unit) / load(f, j), -LAST)
        root = square_root(y * (y + (4.0 * BEND) * scale))
        store(position, j, (y + root) * (0.5 / scale) - origin)
    for j in range(size):
        place = position[j]
        node = min(max(int(place), 0), count - 2)
        t = place - node
        rest = 1.0 - t
        begin = halves((1.0 + 2.0 * t) * (rest * rest), t * (rest * rest))
        end = halves((t * t) * (1.0 + 2.0 * rest), (t * t) * (0.0 - rest))
        at = node * NODE
        a, b, p, q = folded(fma(begin, load(nodes, at), end * load(nodes, at + NODE)))
        out[j], out[WIDTH + j], out[2 * WIDTH + j], out[3 * WIDTH + j] = a, b, p, q


@njit(inline="always")
def _times(a: Any, b: Any) -> Any:
    """The product of two complex numbers."""
    return a[0] * b[0] - a[1] * b[1], fma(a[0], b[1], a[1] * b[0])


@njit(inline="always")
def _monomials(order: int, a: Any, b: Any) -> Any:
    """A^(m+2) B^(m-2) and A^(2-m) B^(-m-2), both conjugate, of the conjugates ``a`` and ``b``."""
    a2, b2 = _times(a, a), _times(b, b)
    if order == 1:
        first = _times(_times(a2, a), (b[0], 0.0 - b[1]))
        return first, _times(_times(b2, b), (a[0], 0.0 - a[1]))
    first, second = _times(a2, a2), _times(b2, b2)
    both = _times(a, b)
    if order == 4:
        both = _times(both, both)
    if order > 2:
        first, second = _times(first, both), _times(second, both)
    return first, second


@njit(**JIT_OPTIONS)
def twisted(
    order: int, mode: int, last: int, table: Floats, strain: Floats, points: int, start: int, left: int,
    spinor: Floats, j: int, spare: Floats, sums: Floats,
) -> None:  # fmt: skip
    """Add to the sums at eight frequencies the modes from ``mode`` to ``last``, all of one order.

    ``left`` is how many frequencies there are; where fewer than eight, strain is read by way of ``spare``.
    """
    a = load(spinor, j), 0.0 - load(spinor, WIDTH + j)
    b = load(spinor, 2 * WIDTH + j), 0.0 - load(spinor, 3 * WIDTH + j)
    x = (a[0] * a[0] + a[1] * a[1]) - (b[0] * b[0] + b[1] * b[1])
    up, down = (x * 0.0, x * 0.0), (x * 0.0, x * 0.0)
    for k in range(mode, last):
        at = k * points + start
        if left >= LANES:
            h = load_complex(strain, at)
        else:
            for i in range(2 * left):
                spare[i] = strain[2 * at + i]
            h = load_complex(spare, 0)
        there, mirrored = fma(x, table[4 * k + 1], table[4 * k]), fma(x, table[4 * k + 3], table[4 * k + 2])
        up = fma(there, h[0], up[0]), fma(there, h[1], up[1])
        down = fma(mirrored, h[0], down[0]), fma(mirrored, h[1], down[1])
    first, second = _monomials(order, a, b)
    up, down = _times(first, up), _times(second, down)
    store(sums, j, load(sums, j) + (up[0] + down[0]))
    store(sums, WIDTH + j, load(sums, WIDTH + j) + (up[1] + down[1]))
    # times -i
    store(sums, 2 * WIDTH + j, load(sums, 2 * WIDTH + j) + (up[1] - down[1]))
    store(sums, 3 * WIDTH + j, load(sums, 3 * WIDTH + j) - (up[0] - down[0]))
