"""Source of the compiled integrals: over the distance, of one row at one phase, or with Bessel's function.

With u = reference / distance, the likelihood is exp(x u - n u^2 / 2), or I0(x u) exp(-n u^2 / 2), times a power of u
and what a table says. Integrals are given as an exponent and a factor, so that they can be summed without a logarithm.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from bnserve_inference.kernel._lanes import larger, root
from bnserve_inference.kernel._sums import Floats, Integers, lane_sum
from bnserve_inference.marginal_kernel._functions import fading, logarithm, nearest_cell
from bnserve_inference.marginal_kernel._layout import CELL, MOST_NODES, Argument, Phase, Prior
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential
from bnserve_surrogate.kernel._memory import at, floats_at, floats_in, load, store
from bnserve_surrogate.kernel._simd import fma, smaller, splat

_LN_PIECE = 3.4657359027997265
"""ln 32, of the ends' ratio of a piece: the nodes follow the power of u, which has a pole at zero, to rounding."""
_NARROW = 1.5
"""Ratio of the ends of what matters, below which it is a normal distribution, or a part of one, to a rule."""
_FLAT = 1e-6
"""A norm at the nearest distance below which the likelihood does not fall with u."""
_LARGE = 8.0
"""From which on Bessel's function has its series in 1 / x."""
_FRACTIONS = 32
"""Of the continued fraction of I1 / I0 below that: the last is smaller than rounding."""


@njit(**JIT_OPTIONS)
def _add_table(u: Floats, prior: Floats, table: Floats, cells: int, out: Floats) -> None:
    """The cubic spline of the prior's table."""
    first, scale = prior[Prior.FIRST], 1.0 / prior[Prior.PER_CELL]
    for j in range(u.shape[0]):
        place = (-logarithm(u[j]) - first) * scale
        cell = nearest_cell(place, cells)
        b, p = place - cell, CELL * cell
        out[j] += table[p] + b * (table[p + 1] + b * (table[p + 2] + b * table[p + 3]))


@njit(inline="always")
def _large_bessel(x: Any, series: Floats) -> Any:
    """ln I0(x) - x, where x is at least 8; by Clenshaw's recurrence."""
    large = larger(x, _LARGE)
    t = 2.0 * _LARGE / large - 1.0
    one, two = splat(0.0), splat(0.0)
    for k in range(series.shape[0] - 1, 0, -1):
        one, two = fma(2.0 * t, one, at(series, k) - two), one
    scaled = fma(t, one, at(series, 0) - two)
    return 0.5 * logarithm(scaled * scaled / large)


@njit(inline="always")
def _small_bessel(x: Any, series: Floats) -> Any:
    """ln I0(x) - x, where x is at most 8."""
    small = smaller(x, _LARGE)
    square, found = 0.25 * small * small, splat(0.0)
    for k in range(series.shape[0] - 1, -1, -1):
        found = fma(square, found, at(series, k))
    return logarithm(found) - small


@njit(**JIT_OPTIONS)
def add_bessel(x: Floats, arguments: Integers, room: Floats, out: Floats) -> None:
    """ln I0(x) - x, of whole lanes; what a lane gives does not depend on the others."""
    large, few = arguments[Argument.LARGE_COUNT], arguments[Argument.SMALL_COUNT]
    series, small = floats_at(arguments[Argument.LARGE_BESSEL], large), floats_at(arguments[Argument.SMALL_BESSEL], few)
    for first in range(0, x.shape[0], LANES):
        given = load(x, first)
        store(room, 0, _large_bessel(given, series))
        least = x[first]
        for j in range(first, first + LANES):
            least = x[j] if x[j] < least else least
        if least < _LARGE:
            store(room, LANES, _small_bessel(given, small))
        for j in range(LANES):
            out[first + j] += room[j] if x[first + j] >= _LARGE else room[LANES + j]


@njit(**JIT_OPTIONS)
def to_ratios(x: Floats, u: Floats, arguments: Integers) -> None:
    """u times I1(x) / I0(x), in the place of u."""
    count = arguments[Argument.LARGE_COUNT]
    series = floats_at(arguments[Argument.LARGE_BESSEL], count)
    for j in range(x.shape[0]):
        if x[j] > _LARGE:
            t = 2.0 * _LARGE / x[j] - 1.0
            one, two, slope_one, slope_two = 0.0, 0.0, 0.0, 0.0
            for k in range(count - 1, 0, -1):
                slope = 2.0 * one + 2.0 * t * slope_one - slope_two
                slope_one, slope_two = slope, slope_one
                one, two = series[k] + 2.0 * t * one - two, one
            slope = one + t * slope_one - slope_two
            scaled = series[0] + t * one - two
            u[j] *= 1.0 - 0.5 / x[j] - 2.0 * _LARGE / (x[j] * x[j]) * slope / scaled
        else:
            ratio = 0.0
            for k in range(_FRACTIONS, 0, -1):
                ratio = x[j] / (2.0 * k + x[j] * ratio)
            u[j] *= ratio


