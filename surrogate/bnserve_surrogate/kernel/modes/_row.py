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
    LANES,
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
    integers_in,
    padded,
    singles_at,
    singles_in,
)
from bnserve_surrogate.kernel._places import find_ends, locate
from bnserve_surrogate.kernel._points import fill_cells
from bnserve_surrogate.kernel._row import fill_cubics, fit_cells, prepared_grid
from bnserve_surrogate.kernel._writing import streamed_from
from bnserve_surrogate.kernel.modes._carriers import (
    CARRIER,
    carrier_at,
    cells_needed,
    fill_carrier,
    prepare_carrier,
    top_of_band,
)
from bnserve_surrogate.kernel.modes._sums import (
    add_carrier,
    add_mode,
    add_two_modes,
    fill_ratio,
    multiply_mode,
    turn,
    write_complex,
)
from bnserve_surrogate.kernel.modes._synthesis import COEFFICIENTS, plan_mode

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
BUFFER = MODE_BLOCK + LANES
MODE_PLACES = 8
"""Integers that a mode has for itself, beside its cubics and the ends of its cells: where its first node and its last
lie on the grid, and the last cell that was used."""


@njit(inline="always")
def _views(scratch: Floats, n_p: int, n_c: int, orders: int) -> Any:
    """A row's working memory, for n_p knots and n_c cells; :func:`..modes._plan.scratch_size` counts it.

    Cubics, polynomials, room to fit them, room for a series, six buffers, four sums, a tail, the carriers, the modes.
    """
    cells = LANES * n_c
    fitted = 8 * n_p
    buffers = fitted + 4 * cells + 128
    carriers = buffers + 10 * BUFFER + 2 * LANES
    return (
        (floats_in(scratch, 0, 4 * n_p), floats_in(scratch, 4 * n_p, 4 * n_p)),
        (floats_in(scratch, fitted, cells), floats_in(scratch, fitted + cells, cells)),
        floats_in(scratch, fitted + 2 * cells, 2 * cells),
        (floats_in(scratch, buffers - 128, 64), floats_in(scratch, buffers - 64, 64)),
        (
            floats_in(scratch, buffers, BUFFER),
            floats_in(scratch, buffers + BUFFER, BUFFER),
            floats_in(scratch, buffers + 2 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 3 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 4 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 5 * BUFFER, BUFFER),
        ),
        (
            floats_in(scratch, buffers + 6 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 7 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 8 * BUFFER, BUFFER),
            floats_in(scratch, buffers + 9 * BUFFER, BUFFER),
        ),
        floats_in(scratch, carriers - 2 * LANES, 2 * LANES),
        floats_in(scratch, carriers, orders * (CARRIER + max(n_p, n_c))),
        floats_in(scratch, carriers + orders * (CARRIER + max(n_p, n_c)), ANY),
    )


@njit(inline="always")
def _mode_views(modes: Floats, mode: Integers) -> Any:
    """A mode's cubics, places and ends of cells; its knots and how many there are, padded."""
    contents, weights = integers_at(mode[PlanMode.CONTENTS], ANY), floats_at(mode[PlanMode.WEIGHTS], ANY)
    count = padded(contents[Entry.PHASE_NODES])
    room = floats_in(modes, mode[PlanMode.LINEAR_AT] >> 1, ANY)
    return (
        (floats_in(room, 0, 4 * count), floats_in(room, 4 * count, 4 * count)),
        integers_in(room, 8 * count, MODE_PLACES),
        integers_in(room, 8 * count + MODE_PLACES, count),
        floats_in(weights, contents[Entry.PHASE_KNOTS_AT], ANY),
        count,
        contents[Entry.PHASE_NODES],
    )


