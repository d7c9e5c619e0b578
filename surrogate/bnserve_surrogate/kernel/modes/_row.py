"""One row of several modes, from their linear synthesis to their values, or their sums', on all frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.kernel._layout import (
    ANY,
    DENSE,
    EDGE,
    MODE_BLOCK,
    Argument,
    Column,
    Entry,
    Output,
    Plan,
    PlanMode,
)
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import (
    at,
    floats_at,
    floats_in,
    integers_at,
    padded,
)
from bnserve_surrogate.kernel._places import find_ends_apart, locate
from bnserve_surrogate.kernel._points import fill_cells
from bnserve_surrogate.kernel._row import fill_cubics, fit_cells, prepared_grid
from bnserve_surrogate.kernel.modes._blocks import strain_block, sum_block
from bnserve_surrogate.kernel.modes._carriers import carrier_at, cells_needed, prepare_carrier, top_of_band
from bnserve_surrogate.kernel.modes._room import State, mode_views, row_views
from bnserve_surrogate.kernel.modes._synthesis import COEFFICIENTS, plan_mode

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def _prepare_mode(
    mode: Integers, ends: bool, lane: int, ratios: Floats, modes: Floats, grid_places: Any, shift: float, stop: int
) -> None:
    """Cubics of a ratio, and where on the grid its knots lie."""
    cubics, places, own_ends, knots, count, nodes = mode_views(modes, mode)
    linear = floats_in(ratios, mode[PlanMode.LINEAR_AT] + 4 * count * lane, 4 * count)
    fill_cells(linear, floats_in(linear, count, count), knots, nodes - 1, count, cubics[0])
    values, curvatures = floats_in(linear, 2 * count, count), floats_in(linear, 3 * count, count)
    fill_cells(values, curvatures, knots, nodes - 1, count, cubics[1])
    places[0] = min(locate(*grid_places, at(knots, 0) - shift), stop)
    places[1] = min(locate(*grid_places, at(knots, nodes - 1) - shift), stop)
    places[2] = 0
    if ends:
        find_ends_apart(grid_places, floats_in(knots, 1, count), nodes - 1, shift, places[1], own_ends)


@njit(**JIT_OPTIONS)
def evaluate_modes(
    i: int, lane: int, row: Floats, linear: Floats, ratios: Floats, arguments: Integers, contents: Integers,
    weights: Floats, scratch: Floats,
) -> None:  # fmt: skip
    """One row on all frequencies."""
    points, alignment = arguments[Argument.POINTS], arguments[Argument.ALIGNMENT]
    plan = integers_at(arguments[Argument.MODES], ANY)
    count, orders = plan[Plan.MODES], plan[Plan.ORDERS]
    numbers = floats_at(plan[Plan.NUMBERS] + 8 * COEFFICIENTS * count, 2)
    _, grid_places = prepared_grid(arguments)
    n_p, n_c = padded(contents[Entry.PHASE_NODES]), padded(contents[Entry.CELLS])
    cubics, fitted, work, series, buffers, sums, tail, carriers, modes = row_views(scratch, n_p, n_c, orders)
    fill_cubics(linear, contents, weights, n_p, n_p, cubics)
    mass = row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
    band, gauge = floats_in(weights, contents[Entry.BAND_AT], 3), floats_in(linear, 4 * n_p, 4)
    stop = locate(*grid_places, np.log(band[1] * (1.0 + EDGE)) - np.log(mass))
    dense = points * orders >= DENSE
    summed = arguments[Argument.OUTPUT] in (Output.POLARIZATIONS, Output.POLARIZATIONS_SINGLE)
    line = _prepare(
        lane, row, mass, dense, stop, plan, arguments, contents, weights, gauge, ratios, work, carriers, modes
    )
    first, last = _cells_to_fit(dense, line, mass, plan, grid_places, contents, weights)
    top = (0.0, 0.0, 0.0)
    if last > first:
        fit_cells(row, linear, contents, weights, alignment, cubics, n_p, series[0], work, *fitted, first, last)
    if line:
        top = top_of_band(band, plan[Plan.TOP_CELL], numbers[1], contents, weights, n_c, *fitted)
    state = State(
        arguments, contents, weights, linear, ratios, (n_p, n_c), dense, cubics, fitted, top, buffers, sums, carriers,
        modes, tail,
    )  # fmt: skip
    for start in range(0, points, MODE_BLOCK):
        end = min(start + MODE_BLOCK, points)
        ends = (start, min(max(stop, start), end), end)
        if summed:
            sum_block(i, lane, ends, state)
        else:
            strain_block(i, lane, ends, state)


@njit(inline="always")
def _cells_to_fit(
    dense: bool, line: bool, mass: float, plan: Integers, grid_places: Any, contents: Integers, weights: Floats
) -> tuple[int, int]:
    """The first cell whose polynomials are needed, and the one after the last."""
    slowest, fastest = plan_mode(plan, plan[Plan.MODES] - 1)[PlanMode.ORDER], plan_mode(plan, 0)[PlanMode.ORDER]
    first, last = 0, 0
    if dense:
        shifts = np.log(2.0 * mass / slowest), np.log(2.0 * mass / fastest)
        first, last = cells_needed(grid_places, shifts, contents, weights)
    elif line:
        first, last = plan[Plan.TOP_CELL], plan[Plan.TOP_CELL] + 1
    return first, last


@njit(**JIT_OPTIONS)
def _prepare(
    lane: int, row: Floats, mass: float, dense: bool, stop: int, plan: Integers, arguments: Integers,
    contents: Integers, weights: Floats, gauge: Floats, ratios: Floats, room: Floats, carriers: Floats, modes: Floats,
) -> bool:  # fmt: skip
    """Prepare every carrier and every mode; whether any goes beyond the end of the band in x."""
    _, grid_places = prepared_grid(arguments)
    size = max(padded(contents[Entry.PHASE_NODES]), padded(contents[Entry.CELLS]))
    number, order, line = -1, 0, False
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.ORDER] != order:
            order, number = mode[PlanMode.ORDER], number + 1
            carrier = carrier_at(carriers, number, size)
            own_mass = 2.0 * mass / order
            alignment = arguments[Argument.ALIGNMENT]
            prepare_carrier(row, own_mass, dense, grid_places, contents, weights, gauge, alignment, room, carrier)
            places = carrier[2]
            line |= places[1] < stop
        if mode[PlanMode.POWER] > 0:
            own_ends = mode[PlanMode.ENDS_OF] == k
            _prepare_mode(mode, own_ends, lane, ratios, modes, grid_places, carrier[1][1], stop)
    return line
