"""Source of the compiled contraction: when the modes of a row pass the nodes.

In the stationary-phase approximation that is -1 / (2 pi) times the derivative of a mode's phase with respect to the
frequency. Bins know it for the waveform that they are made around; the ratio of a row's modes to that turns slowly,
and its turns from node to node say the rest.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from bnserve_inference.kernel._lanes import root, times
from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.moving_kernel._layout import Argument
from bnserve_surrogate.adjoint._sums import load_complex
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_at, floats_in, integers_at, load, padded, store
from bnserve_surrogate.kernel._simd import fma, splat

_LEAST = 1e-300
"""Added to a denominator: nothing turns where there is no strain."""


@njit(inline="always")
def _half_angle(real: Any, imaginary: Any) -> Any:
    """Half of the angle of a complex number, within pi / 2, to 1e-7 of it."""
    tangent = imaginary / (root(real * real + imaginary * imaginary) + real + _LEAST)
    x = tangent / (1.0 + root(1.0 + tangent * tangent))
    z = x * x  # at most one: Abramowitz and Stegun 4.4.49
    series = 0.1065626393 + z * (-0.0752896400 + z * (0.0429096138 + z * (-0.0161657367 + z * 0.0028662257)))
    series = 1.0 + z * (-0.3333314528 + z * (0.1999355085 + z * (-0.1420889944 + z * series)))
    return 2.0 * x * series


@njit(**JIT_OPTIONS)
def _turns(
    wave: Floats, points: int, group: int, group_of: Integers, cosines: Floats, sines: Floats, real: Floats,
    turns: Floats,
) -> None:  # fmt: skip
    """Radians by which the ratio of a group's modes to the reference turns from each node to the next.

    The squares of what turns are summed, so that louder modes count more, and an amplitude that changes sign is no
    turn. ``real`` is room for real parts.
    """
    size = cosines.shape[0]
    for j in range(0, size, LANES):
        store(real, j, splat(0.0))
        store(turns, j, splat(0.0))
    steps = points - 1
    whole = steps // LANES * LANES
    for a in range(group_of.shape[0]):
        if group_of[a] == group:
            strain = floats_in(wave, 2 * a * points, 2 * points)
            for j in range(0, whole, LANES):
                c0, s0, c1, s1 = load(cosines, j), load(sines, j), load(cosines, j + 1), load(sines, j + 1)
                zr, zi = _step(load_complex(strain, j + 1), load_complex(strain, j), c0, s0, c1, s1)
                store(real, j, fma(zr, zr, fma(0.0 - zi, zi, load(real, j))))
                store(turns, j, fma(2.0 * zr, zi, load(turns, j)))
            for j in range(whole, steps):
                to, here = (at(strain, 2 * j + 2), at(strain, 2 * j + 3)), (at(strain, 2 * j), at(strain, 2 * j + 1))
                zr, zi = _step(to, here, cosines[j], sines[j], cosines[j + 1], sines[j + 1])
                real[j] += zr * zr - zi * zi
                turns[j] += 2.0 * zr * zi
    for j in range(0, size, LANES):
        store(turns, j, _half_angle(load(real, j), load(turns, j)))


@njit(inline="always")
def _step(to: Any, here: Any, c0: Any, s0: Any, c1: Any, s1: Any) -> Any:
    """By how much strain turns from ``here`` ``to`` the next node, beside the reference: a product of both."""
    pr, pi = times(to[0], to[1], here[0], 0.0 - here[1])
    c, s = times(c0, s0, c1, 0.0 - s1)
    return times(pr, pi, c, s)


@njit(**JIT_OPTIONS)
def find_passing(row: int, arguments: Integers) -> Any:
    """The times at which the groups of a row pass the nodes, ``(G, padded J)``: those given, or found here."""
    groups, points, modes = arguments[Common.GROUPS], arguments[Common.POINTS], arguments[Common.MODES]
    width, stride = padded(points), arguments[Argument.PASSING_STRIDE]
    passing = floats_at(arguments[Argument.PASSING] + 8 * stride * row, (groups + 1) * width)
    if stride > 0:
        return passing
    wave = floats_at(arguments[Common.STRAIN] + 16 * modes * points * row, 2 * modes * points)
    group_of = integers_at(arguments[Common.GROUP_OF], modes)
    reference = floats_at(arguments[Argument.REFERENCE], 2 * groups * width)
    reference_times = floats_at(arguments[Argument.REFERENCE_TIMES], groups * width)
    slopes = floats_at(arguments[Argument.SLOPES], 2 * width)
    before, after = floats_in(slopes, 0, width), floats_in(slopes, width, width)
    for g in range(groups):
        found, turns = floats_in(passing, g * width, width), floats_in(passing, groups * width, width)
        own = floats_in(reference_times, g * width, width)
        cosines, sines = floats_in(reference, 2 * g * width, width), floats_in(reference, (2 * g + 1) * width, width)
        _turns(wave, points, g, group_of, cosines, sines, found, turns)
        # Nothing turns beyond the last node, where slopes and times are zero; before the first there is no number.
        for j in range(0, width, LANES):
            last = load(turns, j - 1) if j > 0 else splat(0.0)
            turned = fma(load(before, j), last, load(after, j) * load(turns, j))
            store(found, j, load(own, j) - turned)
        for j in range(1, LANES):
            found[j] = own[j] - (before[j] * turns[j - 1] + after[j] * turns[j])
    return passing