@njit(**JIT_OPTIONS)
def _prepare_mode(
    mode: Integers, ends: bool, lane: int, ratios: Floats, modes: Floats, grid_places: Any, shift: float, stop: int
) -> None:
    """Cubics of a ratio, and where on the grid its knots lie."""
    cubics, places, own_ends, knots, count, nodes = _mode_views(modes, mode)
    linear = floats_in(ratios, mode[PlanMode.LINEAR_AT] + 4 * count * lane, 4 * count)
    fill_cells(linear, floats_in(linear, count, count), knots, nodes - 1, count, cubics[0])
    values, curvatures = floats_in(linear, 2 * count, count), floats_in(linear, 3 * count, count)
    fill_cells(values, curvatures, knots, nodes - 1, count, cubics[1])
    places[0] = min(locate(*grid_places, at(knots, 0) - shift), stop)
    places[1] = min(locate(*grid_places, at(knots, nodes - 1) - shift), stop)
    places[2] = 0
    if ends:
        find_ends(grid_places, floats_in(knots, 1, count), nodes - 1, shift, places[1], own_ends)


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
    cubics, fitted, work, series, buffers, sums, tail, carriers, modes = _views(scratch, n_p, n_c, orders)
    fill_cubics(linear, contents, weights, n_p, n_p, cubics)
    mass = row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
    band, gauge = floats_in(weights, contents[Entry.BAND_AT], 3), floats_in(linear, 4 * n_p, 4)
    stop = locate(*grid_places, np.log(band[1] * (1.0 + EDGE)) - np.log(mass))
    dense = points * orders >= DENSE
    summed = arguments[Argument.OUTPUT] in (Output.POLARIZATIONS, Output.POLARIZATIONS_SINGLE)
    line = _prepare(
        lane, row, mass, dense, stop, plan, arguments, contents, weights, gauge, ratios, work, carriers, modes
    )
    first, last = 0, 0
    if dense:
        shifts = np.log(2.0 * mass / _highest(plan)), np.log(2.0 * mass / _lowest(plan))
        first, last = cells_needed(grid_places, shifts, contents, weights)
    elif line:
        first, last = plan[Plan.TOP_CELL], plan[Plan.TOP_CELL] + 1
    top = (0.0, 0.0, 0.0)
    if last > first:
        fit_cells(row, linear, contents, weights, alignment, cubics, n_p, series[0], work, *fitted, first, last)
    if line:
        top = top_of_band(band, plan[Plan.TOP_CELL], numbers[1], contents, weights, n_c, *fitted)
    for start in range(0, points, MODE_BLOCK):
        end = min(start + MODE_BLOCK, points)
        ends = (start, min(max(stop, start), end), end)
        if summed:
            _sum_block(
                i, lane, ends, dense, top, arguments, linear, ratios, contents, weights, (n_p, n_c), cubics, fitted,
                buffers, sums, tail, carriers, modes,
            )  # fmt: skip
        else:
            _strain_block(
                i, lane, ends, dense, top, arguments, linear, ratios, contents, weights, (n_p, n_c), cubics, fitted,
                buffers, tail, carriers, modes,
            )  # fmt: skip


@njit(inline="always")
def _lowest(plan: Integers) -> int:
    """The lowest of the orders."""
    lowest = plan_mode(plan, 0)[PlanMode.ORDER]
    for k in range(1, plan[Plan.MODES]):
        lowest = min(lowest, plan_mode(plan, k)[PlanMode.ORDER])
    return lowest


@njit(inline="always")
def _highest(plan: Integers) -> int:
    """The highest of the orders."""
    highest = 0
    for k in range(plan[Plan.MODES]):
        highest = max(highest, plan_mode(plan, k)[PlanMode.ORDER])
    return highest


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


@njit(inline="always")
def _carrier(
    number: int, ends: tuple[int, int, int], dense: bool, top: tuple[float, float, float], arguments: Integers,
    linear: Floats, contents: Integers, weights: Floats, sizes: tuple[int, int], cubics: Any, fitted: Any,
    buffers: Any, carriers: Floats,
) -> Any:  # fmt: skip
    """Amplitude and phase of a carrier on a block, in the first two buffers; returns what is known of it."""
    grid, _ = prepared_grid(arguments)
    carrier = carrier_at(carriers, number, max(sizes[0], sizes[1]))
    fill_carrier(
        ends[0], ends[1], dense, grid, arguments[Argument.STRIDE], linear, contents, weights, sizes, cubics, fitted,
        top, carrier, buffers[2], buffers[3], buffers[0], buffers[1],
    )  # fmt: skip
    return carrier


