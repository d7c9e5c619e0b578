"""Source of the compiled contraction of several modes: see :mod:`.build`.

As with one mode (:mod:`bnserve_inference.kernel._source`), a row is evaluated by the same sequence of operations
wherever it stands in a batch; eight nodes at a time, no allocation.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from bnserve_inference.kernel._lanes import across, times
from bnserve_inference.kernel._layout import BLOCK, Argument, Sky
from bnserve_inference.kernel._source import _geometry
from bnserve_inference.kernel._sums import Floats, Integers, add_terms, errors_at, spline_at
from bnserve_inference.modes_kernel._layout import GROUP_BLOCKS, SHARED_BLOCKS
from bnserve_surrogate.adjoint._sums import split
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, load, padded, store
from bnserve_surrogate.kernel._simd import fma, from_bits, splat

_COLUMNS = len(Sky)
_TWO_PI = 2.0 * np.pi


@njit(**JIT_OPTIONS)
def _factors(row: int, arguments: Integers, pattern: Floats, factors: Floats) -> None:
    """F+ plus + Fx cross of every mode in every detector, complex."""
    detectors, modes = arguments[Argument.DETECTORS], arguments[Argument.MODES]
    plus = floats_at(arguments[Argument.PLUS] + 8 * modes * row, modes)
    cross = floats_at(arguments[Argument.CROSS] + 16 * modes * row, 2 * modes)
    for d in range(detectors):
        f_plus, f_cross = pattern[3 * d], pattern[3 * d + 1]
        for a in range(modes):
            at = 2 * (d * modes + a)
            factors[at] = f_plus * plus[a] + f_cross * cross[2 * a]
            factors[at + 1] = f_cross * cross[2 * a + 1]


@njit(**JIT_OPTIONS)
def add_mode(cr: float, ci: float, ar: Floats, ai: Floats, hr: Floats, hi: Floats) -> None:
    """Add a mode's strain, times its factor."""
    for j in range(0, hr.shape[0], LANES):
        a, b = load(ar, j), load(ai, j)
        store(hr, j, fma(a, cr, fma(b, -ci, load(hr, j))))
        store(hi, j, fma(b, cr, fma(a, ci, load(hi, j))))


@njit(**JIT_OPTIONS)
def calibrate(amplitude: Floats, phase: Floats, hr: Floats, hi: Floats) -> None:
    """Strain times (1 + dA) (2 + i dphi) / (2 - i dphi), in its place."""
    for j in range(0, hr.shape[0], LANES):
        p = load(phase, j)
        scale = (1.0 + load(amplitude, j)) / fma(p, p, 4.0)
        a, b = times(load(hr, j), load(hi, j), scale * (4.0 - p * p), scale * (4.0 * p))
        store(hr, j, a)
        store(hi, j, b)


@njit(**JIT_OPTIONS)
def _turns(f: Floats, time: float, c: Floats, s: Floats) -> None:
    """exp(-2 pi i f time)."""
    turn = -_TWO_PI * time
    for j in range(0, f.shape[0], LANES):
        sine, cosine = sincos(load(f, j) * turn)
        store(c, j, cosine)
        store(s, j, sine)


@njit(**JIT_OPTIONS)
def _fixed(
    c: Floats, s: Floats, kr: Floats, ki: Floats, wr: Floats, wi: Floats, pr: Floats, pi: Floats
) -> tuple[float, float]:
    """Strain, turned, times weights; and its sum."""
    real, imaginary = splat(0.0), splat(0.0)
    for j in range(0, c.shape[0], LANES):
        a, b = times(load(kr, j), load(ki, j), load(c, j), load(s, j))
        a, b = times(load(wr, j), load(wi, j), a, b)
        store(pr, j, a)
        store(pi, j, b)
        real, imaginary = real + a, imaginary + b
    return across(real), across(imaginary)


@njit(inline="always")
def _six(table: Floats, place: int, row: int, b: Any) -> Any:
    """A sum of six rows of B-spline coefficients."""
    low = fma(load(table, place + row), b[1], load(table, place) * b[0])
    low = fma(load(table, place + 3 * row), b[3], fma(load(table, place + 2 * row), b[2], low))
    return fma(load(table, place + 5 * row), b[5], fma(load(table, place + 4 * row), b[4], low))


