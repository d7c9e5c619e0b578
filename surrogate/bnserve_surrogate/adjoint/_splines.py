"""Splines backwards: from the bars of their cells to those of values and second derivatives at the knots."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.adjoint._sums import dot
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_in, padded

Floats = NDArray[np.float64]


@njit(**JIT_OPTIONS)
def clear(bars: Floats, stride: int) -> None:
    """No bars of cubics, ``(4, stride)``."""
    for i in range(4 * stride):
        bars[i] = 0.0


@njit(**JIT_OPTIONS)
def along_cubics(bars: Floats, slopes: Floats, nodes: int, stride: int, lanes: Floats) -> float:
    """Bars of cubics times what these change by with a parameter: of slopes of cubics, which are parabolas."""
    found = 0.0
    for power in range(3):
        own = floats_in(bars, power * stride, stride)
        found += dot(own, floats_in(slopes, power * stride, stride), padded(nodes - 1), lanes)
    return found


@njit(**JIT_OPTIONS)
def cells_back(bars: Floats, knots: Floats, nodes: int, stride: int, lane: int, place: int, out: Floats) -> None:
    """What :func:`~bnserve_surrogate.kernel._points.fill_cells` does, backwards, of a row in its lane of ``out``:
    values from ``place`` on, second derivatives from ``stride`` further on."""
    widths, reciprocals = floats_in(knots, stride, stride), floats_in(knots, 2 * stride, stride)
    values, curvatures = LANES * place + lane, LANES * (place + stride) + lane
    value = curvature = 0.0
    for i in range(nodes - 1):
        b1, b2 = at(bars, stride + i), at(bars, 2 * stride + i)
        slope, third = b1 * at(reciprocals, i), at(bars, 3 * stride + i) * at(reciprocals, i) * (1.0 / 6.0)
        bent = b1 * at(widths, i) * (1.0 / 6.0)
        out[values + LANES * i] = value + (at(bars, i) - slope)
        out[curvatures + LANES * i] = curvature + (0.5 * b2 - 2.0 * bent - third)
        value, curvature = slope, third - bent
    out[values + LANES * (nodes - 1)] = value
    out[curvatures + LANES * (nodes - 1)] = curvature
