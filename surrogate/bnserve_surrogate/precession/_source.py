"""Source of the compiled precession: from modes that do not precess to polarisations. Compiled by :mod:`.build`."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.kernel._layout import COLUMNS, Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at
from bnserve_surrogate.precession._dynamics import follow
from bnserve_surrogate.precession._equations import fill_constants
from bnserve_surrogate.precession._layout import (
    BLOCK,
    CONSTANTS,
    LANES,
    NODE,
    POINTS,
    STATES,
    WIDTH,
    WORK,
    Argument,
    Constant,
)
from bnserve_surrogate.precession._points import directions, twisted

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
ANY = 1 << 40
"""The size of an array whose end nobody asks for."""


@njit(**JIT_OPTIONS)
def twist(arguments: Integers) -> int:
    """Polarisations of N rows: see :class:`Argument`. Returns zero."""
    scratch = floats_at(arguments[Argument.SCRATCH], ANY)
    c, initial = floats_in(scratch, 0, ANY), floats_in(scratch, CONSTANTS * LANES, ANY)
    work = floats_in(scratch, (CONSTANTS + STATES) * LANES, ANY)
    points = floats_in(scratch, WORK, ANY)
    table = floats_in(scratch, WORK + POINTS, ANY)
    rows = arguments[Argument.ROWS]
    parameters = floats_at(arguments[Argument.PARAMETERS], rows * COLUMNS)
    steps = integers_at(arguments[Argument.LANE_STEPS], 2 * LANES)
    for start in range(0, rows, LANES):
        middle, back = _prepare(start, rows, arguments, steps, c, initial)
        follow(steps, 0, c, initial, work, table, middle)
        follow(steps, 1, c, initial, work, table, middle)
        nodes = floats_in(table, (middle + back + 1) * (NODE * LANES), ANY)
        for i in range(start, min(start + LANES, rows)):
            lane = i - start
            ahead = steps[2 * lane]
            count = ahead + steps[2 * lane + 1] + 1
            _gather(table, middle - ahead, count, lane, nodes)
            scale, origin = c[Constant.SCALE * LANES + lane], c[Constant.FIRST * LANES + lane] - ahead
            mass = parameters[i * COLUMNS + Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
            _row(i, arguments, 1.0 / (2.0 * np.pi * mass), scale, origin, nodes, count, points)
    return 0


@njit(**JIT_OPTIONS)
def _prepare(
    start: int, rows: int, arguments: Integers, steps: Integers, c: Floats, initial: Floats
) -> tuple[int, int]:
    """Constants of up to eight rows, the last repeated where there are fewer; the most steps of any to either side."""
    parameters = floats_at(arguments[Argument.PARAMETERS], rows * COLUMNS)
    in_plane = floats_at(arguments[Argument.IN_PLANE], 4 * rows)
    reference = floats_at(arguments[Argument.REFERENCE], 1)[0]
    given = integers_at(arguments[Argument.STEPS], 2 * rows)
    ahead = back = 0
    for lane in range(LANES):
        i = min(start + lane, rows - 1)
        row, spins = floats_in(parameters, i * COLUMNS, COLUMNS), floats_in(in_plane, 4 * i, 4)
        fill_constants(row, spins, reference, floats_in(c, lane, ANY), floats_in(initial, lane, ANY))
        steps[2 * lane], steps[2 * lane + 1] = given[2 * i], given[2 * i + 1]
        ahead, back = max(ahead, given[2 * i]), max(back, given[2 * i + 1])
    return ahead, back


@njit(**JIT_OPTIONS)
def _gather(table: Floats, first: int, count: int, lane: int, out: Floats) -> None:
    """One lane's nodes, one after the other."""
    for node in range(count):
        at = (first + node) * (NODE * LANES) + lane
        for k in range(NODE):
            out[node * NODE + k] = table[at + k * LANES]


@njit(**JIT_OPTIONS)
def _row(
    i: int, arguments: Integers, unit: float, scale: float, origin: float, nodes: Floats, count: int, room: Floats
) -> None:
    """One row's polarisations, block by block."""
    points, modes = arguments[Argument.POINTS], arguments[Argument.MODES]
    frequencies = floats_at(arguments[Argument.FREQUENCIES], points)
    orders = integers_at(arguments[Argument.ORDERS], modes)
    plus = floats_at(arguments[Argument.PLUS] + 16 * i * points, 2 * points)
    cross = floats_at(arguments[Argument.CROSS] + 16 * i * points, 2 * points)
    spinor, sums = floats_in(room, 0, 4 * WIDTH), floats_in(room, 4 * WIDTH, 4 * WIDTH)
    rest = floats_in(room, 8 * WIDTH, 2 * WIDTH)
    for start in range(0, points, BLOCK):
        size = min(BLOCK, points - start)
        for k in range(4 * WIDTH):
            sums[k] = 0.0
        f = floats_in(frequencies, start, ANY)
        mode = 0
        while mode < modes:
            last = mode + 1
            while last < modes and orders[last] == orders[mode]:
                last += 1
            directions(f, size, orders[mode] * unit, scale, origin, nodes, count, rest, spinor)
            _add_modes(i, arguments, mode, last, start, size, spinor, rest, sums)
            mode = last
        for j in range(size):
            at = 2 * (start + j)
            plus[at], plus[at + 1] = sums[j], sums[WIDTH + j]
            cross[at], cross[at + 1] = sums[2 * WIDTH + j], sums[3 * WIDTH + j]


@njit(**JIT_OPTIONS)
def _add_modes(
    i: int, arguments: Integers, mode: int, last: int, start: int, size: int, spinor: Floats, spare: Floats,
    sums: Floats,
) -> None:  # fmt: skip
    """Add the modes from ``mode`` to ``last``, all of one order, on a block."""
    points, modes = arguments[Argument.POINTS], arguments[Argument.MODES]
    strain = floats_at(arguments[Argument.STRAIN] + 16 * i * modes * points, 2 * modes * points)
    order = integers_at(arguments[Argument.ORDERS], modes)[mode]
    table = floats_at(arguments[Argument.HARMONICS], 4 * modes)
    for j in range(0, size, LANES):
        twisted(order, mode, last, table, strain, points, start + j, size - j, spinor, j, spare, sums)