@njit(**JIT_OPTIONS)
def _splined(
    c: Floats, s: Floats, kr: Floats, ki: Floats, table: Floats, rows: Any, spline: Any, pr: Floats, pi: Floats
) -> tuple[float, float]:
    """Strain, turned, times weights that are splines in time, ``rows`` as ``spline_at`` gives them; and its sum."""
    first, row, other = rows
    real, imaginary = splat(0.0), splat(0.0)
    for j in range(0, c.shape[0], LANES):
        a, b = times(load(kr, j), load(ki, j), load(c, j), load(s, j))
        a, b = times(_six(table, first + j, row, spline), _six(table, first + other + j, row, spline), a, b)
        store(pr, j, a)
        store(pi, j, b)
        real, imaginary = real + a, imaginary + b
    return across(real), across(imaginary)


@njit(**JIT_OPTIONS)
def _pair(ar: Floats, ai: Floats, br: Floats, bi: Floats, qr: Floats, qi: Floats, shared: int) -> tuple[float, float]:
    """The sum of weights times conj(a) b; weights that are shared are real."""
    real, imaginary = splat(0.0), splat(0.0)
    for j in range(0, ar.shape[0], LANES):
        u, v = times(load(br, j), load(bi, j), load(ar, j), 0.0 - load(ai, j))
        if shared == 1:
            real, imaginary = fma(load(qr, j), u, real), fma(load(qr, j), v, imaginary)
        else:
            p, q = times(load(qr, j), load(qi, j), u, v)
            real, imaginary = real + p, imaginary + q
    return across(real), across(imaginary)


@njit(inline="always")
def _blocks(scratch: Floats, first: int, number: int, size: int) -> Any:
    """Real and imaginary parts of a pair of blocks of the working memory."""
    return floats_in(scratch, first + 2 * number * BLOCK, size), floats_in(
        scratch, first + (2 * number + 1) * BLOCK, size
    )


@njit(**JIT_OPTIONS)
def _gather(row: int, d: int, first: int, size: int, arguments: Integers, factors: Floats, blocks: Floats) -> None:
    """The strain of each group in a detector at a block of nodes, with calibration errors."""
    modes, groups, points = arguments[Argument.MODES], arguments[Argument.GROUPS], arguments[Argument.POINTS]
    wave = floats_at(arguments[Argument.STRAIN] + 16 * modes * points * row, 2 * modes * points)
    group_of = integers_at(arguments[Argument.GROUP_OF], modes)
    for j in range(2 * groups * BLOCK):
        blocks[j] = 0.0
    filled = min(size, points - first)
    for a in range(modes):
        hr, hi = _blocks(blocks, 0, group_of[a], size)
        ar, ai = _blocks(blocks, 0, groups, size)
        split(filled, floats_in(wave, 2 * (a * points + first), 2 * filled), ar, ai)
        at = 2 * (d * modes + a)
        add_mode(factors[at], factors[at + 1], ar, ai, hr, hi)
    nodes = arguments[Argument.CALIBRATION_NODES]
    if nodes > 0:
        place = 8 * nodes * (row * arguments[Argument.DETECTORS] + d)
        width = padded(points)
        splines = floats_at(arguments[Argument.LINEAR_SPLINES], nodes * width)
        amplitude, phase = _blocks(blocks, 0, groups, size)
        errors_at(floats_at(arguments[Argument.AMPLITUDE_ERRORS] + place, nodes), splines, width, first, amplitude)
        errors_at(floats_at(arguments[Argument.PHASE_ERRORS] + place, nodes), splines, width, first, phase)
        for g in range(groups):
            hr, hi = _blocks(blocks, 0, g, size)
            calibrate(amplitude, phase, hr, hi)


@njit(**JIT_OPTIONS)
def _add_products(
    row: int, d: int, first: int, size: int, arguments: Integers, arrival: float, delay: float, blocks: Floats
) -> None:
    """Add a block of nodes of one detector to <d|h> of each group at all times, and to its terms where wanted."""
    groups, points, knots = arguments[Argument.GROUPS], arguments[Argument.POINTS], arguments[Argument.KNOTS]
    count, width = arguments[Argument.TIMES], padded(points)
    f = floats_in(floats_at(arguments[Argument.NODES], width), first, size)
    grid, step = floats_at(arguments[Argument.TIME_GRID], 2), from_bits(arguments[Argument.STEP])
    table_size = 2 * width * knots
    out = floats_at(arguments[Argument.PRODUCTS] + 16 * groups * count * row, 2 * groups * count)
    pr, pi = _blocks(blocks, 0, groups, size)  # where the errors were
    c, s = _blocks(blocks, 0, groups + 1, size)
    for k in range(count):
        time = (arrival + k * step) + delay
        _turns(f, time, c, s)
        for g in range(groups):
            hr, hi = _blocks(blocks, 0, g, size)
            place = d if arguments[Argument.SHARED] == 1 else d * groups + g
            table = floats_at(arguments[Argument.LINEAR_WEIGHTS] + 8 * table_size * place, table_size)
            if knots == 1:
                weights = floats_in(table, first, size), floats_in(table, width + first, size)
                real, imaginary = _fixed(c, s, hr, hi, weights[0], weights[1], pr, pi)
            else:
                rows, spline = spline_at(time, grid, knots, width, first)
                real, imaginary = _splined(c, s, hr, hi, table, rows, spline, pr, pi)
            out[2 * (g * count + k)] += real
            out[2 * (g * count + k) + 1] += imaginary
            if k == count - 1 and arguments[Argument.SPECTRUM] != 0:
                filled = min(size, points - first)
                line = arguments[Argument.SPECTRUM] + 16 * ((row * groups + g) * points + first)
                add_terms(pr, pi, 1.0, 0.0, floats_at(line, 2 * filled))


