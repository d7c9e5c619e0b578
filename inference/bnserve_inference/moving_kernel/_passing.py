"""Source of the compiled contraction: when the modes of a row pass the nodes.

In the stationary-phase approximation that is -1 / (2 pi) times the derivative of a mode's phase with respect to the
frequency. Bins know it for the waveform that they are made around; the ratio of a row's modes to that turns slowly,
and its turns from node to node say the rest.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import float64, njit
from numba.core import cgutils
from numba.extending import intrinsic

from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.moving_kernel._layout import Argument
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, padded

_LEAST = 1e-300
"""Added to a denominator: nothing turns where there is no strain."""


@intrinsic
def _root(typing_context: Any, x: Any) -> Any:
    """Square root as an instruction, not as the call of a library."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(ir.DoubleType(), [ir.DoubleType()])
        return builder.call(cgutils.get_or_insert_function(builder.module, kind, "llvm.sqrt.f64"), args)

    return float64(float64), codegen


@njit(inline="always")
def _half_angle(real: float, imaginary: float) -> float:
    """Half of the angle of a complex number, within pi / 2, to 1e-7 of it."""
    tangent = imaginary / (_root(real * real + imaginary * imaginary) + real + _LEAST)
    x = tangent / (1.0 + _root(1.0 + tangent * tangent))
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
    for j in range(points):
        real[j] = 0.0
        turns[j] = 0.0
    for a in range(group_of.shape[0]):
        if group_of[a] == group:
            first = 2 * a * points
            for j in range(points - 1):
                c = cosines[j + 1] * cosines[j] + sines[j + 1] * sines[j]
                s = cosines[j + 1] * sines[j] - sines[j + 1] * cosines[j]
                ar, ai = wave[first + 2 * j + 2], wave[first + 2 * j + 3]
                br, bi = wave[first + 2 * j], wave[first + 2 * j + 1]
                pr, pi = ar * br + ai * bi, ai * br - ar * bi
                zr, zi = pr * c - pi * s, pr * s + pi * c
                real[j] += zr * zr - zi * zi
                turns[j] += 2.0 * zr * zi
    for j in range(points - 1):
        turns[j] = _half_angle(real[j], turns[j])
    turns[points - 1] = 0.0


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
    times = floats_at(arguments[Argument.REFERENCE_TIMES], groups * width)
    slopes = floats_at(arguments[Argument.SLOPES], 2 * width)
    before, after = floats_in(slopes, 0, width), floats_in(slopes, width, width)
    for g in range(groups):
        found, turns = floats_in(passing, g * width, width), floats_in(passing, groups * width, width)
        cosines, sines = floats_in(reference, 2 * g * width, width), floats_in(reference, (2 * g + 1) * width, width)
        _turns(wave, points, g, group_of, cosines, sines, found, turns)
        found[0] = times[g * width] - after[0] * turns[0]
        for j in range(1, points):
            found[j] = times[g * width + j] - (before[j] * turns[j - 1] + after[j] * turns[j])
        for j in range(points, width):
            found[j] = 0.0
    return passing
