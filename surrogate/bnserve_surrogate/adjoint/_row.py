"""One row backwards: from the bars of all its modes to those of what its regressors give, and to its parameters."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.adjoint._carrier import block_back, order_back
from bnserve_surrogate.adjoint._layout import ALPHA, GAMMA, ROOM, SUMS, Z_IMAGINARY, Z_REAL, Place
from bnserve_surrogate.adjoint._ratio import clear_ratio, ratio_back, ratio_block_back
from bnserve_surrogate.adjoint._series import add_coefficients
from bnserve_surrogate.adjoint._splines import along_cubics, cells_back, clear
from bnserve_surrogate.adjoint._sums import add_mode_bars, split, through_carrier, total
from bnserve_surrogate.kernel._layout import (
    ANY,
    EDGE,
    LANES,
    Argument,
    Column,
    Entry,
    Plan,
    PlanMode,
)
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, store
from bnserve_surrogate.kernel._places import locate
from bnserve_surrogate.kernel._row import prepared_grid
from bnserve_surrogate.kernel._simd import splat
from bnserve_surrogate.kernel.modes._sums import turn
from bnserve_surrogate.kernel.modes._synthesis import COEFFICIENTS, plan_mode
from bnserve_surrogate.tangents._carrier import (
    cubics_of,
    fill_block,
    place_carrier,
    prepare_coefficients,
    prepare_splines,
    prepare_top,
)
from bnserve_surrogate.tangents._layout import BLOCK, INTRINSIC, MASS, TANGENTS, WORK, Buffer
from bnserve_surrogate.tangents._ratio import prepare_ratio
from bnserve_surrogate.tangents._room import Row, buffer
from bnserve_surrogate.tangents._row import _QUADRUPOLE, _rise

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def row_back(i: int, state: Row, sums: Floats, bars: Floats, out: Floats) -> None:
    """Row ``i``: its derivatives as far as they do not come from regressors, ``out``, ``(6,)``, and bars of what is
    linear in the outputs of these: of the carrier ``bars``, ``(width, 8)``, and of the ratios after their values."""
    for k in range(SUMS):
        sums[k] = 0.0
    prepare_splines(state, 1)
    prepare_coefficients(state)
    a, p = cubics_of(state, 1)
    clear(a, state.sizes[0])
    clear(p, state.sizes[1])
    mass = state.row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
    if state.arguments[Argument.MODES] == 0:
        _order(i, _QUADRUPOLE, 0, 0, mass, state, sums)
    else:
        plan = integers_at(state.arguments[Argument.MODES], ANY)
        first = 0
        while first < plan[Plan.MODES]:
            order = plan_mode(plan, first)[PlanMode.ORDER]
            last = first + 1
            while last < plan[Plan.MODES] and plan_mode(plan, last)[PlanMode.ORDER] == order:
                last += 1
            _order(i, order, first, last, mass, state, sums)
            first = last
    _finish(state, sums, bars, out)


@njit(**JIT_OPTIONS)
def _order(i: int, order: int, first: int, last: int, whole_mass: float, state: Row, sums: Floats) -> None:
    """The modes number ``first`` to ``last`` of the plan, all of one ``order``; without a plan the (2, 2) alone."""
    points, mass = state.arguments[Argument.POINTS], 2.0 * whole_mass / order
    _, grid_places = prepared_grid(state.arguments)
    band = floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    stop = locate(*grid_places, np.log(band[1] * (1.0 + EDGE)) - np.log(whole_mass))
    places, line = place_carrier(state, mass), floats_in(state.top, 3, 3)
    beyond = places[1] < stop
    if beyond:
        prepare_top(state, mass, 1)
    for k in range(3):
        line[k] = 0.0
    plan = integers_at(state.arguments[Argument.MODES], ANY)
    ratios = False
    for k in range(first, last):
        mode = plan_mode(plan, k)
        if mode[PlanMode.POWER] > 0:
            ratios = True
            prepare_ratio(state, mode, np.log(mass), stop, 1)
            clear_ratio(state, mode)
    cells, cells_of_bars = (0, 0), (0, 0)
    alpha, gamma = buffer(state.buffers, ALPHA), buffer(state.buffers, GAMMA)
    for start in range(0, points, BLOCK):
        inside = min(start + BLOCK, points, stop)
        if inside <= start:
            break
        cells = fill_block(state, mass, start, inside, places, cells, (0 if ratios else 1, 1))
        if ratios:
            amplitude, phase = buffer(state.buffers, Buffer.AMPLITUDE), buffer(state.buffers, Buffer.PHASE)
            turn(inside - start, 0.5 * order, amplitude, phase)
        for j in range(0, inside - start, LANES):
            store(alpha, j, splat(0.0))
            store(gamma, j, splat(0.0))
        if last == first:
            _carrier(i, 1, 0, start, inside, 0.5 * order, state)
        for k in range(first, last):
            _mode(i, plan_mode(plan, k), plan[Plan.MODES], start, inside, mass, state, sums)
        cells_of_bars = block_back(state, sums, mass, start, inside, places, cells_of_bars, line)
    order_back(state, sums, mass, beyond, line)
    for k in range(first, last):
        mode = plan_mode(plan, k)
        if mode[PlanMode.POWER] > 0:
            ratio_back(state, mode, sums)


@njit(**JIT_OPTIONS)
def _carrier(i: int, count: int, place: int, start: int, inside: int, turns: float, state: Row) -> None:
    """Bars of the carrier, of those of a mode in the block; the mode and its bars are left in the buffers."""
    points, stride = state.arguments[Argument.POINTS], state.arguments[Argument.GIVEN]
    mode, size = i * count + place, inside - start
    h = buffer(state.buffers, Buffer.H_REAL), buffer(state.buffers, Buffer.H_IMAGINARY)
    z = buffer(state.buffers, Z_REAL), buffer(state.buffers, Z_IMAGINARY)
    split(size, floats_at(state.arguments[Argument.FIRST] + 16 * (mode * points + start), 2 * size), h[0], h[1])
    split(size, floats_at(state.arguments[Argument.SECOND] + 16 * (mode * stride + start), 2 * size), z[0], z[1])
    add_mode_bars(size, turns, h, z, buffer(state.buffers, ALPHA), buffer(state.buffers, GAMMA))


@njit(**JIT_OPTIONS)
def _mode(i: int, mode: Integers, count: int, start: int, inside: int, mass: float, state: Row, sums: Floats) -> None:
    """Bars of the carrier of a mode of the plan, and of its ratio."""
    power, size, turns = mode[PlanMode.POWER], inside - start, 0.5 * mode[PlanMode.ORDER]
    _carrier(i, count, mode[PlanMode.PLACE], start, inside, turns, state)
    if power == 0:
        return
    h = buffer(state.buffers, Buffer.H_REAL), buffer(state.buffers, Buffer.H_IMAGINARY)
    z = buffer(state.buffers, Z_REAL), buffer(state.buffers, Z_IMAGINARY)
    plan = integers_at(state.arguments[Argument.MODES], ANY)
    highest = floats_at(plan[Plan.NUMBERS] + 8 * COEFFICIENTS * count, 3)[2]
    grid, _ = prepared_grid(state.arguments)
    cbrt_f = floats_in(grid, 2 * state.arguments[Argument.STRIDE] + start, ANY)
    carrier = buffer(state.buffers, ROOM + 2), buffer(state.buffers, ROOM + 3)
    cut = _rise(size, cbrt_f, (np.pi * mass) ** (1.0 / 3.0), highest, power, state, carrier)
    own, unused = buffer(state.buffers, ROOM), buffer(state.buffers, ROOM + 1)
    for j in range(0, size, LANES):
        store(own, j, splat(0.0))
        store(unused, j, splat(0.0))
    add_mode_bars(size, turns, h, z, own, unused)
    rising = power / (3.0 * state.row[Column.TOTAL_MASS])
    sums[Place.OWN + MASS] += rising * total(own, 0, cut, state.tail)
    through_carrier(size, carrier, z)
    ratio_block_back(state, mode, start, inside, np.log(mass))


@njit(**JIT_OPTIONS)
def _finish(state: Row, sums: Floats, bars: Floats, out: Floats) -> None:
    """What all orders share."""
    n_a, n_p, _ = state.sizes
    slopes, cubics = cubics_of(state, 1 + MASS), cubics_of(state, 1)
    nodes = state.contents[Entry.AMPLITUDE_NODES], state.contents[Entry.PHASE_NODES]
    knots = (
        floats_in(state.weights, state.contents[Entry.AMPLITUDE_KNOTS_AT], ANY),
        floats_in(state.weights, state.contents[Entry.PHASE_KNOTS_AT], ANY),
    )
    found = along_cubics(cubics[0], slopes[0], nodes[0], n_a, state.tail)
    found += along_cubics(cubics[1], slopes[1], nodes[1], n_p, state.tail)
    sums[Place.OWN + MASS] += found
    for k in range(4):
        cubics[0][k * n_a + nodes[0] - 2] += sums[Place.TOP + k]
        cubics[1][k * n_p + nodes[1] - 2] += sums[Place.TOP + 4 + k]
    cells_back(cubics[0], knots[0], nodes[0], n_a, state.lane, 0, bars)
    cells_back(cubics[1], knots[1], nodes[1], n_p, state.lane, 2 * n_a, bars)
    bars[state.lane] += sums[Place.EDGE]
    bars[LANES * 2 * n_a + state.lane] += sums[Place.EDGE + 1]
    for k in range(4):
        bars[LANES * (2 * (n_a + n_p) + k) + state.lane] = sums[Place.GAUGE + k]
    phase = floats_in(state.coefficients[0], 2 * WORK, INTRINSIC * WORK)
    add_coefficients(sums, phase, floats_in(state.coefficients[1], 2 * LANES, INTRINSIC * LANES))
    for p in range(TANGENTS):
        out[p] = sums[Place.OWN + p]
