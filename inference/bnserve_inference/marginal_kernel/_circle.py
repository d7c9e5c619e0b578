"""Source of the compiled integrals: over the orbital phase, where modes of several orders turn by different multiples.

Of a loud signal all but a few narrow peaks are negligible: cells of the circle are halved again and again where they
may matter, each as far as its last step before the next, so that no more than a few blocks of them are ever kept.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from bnserve_inference.kernel._lanes import larger, root, size_of
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.marginal_kernel._distance import is_normal, over_distances
from bnserve_inference.marginal_kernel._functions import fading, logarithm, nearest_cell
from bnserve_inference.marginal_kernel._layout import CELL, PHASES, ROOM, ROWS_OF_WAITING, STACK, Argument, Prior
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential, sincos
from bnserve_surrogate.kernel._memory import at, floats_at, floats_in, integers_at, load, padded, store
from bnserve_surrogate.kernel._simd import fma, smaller, splat

_STEPS = 8.5
"""Times the root of the largest curvature of ln L: equal steps leave exp(-8.5**2 / 2) of the integral, 2e-16."""
_SPARE_STEPS = 32.0
"""Beside them, for what is hardly curved."""
_MOST_HALVINGS = 24
"""A signal-to-noise ratio of a hundred million."""
_LOST = 1e13
"""ln L of this size is rounded to 2e-3, and of more to what no step of the phase changes: nothing to divide."""
_LEAST_NORM = 1e-9
"""Of the largest <h|h>: bounds of what is positive are no smaller."""
_TINY = 2.2250738585072014e-308
_CLIMB = 0.25
"""Of the width in which the highest place is looked for, from step to step."""

# Rows of a block of phases.
_PHASE, _COS, _SIN, _X, _N, _MIDDLE, _WIDTH, _OWN, _UPPER = range(9)
_ROWS_OF_BLOCK = 9
# Rows of what waits for its integral over the distance; the last has as many as a cell of the prior's table.
_W_X, _MIDDLE_, _WIDTH_, _W_COS, _W_SIN, _SHARE, _FACTOR, _FIRSTS, _SQUARES, _EXPONENT, _CELL, _TABLE = range(12)
_LN_2 = 0.6931471805599453
# Of a row of the batch, ``terms`` are eight arrays by the multiple of the phase: real and imaginary parts of both
# series, and sums of derivatives by the first and by the second, with cosine and sine.


@njit(inline="always")
def _largest(x: Any, n: Any, least: float, most: float) -> Any:
    """ln L at the best of the distances, the prior aside."""
    u = smaller(larger(x / n, least), most)
    return u * (x - 0.5 * u * n)


@njit(**JIT_OPTIONS)
def _at_phases(
    block: Floats, terms: Floats, orders: int, half: float, bends: tuple[float, float, float], least: float, most: float
) -> None:
    """Re <d|h> and <h|h> at a block of phases, ln L at the best of the distances, and a bound of it within ``half`` of
    the phases; ``bends``, of the second derivatives of both, and of <h|h> itself."""
    s, c = sincos(load(block, _PHASE * LANES))
    store(block, _COS * LANES, c)
    store(block, _SIN * LANES, s)
    real, imaginary, zero = splat(1.0), splat(0.0), splat(0.0)
    x, n, dx, dn = zero, zero, zero, zero
    for m in range(orders):
        xr, xi, nr, ni = at(terms, m), at(terms, orders + m), at(terms, 2 * orders + m), at(terms, 3 * orders + m)
        x = fma(real, xr, fma(imaginary, -xi, x))
        n = fma(real, nr, fma(imaginary, -ni, n))
        dx = fma(real, m * xi, fma(imaginary, m * xr, dx))
        dn = fma(real, m * ni, fma(imaginary, m * nr, dn))
        turned = fma(real, c, 0.0 - imaginary * s)
        imaginary = fma(real, s, imaginary * c)
        real = turned
    floor = _LEAST_NORM * bends[2] + _TINY
    n = larger(n, floor)
    store(block, _X * LANES, x)
    store(block, _N * LANES, n)
    store(block, _MIDDLE * LANES, x / n)
    store(block, _WIDTH * LANES, 1.0 / root(n))
    store(block, _OWN * LANES, _largest(x, n, least, most))
    high = fma(size_of(dx), half, x) + 0.5 * half * half * bends[0]
    low = larger(fma(size_of(dn), -half, n) - 0.5 * half * half * bends[1], floor)
    store(block, _UPPER * LANES, _largest(high, low, least, most))


@njit(**JIT_OPTIONS)
def _together(waiting: Floats, count: int, arguments: Integers, prior: Floats) -> None:
    """The integrals over the distance of those that wait, all of them narrow normal distributions."""
    rule, cells = floats_at(arguments[Argument.NARROW_RULE], 2 * LANES), arguments[Argument.TABLE_CELLS]
    table = floats_at(arguments[Argument.TABLE], CELL * cells)
    first, scale, power = prior[Prior.FIRST], 1.0 / prior[Prior.PER_CELL], prior[Prior.POWER]
    for j in range(count):
        if cells > 0:
            place = (-logarithm(waiting[_MIDDLE_ * PHASES + j]) - first) * scale
            cell = nearest_cell(place, cells)
            waiting[_CELL * PHASES + j] = cell
            for k in range(CELL):
                waiting[(_TABLE + k) * PHASES + j] = table[CELL * cell + k]
    for j in range(0, count, LANES):
        middle, width = load(waiting, _MIDDLE_ * PHASES + j), load(waiting, _WIDTH_ * PHASES + j)
        cell, p0, p1 = (
            load(waiting, _CELL * PHASES + j), load(waiting, _TABLE * PHASES + j),
            load(waiting, (_TABLE + 1) * PHASES + j),
        )  # fmt: skip
        p2, p3 = load(waiting, (_TABLE + 2) * PHASES + j), load(waiting, (_TABLE + 3) * PHASES + j)
        right, left = load(waiting, (_TABLE + 4) * PHASES + j), load(waiting, (_TABLE + 5) * PHASES + j)
        factor, firsts, squares, top = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
        for node in range(LANES):
            u = fma(width, at(rule, node), middle)
            ln_u = logarithm(u)
            beside = power * ln_u
            if cells > 0:
                b = fma(0.0 - ln_u - first, scale, 0.0 - cell)
                beyond, before = larger(b - 1.0, 0.0), larger(0.0 - b, 0.0)
                beside = beside + fma(fma(fma(p3, b, p2), b, p1), b, p0)
                beside = fma(right * beyond, beyond * beyond, fma(left * before, before * before, beside))
            if node == 0:
                top = beside
            share = at(rule, LANES + node) * exponential(beside - top)
            factor = factor + share
            firsts = fma(share, u, firsts)
            squares = fma(share * u, u, squares)
        store(waiting, _EXPONENT * PHASES + j, 0.5 * load(waiting, _W_X * PHASES + j) * middle + top)
        store(waiting, _FACTOR * PHASES + j, width * factor)
        store(waiting, _FIRSTS * PHASES + j, width * firsts)
        store(waiting, _SQUARES * PHASES + j, width * squares)


@njit(**JIT_OPTIONS)
def _add(waiting: Floats, count: int, orders: int, terms: Floats, differentiated: bool, so_far: Floats) -> None:
    """Add integrals over the distance to that over the phase: ``so_far``, its exponent and its factor."""
    exponent, factor = floats_in(waiting, _EXPONENT * PHASES, count), floats_in(waiting, _FACTOR * PHASES, count)
    share = floats_in(waiting, _SHARE * PHASES, count)
    top = so_far[0]
    for j in range(count):
        top = exponent[j] if exponent[j] > top else top
    if top > so_far[0]:
        scale = fading(so_far[0] - top)
        so_far[0] = top
        so_far[1] *= scale
        if differentiated:
            for k in range(4 * orders, 8 * orders):
                terms[k] *= scale
    for j in range(count):
        share[j] = fading(exponent[j] - top)
    total = 0.0
    for j in range(count):
        total += share[j] * factor[j]
    so_far[1] += total
    if differentiated:
        c, s = floats_in(waiting, _W_COS * PHASES, count), floats_in(waiting, _W_SIN * PHASES, count)
        firsts, squares = floats_in(waiting, _FIRSTS * PHASES, count), floats_in(waiting, _SQUARES * PHASES, count)
        for j in range(count):
            real, imaginary = 1.0, 0.0
            for m in range(orders):
                terms[4 * orders + m] += share[j] * firsts[j] * real
                terms[5 * orders + m] += share[j] * firsts[j] * imaginary
                terms[6 * orders + m] += share[j] * squares[j] * real
                terms[7 * orders + m] += share[j] * squares[j] * imaginary
                real, imaginary = real * c[j] - imaginary * s[j], real * s[j] + imaginary * c[j]


@njit(**JIT_OPTIONS)
def _survey(
    block: Floats, terms: Floats, orders: int, cells: int, bends: tuple[float, float, float],
    sizes: float, prior: Floats,
) -> tuple[float, int, int]:  # fmt: skip
    """The highest ln L that is seen from ``cells`` places, the cells that the circle is divided into, and how often
    they are halved."""
    least, most, depth = prior[Prior.LEAST], prior[Prior.MOST], prior[Prior.DEPTH]
    best, where, x, n, half = -np.inf, 0.0, 0.0, 1.0, np.pi / cells
    for first in range(0, cells, LANES):
        for j in range(LANES):
            block[j] = (2 * (first + j) + 1) * half
        _at_phases(block, terms, orders, half, bends, least, most)
        for j in range(LANES):
            if block[_OWN * LANES + j] > best:
                best, where = block[_OWN * LANES + j], block[j]
                x, n = block[_X * LANES + j], block[_N * LANES + j]
    u = 1.1 * (min(max(x / n, least), most) + root(2.0 * depth / n))  # the tenth: between places it may be larger
    u = u if u < most else most
    steps = _STEPS * root(u * (bends[0] + 0.5 * u * bends[1])) + _SPARE_STEPS
    halvings = 0
    if u * (sizes + u * bends[2]) < _LOST:
        while steps >= 2.0 * cells and halvings < _MOST_HALVINGS:
            steps *= 0.5
            halvings += 1
    if cells < steps < 2.0 * cells:
        cells = LANES * int(np.ceil(steps / LANES))
    width = 2.0 * half
    finest = np.pi / cells
    for _ in range(halvings):
        finest *= 0.5
    while width > finest:
        for j in range(LANES):
            block[j] = where + width * ((2 * j + 1) / LANES - 1.0)
        _at_phases(block, terms, orders, 0.0, bends, least, most)
        for j in range(LANES):
            if block[_OWN * LANES + j] > best:
                best, where = block[_OWN * LANES + j], block[j]
        width *= _CLIMB
    return best, cells, halvings


@njit(**JIT_OPTIONS)
def _finish(
    waiting: Floats, count: int, together: bool, orders: int, terms: Floats, arguments: Integers, prior: Floats,
    so_far: Floats,
) -> None:  # fmt: skip
    """Add those that wait, filled up to whole lanes with what counts nothing, to the integral over the phase."""
    if count == 0:
        return
    whole = padded(count)
    for row in range(ROWS_OF_WAITING):
        for j in range(count, whole):
            waiting[row * PHASES + j] = waiting[row * PHASES + count - 1]
    if together:
        _together(waiting, whole, arguments, prior)
    for row in (_FACTOR, _FIRSTS, _SQUARES):
        for j in range(count, whole):
            waiting[row * PHASES + j] = 0.0
    _add(waiting, whole, orders, terms, arguments[Argument.BY_PRODUCTS] != 0, so_far)


@njit(**JIT_OPTIONS)
def _halved(block: Floats, limit: float, count: int, stack: Floats, waiting: int) -> int:
    """Put the halves of the cells of a block that may matter on the stack, the first on top; how many wait there now.

    The block of the stack that these are of has been taken off, and is overwritten.
    """
    places = floats_in(stack, (STACK - 1) * (LANES + 2), LANES)  # a copy
    place = floats_in(stack, waiting * (LANES + 2), LANES + 2)
    level = place[LANES + 1] + 1.0
    kept = 0
    for j in range(count):
        if block[_UPPER * LANES + j] >= limit:
            places[kept] = 2.0 * place[j]
            kept += 1
    for first in (LANES // 2, 0):
        size = min(kept - first, LANES // 2)
        if size > 0:
            place = floats_in(stack, waiting * (LANES + 2), LANES + 2)
            for j in range(LANES):
                place[j] = places[first + min(j // 2, size - 1)] + j % 2
            place[LANES] = 2.0 * size
            place[LANES + 1] = level
            waiting += 1
    return waiting


@njit(**JIT_OPTIONS)
def _integrate(
    terms: Floats, orders: int, bends: tuple[float, float, float], sizes: float, arguments: Integers, prior: Floats,
    scratch: Floats,
) -> tuple[float, float]:  # fmt: skip
    """ln of the mean over the circle, and the factor of the sums of derivatives, which are left in ``terms``."""
    block, so_far = floats_in(scratch, 0, _ROWS_OF_BLOCK * LANES), floats_in(scratch, _ROWS_OF_BLOCK * LANES, LANES)
    first, size = (_ROWS_OF_BLOCK + 1) * LANES + ROOM, ROWS_OF_WAITING * PHASES
    room = floats_in(scratch, first - ROOM, ROOM)
    normal, other = floats_in(scratch, first, size), floats_in(scratch, first + size, size)
    stack = floats_in(scratch, first + 2 * size, (LANES + 2) * STACK)
    least, most, depth = prior[Prior.LEAST], prior[Prior.MOST], prior[Prior.DEPTH]
    has_distance = arguments[Argument.HAS_DISTANCE] == 1
    best, cells, halvings = _survey(block, terms, orders, arguments[Argument.CELLS], bends, sizes, prior)
    so_far[0] = -np.inf
    so_far[1] = 0.0
    normals, others = 0, 0
    for first in range(0, cells, LANES):
        for j in range(LANES):
            stack[j] = first + j
        stack[LANES] = LANES
        stack[LANES + 1] = 0.0
        waiting = 1
        while waiting > 0:
            waiting -= 1
            place = floats_in(stack, waiting * (LANES + 2), LANES + 2)
            count, level = int(place[LANES]), int(place[LANES + 1])
            half = np.pi / cells
            for _ in range(level):
                half *= 0.5
            for j in range(LANES):
                block[j] = (2.0 * place[j] + 1.0) * half
            _at_phases(block, terms, orders, half, bends, least, most)
            for j in range(count):
                own = block[_OWN * LANES + j]
                best = own if own > best else best
            if level < halvings:
                waiting = _halved(block, best - depth, count, stack, waiting)
                continue
            for j in range(count):
                if block[_OWN * LANES + j] >= best - depth:
                    x, n = block[_X * LANES + j], block[_N * LANES + j]
                    middle, width = block[_MIDDLE * LANES + j], block[_WIDTH * LANES + j]
                    c, s = block[_COS * LANES + j], block[_SIN * LANES + j]
                    if has_distance and is_normal(middle, width, prior[Prior.NARROW], prior):
                        normal[_W_X * PHASES + normals] = x
                        normal[_MIDDLE_ * PHASES + normals] = middle
                        normal[_WIDTH_ * PHASES + normals] = width
                        normal[_W_COS * PHASES + normals] = c
                        normal[_W_SIN * PHASES + normals] = s
                        normals += 1
                    else:
                        found = over_distances(x, n, arguments, prior, room)
                        other[_EXPONENT * PHASES + others] = found[0]
                        other[_FACTOR * PHASES + others] = found[1]
                        other[_FIRSTS * PHASES + others] = found[2]
                        other[_SQUARES * PHASES + others] = found[3]
                        other[_W_COS * PHASES + others] = c
                        other[_W_SIN * PHASES + others] = s
                        others += 1
                    if normals == PHASES:
                        _finish(normal, normals, True, orders, terms, arguments, prior, so_far)
                        normals = 0
                    if others == PHASES:
                        _finish(other, others, False, orders, terms, arguments, prior, so_far)
                        others = 0
    _finish(normal, normals, True, orders, terms, arguments, prior, so_far)
    _finish(other, others, False, orders, terms, arguments, prior, so_far)
    if not so_far[1] > 0.0:
        return np.nan, 1.0
    return so_far[0] + (logarithm(so_far[1] / cells) - halvings * _LN_2), so_far[1]


@njit(**JIT_OPTIONS)
def over_circle(row: int, arguments: Integers, prior: Floats, scratch: Floats) -> None:
    """The integral of a row of the batch, and what it changes by with products and norms where that is asked for."""
    rows, groups, series = arguments[Argument.ROWS], arguments[Argument.GROUPS], arguments[Argument.TERMS]
    products = floats_at(arguments[Argument.PRODUCTS], 2 * groups * rows)
    norms = floats_at(arguments[Argument.NORMS], 2 * series * rows)
    by_order, by_difference = (
        integers_at(arguments[Argument.ORDERS], groups), integers_at(arguments[Argument.DIFFERENCES], series),
    )  # fmt: skip
    orders = 1 + max(by_order[groups - 1], by_difference[series - 1])
    terms = floats_in(scratch, 0, 8 * orders)
    for k in range(8 * orders):
        terms[k] = 0.0
    bend_x, bend_n, size_x, size_n = 0.0, 0.0, 0.0, 0.0
    for g in range(groups):
        m, a, b = by_order[g], products[2 * (g * rows + row)], products[2 * (g * rows + row) + 1]
        terms[m], terms[orders + m], size = a, b, root(a * a + b * b)
        bend_x += m * m * size
        size_x += size
    for g in range(series):
        m, a, b = by_difference[g], norms[2 * (g * rows + row)], norms[2 * (g * rows + row) + 1]
        terms[2 * orders + m], terms[3 * orders + m], size = a, b, root(a * a + b * b)
        bend_n += m * m * size
        size_n += size
    values = floats_at(arguments[Argument.VALUES], rows)
    value, factor = np.nan, 1.0
    if size_x + size_n < np.inf:
        bends, rest = (bend_x, bend_n, size_n), floats_in(scratch, 8 * orders, 1)
        value, factor = _integrate(terms, orders, bends, size_x, arguments, prior, rest)
    values[row] = value - prior[Prior.LOG_NORM]
    if arguments[Argument.BY_PRODUCTS] == 0:
        return
    by_products = floats_at(arguments[Argument.BY_PRODUCTS], 2 * groups * rows)
    by_norms = floats_at(arguments[Argument.BY_NORMS], 2 * series * rows)
    scale = 1.0 / factor if value == value else np.nan
    for g in range(groups):
        by_products[2 * (g * rows + row)] = scale * terms[4 * orders + by_order[g]]
        by_products[2 * (g * rows + row) + 1] = scale * terms[5 * orders + by_order[g]]
    for g in range(series):
        by_norms[2 * (g * rows + row)] = -0.5 * scale * terms[6 * orders + by_difference[g]]
        by_norms[2 * (g * rows + row) + 1] = -0.5 * scale * terms[7 * orders + by_difference[g]]
