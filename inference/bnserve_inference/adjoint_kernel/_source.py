"""Source of the compiled adjoint of the contraction: see :mod:`.build`.

The contraction of all kinds is that of moving detectors (:mod:`bnserve_inference.moving_kernel._source`): one mode, and
detectors that stand, are cases of it. A row is evaluated by the same sequence of operations wherever it stands in a
batch.
"""

from __future__ import annotations

from numba import njit

from bnserve_inference.adjoint_kernel._back import errors_back, errors_to_nodes, pull_back, waves_back
from bnserve_inference.adjoint_kernel._layout import (
    BLOCK,
    GEOMETRY,
    GROUP_BUFFERS,
    SHARED_BUFFERS,
    SUMS,
    Argument,
    Buffer,
    Geometry,
    Shared,
    Sum,
)
from bnserve_inference.adjoint_kernel._passing import passing_back
from bnserve_inference.adjoint_kernel._response import add_arm, block_of, clear_patterns, fill_geometry, short_patterns
from bnserve_inference.adjoint_kernel._standing import pull_back_standing, respond_standing
from bnserve_inference.adjoint_kernel._sums import add_fixed, add_mode, add_pair, add_splined, respond, slopes_at
from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.kernel._layout import Sky
from bnserve_inference.kernel._sums import Floats, Integers, errors_at, spline_at
from bnserve_inference.moving_kernel._layout import COEFFICIENTS, Coefficient
from bnserve_inference.moving_kernel._layout import Argument as Moving
from bnserve_inference.moving_kernel._passing import find_passing
from bnserve_inference.moving_kernel._response import coefficients
from bnserve_surrogate.adjoint._sums import split
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, load, padded, store
from bnserve_surrogate.kernel._simd import fma, from_bits, splat

_COLUMNS = len(Sky)


@njit(inline="always")
def _own(buffers: Floats, g: int) -> Floats:
    """The buffers of a group."""
    return floats_in(buffers, (SHARED_BUFFERS + GROUP_BUFFERS * g) * BLOCK, GROUP_BUFFERS * BLOCK)


@njit(**JIT_OPTIONS)
def _begin(own: Floats, times: Floats, rate: float, size: int, moves: int) -> None:
    """Nothing yet in the polarisations of a group and in bars; how far the Earth has turned at times."""
    for part in (Buffer.PLUS, Buffer.CROSS, Buffer.PLUS_BAR, Buffer.CROSS_BAR):
        real, imaginary = block_of(own, part), block_of(own, part + 1)
        for j in range(0, size, LANES):
            store(real, j, splat(0.0))
            store(imaginary, j, splat(0.0))
    turn, cosine, sine = block_of(own, Buffer.TURN_BAR), block_of(own, Buffer.COSINE), block_of(own, Buffer.COSINE + 1)
    for j in range(0, size, LANES):
        store(turn, j, splat(0.0))
        s, c = sincos(load(times, j) * rate) if moves == 1 else (splat(0.0), splat(1.0))
        store(cosine, j, c)
        store(sine, j, s)


@njit(**JIT_OPTIONS)
def _polarise(row: int, first: int, size: int, arguments: Integers, passing: Floats, buffers: Floats) -> None:
    """The polarisations of each group at a block of nodes, and how far the Earth has turned when it passes them."""
    modes, groups, points = arguments[Common.MODES], arguments[Common.GROUPS], arguments[Common.POINTS]
    wave = floats_at(arguments[Common.STRAIN] + 16 * modes * points * row, 2 * modes * points)
    plus = floats_at(arguments[Common.PLUS] + 8 * modes * row, modes)
    cross = floats_at(arguments[Common.CROSS] + 16 * modes * row, 2 * modes)
    group_of = integers_at(arguments[Common.GROUP_OF], modes)
    rate, width = floats_at(arguments[Common.SIDEREAL], 2)[1], padded(points)
    for g in range(groups):
        own = _own(buffers, g)
        _begin(own, floats_in(passing, g * width + first, size), rate, size, arguments[Moving.MOVES])
    for a in range(modes):
        own, start, filled = _own(buffers, group_of[a]), 2 * (a * points + first), min(size, points - first)
        shared = floats_in(buffers, 0, SHARED_BUFFERS * BLOCK)
        real, imaginary = block_of(shared, Shared.WAVE), block_of(shared, Shared.WAVE + 1)
        split(filled, floats_in(wave, start, 2 * filled), real, imaginary)
        add_mode(plus[a], cross[2 * a], cross[2 * a + 1], size, floats_in(buffers, 0, SHARED_BUFFERS * BLOCK), own)