@njit(**JIT_OPTIONS)
def _sum_block(
    i: int, lane: int, ends: tuple[int, int, int], dense: bool, top: tuple[float, float, float], arguments: Integers,
    linear: Floats, ratios: Floats, contents: Integers, weights: Floats, sizes: tuple[int, int], cubics: Any,
    fitted: Any, buffers: Any, sums: Any, tail: Floats, carriers: Floats, modes: Floats,
) -> None:  # fmt: skip
    """Both polarisations on one block of frequencies.

    It begins at the first of the ``ends``, is zero from the second on and ends with the third.
    """
    plan, count = integers_at(arguments[Argument.MODES], ANY), ends[1] - ends[0]
    grid, _ = prepared_grid(arguments)
    cbrt_f = floats_in(grid, 2 * arguments[Argument.STRIDE] + ends[0], ANY)
    amplitude, phase, first, second = buffers[0], buffers[1], (buffers[2], buffers[3]), (buffers[4], buffers[5])
    number, k, own = 0, 0, (0.0, 0.0)
    while k < plan[Plan.MODES]:
        mode = plan_mode(plan, k)
        order = mode[PlanMode.ORDER]
        carrier = _carrier(
            number, ends, dense, top, arguments, linear, contents, weights, sizes, cubics, fitted, buffers, carriers
        )
        turns, fresh, own, known = 0.5 * order, number == 0, (0.0, 0.0), carrier[1]
        number += 1
        if mode[PlanMode.POWER] == 0:
            own, k = _factors(i, mode, plan, arguments), k + 1
            mode = plan_mode(plan, k)
            if k == plan[Plan.MODES] or mode[PlanMode.ORDER] != order:
                add_carrier(count, fresh, turns, amplitude, phase, own, sums)
                continue
        velocity = _fill(mode, lane, ends, plan, arguments, ratios, modes, known, first)
        factors, k, other = _factors(i, mode, plan, arguments), k + 1, plan_mode(plan, k + 1)
        if k == plan[Plan.MODES] or other[PlanMode.ORDER] != order:
            add_mode(count, fresh, turns, amplitude, phase, own, first, cbrt_f, velocity, factors, sums)
            continue
        faster = _fill(other, lane, ends, plan, arguments, ratios, modes, known, second)
        others, k = _factors(i, other, plan, arguments), k + 1
        powers = velocity[2], faster[2]
        add_two_modes(
            count, fresh, turns, amplitude, phase, first, second, cbrt_f, velocity, powers, factors, others, sums
        )
    _write_both(i, ends[0], ends[2], arguments, count, sums, tail)


@njit(inline="always")
def _factors(i: int, mode: Integers, plan: Integers, arguments: Integers) -> tuple[float, float]:
    """What a mode counts in row i: in the plus polarisation, and, over i, in the other one."""
    place = i * plan[Plan.MODES] + mode[PlanMode.PLACE]
    plus, cross = floats_at(arguments[Argument.PLUS], ANY), floats_at(arguments[Argument.CROSS], ANY)
    return plus[place], cross[2 * place + 1]


@njit(**JIT_OPTIONS)
def _strain_block(
    i: int, lane: int, ends: tuple[int, int, int], dense: bool, top: tuple[float, float, float], arguments: Integers,
    linear: Floats, ratios: Floats, contents: Integers, weights: Floats, sizes: tuple[int, int], cubics: Any,
    fitted: Any, buffers: Any, tail: Floats, carriers: Floats, modes: Floats,
) -> None:  # fmt: skip
    """Each mode on one block of frequencies, as :func:`_sum_block`."""
    plan, count = integers_at(arguments[Argument.MODES], ANY), ends[1] - ends[0]
    grid, _ = prepared_grid(arguments)
    cbrt_f = floats_in(grid, 2 * arguments[Argument.STRIDE] + ends[0], ANY)
    real, imaginary, ratio = buffers[0], buffers[1], (buffers[2], buffers[3])
    number, order = -1, 0
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.ORDER] != order:
            order, number = mode[PlanMode.ORDER], number + 1
            carrier = _carrier(
                number, ends, dense, top, arguments, linear, contents, weights, sizes, cubics, fitted, buffers, carriers
            )
            turn(count, 0.5 * order, real, imaginary)
        place = i * plan[Plan.MODES] + mode[PlanMode.PLACE]
        if mode[PlanMode.POWER] == 0:
            _write(place, ends[0], ends[2], arguments, count, real, imaginary, tail)
        else:
            velocity = _fill(mode, lane, ends, plan, arguments, ratios, modes, carrier[1], ratio)
            multiply_mode(count, real, imaginary, ratio, cbrt_f, velocity)
            _write(place, ends[0], ends[2], arguments, count, ratio[0], ratio[1], tail)


