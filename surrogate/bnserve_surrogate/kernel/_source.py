"""Source of the fused kernel: from parameters to strain. Compiled ahead by :mod:`.build`.

Eight rows go through the regressor together, then each through its frequencies, block by block. A row is evaluated by
the same sequence of operations wherever it stands in a batch, whatever its neighbours and whichever thread runs it, so
its bits depend on the row, the grid and the model alone. Nothing is allocated, and nothing needs Python to run.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS, RowStatus
from bnserve_surrogate.kernel._layout import (
    ANY,
    COLUMNS,
    EDGE,
    LANES,
    LEAST_MF,
    MOST_PHASE,
    OTHER_GRID,
    Argument,
    Column,
    Entry,
    Output,
    Plan,
    Policy,
)
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import (
    bytes_at,
    finish_streams,
    floats_at,
    floats_in,
    integers_at,
    padded,
    singles_at,
)
from bnserve_surrogate.kernel._regression import fill_coordinates, synthesise
from bnserve_surrogate.kernel._row import evaluate_row
from bnserve_surrogate.kernel.modes._row import evaluate_modes
from bnserve_surrogate.kernel.modes._synthesis import fill_harmonics, synthesise_modes

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def evaluate(arguments: Integers) -> int:
    """Evaluate rows of parameters on a prepared grid: see :class:`Argument`. Returns OTHER_GRID or how many are bad."""
    points, stride = arguments[Argument.POINTS], arguments[Argument.STRIDE]
    grid = floats_at(arguments[Argument.GRID], 5 * stride)
    if arguments[Argument.GIVEN] != 0:
        given = floats_at(arguments[Argument.GIVEN], points)
        for j in range(points):
            if given[j] != grid[j]:
                return OTHER_GRID
    contents = integers_at(arguments[Argument.CONTENTS], 1 << 16)
    weights = floats_at(arguments[Argument.WEIGHTS], ANY)
    rows = arguments[Argument.ROWS]
    parameters = floats_at(arguments[Argument.PARAMETERS], rows * COLUMNS)
    status = bytes_at(arguments[Argument.STATUS], rows)
    plus, cross = floats_at(arguments[Argument.PLUS], rows), floats_at(arguments[Argument.CROSS], 2 * rows)
    bad, least = 0, LEAST_MF
    if arguments[Argument.MODES] != 0:
        least *= integers_at(arguments[Argument.MODES], ANY)[Plan.SLOWEST] / 2.0
    for i in range(rows):
        row = parameters[i * COLUMNS : (i + 1) * COLUMNS]
        limits, band = weights[contents[Entry.LIMITS_AT] :], weights[contents[Entry.BAND_AT] :]
        code = _status(row, grid[0], grid[points - 1], limits, band, arguments[Argument.POLICY], least)
        status[i] = code
        cosine = np.cos(row[Column.INCLINATION]) if code == RowStatus.OK else np.nan
        if arguments[Argument.MODES] != 0:
            fill_harmonics(i, cosine, np.sin(row[Column.INCLINATION]), arguments)
        else:
            plus[i] = 0.5 * (1.0 + cosine * cosine)
            cross[2 * i] = 0.0
            cross[2 * i + 1] = -cosine
        bad += code != RowStatus.OK
    if bad > 0 and arguments[Argument.POLICY] & Policy.STOP_AT_BAD_ROWS != 0:
        return bad
    for start in range(0, rows, LANES):
        stop = min(start + LANES, rows)
        if arguments[Argument.MODES] != 0:
            _tile_of_modes(start, stop, arguments, contents, weights, parameters, status)
        else:
            _tile(start, stop, arguments, contents, weights, parameters, status, plus, cross)
    finish_streams()
    return bad


@njit(**JIT_OPTIONS)
def _status(row: Floats, first: float, last: float, limits: Floats, band: Floats, policy: int, least: float) -> int:
    """The RowStatus of one row on frequencies from ``first`` to ``last``; as :func:`bnserve_surrogate._domain`."""
    inside = True
    for i in range(COLUMNS):
        if not np.isfinite(row[i]):
            return RowStatus.NOT_FINITE
        inside &= (row[i] >= limits[i]) & (row[i] <= limits[COLUMNS + i])
    inside &= row[Column.DISTANCE] > 0.0
    inside &= abs(row[Column.REFERENCE_PHASE]) + (2.0 * np.pi * last) * abs(row[Column.TIME_SHIFT]) <= MOST_PHASE
    if not inside:
        return RowStatus.OUT_OF_DOMAIN
    mass = row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
    outside = first * mass < least
    if policy & Policy.ABOVE_BAND_IS_ERROR != 0:
        outside |= last * mass > band[1] * (1.0 + EDGE)
    if policy & Policy.BELOW_BAND_IS_ERROR != 0:
        outside |= first * mass < band[3] * (1.0 - EDGE)
    return RowStatus.OUT_OF_BAND if outside else RowStatus.OK


@njit(inline="always")
def _coordinates(
    start: int, stop: int, contents: Integers, weights: Floats, parameters: Floats, scratch: Floats
) -> Floats:
    """What the regressor sees of eight rows, in the first 80 places of the scratch."""
    intrinsic, coordinates = floats_in(scratch, 0, 5 * LANES), floats_in(scratch, 5 * LANES, 5 * LANES)
    _intrinsic(parameters, start, stop, intrinsic)
    scaling = floats_in(weights, contents[Entry.COORDINATES_AT], 11)
    fill_coordinates(intrinsic, contents, scaling, floats_in(scratch, 10 * LANES, 5), coordinates)
    return coordinates


@njit(inline="always")
def _intrinsic(parameters: Floats, start: int, stop: int, out: Floats) -> None:
    """The regressor's parameters of eight rows; the last is repeated where there are fewer."""
    for lane in range(LANES):
        row = floats_in(parameters, min(start + lane, stop - 1) * COLUMNS, COLUMNS)
        out[5 * lane], out[5 * lane + 1] = row[Column.MASS_RATIO], row[Column.CHI_1]
        out[5 * lane + 2], out[5 * lane + 3] = row[Column.CHI_2], row[Column.LAMBDA_1]
        out[5 * lane + 4] = row[Column.LAMBDA_2]