@njit(**JIT_OPTIONS)
def _calibrate(row: int, d: int, first: int, size: int, arguments: Integers, shared: Floats) -> None:
    """The errors of a detector at a block of nodes, and what they multiply its strain with."""
    kr, ki = block_of(shared, Shared.CALIBRATION), block_of(shared, Shared.CALIBRATION + 1)
    nodes, width = arguments[Common.CALIBRATION_NODES], padded(arguments[Common.POINTS])
    if nodes == 0:
        for j in range(0, size, LANES):
            store(kr, j, splat(1.0))
            store(ki, j, splat(0.0))
        return
    amplitude = floats_in(shared, Shared.ERRORS * BLOCK, size)
    phase = floats_in(shared, (Shared.ERRORS + 1) * BLOCK, size)
    place = 8 * nodes * (row * arguments[Common.DETECTORS] + d)
    splines = floats_at(arguments[Common.LINEAR_SPLINES], nodes * width)
    errors_at(floats_at(arguments[Common.AMPLITUDE_ERRORS] + place, nodes), splines, width, first, amplitude)
    errors_at(floats_at(arguments[Common.PHASE_ERRORS] + place, nodes), splines, width, first, phase)
    for j in range(0, size, LANES):
        p = load(phase, j)
        scale = (load(amplitude, j) + 1.0) / fma(p, p, 4.0)
        store(kr, j, scale * (p * p * -1.0 + 4.0))
        store(ki, j, scale * p * 4.0)
    block_of(shared, Shared.ERRORS_BAR)[:], block_of(shared, Shared.ERRORS_BAR + 1)[:] = 0.0, 0.0


@njit(**JIT_OPTIONS)
def _fill_bars(row: int, g: int, k: int, first: int, size: int, arguments: Integers, shared: Floats) -> None:
    """The bar of <d|h> of a group at a time, or of its terms at a block of nodes."""
    real, imaginary = block_of(shared, Shared.WORK), block_of(shared, Shared.WORK + 1)
    groups, points, times = arguments[Common.GROUPS], arguments[Common.POINTS], arguments[Common.TIMES]
    if arguments[Argument.BY_NODE] == 1:
        filled = min(size, points - first)
        line = floats_at(arguments[Argument.PRODUCTS_BAR] + 16 * ((row * groups + g) * points + first), 2 * filled)
        split(filled, line, real, imaginary)
    else:
        bar = floats_at(arguments[Argument.PRODUCTS_BAR] + 16 * ((row * groups + g) * times + k), 2)
        for j in range(0, size, LANES):
            store(real, j, splat(bar[0]))
            store(imaginary, j, splat(bar[1]))


@njit(**JIT_OPTIONS)
def _through_weights(
    row: int, d: int, g: int, first: int, size: int, arguments: Integers, arrival: float, shared: Floats
) -> None:
    """The bar of a group's strain in a detector, and that of its time of arrival over the strain, of <d|h>."""
    groups, points, knots = arguments[Common.GROUPS], arguments[Common.POINTS], arguments[Common.KNOTS]
    width = padded(points)
    f = floats_in(floats_at(arguments[Common.NODES], width), first, size)
    grid, step = floats_at(arguments[Common.TIME_GRID], 2), from_bits(arguments[Common.STEP])
    place = d if arguments[Common.SHARED] == 1 else d * groups + g
    table = floats_at(arguments[Common.LINEAR_WEIGHTS] + 16 * width * knots * place, 2 * width * knots)
    for part in range(Shared.STRAIN_BAR, Shared.SLOPE_BAR + 2):
        for j in range(0, size, LANES):
            store(block_of(shared, part), j, splat(0.0))
    for k in range(arguments[Common.TIMES]):
        _fill_bars(row, g, k, first, size, arguments, shared)
        time = arrival + k * step
        if knots == 1:
            add_fixed(f, time, floats_in(table, first, size), floats_in(table, width + first, size), size, shared)
        else:
            rows, spline = spline_at(time, grid, knots, width, first)
            add_splined(f, time, table, rows, spline, slopes_at(time, grid, knots), size, shared)


