"""Derivatives of a carrier and of its modes on a block of frequencies, eight at a time.

Loops run over whole vectors, up to seven values beyond the end of a segment, which the next one overwrites or which
stand in the padding of the buffers.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.baseline import FREEZING_END, FREEZING_START
from bnserve_surrogate.kernel._layout import CACHE_LINE, LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import load, padded, store
from bnserve_surrogate.kernel._points import step
from bnserve_surrogate.kernel._simd import fma, splat
from bnserve_surrogate.kernel._writing import put

Floats = NDArray[np.float64]

LINE = CACHE_LINE // 16
"""Complex numbers."""
_WIDTH = FREEZING_END - FREEZING_START


@njit(inline="always")
def _series(u: Any, c: Floats) -> Any:
    """The series of an amplitude in f^(1/3)."""
    high = fma(u, fma(u, fma(u, splat(c[7]), c[6]), c[5]), c[4])
    return fma(u, fma(u, fma(u, fma(u, high, c[3]), c[2]), c[1]), c[0])


@njit(**JIT_OPTIONS)
def fill_shares(
    f: Floats, cbrt_f: Floats, power: Floats, segments: tuple[int, int, int], mass: float, c: Floats, constant: float,
    bare: Floats, frozen: Floats, moving: Floats,
) -> None:  # fmt: skip
    """What derivatives of the series, of the constant and of ln M count in that of the logarithm of an amplitude.

    As :func:`~bnserve_surrogate.kernel._points.amplitudes`: between the first two ``segments`` the series gives way to
    the constant.
    """
    freezing, end, stop = segments
    for j in range(0, freezing, LANES):
        store(bare, j, splat(1.0) / _series(load(cbrt_f, j), c))
        store(frozen, j, splat(0.0))
        store(moving, j, splat(0.0))
    for j in range(freezing, end, LANES):
        scale = load(power, j)
        own = _series(load(cbrt_f, j), c) * scale
        x = fma(load(f, j), mass / _WIDTH, -FREEZING_START / _WIDTH)
        weight, sine = step(x), sincos(x * np.pi)[0]
        share = splat(1.0) / fma(weight, splat(constant) - own, own)
        store(bare, j, (splat(1.0) - weight) * scale * share)
        store(frozen, j, weight * share)
        slope = sine * (load(f, j) * (0.5 * np.pi * mass / _WIDTH))
        store(moving, j, slope * (splat(constant) - own) * share)
    for j in range(end, stop, LANES):
        store(bare, j, splat(0.0))
        store(frozen, j, splat(1.0 / constant))
        store(moving, j, splat(0.0))


@njit(**JIT_OPTIONS)
def add_amplitude_tangent(
    cbrt_f: Floats, frozen_from: int, stop: int, c: Floats, constant: float, moves: float,
    bare: Floats, frozen: Floats, moving: Floats, a: Floats,
) -> None:  # fmt: skip
    """The derivative of the baseline's logarithm, added to that of the residual.

    ``moves`` is what ln M changes with the parameter; from ``frozen_from`` on the series counts nothing. Nothing is
    added twice: the vector in which the series ends is the first loop's.
    """
    whole = padded(frozen_from)
    for j in range(0, whole, LANES):
        own = fma(_series(load(cbrt_f, j), c), load(bare, j), load(a, j))
        store(a, j, fma(load(frozen, j), constant, fma(load(moving, j), moves, own)))
    for j in range(whole, stop, LANES):
        store(a, j, fma(load(frozen, j), constant, load(a, j)))


@njit(**JIT_OPTIONS)
def extend_mass_below(
    f: Floats, count: int, mass: float, mf_min: float, edge: float, slope: float, over_mass: float, a: Floats, p: Floats
) -> None:
    """Below the trained band, of the residuals that :func:`~bnserve_surrogate.kernel._points.extend_below` fills, the
    derivative with respect to the total mass."""
    for j in range(count):
        mf = f[j] * mass
        ratio = 2.0 * mf / mf_min - 1.0
        steep = 0.5 * np.pi * np.sin(np.pi * ratio) if ratio > 0.0 else 0.0
        a[j] = edge * steep * (2.0 * mf / mf_min) * over_mass
        p[j] = slope * mf * over_mass


@njit(**JIT_OPTIONS)
def fill_line(
    f: Floats, first: int, stop: int, mass: float, top: float, a_top: float, p_top: float, slope: float, a: Floats,
    p: Floats,
) -> None:  # fmt: skip
    """Above the (2, 2)'s band: what an amplitude's logarithm has everywhere, and a straight line from the ``top``."""
    for j in range(first, stop, LANES):
        store(a, j, splat(a_top))
        store(p, j, fma(fma(load(f, j), mass, -top), slope, p_top))


@njit(**JIT_OPTIONS)
def split(count: int, h: Floats, real: Floats, imaginary: Floats) -> None:
    """Real and imaginary parts of complex numbers."""
    for j in range(count):
        real[j] = h[2 * j]
        imaginary[j] = h[2 * j + 1]


@njit(**JIT_OPTIONS)
def write_carrier(
    count: int, turns: float, h: tuple[Floats, Floats], a: Floats, p: Floats, out: Floats, streamed: int, tail: Floats
) -> None:
    """h (d ln A + i turns d phi): the derivative of a mode that is its carrier; from place ``streamed`` on past the
    caches, unless it is negative."""
    j = 0
    while j < count:
        size = min(count - j, LANES)
        if j < streamed:
            size = min(size, streamed)
        real, imaginary, along, across = load(h[0], j), load(h[1], j), load(a, j), load(p, j) * turns
        first = fma(real, along, splat(0.0) - imaginary * across)
        put(out, j, size, streamed, first, fma(real, across, imaginary * along), tail)
        j += size


@njit(**JIT_OPTIONS)
def write_mode(
    count: int, turns: float, rising: float, cut: int, h: tuple[Floats, Floats], a: Floats, p: Floats,
    carrier: tuple[Floats, Floats], ratio: tuple[Floats, Floats], out: Floats, streamed: int, tail: Floats,
) -> None:  # fmt: skip
    """The same of another mode, with what its ratio R adds: its carrier times v^p, times the derivative of R.

    ``rising`` is the derivative of ln v^p, up to the frequency number ``cut``, from which on v is constant.
    """
    j = 0
    while j < count:
        size = min(count - j, LANES)
        if j < streamed:
            size = min(size, streamed)
        if j < cut:
            size = min(size, cut - j)
        past = streamed if (j - streamed) % LINE == 0 else -1  # the cut need not be where a line begins
        real, imaginary = load(h[0], j), load(h[1], j)
        along, across = load(a, j) + (rising if j < cut else 0.0), load(p, j) * turns
        c, d, x, y = load(carrier[0], j), load(carrier[1], j), load(ratio[0], j), load(ratio[1], j)
        first = fma(c, x, splat(0.0) - d * y) + fma(real, along, splat(0.0) - imaginary * across)
        second = fma(c, y, d * x) + fma(real, across, imaginary * along)
        put(out, j, size, past, first, second, tail)
        j += size


@njit(**JIT_OPTIONS)
def zeros(first: int, stop: int, out: Floats) -> None:
    """No derivative, where there is no strain."""
    for j in range(2 * first, 2 * stop):
        out[j] = 0.0
