"""Source of the compiled contraction of moving detectors: see :mod:`.build`.

As with detectors that stand (:mod:`bnserve_inference.modes_kernel._source`), a row is evaluated by the same sequence of
operations wherever it stands in a batch; eight nodes at a time, no allocation.
"""

from __future__ import annotations

from numba import njit

from bnserve_inference.kernel._layout import BLOCK, Sky
from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.kernel._sums import Floats, Integers, errors_at
from bnserve_inference.modes_kernel._source import _add_pairs, _add_products, _blocks, add_mode, calibrate
from bnserve_inference.moving_kernel._layout import (
    COEFFICIENTS,
    GROUP_BLOCKS,
    SHARED_BLOCKS,
    Argument,
    Coefficient,
)
from bnserve_inference.moving_kernel._passing import find_passing
from bnserve_inference.moving_kernel._response import coefficients, delay, one_arm, short_arms
from bnserve_surrogate.adjoint._sums import split
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, load, padded, store

_COLUMNS = len(Sky)


@njit(inline="always")
def _plus(groups: int, g: int) -> int:
    """Which pair of blocks holds the plus polarisation of a group; cross, and cosine and sine, are the next two."""
    return groups + 2 + 3 * g


@njit(**JIT_OPTIONS)
def _turn(times: Floats, rate: float, c: Floats, s: Floats) -> None:
    for j in range(0, times.shape[0], LANES):
        sine, cosine = sincos(rate * load(times, j))
        store(c, j, cosine)
        store(s, j, sine)


@njit(**JIT_OPTIONS)
def _polarise(row: int, first: int, size: int, arguments: Integers, passing: Floats, blocks: Floats) -> None:
    """The polarisations of each group at a block of nodes, and how far the Earth has turned when it passes them."""
    modes, groups, points = arguments[Common.MODES], arguments[Common.GROUPS], arguments[Common.POINTS]
    width = padded(points)
    wave = floats_at(arguments[Common.STRAIN] + 16 * modes * points * row, 2 * modes * points)
    plus = floats_at(arguments[Common.PLUS] + 8 * modes * row, modes)
    cross = floats_at(arguments[Common.CROSS] + 16 * modes * row, 2 * modes)
    group_of = integers_at(arguments[Common.GROUP_OF], modes)
    rate = floats_at(arguments[Common.SIDEREAL], 2)[1]
    filled = min(size, points - first)
    for g in range(groups):
        pr, pi = _blocks(blocks, 0, _plus(groups, g), size)
        xr, xi = _blocks(blocks, 0, _plus(groups, g) + 1, size)
        pr[:], pi[:], xr[:], xi[:] = 0.0, 0.0, 0.0, 0.0
        c, s = _blocks(blocks, 0, _plus(groups, g) + 2, size)
        _turn(floats_in(passing, g * width + first, size), rate, c, s)
    for a in range(modes):
        pr, pi = _blocks(blocks, 0, _plus(groups, group_of[a]), size)
        xr, xi = _blocks(blocks, 0, _plus(groups, group_of[a]) + 1, size)
        ar, ai = _blocks(blocks, 0, groups, size)
        split(filled, floats_in(wave, 2 * (a * points + first), 2 * filled), ar, ai)
        add_mode(plus[a], 0.0, ar, ai, pr, pi)
        add_mode(cross[2 * a], cross[2 * a + 1], ar, ai, xr, xi)