@njit(**JIT_OPTIONS)
def _by_rule(
    x: float, n: float, middle: float, half: float, normal: bool, rule: Floats, size: int, arguments: Integers,
    prior: Floats, room: Floats,
) -> tuple[float, float, float, float]:  # fmt: skip
    """Exponent, factor, and the same factor of u, and of u^2, of the integral by a rule around ``middle``.

    Of a ``normal`` distribution, the rule's weights have it already.
    """
    u, e = floats_in(room, 0, size), floats_in(room, MOST_NODES, size)
    for j in range(size):
        u[j] = middle + half * rule[j]
    for j in range(size):
        e[j] = prior[Prior.POWER] * logarithm(u[j])
    cells = arguments[Argument.TABLE_CELLS]
    if cells > 0:
        _add_table(u, prior, floats_at(arguments[Argument.TABLE], CELL * cells), cells, e)
    bessel = arguments[Argument.PHASE] == Phase.BESSEL
    amplitude = floats_in(room, 2 * MOST_NODES, size)
    if bessel:
        for j in range(size):
            amplitude[j] = x * u[j]
        add_bessel(amplitude, arguments, floats_in(room, 3 * MOST_NODES, 2 * LANES), e)
    base = 0.5 * x * middle
    if not normal:
        base = 0.0
        for j in range(size):
            e[j] += u[j] * (x - 0.5 * n * u[j])
    top = e[0]
    for j in range(size):
        top = e[j] if e[j] > top else top
    for j in range(size):
        e[j] = rule[size + j] * fading(e[j] - top)
    factor = half * lane_sum(e)
    if arguments[Argument.BY_PRODUCTS] == 0:
        return base + top, factor, 0.0, 0.0
    squares = 0.0
    for j in range(size):
        squares += e[j] * u[j] * u[j]
    if bessel:
        to_ratios(amplitude, u, arguments)
    firsts = 0.0
    for j in range(size):
        firsts += e[j] * u[j]
    return base + top, factor, half * firsts, half * squares


@njit(inline="always")
def is_normal(middle: float, width: float, relative: float, prior: Floats) -> bool:
    """Whether all that matters is a normal distribution of less than this ``relative`` width, inside of the prior."""
    reach = root(2.0 * prior[Prior.DEPTH]) * width
    inside = middle - reach > prior[Prior.LEAST] and middle + reach < prior[Prior.MOST]
    return inside and width < relative * middle


@njit(**JIT_OPTIONS)
def over_distances(
    x: float, n: float, arguments: Integers, prior: Floats, room: Floats
) -> tuple[float, float, float, float]:
    """Exponent and factor of the integral at one phase, or over all with Bessel's function where there are distances to
    integrate over; and its factors of u and u^2."""
    if arguments[Argument.HAS_DISTANCE] == 0:
        return x - 0.5 * n, 1.0, 1.0, 1.0
    if x > 0.0 and n > 0.0:
        middle, width = x / n, 1.0 / root(n)
        if is_normal(middle, width, prior[Prior.NARROW], prior):
            rule = floats_at(arguments[Argument.NARROW_RULE], 2 * LANES)
            return _by_rule(x, n, middle, width, True, rule, LANES, arguments, prior, room)
        if is_normal(middle, width, prior[Prior.WIDE], prior):
            rule = floats_at(arguments[Argument.WIDE_RULE], 4 * LANES)
            return _by_rule(x, n, middle, width, True, rule, 2 * LANES, arguments, prior, room)
    least, most = prior[Prior.LEAST], prior[Prior.MOST]
    flat = _FLAT / (most * most)
    norm = n if n > flat else flat
    peak = x / norm
    nearest = min(max(peak, least), most)
    reach = root((nearest - peak) * (nearest - peak) + 2.0 * prior[Prior.DEPTH] / norm)
    start, stop = max(least, peak - reach), min(most, peak + reach)
    if stop < _NARROW * start:
        size = arguments[Argument.PART_NODES]
        rule, half = floats_at(arguments[Argument.PART_RULE], 2 * size), 0.5 * (stop - start)
        return _by_rule(x, n, start + half, half, False, rule, size, arguments, prior, room)
    rule = floats_at(arguments[Argument.GAUSS_RULE], 2 * MOST_NODES)
    width, pieces = logarithm(stop / start), 1
    while pieces * _LN_PIECE < width:
        pieces += 1
    growth, low = exponential(width / pieces), start
    top, factor, firsts, squares = 0.0, 0.0, 0.0, 0.0
    for piece in range(pieces):
        high = stop if piece == pieces - 1 else low * growth
        half = 0.5 * (high - low)
        found = _by_rule(x, n, low + half, half, False, rule, MOST_NODES, arguments, prior, room)
        if piece == 0 or found[0] > top:
            scale = 0.0 if piece == 0 else fading(top - found[0])
            top, factor, firsts, squares = found[0], scale * factor, scale * firsts, scale * squares
        scale = fading(found[0] - top)
        factor += scale * found[1]
        firsts += scale * found[2]
        squares += scale * found[3]
        low = high
    return top, factor, firsts, squares
