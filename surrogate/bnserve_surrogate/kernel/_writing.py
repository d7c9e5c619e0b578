"""From amplitudes and phases to what was asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import CACHE_LINE, LANES, STREAMED, Argument, Output
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import (
    floats_at,
    load,
    rounded_to,
    singles_at,
    singles_in,
    store_complex,
    stream_complex,
)

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def write_block(
    i: int, start: int, inside: int, stop: int, arguments: Integers, amplitude: Floats, phase: Floats,
    factors: tuple[float, float], tail: Floats,
) -> None:  # fmt: skip
    """One block of one row into the outputs: values up to ``inside``, zeros from there to ``stop``."""
    output, first, second = arguments[Argument.OUTPUT], arguments[Argument.FIRST], arguments[Argument.SECOND]
    place = i * arguments[Argument.POINTS] + start
    if output == Output.AMPLITUDE_PHASE:
        a, p = floats_at(first + 8 * place, stop - start), floats_at(second + 8 * place, stop - start)
        for j in range(inside - start):
            a[j] = amplitude[j]
            p[j] = phase[j]
        for j in range(inside - start, stop - start):
            a[j] = 0.0
            p[j] = 0.0
    elif output in (Output.STRAIN_SINGLE, Output.POLARIZATIONS_SINGLE):
        size = 2 * (stop - start)
        h = singles_at(first + 8 * place, size)
        other = singles_at(second + 8 * place, size if output == Output.POLARIZATIONS_SINGLE else 0)
        streamed = streamed_from(arguments, first + 8 * place, second + 8 * place, other.shape[0] > 0, 8)
        to_complex(amplitude, phase, inside - start, factors, streamed, h, other, singles_in(tail, 0, 4 * LANES))
        _zeros(h, other, 2 * (inside - start))
    else:
        size = 2 * (stop - start)
        wide = floats_at(first + 16 * place, size)
        other_wide = floats_at(second + 16 * place, size if output == Output.POLARIZATIONS else 0)
        streamed = streamed_from(arguments, first + 16 * place, second + 16 * place, other_wide.shape[0] > 0, 16)
        to_complex(amplitude, phase, inside - start, factors, streamed, wide, other_wide, tail)
        _zeros(wide, other_wide, 2 * (inside - start))


@njit(inline="always")
def put(out: Any, j: int, count: int, streamed: int, real: Any, imaginary: Any, tail: Any) -> None:
    if count < LANES:
        store_complex(tail, 0, real, imaginary)
        for i in range(2 * count):
            out[2 * j + i] = tail[i]
    elif streamed >= 0:
        stream_complex(out, j, real, imaginary)
    else:
        store_complex(out, j, real, imaginary)


@njit(**JIT_OPTIONS)
def to_complex(
    amplitude: Floats, phase: Floats, stop: int, factors: tuple[float, float], streamed: int, first: Any, second: Any,
    tail: Any,
) -> None:  # fmt: skip
    """A exp(i phi) into ``first``; or, where ``second`` is not empty, times plus and times i cross into the two.

    From place ``streamed`` on whole vectors are written past the caches, unless it is negative.
    """
    plus, cross = rounded_to(first, factors[0]), rounded_to(first, factors[1])
    two = second.shape[0] > 0
    if not two:
        plus = 1.0
    j = 0
    while j < stop:
        count = min(stop - j, LANES)
        if j < streamed:
            count = min(count, streamed)
        sine, cosine = sincos(load(phase, j))
        a = load(amplitude, j)
        real, imaginary = rounded_to(first, a * cosine), rounded_to(first, a * sine)
        put(first, j, count, streamed, real * plus, imaginary * plus, tail)
        if two:
            put(second, j, count, streamed, imaginary * (0.0 - cross), real * cross, tail)
        j += count


@njit(**JIT_OPTIONS)
def streamed_from(arguments: Integers, first: int, second: int, two: bool, size: int) -> int:
    """How many values stand before the first cache line's beginning, or -1 if the caches hold the whole result."""
    small = arguments[Argument.ROWS] * arguments[Argument.POINTS] * size * (2 if two else 1) < STREAMED
    apart = two and (first - second) % CACHE_LINE != 0
    if small or apart or first % size != 0:
        return -1
    return (-first % CACHE_LINE) // size


@njit(**JIT_OPTIONS)
def _zeros(first: Any, second: Any, start: int) -> None:
    for j in range(start, first.shape[0]):
        first[j] = 0.0
    for j in range(start, second.shape[0]):
        second[j] = 0.0