@njit(**JIT_OPTIONS)
def _tile(
    start: int, stop: int, arguments: Integers, contents: Integers, weights: Floats, parameters: Floats,
    status: NDArray[np.uint8], plus: Floats, cross: Floats,
) -> None:  # fmt: skip
    """Up to eight rows of the (2, 2)."""
    scratch = floats_at(arguments[Argument.SCRATCH], ANY)
    coordinates = _coordinates(start, stop, contents, weights, parameters, scratch)
    width = 2 * (padded(contents[Entry.AMPLITUDE_NODES]) + padded(contents[Entry.PHASE_NODES])) + LANES
    linear = floats_in(scratch, 10 * LANES, width * LANES)
    rest = floats_in(scratch, (10 + width) * LANES, ANY)
    exponents = integers_at(arguments[Argument.EXPONENTS], ANY)
    outputs = synthesise(coordinates, stop - start, contents, exponents, weights, width, linear, rest)
    per_row = LANES + padded(contents[Entry.OUTPUTS])
    if arguments[Argument.ESTIMATES] != 0:
        estimates = floats_at(arguments[Argument.ESTIMATES], stop)
        for i in range(start, stop):
            estimates[i] = np.exp(outputs[(i - start) * per_row + LANES - 1 + contents[Entry.OUTPUTS]])
    for i in range(start, stop):
        if status[i] == RowStatus.OK:
            values = floats_in(linear, (i - start) * width, width)
            row = floats_in(parameters, i * COLUMNS, COLUMNS)
            evaluate_row(i, row, values, arguments, contents, weights, rest, plus[i], cross[2 * i + 1])
        else:
            _refuse_row(i, arguments)


@njit(**JIT_OPTIONS)
def _tile_of_modes(
    start: int, stop: int, arguments: Integers, contents: Integers, weights: Floats, parameters: Floats,
    status: NDArray[np.uint8],
) -> None:  # fmt: skip
    """Up to eight rows of several modes, or of another than the (2, 2)."""
    scratch = floats_at(arguments[Argument.SCRATCH], ANY)
    coordinates = _coordinates(start, stop, contents, weights, parameters, scratch)
    plan = integers_at(arguments[Argument.MODES], ANY)
    width = 4 * padded(contents[Entry.PHASE_NODES]) + LANES
    linear = floats_in(scratch, 10 * LANES, width * LANES)
    ratios = floats_in(scratch, (10 + width) * LANES, plan[Plan.LINEAR])
    rest = floats_in(scratch, (10 + width) * LANES + plan[Plan.LINEAR], ANY)
    synthesise_modes(start, stop, arguments, contents, weights, coordinates, linear, ratios, rest)
    for i in range(start, stop):
        if status[i] == RowStatus.OK:
            own = floats_in(linear, (i - start) * width, width)
            row = floats_in(parameters, i * COLUMNS, COLUMNS)
            evaluate_modes(i, i - start, row, own, ratios, arguments, contents, weights, rest)
        else:
            _refuse_row(i, arguments)


@njit(**JIT_OPTIONS)
def _refuse_row(i: int, arguments: Integers) -> None:
    """NaN for everything that a row which is not evaluated would have had."""
    points, output = arguments[Argument.POINTS], arguments[Argument.OUTPUT]
    if arguments[Argument.MODES] != 0 and output in (Output.STRAIN, Output.STRAIN_SINGLE):
        points *= integers_at(arguments[Argument.MODES], 1)[0]
    if arguments[Argument.ESTIMATES] != 0:
        floats_at(arguments[Argument.ESTIMATES], i + 1)[i] = np.nan
    size = points if output == Output.AMPLITUDE_PHASE else 2 * points
    for address in (arguments[Argument.FIRST], arguments[Argument.SECOND]):
        if address != 0:
            if output in (Output.STRAIN_SINGLE, Output.POLARIZATIONS_SINGLE):
                singles_at(address + 4 * i * size, size)[:] = np.nan
            else:
                floats_at(address + 8 * i * size, size)[:] = np.nan
