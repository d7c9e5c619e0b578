"""One block of frequencies of a row: all modes, summed or one by one."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, LANES, Argument, Output, Plan, PlanMode
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, singles_at, singles_in
from bnserve_surrogate.kernel._row import prepared_grid
from bnserve_surrogate.kernel._writing import streamed_from
from bnserve_surrogate.kernel.modes._carriers import carrier_at, fill_carrier
from bnserve_surrogate.kernel.modes._room import State, mode_views
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


@njit(inline="always")
def _carrier(number: int, ends: tuple[int, int, int], state: State) -> Any:
    """Amplitude and phase of a carrier on a block, in the first two buffers; returns what is known of it."""
    grid, _ = prepared_grid(state.arguments)
    stride, buffers = state.arguments[Argument.STRIDE], state.buffers
    carrier = carrier_at(state.carriers, number, max(state.sizes[0], state.sizes[1]))
    fill_carrier(
        ends[0], ends[1], state.dense, grid, stride, state.linear, state.contents, state.weights, state.sizes,
        state.cubics, state.fitted, state.top, carrier, buffers[2], buffers[3], buffers[0], buffers[1],
    )  # fmt: skip
    return carrier


@njit(**JIT_OPTIONS)
def sum_block(i: int, lane: int, ends: tuple[int, int, int], state: State) -> None:
    """Both polarisations on one block of frequencies.

    It begins at the first of the ``ends``, is zero from the second on and ends with the third.
    """
    arguments, buffers, sums = state.arguments, state.buffers, state.sums
    plan, count = integers_at(arguments[Argument.MODES], ANY), ends[1] - ends[0]
    grid, _ = prepared_grid(arguments)
    cbrt_f = floats_in(grid, 2 * arguments[Argument.STRIDE] + ends[0], ANY)
    amplitude, phase, first, second = buffers[0], buffers[1], (buffers[2], buffers[3]), (buffers[4], buffers[5])
    number, k, own = 0, 0, (0.0, 0.0)
    while k < plan[Plan.MODES]:
        mode = plan_mode(plan, k)
        order = mode[PlanMode.ORDER]
        carrier = _carrier(number, ends, state)
        turns, fresh, own, known = 0.5 * order, number == 0, (0.0, 0.0), carrier[1]
        number += 1
        if mode[PlanMode.POWER] == 0:
            own, k = _factors(i, mode, plan, arguments), k + 1
            mode = plan_mode(plan, k)
            if k == plan[Plan.MODES] or mode[PlanMode.ORDER] != order:
                add_carrier(count, fresh, turns, amplitude, phase, own, sums)
                continue
        velocity = _fill(mode, lane, ends, plan, state, known, first)
        factors, k, other = _factors(i, mode, plan, arguments), k + 1, plan_mode(plan, k + 1)
        if k == plan[Plan.MODES] or other[PlanMode.ORDER] != order:
            add_mode(count, fresh, turns, amplitude, phase, own, first, cbrt_f, velocity, factors, sums)
            continue
        faster = _fill(other, lane, ends, plan, state, known, second)
        others, k = _factors(i, other, plan, arguments), k + 1
        powers = velocity[2], faster[2]
        add_two_modes(
            count, fresh, turns, amplitude, phase, first, second, cbrt_f, velocity, powers, factors, others, sums
        )
    _write_both(i, ends[0], ends[2], arguments, count, sums, state.tail)


@njit(inline="always")
def _factors(i: int, mode: Integers, plan: Integers, arguments: Integers) -> tuple[float, float]:
    """What a mode counts in row i: in the plus polarisation, and, over i, in the other one."""
    place = i * plan[Plan.MODES] + mode[PlanMode.PLACE]
    plus, cross = floats_at(arguments[Argument.PLUS], ANY), floats_at(arguments[Argument.CROSS], ANY)
    return plus[place], cross[2 * place + 1]


@njit(**JIT_OPTIONS)
def strain_block(i: int, lane: int, ends: tuple[int, int, int], state: State) -> None:
    """Each mode on one block of frequencies, as :func:`sum_block`."""
    arguments, buffers, tail = state.arguments, state.buffers, state.tail
    plan, count = integers_at(arguments[Argument.MODES], ANY), ends[1] - ends[0]
    grid, _ = prepared_grid(arguments)
    cbrt_f = floats_in(grid, 2 * arguments[Argument.STRIDE] + ends[0], ANY)
    real, imaginary, ratio = buffers[0], buffers[1], (buffers[2], buffers[3])
    number, order = -1, 0
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.ORDER] != order:
            order, number = mode[PlanMode.ORDER], number + 1
            carrier = _carrier(number, ends, state)
            turn(count, 0.5 * order, real, imaginary)
        place = i * plan[Plan.MODES] + mode[PlanMode.PLACE]
        if mode[PlanMode.POWER] == 0:
            _write(place, ends[0], ends[2], arguments, count, real, imaginary, tail)
        else:
            velocity = _fill(mode, lane, ends, plan, state, carrier[1], ratio)
            multiply_mode(count, real, imaginary, ratio, cbrt_f, velocity)
            _write(place, ends[0], ends[2], arguments, count, ratio[0], ratio[1], tail)


@njit(inline="always")
def _fill(
    mode: Integers, lane: int, ends: tuple[int, int, int], plan: Integers, state: State, numbers: Floats,
    ratio: tuple[Floats, Floats],
) -> Any:  # fmt: skip
    """A mode's ratio on a block; returns how v follows from f^(1/3), its largest value, and its power."""
    cubics, places, _, knots, count, nodes = mode_views(state.modes, mode)
    cells = mode_views(state.modes, plan_mode(plan, mode[PlanMode.ENDS_OF]))[2]
    own = floats_in(state.ratios, mode[PlanMode.LINEAR_AT] + 4 * count * lane, 4 * count)
    edges = (own[0], own[2 * count], own[nodes - 1], own[2 * count + nodes - 1])
    grid, _ = prepared_grid(state.arguments)
    log_f = floats_in(grid, state.arguments[Argument.STRIDE], ANY)
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
