"""Source of the compiled adjoint: sums over a block of nodes, eight at a time."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from bnserve_inference.adjoint_kernel._layout import Buffer, Shared
from bnserve_inference.adjoint_kernel._response import block_of
from bnserve_inference.kernel._sums import Floats
from bnserve_surrogate.adjoint._sums import across
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import load, store
from bnserve_surrogate.kernel._simd import fma, splat

_TWO_PI = 2.0 * np.pi


@njit(inline="always")
def times(ar: Any, ai: Any, br: Any, bi: Any) -> Any:
    """A product of complex numbers."""
    return fma(ar, br, ai * bi * -1.0), fma(ar, bi, ai * br)


@njit(**JIT_OPTIONS)
def add_fixed(f: Floats, time: float, wr: Floats, wi: Floats, size: int, shared: Floats) -> None:
    """Add what weights that do not depend on time make of the products' bars, at a time."""
    lr, li = block_of(shared, Shared.WORK), block_of(shared, Shared.WORK + 1)
    zr, zi = block_of(shared, Shared.STRAIN_BAR), block_of(shared, Shared.STRAIN_BAR + 1)
    yr, yi = block_of(shared, Shared.SLOPE_BAR), block_of(shared, Shared.SLOPE_BAR + 1)
    for j in range(0, size, LANES):
        frequency = load(f, j) * -_TWO_PI
        s, c = sincos(frequency * time)
        er, ei = times(load(lr, j), load(li, j), c, s)
        ar, ai = times(load(wr, j), load(wi, j), er, ei)
        store(zr, j, load(zr, j) + ar)
        store(zi, j, load(zi, j) + ai)
        store(yr, j, load(yr, j) - frequency * ai)
        store(yi, j, fma(frequency, ar, load(yi, j)))


@njit(inline="always")
def slopes_at(time: float, knots: Floats, rows: int) -> Any:
    """Derivatives with respect to time of the six B-splines of ``spline_at``."""
    u = (time - knots[0]) / knots[1]
    cell = min(max(int(np.floor(u)), 2), rows - 4)
    x = u - cell
    y = 1.0 - x
    scale = 1.0 / (24.0 * knots[1])
    inner, outer = -24.0 * x + x * x * x * (24.0 - 10.0 * x), -24.0 * y + y * y * y * (24.0 - 10.0 * y)
    first = -10.0 + x * (8.0 + x * (12.0 + x * (-16.0 + 5.0 * x)))
    last = -10.0 + y * (8.0 + y * (12.0 + y * (-16.0 + 5.0 * y)))
    return (
        -y * y * y * y * scale, first * scale, inner * scale, -outer * scale, -last * scale, x * x * x * x * scale,
    )  # fmt: skip


@njit(inline="always")
def _splined(table: Floats, place: int, row: int, b: Any) -> Any:
    """A sum of six rows of coefficients."""
    low = fma(load(table, place + row), b[1], load(table, place) * b[0])
    low = fma(load(table, place + 3 * row), b[3], fma(load(table, place + 2 * row), b[2], low))
    return fma(load(table, place + 5 * row), b[5], fma(load(table, place + 4 * row), b[4], low))


@njit(**JIT_OPTIONS)
def add_splined(
    f: Floats, time: float, table: Floats, rows: Any, spline: Any, slopes: Any, size: int, shared: Floats
) -> None:
    """The same of weights that are splines in time; ``rows`` as ``spline_at`` gives them."""
    first, row, imaginary = rows
    lr, li = block_of(shared, Shared.WORK), block_of(shared, Shared.WORK + 1)
    zr, zi = block_of(shared, Shared.STRAIN_BAR), block_of(shared, Shared.STRAIN_BAR + 1)
    yr, yi = block_of(shared, Shared.SLOPE_BAR), block_of(shared, Shared.SLOPE_BAR + 1)
    for j in range(0, size, LANES):
        frequency = load(f, j) * -_TWO_PI
        s, c = sincos(frequency * time)
        er, ei = times(load(lr, j), load(li, j), c, s)
        real, other = first + j, first + imaginary + j
        ar, ai = times(_splined(table, real, row, spline), _splined(table, other, row, spline), er, ei)
        dr, di = times(_splined(table, real, row, slopes), _splined(table, other, row, slopes), er, ei)
        store(zr, j, load(zr, j) + ar)
        store(zi, j, load(zi, j) + ai)
        store(yr, j, load(yr, j) + (dr - frequency * ai))
        store(yi, j, load(yi, j) + fma(frequency, ar, di))


