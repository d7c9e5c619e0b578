"""A carrier, its modes and their sums on a block of frequencies, eight at a time; and writing them.

Loops run over whole vectors, up to seven values beyond the end, which stand in the padding of the buffers.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_in, load, store
from bnserve_surrogate.kernel._points import two_splines
from bnserve_surrogate.kernel._simd import fma, smaller, splat
from bnserve_surrogate.kernel._writing import put

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def turn(count: int, turns: float, amplitude: Floats, phase: Floats) -> None:
    """A exp(i phi turns) in place of A and phi: its real and its imaginary part."""
    for j in range(0, count, LANES):
        sine, cosine = sincos(load(phase, j) * turns)
        a = load(amplitude, j)
        store(amplitude, j, a * cosine)
        store(phase, j, a * sine)


@njit(**JIT_OPTIONS)
def fill_ratio(
    log_f: Floats, start: int, inside: int, places: Integers, shift: float, knots: Floats, ends: Integers,
    cubics: tuple[Floats, Floats], stride: int, edges: tuple[float, float, float, float], real: Floats,
    imaginary: Floats,
) -> None:  # fmt: skip
    """R for the frequencies ``start`` to ``inside``: constant outside its nodes.

    ``places`` are where on the grid the first node lies and the last, and the last cell that was used; ``edges`` R at
    both.
    """
    first, last = min(max(places[0], start), inside), min(max(places[1], start), inside)
    for j in range(0, first - start, LANES):
        store(real, j, splat(edges[0]))
        store(imaginary, j, splat(edges[1]))
    a, b = floats_in(real, first - start, last - start), floats_in(imaginary, first - start, last - start)
    places[2] = two_splines(log_f, first, last, shift, knots, ends, places[2], cubics[0], stride, a, cubics[1], b)
    for j in range(last - start, inside - start, LANES):
        store(real, j, splat(edges[2]))
        store(imaginary, j, splat(edges[3]))


@njit(inline="always")
def _velocity(cbrt_f: Floats, j: int, scale: float, highest: float, power: int) -> Any:
    """v to a power of 1, 2 or 3, no larger than at the end of the band."""
    v = smaller(load(cbrt_f, j) * scale, highest)
    w = v
    for _ in range(1, power):
        w = w * v
    return w


@njit(inline="always")
def _add(j: int, fresh: bool, carrier: Any, plus: Any, cross: Any, sums: Any) -> None:
    """Carrier times ``plus``, and times i ``cross``, into the sums, or, if ``fresh``, in place of them."""
    real, imaginary = carrier
    first, second, third, fourth = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
    if not fresh:
        first, second, third, fourth = load(sums[0], j), load(sums[1], j), load(sums[2], j), load(sums[3], j)
    store(sums[0], j, fma(real, plus[0], fma(imaginary, splat(0.0) - plus[1], first)))
    store(sums[1], j, fma(real, plus[1], fma(imaginary, plus[0], second)))
    store(sums[2], j, fma(real, splat(0.0) - cross[1], fma(imaginary, splat(0.0) - cross[0], third)))
    store(sums[3], j, fma(real, cross[0], fma(imaginary, splat(0.0) - cross[1], fourth)))


@njit(inline="always")
def _turned(j: int, turns: float, amplitude: Floats, phase: Floats) -> tuple[Any, Any]:
    """A exp(i phi turns)."""
    sine, cosine = sincos(load(phase, j) * turns)
    a = load(amplitude, j)
    return a * cosine, a * sine


@njit(**JIT_OPTIONS)
def add_carrier(
    count: int, fresh: bool, turns: float, amplitude: Floats, phase: Floats, factors: tuple[float, float],
    sums: tuple[Floats, Floats, Floats, Floats],
) -> None:  # fmt: skip
    """The (2, 2), which is its carrier, times both factors (plus, and cross over i) into the sums."""
    zero, plus, cross = splat(0.0), splat(factors[0]), splat(factors[1])
    for j in range(0, count, LANES):
        _add(j, fresh, _turned(j, turns, amplitude, phase), (plus, zero), (cross, zero), sums)


@njit(**JIT_OPTIONS)
def add_mode(
    count: int, fresh: bool, turns: float, amplitude: Floats, phase: Floats, own: tuple[float, float],
    ratio: tuple[Floats, Floats], cbrt_f: Floats, velocity: tuple[float, float, int], factors: tuple[float, float],
    sums: tuple[Floats, Floats, Floats, Floats],
) -> None:  # fmt: skip
    """The carrier times its ``own`` factors and those of one mode, times v^p R, into the sums."""
    for j in range(0, count, LANES):
        w = _velocity(cbrt_f, j, velocity[0], velocity[1], velocity[2])
        c, d = load(ratio[0], j) * w, load(ratio[1], j) * w
        plus = (fma(c, factors[0], splat(own[0])), d * factors[0])
        cross = (fma(c, factors[1], splat(own[1])), d * factors[1])
        _add(j, fresh, _turned(j, turns, amplitude, phase), plus, cross, sums)


@njit(**JIT_OPTIONS)
def add_two_modes(
    count: int, fresh: bool, turns: float, amplitude: Floats, phase: Floats,
    ratio: tuple[Floats, Floats], other: tuple[Floats, Floats], cbrt_f: Floats, velocity: tuple[float, float, int],
    powers: tuple[int, int], factors: tuple[float, float], others: tuple[float, float],
    sums: tuple[Floats, Floats, Floats, Floats],
) -> None:  # fmt: skip
    """The carrier times the factors of two modes, times v^p R of each, into the sums."""
    for j in range(0, count, LANES):
        v = _velocity(cbrt_f, j, velocity[0], velocity[1], powers[0])
        w = _velocity(cbrt_f, j, velocity[0], velocity[1], powers[1])
        a, b = load(ratio[0], j) * v, load(ratio[1], j) * v
        c, d = load(other[0], j) * w, load(other[1], j) * w
        plus = (fma(c, others[0], a * factors[0]), fma(d, others[0], b * factors[0]))
        cross = (fma(c, others[1], a * factors[1]), fma(d, others[1], b * factors[1]))
        _add(j, fresh, _turned(j, turns, amplitude, phase), plus, cross, sums)


@njit(**JIT_OPTIONS)
def multiply_mode(
    count: int, real: Floats, imaginary: Floats, ratio: tuple[Floats, Floats], cbrt_f: Floats,
    velocity: tuple[float, float, int],
) -> None:  # fmt: skip
    """Carrier times v^p R, in place of R."""
    for j in range(0, count, LANES):
        w = _velocity(cbrt_f, j, velocity[0], velocity[1], velocity[2])
        a, b = load(real, j) * w, load(imaginary, j) * w
        c, d = load(ratio[0], j), load(ratio[1], j)
        store(ratio[0], j, fma(a, c, splat(0.0) - b * d))
        store(ratio[1], j, fma(a, d, b * c))


@njit(**JIT_OPTIONS)
def write_complex(count: int, real: Floats, imaginary: Floats, streamed: int, out: Any, tail: Any) -> None:
    """Complex numbers, and zeros from ``count`` to the end of ``out``; as :func:`bnserve_surrogate.kernel._writing`."""
    j = 0
    while j < count:
        size = min(count - j, LANES)
        if j < streamed:
            size = min(size, streamed)
        put(out, j, size, streamed, load(real, j), load(imaginary, j), tail)
        j += size
    for i in range(2 * count, out.shape[0]):
        out[i] = 0.0
