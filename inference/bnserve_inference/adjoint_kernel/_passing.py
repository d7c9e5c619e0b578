"""Source of the compiled adjoint: through the times at which modes pass the nodes, where they are found by comparison.

See :mod:`bnserve_inference.moving_kernel._passing`, whose turns between nodes are halves of angles of sums of squares.
"""

from __future__ import annotations

from numba import njit

from bnserve_inference.adjoint_kernel._layout import Argument
from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.moving_kernel._layout import Argument as Moving
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, padded


@njit(inline="always")
def _step(wave: Floats, first: int, j: int, c: float, s: float) -> tuple[float, float]:
    """What turns of a mode from one node to the next, against the reference, which turns by c + i s back."""
    ar, ai = wave[first + 2 * j + 2], wave[first + 2 * j + 3]
    br, bi = wave[first + 2 * j], wave[first + 2 * j + 1]
    pr, pi = ar * br + ai * bi, ai * br - ar * bi
    return pr * c - pi * s, pr * s + pi * c


@njit(**JIT_OPTIONS)
def _turn_back(
    wave: Floats, points: int, group_of: Integers, g: int, j: int, turn: tuple[float, float, float], waves: Floats
) -> None:
    """Add to the conjugated bars of the strains of a group at two nodes: of ``turn``, its bar, c and s.

    With S the sum of squares of z, the turn changes by Im(sum of z dz / S).
    """
    bar, c, s = turn
    width = padded(points)
    real = imaginary = 0.0
    for a in range(group_of.shape[0]):
        if group_of[a] == g:
            zr, zi = _step(wave, 2 * a * points, j, c, s)
            real += zr * zr - zi * zi
            imaginary += 2.0 * zr * zi
    largest = max(abs(real), abs(imaginary))
    if not largest > 0.0:
        return
    real, imaginary = real / largest, imaginary / largest
    scale = bar / (real * real + imaginary * imaginary) / largest
    for a in range(group_of.shape[0]):
        if group_of[a] == g:
            first = 2 * a * points
            zr, zi = _step(wave, first, j, c, s)
            # b = -i bar z / S, times the reference's turn
            ur, ui = zr * real + zi * imaginary, zi * real - zr * imaginary
            vr, vi = ui * scale, -ur * scale
            wr, wi = vr * c - vi * s, vr * s + vi * c
            at = 2 * (width * a + j)
            hr, hi = wave[first + 2 * j], wave[first + 2 * j + 1]
            nr, ni = wave[first + 2 * j + 2], wave[first + 2 * j + 3]
            waves[at + 2] += wr * hr + wi * hi
            waves[at + 3] -= wi * hr - wr * hi
            waves[at] += wr * nr - wi * ni
            waves[at + 1] += wr * ni + wi * nr


@njit(**JIT_OPTIONS)
def passing_back(row: int, arguments: Integers, waves: Floats) -> None:
    """Add what passing times say of a row's strains to their conjugated bars."""
    groups, points, modes = arguments[Common.GROUPS], arguments[Common.POINTS], arguments[Common.MODES]
    width = padded(points)
    wave = floats_at(arguments[Common.STRAIN] + 16 * modes * points * row, 2 * modes * points)
    group_of = integers_at(arguments[Common.GROUP_OF], modes)
    slopes = floats_at(arguments[Moving.SLOPES], 2 * width)
    before, after = floats_in(slopes, 0, width), floats_in(slopes, width, width)
    for g in range(groups):
        reference = floats_at(arguments[Moving.REFERENCE] + 16 * g * width, 2 * width)
        cosines, sines = floats_in(reference, 0, width), floats_in(reference, width, width)
        bars = floats_at(arguments[Argument.PASSING_BAR] + 8 * (row * groups + g) * width, width)
        for j in range(points - 1):
            c = cosines[j + 1] * cosines[j] + sines[j + 1] * sines[j]
            s = cosines[j + 1] * sines[j] - sines[j + 1] * cosines[j]
            bar = -(before[j + 1] * bars[j + 1] + after[j] * bars[j])
            _turn_back(wave, points, group_of, g, j, (bar, c, s), waves)