@njit(**JIT_OPTIONS)
def _respond(row: int, d: int, first: int, size: int, arguments: Integers, k: Floats, blocks: Floats) -> None:
    """The strain of each group in a detector at a block of nodes, with calibration errors."""
    groups, width = arguments[Common.GROUPS], padded(arguments[Common.POINTS])
    f = floats_in(floats_at(arguments[Common.NODES], width), first, size)
    for g in range(groups):
        hr, hi = _blocks(blocks, 0, g, size)
        pr, pi = _blocks(blocks, 0, _plus(groups, g), size)
        xr, xi = _blocks(blocks, 0, _plus(groups, g) + 1, size)
        c, s = _blocks(blocks, 0, _plus(groups, g) + 2, size)
        if k[Coefficient.X_ARM + 3] > 0.0:
            hr[:], hi[:] = 0.0, 0.0
            one_arm(k, Coefficient.X_ARM, 1.0, f, c, s, pr, pi, xr, xi, hr, hi)
            one_arm(k, Coefficient.Y_ARM, -1.0, f, c, s, pr, pi, xr, xi, hr, hi)
        else:
            short_arms(k, c, s, pr, pi, xr, xi, hr, hi)
        delay(k, f, c, s, hr, hi)
    nodes = arguments[Common.CALIBRATION_NODES]
    if nodes > 0:
        place = 8 * nodes * (row * arguments[Common.DETECTORS] + d)
        splines = floats_at(arguments[Common.LINEAR_SPLINES], nodes * width)
        amplitude, phase = _blocks(blocks, 0, groups, size)
        errors_at(floats_at(arguments[Common.AMPLITUDE_ERRORS] + place, nodes), splines, width, first, amplitude)
        errors_at(floats_at(arguments[Common.PHASE_ERRORS] + place, nodes), splines, width, first, phase)
        for g in range(groups):
            hr, hi = _blocks(blocks, 0, g, size)
            calibrate(amplitude, phase, hr, hi)


@njit(**JIT_OPTIONS)
def _place(row: int, arguments: Integers, out: Floats) -> None:
    """The coefficients of all detectors for one row."""
    sky = floats_at(arguments[Common.SKY] + 8 * _COLUMNS * row, _COLUMNS)
    sidereal = floats_at(arguments[Common.SIDEREAL], 2)
    for d in range(arguments[Common.DETECTORS]):
        tensor = floats_at(arguments[Common.RESPONSES] + 72 * d, 9)
        place = floats_at(arguments[Common.LOCATIONS] + 24 * d, 3)
        arms = floats_at(arguments[Argument.ARMS] + 48 * d, 6)
        found = floats_in(out, COEFFICIENTS * d, COEFFICIENTS)
        coefficients(sky, sidereal, arguments[Argument.MOVES], tensor, place, arms, found)


@njit(**JIT_OPTIONS)
def contract(arguments: Integers) -> int:
    """Inner products of every row: see :class:`Argument`; returns 0."""
    detectors, groups, points = arguments[Common.DETECTORS], arguments[Common.GROUPS], arguments[Common.POINTS]
    room = (GROUP_BLOCKS * groups + SHARED_BLOCKS) * BLOCK
    scratch = floats_at(arguments[Common.SCRATCH], COEFFICIENTS * detectors + room)
    found = floats_in(scratch, 0, COEFFICIENTS * detectors)
    blocks = floats_in(scratch, COEFFICIENTS * detectors, room)
    width = padded(points)
    products, pairs = groups * arguments[Common.TIMES], groups * (groups + 1) // 2
    terms = groups * points if arguments[Common.SPECTRUM] != 0 else 0
    for row in range(arguments[Common.ROWS]):
        arrival = floats_at(arguments[Common.SKY] + 8 * _COLUMNS * row, _COLUMNS)[Sky.TIME]
        _place(row, arguments, found)
        passing = find_passing(row, arguments)
        floats_at(arguments[Common.PRODUCTS] + 16 * products * row, 2 * products)[:] = 0.0
        floats_at(arguments[Common.NORMS] + 16 * pairs * row, 2 * pairs)[:] = 0.0
        if terms > 0:
            floats_at(arguments[Common.SPECTRUM] + 16 * terms * row, 2 * terms)[:] = 0.0
        for first in range(0, width, BLOCK):
            size = min(BLOCK, width - first)
            _polarise(row, first, size, arguments, passing, blocks)
            for d in range(detectors):
                k = floats_in(found, COEFFICIENTS * d, COEFFICIENTS)
                _respond(row, d, first, size, arguments, k, blocks)
                _add_products(row, d, first, size, arguments, arrival, k[Coefficient.DELAY], blocks)
                _add_pairs(row, d, first, size, arguments, blocks)
    return 0
