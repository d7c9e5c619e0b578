"""Source of the compiled derivatives: from modes to what changes them. Compiled by :mod:`.build`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import RowStatus
from bnserve_surrogate.kernel._layout import ANY, COLUMNS, LANES, Argument, Column, Entry, Plan, PlanMode
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import bytes_at, finish_streams, floats_at, floats_in, integers_at, padded
from bnserve_surrogate.kernel._regression import fill_coordinates
from bnserve_surrogate.kernel.modes._synthesis import plan_mode
from bnserve_surrogate.tangents._coordinates import fill_jacobian
from bnserve_surrogate.tangents._layout import TANGENTS
from bnserve_surrogate.tangents._regression import synthesise_with_tangents
from bnserve_surrogate.tangents._room import row_of
from bnserve_surrogate.tangents._row import evaluate_row

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def differentiate(arguments: Integers) -> int:
    """Derivatives of the modes of rows on a prepared grid: see :mod:`._layout`. Returns zero."""
    rows = arguments[Argument.ROWS]
    for start in range(0, rows, LANES):
        _tile(start, min(start + LANES, rows), arguments)
    finish_streams()
    return 0


@njit(**JIT_OPTIONS)
def _tile(start: int, stop: int, arguments: Integers) -> None:
    """Up to eight rows."""
    contents, exponents = (
        integers_at(arguments[Argument.CONTENTS], 1 << 16),
        integers_at(arguments[Argument.EXPONENTS], ANY),
    )
    weights, scratch = floats_at(arguments[Argument.WEIGHTS], ANY), floats_at(arguments[Argument.SCRATCH], ANY)
    parameters = floats_at(arguments[Argument.PARAMETERS], stop * COLUMNS)
    status = bytes_at(arguments[Argument.STATUS], stop)
    jacobian = floats_in(scratch, 10 * LANES, 25 * LANES)
    coordinates = _coordinates(start, stop, contents, weights, parameters, scratch, jacobian)
    sizes = (padded(contents[Entry.AMPLITUDE_NODES]), padded(contents[Entry.PHASE_NODES]))
    width = 2 * (sizes[0] + sizes[1]) + LANES
    linear = floats_in(scratch, 40 * LANES, TANGENTS * LANES * width)
    beyond = 40 * LANES + TANGENTS * LANES * width
    extra = integers_at(arguments[Argument.MODES], ANY)[Plan.LINEAR] if arguments[Argument.MODES] != 0 else 0
    ratios, rest = floats_in(scratch, beyond, TANGENTS * extra), floats_in(scratch, beyond + TANGENTS * extra, ANY)
    synthesise_with_tangents(coordinates, jacobian, stop - start, contents, exponents, weights, width, linear, rest)
    if extra > 0:
        _ratios(stop - start, arguments, coordinates, jacobian, ratios, rest)
    for i in range(start, stop):
        if status[i] == RowStatus.OK:
            row = floats_in(parameters, i * COLUMNS, COLUMNS)
            state = row_of(
                arguments, contents, weights, linear, ratios, i - start, row, (sizes[0], sizes[1], width), rest
            )
            evaluate_row(i, state)
        else:
            _refuse(i, arguments)


@njit(**JIT_OPTIONS)
def _coordinates(
    start: int, stop: int, contents: Integers, weights: Floats, parameters: Floats, scratch: Floats, jacobian: Floats
) -> Floats:
    """What the regressor sees of eight rows, ``(5, 8)``, and its derivatives; the last is repeated where there are
    fewer."""
    intrinsic, coordinates = floats_in(scratch, 0, 5 * LANES), floats_in(scratch, 5 * LANES, 5 * LANES)
    scaling = floats_in(weights, contents[Entry.COORDINATES_AT], 11)
    for lane in range(LANES):
        row = floats_in(parameters, min(start + lane, stop - 1) * COLUMNS, COLUMNS)
        intrinsic[5 * lane], intrinsic[5 * lane + 1] = row[Column.MASS_RATIO], row[Column.CHI_1]
        intrinsic[5 * lane + 2], intrinsic[5 * lane + 3] = row[Column.CHI_2], row[Column.LAMBDA_1]
        intrinsic[5 * lane + 4] = row[Column.LAMBDA_2]
        fill_jacobian(row, contents, scaling, lane, jacobian)
    fill_coordinates(intrinsic, contents, scaling, floats_in(scratch, 35 * LANES, 5), coordinates)
    return coordinates


@njit(**JIT_OPTIONS)
def _ratios(
    rows: int, arguments: Integers, coordinates: Floats, jacobian: Floats, ratios: Floats, scratch: Floats
) -> None:
    """The linear synthesis of the ratios of all modes, and its derivatives."""
    plan = integers_at(arguments[Argument.MODES], ANY)
    for k in range(plan[Plan.MODES]):
        mode: Any = plan_mode(plan, k)
        if mode[PlanMode.POWER] > 0:
            contents = integers_at(mode[PlanMode.CONTENTS], ANY)
            exponents, weights = integers_at(mode[PlanMode.EXPONENTS], ANY), floats_at(mode[PlanMode.WEIGHTS], ANY)
            own = floats_in(ratios, TANGENTS * mode[PlanMode.LINEAR_AT], ANY)
            columns = 4 * padded(contents[Entry.PHASE_NODES])
            synthesise_with_tangents(coordinates, jacobian, rows, contents, exponents, weights, columns, own, scratch)


@njit(**JIT_OPTIONS)
def _refuse(i: int, arguments: Integers) -> None:
    """NaN for everything of a row that is not evaluated."""
    modes = integers_at(arguments[Argument.MODES], 1)[Plan.MODES] if arguments[Argument.MODES] != 0 else 1
    size = 2 * TANGENTS * modes * arguments[Argument.POINTS]
    floats_at(arguments[Argument.SECOND] + 8 * i * size, size)[:] = np.nan