@njit(**JIT_OPTIONS)
def _through_pairs(row: int, d: int, g: int, first: int, size: int, arguments: Integers, buffers: Floats) -> None:
    """What <h|h> adds to the bar of a group's strain in a detector."""
    groups, width, alike = arguments[Common.GROUPS], padded(arguments[Common.POINTS]), arguments[Common.SHARED] == 1
    pairs = groups * (groups + 1) // 2
    bars = floats_at(arguments[Argument.PAIRS_BAR] + 16 * pairs * row, 2 * pairs)
    at = 0
    for a in range(groups):
        for b in range(a, groups):
            place = width * d if alike else 2 * width * (d * pairs + at)
            weights = floats_at(arguments[Common.QUADRATIC_WEIGHTS] + 8 * place, 2 * width)
            imaginary = floats_in(weights, first if alike else width + first, size)
            q = floats_in(weights, first, size), imaginary, not alike, bars[2 * at], bars[2 * at + 1]
            if b == g:
                other = _own(buffers, a)
                add_pair(
                    block_of(other, Buffer.STRAIN), block_of(other, Buffer.STRAIN + 1), q, 1.0, size,
                    floats_in(buffers, 0, SHARED_BUFFERS * BLOCK),
                )  # fmt: skip
            if a == g:
                other = _own(buffers, b)
                add_pair(
                    block_of(other, Buffer.STRAIN), block_of(other, Buffer.STRAIN + 1), q, -1.0, size,
                    floats_in(buffers, 0, SHARED_BUFFERS * BLOCK),
                )  # fmt: skip
            at += 1


@njit(**JIT_OPTIONS)
def _in_detector(
    row: int, d: int, first: int, size: int, arguments: Integers, arrival: float, k: Floats, geometry: Floats,
    buffers: Floats,
) -> None:  # fmt: skip
    """One detector at a block of nodes: strain there, and back."""
    groups, nodes = arguments[Common.GROUPS], arguments[Common.CALIBRATION_NODES]
    f = floats_in(floats_at(arguments[Common.NODES], padded(arguments[Common.POINTS])), first, size)
    shared = floats_in(buffers, 0, SHARED_BUFFERS * BLOCK)
    _calibrate(row, d, first, size, arguments, shared)
    stands = arguments[Moving.MOVES] == 0 and k[Coefficient.X_ARM + 3] == 0.0
    for g in range(groups):
        own = _own(buffers, g)
        if stands:
            respond_standing(k, nodes > 0, size, shared, own)
            continue
        if k[Coefficient.X_ARM + 3] > 0.0:
            clear_patterns(own)
            add_arm(k, Coefficient.X_ARM, 1.0, f, size, own)
            add_arm(k, Coefficient.Y_ARM, -1.0, f, size, own)
        else:
            short_patterns(k, geometry, size, own)
        respond(f, k[Coefficient.RECEDING], k[Coefficient.SIDEWAYS], arguments[Moving.MOVES], size, shared, own)
    for g in range(groups):
        own = _own(buffers, g)
        _through_weights(row, d, g, first, size, arguments, arrival + k[Coefficient.DELAY], shared)
        _through_pairs(row, d, g, first, size, arguments, buffers)
        if nodes > 0:
            errors_back(size, shared, own)
        if stands:
            pull_back_standing(k, geometry, nodes > 0, size, shared, own, block_of(shared, Shared.WORK))
        else:
            pull_back(f, k, geometry, size, shared, own, block_of(shared, Shared.WORK))
    if nodes > 0:
        errors_to_nodes(row, d, first, size, arguments, shared)


@njit(**JIT_OPTIONS)
def _place(row: int, arguments: Integers, coefficients_out: Floats, geometries: Floats) -> None:
    """The coefficients of all detectors for one row, and their derivatives."""
    sky = floats_at(arguments[Common.SKY] + 8 * _COLUMNS * row, _COLUMNS)
    sidereal, moves = floats_at(arguments[Common.SIDEREAL], 2), arguments[Moving.MOVES]
    for d in range(arguments[Common.DETECTORS]):
        tensor = floats_at(arguments[Common.RESPONSES] + 72 * d, 9)
        place = floats_at(arguments[Common.LOCATIONS] + 24 * d, 3)
        arms = floats_at(arguments[Moving.ARMS] + 48 * d, 6)
        found = floats_in(coefficients_out, COEFFICIENTS * d, COEFFICIENTS)
        coefficients(sky, sidereal, moves, tensor, place, arms, found)
        fill_geometry(sky, sidereal, moves, tensor, place, floats_in(geometries, GEOMETRY * d, GEOMETRY))