@njit(inline="always")
def _fill(
    mode: Integers, lane: int, ends: tuple[int, int, int], plan: Integers, arguments: Integers, ratios: Floats,
    modes: Floats, numbers: Floats, ratio: tuple[Floats, Floats],
) -> Any:  # fmt: skip
    """A mode's ratio on a block; returns how v follows from f^(1/3), its largest value, and its power."""
    cubics, places, _, knots, count, nodes = _mode_views(modes, mode)
    cells = _mode_views(modes, plan_mode(plan, mode[PlanMode.ENDS_OF]))[2]
    own = floats_in(ratios, mode[PlanMode.LINEAR_AT] + 4 * count * lane, 4 * count)
    edges = (own[0], own[2 * count], own[nodes - 1], own[2 * count + nodes - 1])
    grid, _ = prepared_grid(arguments)
    log_f = floats_in(grid, arguments[Argument.STRIDE], ANY)
    fill_ratio(log_f, ends[0], ends[1], places, numbers[1], knots, cells, cubics, count, edges, ratio[0], ratio[1])
    highest = floats_at(plan[Plan.NUMBERS] + 8 * COEFFICIENTS * plan[Plan.MODES], 3)[2]
    return numbers[3], highest, mode[PlanMode.POWER]


@njit(**JIT_OPTIONS)
def _write(
    place: int, start: int, stop: int, arguments: Integers, count: int, real: Floats, imaginary: Floats, tail: Floats
) -> None:
    """A block of one mode, the one at a place among all rows and modes."""
    points, first = arguments[Argument.POINTS], arguments[Argument.FIRST]
    at_point, size = place * points + start, 2 * (stop - start)
    if arguments[Argument.OUTPUT] == Output.STRAIN_SINGLE:
        streamed = streamed_from(arguments, first + 8 * at_point, 0, False, 8)
        out = singles_at(first + 8 * at_point, size)
        write_complex(count, real, imaginary, streamed, out, singles_in(tail, 0, 4 * LANES))
    else:
        streamed = streamed_from(arguments, first + 16 * at_point, 0, False, 16)
        write_complex(count, real, imaginary, streamed, floats_at(first + 16 * at_point, size), tail)


@njit(**JIT_OPTIONS)
def _write_both(
    i: int, start: int, stop: int, arguments: Integers, count: int, sums: tuple[Floats, Floats, Floats, Floats],
    tail: Floats,
) -> None:  # fmt: skip
    """A block of both polarisations of row i."""
    at_point, size = i * arguments[Argument.POINTS] + start, 2 * (stop - start)
    single = arguments[Argument.OUTPUT] == Output.POLARIZATIONS_SINGLE
    width = 8 if single else 16
    first, second = arguments[Argument.FIRST] + width * at_point, arguments[Argument.SECOND] + width * at_point
    streamed = streamed_from(arguments, first, second, True, width)
    if single:
        narrow = singles_in(tail, 0, 4 * LANES)
        write_complex(count, sums[0], sums[1], streamed, singles_at(first, size), narrow)
        write_complex(count, sums[2], sums[3], streamed, singles_at(second, size), narrow)
    else:
        write_complex(count, sums[0], sums[1], streamed, floats_at(first, size), tail)
        write_complex(count, sums[2], sums[3], streamed, floats_at(second, size), tail)
