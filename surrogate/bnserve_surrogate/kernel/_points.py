"""From the cubics of a row to its values on a block of frequencies, eight at a time.

Loops run over whole vectors: up to seven values beyond the end of a segment are computed and then overwritten by the
next segment, or stand in the padding of a buffer.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.baseline import FREEZING_END, FREEZING_START
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential, sincos
from bnserve_surrogate.kernel._memory import at, load, store
from bnserve_surrogate.kernel._simd import fma, splat

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def step(x: Any) -> Any:
    """Smooth step of the paper (section "High frequency bound"): 0 at x = 0, 1 at x = 1, flat at both."""
    return fma(sincos(x * np.pi)[1], -0.5, 0.5)


@njit(**JIT_OPTIONS)
def fill_cells(values: Floats, curvatures: Floats, knots: Floats, cells: int, stride: int, out: Floats) -> None:
    """Cubics c0 + t (c1 + t (c2 + t c3)) of a spline's cells, t from the cell's knot on; ``out`` is ``(4, stride)``."""
    widths, reciprocals = knots[stride:], knots[2 * stride :]
    for i in range(0, cells, LANES):
        y, y_next = load(values, i), load(values, i + 1)
        m, m_next = load(curvatures, i), load(curvatures, i + 1)
        width, reciprocal = load(widths, i), load(reciprocals, i)
        slope = (y_next - y) * reciprocal
        store(out, i, y)
        store(out, stride + i, slope - width * (fma(m, 2.0, m_next) * (1.0 / 6.0)))
        store(out, 2 * stride + i, m * 0.5)
        store(out, 3 * stride + i, (m_next - m) * reciprocal * (1.0 / 6.0))


@njit(**JIT_OPTIONS)
def spline(
    log_f: Floats, first: int, stop: int, shift: float, knots: Floats, ends: Integers, cell: int, cubics: Floats,
    stride: int, out: Floats,
) -> int:  # fmt: skip
    """A spline at ``log_f + shift`` for the frequencies ``first`` to ``stop``; returns the last cell that was used.

    ``ends[c]`` is the first frequency beyond cell c.
    """
    start = first
    while start < stop:
        while at(ends, cell) <= start:
            cell += 1
        end = min(at(ends, cell), stop)
        offset = shift - at(knots, cell)
        c0, c1 = at(cubics, cell), at(cubics, stride + cell)
        c2, c3 = at(cubics, 2 * stride + cell), at(cubics, 3 * stride + cell)
        for j in range(start, end, LANES):
            t = load(log_f, j) + offset
            store(out, j - first, fma(t, fma(t, fma(t, splat(c3), c2), c1), c0))
        start = end
    return cell


@njit(**JIT_OPTIONS)
def two_splines(
    log_f: Floats, first: int, stop: int, shift: float, knots: Floats, ends: Integers, cell: int, cubics: Floats,
    stride: int, out: Floats, other_cubics: Floats, other_out: Floats,
) -> int:  # fmt: skip
    """:func:`spline` for two splines with the same knots."""
    start = first
    while start < stop:
        while at(ends, cell) <= start:
            cell += 1
        end = min(at(ends, cell), stop)
        offset = shift - at(knots, cell)
        c0, c1 = at(cubics, cell), at(cubics, stride + cell)
        c2, c3 = at(cubics, 2 * stride + cell), at(cubics, 3 * stride + cell)
        d0, d1 = at(other_cubics, cell), at(other_cubics, stride + cell)
        d2, d3 = at(other_cubics, 2 * stride + cell), at(other_cubics, 3 * stride + cell)
        for j in range(start, end, LANES):
            t = load(log_f, j) + offset
            store(out, j - first, fma(t, fma(t, fma(t, splat(c3), c2), c1), c0))
            store(other_out, j - first, fma(t, fma(t, fma(t, splat(d3), d2), d1), d0))
        start = end
    return cell


@njit(**JIT_OPTIONS)
def extend_below(
    f: Floats, count: int, mass: float, mf_min: float, edge: tuple[float, float], slope: float, a: Floats, p: Floats
) -> None:
    """Residuals below the trained band: the amplitude's fades out over an octave, the phase's goes on linearly."""
    for j in range(count):
        mf = f[j] * mass
        ratio = 2.0 * mf / mf_min - 1.0
        a[j] = edge[0] * step(ratio) if ratio > 0.0 else 0.0
        p[j] = edge[1] + slope * (mf - mf_min)


@njit(**JIT_OPTIONS)
def amplitudes(
    f: Floats, cbrt_f: Floats, power: Floats, segments: tuple[int, int, int], mass: float, c: Floats, constant: float,
    residuals: Floats, out: Floats,
) -> None:  # fmt: skip
    """Residual log-amplitudes into amplitudes over the baseline, which freezes between the first two ``segments``.

    ``power`` is f^(-7/6) and ``c`` the series in f^(1/3).
    """
    c0, c1, c2, c3, c4, c5, c6, c7 = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]
    freezing, frozen, stop = segments
    for j in range(0, freezing, LANES):
        u = load(cbrt_f, j)
        high = fma(u, fma(u, fma(u, splat(c7), c6), c5), c4)
        bare = fma(u, fma(u, fma(u, fma(u, high, c3), c2), c1), c0) * load(power, j)
        store(out, j, exponential(load(residuals, j)) * bare)
    for j in range(freezing, frozen, LANES):
        u = load(cbrt_f, j)
        high = fma(u, fma(u, fma(u, splat(c7), c6), c5), c4)
        bare = fma(u, fma(u, fma(u, fma(u, high, c3), c2), c1), c0) * load(power, j)
        x = fma(load(f, j), mass / (FREEZING_END - FREEZING_START), -FREEZING_START / (FREEZING_END - FREEZING_START))
        store(out, j, exponential(load(residuals, j)) * fma(step(x), splat(constant) - bare, bare))
    for j in range(frozen, stop, LANES):
        store(out, j, exponential(load(residuals, j)) * constant)


@njit(**JIT_OPTIONS)
def phases(
    f: Floats, log_f: Floats, cbrt_f: Floats, power: Floats, stop: int, c: Floats, d: Floats, p: Floats, out: Floats
) -> None:
    """Residual phases into phi = constant + slope f - (TaylorF2 phase + residual).

    ``power`` is f^(-5/3); ``c`` holds the 16 coefficients in f^(1/3), ``d`` the seven of log f and f^(1/3), the one of
    log^2 f times f, the constant and the slope.
    """
    c0, c1, c2, c3, c4, c5, c6, c7 = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]
    c8, c9, c10, c11, c12, c13, c14, c15 = c[8], c[9], c[10], c[11], c[12], c[13], c[14], c[15]
    d0, d1, d2, d3, d4, d5, d6, e3, constant, slope = d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8], d[9]
    for j in range(0, stop, LANES):
        u, x, log_x = load(cbrt_f, j), load(f, j), load(log_f, j)
        square = u * u
        # Horner in u^2 for even and odd powers: half as long a chain.
        even = fma(square, fma(square, fma(square, splat(c14), c12), c10), c8)
        odd = fma(square, fma(square, fma(square, splat(c15), c13), c11), c9)
        low_even = fma(square, fma(square, fma(square, splat(c6), c4), c2), c0)
        low_odd = fma(square, fma(square, fma(square, splat(c7), c5), c3), c1)
        log_even = fma(square, fma(square, fma(square, splat(d6), d4), d2), d0)
        log_odd = fma(square, fma(square, splat(d5), d3), d1)
        baseline = fma(u, low_odd, low_even) * load(power, j)
        logarithmic = fma(log_x * x, e3, fma(u, log_odd, log_even))
        smooth = fma(log_x, logarithmic, fma(x, fma(u, odd, even), load(p, j)))
        store(out, j, fma(x, slope, constant) - (baseline + smooth))


@njit(**JIT_OPTIONS)
def fill_polynomials(values: Floats, matrix: Floats, cells: int, out: Floats) -> None:
    """Coefficients of the powers of the cell's coordinate, ``(cells, 8)``, from values at its eight nodes."""
    for cell in range(0, LANES * cells, LANES):
        even, odd = splat(0.0), splat(0.0)
        for node in range(0, LANES, 2):
            even = fma(load(matrix, LANES * node), at(values, cell + node), even)
            odd = fma(load(matrix, LANES * node + LANES), at(values, cell + node + 1), odd)
        store(out, cell, even + odd)