@njit(**JIT_OPTIONS)
def _add_pairs(row: int, d: int, first: int, size: int, arguments: Integers, blocks: Floats) -> None:
    """Add a block of nodes of one detector to <h|h'> of each pair of groups."""
    groups, width = arguments[Argument.GROUPS], padded(arguments[Argument.POINTS])
    shared = arguments[Argument.SHARED]
    pairs = groups * (groups + 1) // 2
    out = floats_at(arguments[Argument.NORMS] + 16 * pairs * row, 2 * pairs)
    at = 0
    for g in range(groups):
        ar, ai = _blocks(blocks, 0, g, size)
        for k in range(g, groups):
            br, bi = _blocks(blocks, 0, k, size)
            place = width * d if shared == 1 else 2 * width * (d * pairs + at)
            weights = floats_at(arguments[Argument.QUADRATIC_WEIGHTS] + 8 * place, 2 * width)
            imaginary = first if shared == 1 else width + first
            qr, qi = floats_in(weights, first, size), floats_in(weights, imaginary, size)
            real, turned = _pair(ar, ai, br, bi, qr, qi, shared)
            out[2 * at] += real
            out[2 * at + 1] += turned
            at += 1


@njit(**JIT_OPTIONS)
def contract(arguments: Integers) -> int:
    """Inner products of every row: see :class:`Argument`; returns 0."""
    detectors, modes, groups = arguments[Argument.DETECTORS], arguments[Argument.MODES], arguments[Argument.GROUPS]
    sidereal = floats_at(arguments[Argument.SIDEREAL], 2)
    responses = floats_at(arguments[Argument.RESPONSES], 9 * detectors)
    locations = floats_at(arguments[Argument.LOCATIONS], 3 * detectors)
    size = (3 + 2 * modes) * detectors + (GROUP_BLOCKS * groups + SHARED_BLOCKS) * BLOCK
    scratch = floats_at(arguments[Argument.SCRATCH], size)
    pattern = floats_in(scratch, 0, 3 * detectors)
    factors = floats_in(scratch, 3 * detectors, 2 * detectors * modes)
    blocks = floats_in(scratch, (3 + 2 * modes) * detectors, (GROUP_BLOCKS * groups + SHARED_BLOCKS) * BLOCK)
    width = padded(arguments[Argument.POINTS])
    products, pairs = groups * arguments[Argument.TIMES], groups * (groups + 1) // 2
    terms = groups * arguments[Argument.POINTS] if arguments[Argument.SPECTRUM] != 0 else 0
    for row in range(arguments[Argument.ROWS]):
        place = floats_at(arguments[Argument.SKY] + 8 * _COLUMNS * row, _COLUMNS)
        _geometry(place, sidereal, responses, locations, pattern)
        _factors(row, arguments, pattern, factors)
        floats_at(arguments[Argument.PRODUCTS] + 16 * products * row, 2 * products)[:] = 0.0
        floats_at(arguments[Argument.NORMS] + 16 * pairs * row, 2 * pairs)[:] = 0.0
        if terms > 0:
            floats_at(arguments[Argument.SPECTRUM] + 16 * terms * row, 2 * terms)[:] = 0.0
        for first in range(0, width, BLOCK):
            block = min(BLOCK, width - first)
            for d in range(detectors):
                _gather(row, d, first, block, arguments, factors, blocks)
                _add_products(row, d, first, block, arguments, place[Sky.TIME], pattern[3 * d + 2], blocks)
                _add_pairs(row, d, first, block, arguments, blocks)
    return 0