@njit(**JIT_OPTIONS)
def add_pair(br: Floats, bi: Floats, q: Any, conjugate: float, size: int, shared: Floats) -> None:
    """Add (mu q)^(*) conj(b) to the bar of the strain: mu q, or, where ``conjugate`` is -1, its complex conjugate.

    ``q``: real and imaginary parts of the weights, whether there are imaginary ones, and mu.
    """
    qr, qi, both, mr, mi = q
    zr, zi = block_of(shared, Shared.STRAIN_BAR), block_of(shared, Shared.STRAIN_BAR + 1)
    for j in range(0, size, LANES):
        real = load(qr, j)
        imaginary = load(qi, j) if both else splat(0.0)
        ur, ui = real * mr - imaginary * mi, (real * mi + imaginary * mr) * conjugate
        ar, ai = load(br, j), load(bi, j)
        store(zr, j, load(zr, j) + fma(ur, ar, ui * ai))
        store(zi, j, load(zi, j) + (ui * ar - ur * ai))


@njit(**JIT_OPTIONS)
def add_mode(plus: float, cr: float, ci: float, size: int, shared: Floats, own: Floats) -> None:
    """Add the mode that was split to the polarisations of its group."""
    for j in range(0, size, LANES):
        hr, hi = load(block_of(shared, Shared.WAVE), j), load(block_of(shared, Shared.WAVE + 1), j)
        pr, pi = block_of(own, Buffer.PLUS), block_of(own, Buffer.PLUS + 1)
        xr, xi = block_of(own, Buffer.CROSS), block_of(own, Buffer.CROSS + 1)
        store(pr, j, fma(hr, plus, load(pr, j)))
        store(pi, j, fma(hi, plus, load(pi, j)))
        store(xr, j, fma(hr, cr, fma(hi, -ci, load(xr, j))))
        store(xi, j, fma(hr, ci, fma(hi, cr, load(xi, j))))


@njit(**JIT_OPTIONS)
def respond(f: Floats, receding: float, sideways: float, moves: int, size: int, shared: Floats, own: Floats) -> None:
    """The strain of a group in a detector, delayed and calibrated, of its polarisations and the patterns."""
    for j in range(0, size, LANES):
        pr, pi = load(block_of(own, Buffer.PLUS), j), load(block_of(own, Buffer.PLUS + 1), j)
        xr, xi = load(block_of(own, Buffer.CROSS), j), load(block_of(own, Buffer.CROSS + 1), j)
        ar, ai = times(load(block_of(own, Buffer.PATTERN), j), load(block_of(own, Buffer.PATTERN + 1), j), pr, pi)
        br, bi = times(load(block_of(own, Buffer.PATTERN + 2), j), load(block_of(own, Buffer.PATTERN + 3), j), xr, xi)
        cosine, sine = splat(1.0), splat(0.0)
        if moves == 1:
            c, s = load(block_of(own, Buffer.COSINE), j), load(block_of(own, Buffer.COSINE + 1), j)
            late = fma(s, sideways, (splat(1.0) - c) * receding)
            sine, cosine = sincos(load(f, j) * -_TWO_PI * late)
        store(block_of(own, Buffer.DELAY), j, cosine)
        store(block_of(own, Buffer.DELAY + 1), j, sine)
        er, ei = times(ar + br, ai + bi, cosine, sine)
        kr, ki = load(block_of(shared, Shared.CALIBRATION), j), load(block_of(shared, Shared.CALIBRATION + 1), j)
        sr, si = times(er, ei, kr, ki)
        store(block_of(own, Buffer.STRAIN), j, sr)
        store(block_of(own, Buffer.STRAIN + 1), j, si)


@njit(**JIT_OPTIONS)
def dot(a: Floats, b: Floats, size: int, lanes: Floats) -> float:
    """Sum of products of as many numbers, in a fixed order; ``lanes`` is room for eight."""
    total = splat(0.0)
    whole = size // LANES * LANES
    for j in range(0, whole, LANES):
        total = fma(load(a, j), load(b, j), total)
    rest = 0.0
    for j in range(whole, size):
        rest += a[j] * b[j]
    return across(total, lanes) + rest
