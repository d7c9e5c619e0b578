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
def clear(count: int, sums: tuple[Floats, Floats, Floats, Floats]) -> None:
    """Nothing yet, in the real and imaginary parts of both polarisations."""
    for j in range(0, count, LANES):
        store(sums[0], j, splat(0.0))
        store(sums[1], j, splat(0.0))
        store(sums[2], j, splat(0.0))
        store(sums[3], j, splat(0.0))


@njit(inline="always")
def _add(j: int, real: Any, imaginary: Any, factors: tuple[float, float], sums: Any) -> None:
    """Add h times plus and h times i cross."""
    plus, cross = factors
    store(sums[0], j, fma(real, plus, load(sums[0], j)))
    store(sums[1], j, fma(imaginary, plus, load(sums[1], j)))
    store(sums[2], j, fma(imaginary, 0.0 - cross, load(sums[2], j)))
    store(sums[3], j, fma(real, cross, load(sums[3], j)))


@njit(**JIT_OPTIONS)
def add_carrier(
    count: int, real: Floats, imaginary: Floats, factors: tuple[float, float],
    sums: tuple[Floats, Floats, Floats, Floats],
) -> None:  # fmt: skip
    """The (2, 2), which is its carrier, into the sums."""
    for j in range(0, count, LANES):
        _add(j, load(real, j), load(imaginary, j), factors, sums)


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


@njit(**JIT_OPTIONS)
def add_mode(
    count: int, real: Floats, imaginary: Floats, ratio: tuple[Floats, Floats], cbrt_f: Floats,
    velocity: tuple[float, float, int], factors: tuple[float, float], sums: tuple[Floats, Floats, Floats, Floats],
) -> None:  # fmt: skip
    """Carrier times v^p R, into the sums."""
    for j in range(0, count, LANES):
        w = _velocity(cbrt_f, j, velocity[0], velocity[1], velocity[2])
        a, b = load(real, j) * w, load(imaginary, j) * w
        c, d = load(ratio[0], j), load(ratio[1], j)
        _add(j, fma(a, c, splat(0.0) - b * d), fma(a, d, b * c), factors, sums)


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
