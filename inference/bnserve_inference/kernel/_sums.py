"""Sums over a block of nodes: strain with calibration errors, moved in time, times the weights there."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
_TWO_PI = 2.0 * np.pi


@njit(**JIT_OPTIONS)
def lane_sum(values: Floats) -> float:
    """Sum of whole lanes, in a fixed order that the compiler can vectorise."""
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = 0.0
    for j in range(values.shape[0] // LANES):
        at = LANES * j
        s0 += values[at]
        s1 += values[at + 1]
        s2 += values[at + 2]
        s3 += values[at + 3]
        s4 += values[at + 4]
        s5 += values[at + 5]
        s6 += values[at + 6]
        s7 += values[at + 7]
    return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7))


@njit(**JIT_OPTIONS)
def errors_at(nodes: Floats, spline: Floats, stride: int, first: int, out: Floats) -> None:
    """A calibration spline at some frequencies: values at its nodes times the nodes' cardinal functions."""
    count = out.shape[0]
    for j in range(count):
        out[j] = 0.0
    for k in range(nodes.shape[0]):
        row = spline[k * stride + first : k * stride + first + count]
        value = nodes[k]
        for j in range(count):
            out[j] += value * row[j]


@njit(**JIT_OPTIONS)
def calibrate(amplitude: Floats, phase: Floats, hr: Floats, hi: Floats, kr: Floats, ki: Floats) -> None:
    """Strain times (1 + dA) (2 + i dphi) / (2 - i dphi)."""
    for j in range(hr.shape[0]):
        p = phase[j]
        scale = (1.0 + amplitude[j]) / (4.0 + p * p)
        c = scale * (4.0 - p * p)
        s = scale * (4.0 * p)
        kr[j] = hr[j] * c - hi[j] * s
        ki[j] = hr[j] * s + hi[j] * c


@njit(**JIT_OPTIONS)
def products_at(
    f: Floats, time: float, kr: Floats, ki: Floats, weights: Floats, rows: Any, spline: Any, pr: Floats, pi: Floats
) -> None:
    """Strain, moved to ``time``, times the weights at that time: a sum of six rows of B-spline coefficients.

    ``rows``: where the first row of real parts begins, how far it is to the next row, and to its imaginary parts.
    """
    n = f.shape[0]
    first, row, imaginary = rows
    b0, b1, b2, b3, b4, b5 = spline
    r0, i0 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r1, i1 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r2, i2 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r3, i3 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r4, i4 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r5, i5 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    turn = -_TWO_PI * time
    for j in range(n):
        s, c = sincos(f[j] * turn)
        hr = kr[j] * c - ki[j] * s
        hi = kr[j] * s + ki[j] * c
        wr = b0 * r0[j] + b1 * r1[j] + b2 * r2[j] + b3 * r3[j] + b4 * r4[j] + b5 * r5[j]
        wi = b0 * i0[j] + b1 * i1[j] + b2 * i2[j] + b3 * i3[j] + b4 * i4[j] + b5 * i5[j]
        pr[j] = wr * hr - wi * hi
        pi[j] = wr * hi + wi * hr


@njit(**JIT_OPTIONS)
def fixed_products(
    f: Floats, time: float, kr: Floats, ki: Floats, wr: Floats, wi: Floats, pr: Floats, pi: Floats
) -> None:
    """As :func:`products_at`, of weights that do not depend on time."""
    turn = -_TWO_PI * time
    for j in range(f.shape[0]):
        s, c = sincos(f[j] * turn)
        hr = kr[j] * c - ki[j] * s
        hi = kr[j] * s + ki[j] * c
        pr[j] = wr[j] * hr - wi[j] * hi
        pi[j] = wr[j] * hi + wi[j] * hr


@njit(**JIT_OPTIONS)
def spline_at(time: float, knots: Floats, rows: int, width: int, first: int) -> Any:
    """Which six coefficient rows, and the values of the six quintic B-splines, at a time."""
    u = (time - knots[0]) / knots[1]
    cell = int(np.floor(u))
    cell = min(max(cell, 2), rows - 4)
    x = u - cell
    y = 1.0 - x
    spline = (
        y * y * y * y * y / 120.0,
        (26.0 + x * (-50.0 + x * (20.0 + x * (20.0 + x * (-20.0 + 5.0 * x))))) / 120.0,
        (66.0 + x * x * (-60.0 + x * x * (30.0 - 10.0 * x))) / 120.0,
        (66.0 + y * y * (-60.0 + y * y * (30.0 - 10.0 * y))) / 120.0,
        (26.0 + y * (-50.0 + y * (20.0 + y * (20.0 + y * (-20.0 + 5.0 * y))))) / 120.0,
        x * x * x * x * x / 120.0,
    )
    return (2 * width * (cell - 2) + first, 2 * width, width), spline


@njit(**JIT_OPTIONS)
def gather(wave: Floats, places: Integers, filled: int, hr: Floats, hi: Floats) -> None:
    """Strain at the ``filled`` nodes of a block, and zero beyond them."""
    for j in range(filled):
        hr[j] = wave[2 * places[j]]
        hi[j] = wave[2 * places[j] + 1]
    for j in range(filled, hr.shape[0]):
        hr[j] = 0.0
        hi[j] = 0.0


@njit(**JIT_OPTIONS)
def add_terms(pr: Floats, pi: Floats, cr: float, ci: float, line: Floats) -> None:
    for j in range(line.shape[0] // 2):
        line[2 * j] += cr * pr[j] - ci * pi[j]
        line[2 * j + 1] += cr * pi[j] + ci * pr[j]
