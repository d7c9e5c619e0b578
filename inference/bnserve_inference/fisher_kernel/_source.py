"""Source of the compiled factorisation of whitened derivatives: see :mod:`.build`.

A row is evaluated by the same sequence of operations wherever it stands in a batch; no allocation.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_inference.fisher_kernel._factor import fold, lane_sum
from bnserve_inference.fisher_kernel._layout import (
    ARM,
    ARMS,
    COLUMNS,
    INTRINSIC,
    POLARIZATIONS,
    RESPONSE,
    Argument,
    Response,
    Sky,
)
from bnserve_inference.fisher_kernel._response import add, respond
from bnserve_inference.fisher_kernel._tangents import differentiate, observe, pass_nodes, polarise
from bnserve_surrogate.kernel._layout import LANES, Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import bytes_at, floats_at, floats_in, integers_at, load, store
from bnserve_surrogate.kernel._simd import splat

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_TWO_PI, _SKY = 2.0 * np.pi, len(Sky)


class _Room(NamedTuple):
    """The working memory."""

    block: Floats
    """``(13, capacity, 8)``."""
    waves: Floats
    angles: Floats
    times: Floats
    response: Floats
    squares: Floats
    """``(D, 8)``."""
    lanes: Floats
    root: Floats
    """``(13, 13)``, and what a vector may read beyond it."""


@njit(inline="always")
def _room(arguments: Integers) -> Any:
    capacity, detectors = arguments[Argument.CAPACITY], arguments[Argument.DETECTORS]
    scratch = floats_at(arguments[Argument.SCRATCH], 1 << 30)
    waves = COLUMNS * capacity * LANES
    angles = waves + 4 * POLARIZATIONS * LANES
    response = angles + 2 * INTRINSIC * LANES
    squares = response + RESPONSE * LANES
    lanes = squares + detectors * LANES
    return _Room(
        floats_in(scratch, 0, waves),
        floats_in(scratch, waves, 4 * POLARIZATIONS * LANES),
        floats_in(scratch, angles, INTRINSIC * LANES),
        floats_in(scratch, angles + INTRINSIC * LANES, INTRINSIC * LANES),
        floats_in(scratch, response, RESPONSE * LANES),
        floats_in(scratch, squares, detectors * LANES),
        floats_in(scratch, lanes, 4 * LANES),
        floats_in(scratch, lanes + 4 * LANES, COLUMNS * COLUMNS),
    )


@njit(inline="always")
def _detectors_of(panel: int, arguments: Integers) -> Integers:
    """How many detectors have the noise of a panel, and which."""
    width = 1 + arguments[Argument.DETECTORS]
    curve = integers_at(arguments[Argument.CURVE], panel + 1)[panel]
    return integers_at(arguments[Argument.WITH] + 8 * width * curve, width)


@njit(inline="always")
def _rows_of(panel: int, arguments: Integers) -> int:
    """Rows that a detector has in a panel: groups that are apart, or one."""
    apart = integers_at(arguments[Argument.APART], panel + 1)[panel]
    return arguments[Argument.GROUPS] if apart == 1 else 1


@njit(**JIT_OPTIONS)
def _fill_panel(row: int, panel: int, used: int, sky: Floats, arguments: Integers, room: _Room) -> None:
    """The derivatives of the signals of all groups in all detectors that have the noise of a panel, into the block from
    the vector number ``used`` on."""
    width = LANES * arguments[Argument.CAPACITY]
    f = load(floats_at(arguments[Argument.FREQUENCIES] + 8 * LANES * panel, LANES), 0)
    scale = load(floats_at(arguments[Argument.SCALES] + 8 * LANES * panel, LANES), 0)
    sidereal = floats_at(arguments[Argument.SIDEREAL], 2)
    hour = sidereal[0] + sidereal[1] * sky[Sky.TIME] - sky[Sky.RIGHT_ASCENSION]
    declination, polarization = sincos(sky[Sky.DECLINATION]), sincos(2.0 * sky[Sky.POLARIZATION])
    inverse, moves = 1.0 / sky[Sky.DISTANCE], arguments[Argument.MOVES] == 1
    detectors, rows = _detectors_of(panel, arguments), _rows_of(panel, arguments)
    orders = integers_at(arguments[Argument.ORDERS], arguments[Argument.GROUPS])
    for group in range(arguments[Argument.GROUPS]):
        polarise(row, panel, group, arguments, room.waves, room.angles, room.lanes)
        turned = splat(hour)
        if moves:
            turned = turned + pass_nodes(panel, sky[Sky.MASS], f, arguments, room.angles, room.times) * sidereal[1]
        sin_h, cos_h = sincos(turned)
        numbers = (0.5 * orders[group], inverse, sidereal[1])
        adds = rows == 1 and group > 0
        for number in range(detectors[0]):
            d = detectors[1 + number]
            arms = floats_at(arguments[Argument.ARMS] + 8 * ARMS * ARM * d, ARMS * ARM)
            location = floats_at(arguments[Argument.LOCATIONS] + 24 * d, 3)
            respond(arms, location, declination, polarization, f, sin_h, cos_h, room.response)
            sine, cosine = sincos(f * load(room.response, LANES * Response.DELAY) * (-_TWO_PI))
            turn = (cosine * scale, sine * scale)
            at = LANES * (used + 2 * (rows * number + (group if rows > 1 else 0)))
            if arguments[Argument.DERIVATIVES] == 0:
                observe(room.waves, room.response, inverse, turn, room.block, width, at, adds)
            else:
                differentiate(
                    room.waves, room.response, room.times, numbers, f, turn, moves, room.block, width, at, adds
                )


@njit(**JIT_OPTIONS)
def _add_squares(panel: int, used: int, arguments: Integers, room: _Room) -> None:
    """Squares of the derivatives by the distance of each detector in a panel."""
    detectors, rows = _detectors_of(panel, arguments), _rows_of(panel, arguments)
    column = floats_in(room.block, LANES * arguments[Argument.CAPACITY] * Column.DISTANCE, 1 << 30)
    for number in range(detectors[0]):
        for k in range(2 * rows):
            x = load(column, LANES * (used + 2 * rows * number + k))
            add(room.squares, detectors[1 + number], x * x)


@njit(**JIT_OPTIONS)
def _copy(row: int, done: int, used: int, vectors: int, arguments: Integers, room: _Room) -> None:
    """The derivatives themselves, for who wants them."""
    size, width = arguments[Argument.WHITENED_SIZE], LANES * arguments[Argument.CAPACITY]
    place = 8 * LANES * COLUMNS * (row * size + done)
    out = floats_at(arguments[Argument.WHITENED] + place, LANES * COLUMNS * vectors)
    for k in range(vectors):
        for column in range(COLUMNS):
            store(out, LANES * (COLUMNS * k + column), load(room.block, width * column + LANES * (used + k)))


@njit(**JIT_OPTIONS)
def _finish(row: int, arguments: Integers, room: _Room) -> None:
    """The triangle in other coordinates, with priors, written out."""
    jacobian = floats_at(arguments[Argument.JACOBIAN] + 8 * COLUMNS * COLUMNS * row, COLUMNS * COLUMNS)
    priors = arguments[Argument.PRIORS]
    given = floats_at(arguments[Argument.PRIOR_ROWS], LANES * COLUMNS * priors)
    for column in range(COLUMNS):
        out = floats_in(room.block, LANES * arguments[Argument.CAPACITY] * column, LANES * (2 + priors))
        for i in range(2 * LANES):
            total = 0.0
            if i < COLUMNS:
                for k in range(i, COLUMNS):
                    total += room.root[COLUMNS * i + k] * jacobian[COLUMNS * k + column]
            out[i] = total
        for k in range(priors):
            store(out, LANES * (2 + k), load(given, LANES * (column * priors + k)))
    for i in range(COLUMNS * COLUMNS):
        room.root[i] = 0.0
    fold(room.block, arguments[Argument.CAPACITY], 2 + priors, room.root, room.lanes)
    result = floats_at(arguments[Argument.ROOT] + 8 * COLUMNS * COLUMNS * row, COLUMNS * COLUMNS)
    for i in range(COLUMNS * COLUMNS):
        result[i] = room.root[i]


@njit(**JIT_OPTIONS)
def _row(row: int, arguments: Integers, room: _Room) -> None:
    sky = floats_at(arguments[Argument.SKY] + 8 * _SKY * row, _SKY)
    detectors, alone = arguments[Argument.DETECTORS], arguments[Argument.DERIVATIVES] == 0
    for i in range(COLUMNS * COLUMNS):
        room.root[i] = 0.0
    for i in range(detectors * LANES):
        room.squares[i] = 0.0
    used, done = 0, 0
    for panel in range(arguments[Argument.PANELS]):
        vectors = 2 * _rows_of(panel, arguments) * _detectors_of(panel, arguments)[0]
        if used + vectors > arguments[Argument.CAPACITY]:
            fold(room.block, arguments[Argument.CAPACITY], used, room.root, room.lanes)
            used = 0
        _fill_panel(row, panel, used, sky, arguments, room)
        _add_squares(panel, used, arguments, room)
        if arguments[Argument.WHITENED] != 0:
            _copy(row, done, used, vectors, arguments, room)
        done += vectors
        if not alone:
            used += vectors
    squares = floats_at(arguments[Argument.SQUARES] + 8 * detectors * row, detectors)
    for d in range(detectors):
        total = lane_sum(load(room.squares, LANES * d), room.lanes)
        squares[d] = total * sky[Sky.DISTANCE] * sky[Sky.DISTANCE]
    if not alone:
        fold(room.block, arguments[Argument.CAPACITY], used, room.root, room.lanes)
        _finish(row, arguments, room)


@njit(**JIT_OPTIONS)
def _refuse(row: int, arguments: Integers) -> None:
    """NaN for everything of a row that was not evaluated."""
    detectors = arguments[Argument.DETECTORS]
    floats_at(arguments[Argument.SQUARES] + 8 * detectors * row, detectors)[:] = np.nan
    if arguments[Argument.DERIVATIVES] != 0:
        size = COLUMNS * COLUMNS
        floats_at(arguments[Argument.ROOT] + 8 * size * row, size)[:] = np.nan


@njit(**JIT_OPTIONS)
def factorise(arguments: Integers) -> int:
    """Triangles and squares of every row: see :class:`Argument`; returns 0."""
    room = _room(arguments)
    status = bytes_at(arguments[Argument.STATUS], arguments[Argument.ROWS])
    for row in range(arguments[Argument.ROWS]):
        if status[row] == 0:  # RowStatus.OK
            _row(row, arguments, room)
        else:
            _refuse(row, arguments)
    return 0