@njit(**JIT_OPTIONS)
def spline_at_nodes(
    log_mf: Floats, knots: Floats, cubics: Floats, stride: int, owners: Integers, cells: int, out: Floats
) -> None:
    """A spline at the nodes of the cells."""
    for cell in range(cells):
        owner = at(owners, cell)
        t = load(log_mf, LANES * cell) - at(knots, owner)
        c0, c1 = at(cubics, owner), at(cubics, stride + owner)
        c2, c3 = at(cubics, 2 * stride + owner), at(cubics, 3 * stride + owner)
        store(out, LANES * cell, fma(t, fma(t, fma(t, splat(c3), c2), c1), c0))


@njit(**JIT_OPTIONS)
def polynomials(
    f: Floats, first: int, stop: int, mass: float, scales: Floats, offsets: Floats, ends: Integers, cell: int,
    a: Floats, p: Floats, amplitude: Floats, phase: Floats,
) -> int:  # fmt: skip
    """Amplitude and phase for the frequencies ``first`` to ``stop``; returns the last cell that was used."""
    start = first
    while start < stop:
        while at(ends, cell) <= start:
            cell += 1
        end = min(at(ends, cell), stop)
        scale, offset = mass * at(scales, cell), 0.0 - at(offsets, cell)
        c = LANES * cell
        a0, a1, a2, a3, a4, a5 = at(a, c), at(a, c + 1), at(a, c + 2), at(a, c + 3), at(a, c + 4), at(a, c + 5)
        p0, p1, p2, p3 = at(p, c), at(p, c + 1), at(p, c + 2), at(p, c + 3)
        p4, p5, p6 = at(p, c + 4), at(p, c + 5), at(p, c + 6)
        for j in range(start, end, LANES):
            x = fma(load(f, j), scale, offset)
            store(amplitude, j - first, fma(x, fma(x, fma(x, fma(x, fma(x, splat(a5), a4), a3), a2), a1), a0))
            high = fma(x, fma(x, fma(x, splat(p6), p5), p4), p3)
            store(phase, j - first, fma(x, fma(x, fma(x, high, p2), p1), p0))
        start = end
    return cell