@njit(**JIT_OPTIONS)
def _sky_back(row: int, arguments: Integers, found: Floats, geometries: Floats) -> None:
    """Derivatives by place and time, of what was summed up in the detectors."""
    rate = floats_at(arguments[Common.SIDEREAL], 2)[1]
    out = floats_at(arguments[Argument.SUMS] + 8 * SUMS * row, SUMS)
    for d in range(arguments[Common.DETECTORS]):
        k, geometry = floats_in(found, COEFFICIENTS * d, COEFFICIENTS), floats_in(geometries, GEOMETRY * d, GEOMETRY)
        time = geometry[Geometry.TIME_BAR]
        hour = geometry[Geometry.HOUR_BAR] + time * k[Coefficient.SIDEWAYS]
        declination = geometry[Geometry.DECLINATION_BAR] + time * geometry[Geometry.DELAY]
        declination += rate * geometry[Geometry.ARRIVAL_DELAY + 1] * hour
        hour += rate * geometry[Geometry.ARRIVAL_DELAY] * hour
        out[Sum.RIGHT_ASCENSION] -= hour
        out[Sum.DECLINATION] += declination
        out[Sum.POLARIZATION] += geometry[Geometry.POLARIZATION_BAR]
        out[Sum.TIME] += time + rate * hour


@njit(**JIT_OPTIONS)
def _block_back(row: int, first: int, size: int, arguments: Integers, buffers: Floats, waves: Floats) -> None:
    """What all detectors make of the modes at a block of nodes, and of when they pass them."""
    modes, groups, points = arguments[Common.MODES], arguments[Common.GROUPS], arguments[Common.POINTS]
    width, filled = padded(points), min(size, points - first)
    group_of = integers_at(arguments[Common.GROUP_OF], modes)
    shared = floats_in(buffers, 0, SHARED_BUFFERS * BLOCK)
    for a in range(modes):
        own = floats_in(waves, 2 * (width * a + first), 2 * size)
        waves_back(row, first, filled, arguments, shared, _own(buffers, group_of[a]), a, own)
    if arguments[Argument.PASSING_BAR] != 0:
        rate = floats_at(arguments[Common.SIDEREAL], 2)[1]
        for g in range(groups):
            bars = floats_at(arguments[Argument.PASSING_BAR] + 8 * ((row * groups + g) * width + first), size)
            turns = block_of(_own(buffers, g), Buffer.TURN_BAR)
            for j in range(0, size, LANES):
                store(bars, j, load(turns, j) * rate)


@njit(**JIT_OPTIONS)
def pull(arguments: Integers) -> int:
    """The bars of every row: see :class:`Argument`; returns 0. The sums begin as they are given."""
    detectors, groups, modes = arguments[Common.DETECTORS], arguments[Common.GROUPS], arguments[Common.MODES]
    width, room = padded(arguments[Common.POINTS]), (GROUP_BUFFERS * groups + SHARED_BUFFERS) * BLOCK
    own = (COEFFICIENTS + GEOMETRY) * detectors
    scratch = floats_at(arguments[Common.SCRATCH], own + room)
    found = floats_in(scratch, 0, COEFFICIENTS * detectors)
    geometries = floats_in(scratch, COEFFICIENTS * detectors, GEOMETRY * detectors)
    buffers = floats_in(scratch, own, room)
    for row in range(arguments[Common.ROWS]):
        arrival = floats_at(arguments[Common.SKY] + 8 * _COLUMNS * row, _COLUMNS)[Sky.TIME]
        _place(row, arguments, found, geometries)
        passing = find_passing(row, arguments)
        waves = floats_at(arguments[Argument.WAVES_BAR] + 16 * width * modes * row, 2 * width * modes)
        for first in range(0, width, BLOCK):
            size = min(BLOCK, width - first)
            _polarise(row, first, size, arguments, passing, buffers)
            for d in range(detectors):
                k = floats_in(found, COEFFICIENTS * d, COEFFICIENTS)
                geometry = floats_in(geometries, GEOMETRY * d, GEOMETRY)
                _in_detector(row, d, first, size, arguments, arrival, k, geometry, buffers)
            _block_back(row, first, size, arguments, buffers, waves)
        _sky_back(row, arguments, found, geometries)
        if arguments[Argument.PASSING_BAR] != 0 and arguments[Moving.PASSING_STRIDE] == 0:
            passing_back(row, arguments, waves)
    return 0
