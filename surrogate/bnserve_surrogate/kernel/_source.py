"""Source of the fused kernel: from parameters to strain. Compiled ahead by :mod:`.build`.

Eight rows go through the regressor together, then each through its frequencies, block by block. A row is evaluated by
the same sequence of operations wherever it stands in a batch, whatever its neighbours and whichever thread runs it, so
its bits depend on the row, the grid and the model alone. Nothing is allocated, and nothing needs Python to run.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.kernel import _codes as c
from bnserve_surrogate.kernel._arguments import OTHER_GRID
from bnserve_surrogate.kernel._cells import LANES
from bnserve_surrogate.kernel._layout import TILE
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._regression import multiply, regress
from bnserve_surrogate.kernel._row import ANY, EDGE, evaluate_row
from bnserve_surrogate.kernel._simd import bytes_at, finish_streams, floats_at, floats_in, integers_at, singles_at

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

MOST_PHASE = 1e14
"""Radians; doubles of this size are 0.016 apart, and of 1e16 more than a turn."""
LEAST_MF = 1e-9
"""M f below which the post-Newtonian phase exceeds that: 7e-5 Hz at 2.8 solar masses."""


@njit(**JIT_OPTIONS)
def evaluate(arguments: Integers) -> int:
    """Evaluate rows of parameters on a prepared grid: see :class:`Argument`. Returns OTHER_GRID or how many are bad."""
    points, stride = arguments[c.POINTS], arguments[c.STRIDE]
    grid = floats_at(arguments[c.GRID], 5 * stride)
    if arguments[c.GIVEN] != 0:
        given = floats_at(arguments[c.GIVEN], points)
        for j in range(points):
            if given[j] != grid[j]:
                return OTHER_GRID
    contents = integers_at(arguments[c.CONTENTS], 1 << 16)
    weights = floats_at(arguments[c.WEIGHTS], ANY)
    rows = arguments[c.ROWS]
    parameters = floats_at(arguments[c.PARAMETERS], rows * c.COLUMNS)
    status = bytes_at(arguments[c.STATUS], rows)
    plus, cross = floats_at(arguments[c.PLUS], rows), floats_at(arguments[c.CROSS], 2 * rows)
    bad = 0
    for i in range(rows):
        row = parameters[i * c.COLUMNS : (i + 1) * c.COLUMNS]
        limits, band = weights[contents[c.LIMITS_AT] :], weights[contents[c.BAND_AT] :]
        code = _status(row, grid[0], grid[points - 1], limits, band, arguments[c.POLICY])
        status[i] = code
        cosine = np.cos(row[c.INCLINATION]) if code == c.OK else np.nan
        plus[i] = 0.5 * (1.0 + cosine * cosine)
        cross[2 * i] = 0.0
        cross[2 * i + 1] = -cosine
        bad += code != c.OK
    if bad > 0 and arguments[c.POLICY] & c.STOP != 0:
        return bad
    for start in range(0, rows, LANES):
        _tile(start, min(start + LANES, rows), arguments, contents, weights, parameters, status, plus, cross)
    finish_streams()
    return bad


@njit(**JIT_OPTIONS)
def _status(row: Floats, first: float, last: float, limits: Floats, band: Floats, policy: int) -> int:
    """The RowStatus of one row on frequencies from ``first`` to ``last``; as :func:`bnserve_surrogate._domain`."""
    inside = True
    for i in range(c.COLUMNS):
        if not np.isfinite(row[i]):
            return c.NOT_FINITE
        inside &= (row[i] >= limits[i]) & (row[i] <= limits[c.COLUMNS + i])
    inside &= row[c.DISTANCE] > 0.0
    inside &= abs(row[c.REFERENCE_PHASE]) + (2.0 * np.pi * last) * abs(row[c.TIME_SHIFT]) <= MOST_PHASE
    if not inside:
        return c.OUT_OF_DOMAIN
    mass = row[c.TOTAL_MASS] * SOLAR_MASS_SECONDS
    outside = first * mass < LEAST_MF
    if policy & c.ABOVE != 0:
        outside |= last * mass > band[1] * (1.0 + EDGE)
    if policy & c.BELOW != 0:
        outside |= first * mass < band[0] * (1.0 - EDGE)
    return c.OUT_OF_BAND if outside else c.OK


@njit(**JIT_OPTIONS)
def _tile(
    start: int,
    stop: int,
    arguments: Integers,
    contents: Integers,
    weights: Floats,
    parameters: Floats,
    status: NDArray[np.uint8],
    plus: Floats,
    cross: Floats,
) -> None:
    """Up to eight rows."""
    scratch = floats_at(arguments[c.SCRATCH], ANY)
    intrinsic = floats_in(scratch, 0, 5 * LANES)
    for lane in range(LANES):
        row = floats_in(parameters, min(start + lane, stop - 1) * c.COLUMNS, c.COLUMNS)
        intrinsic[5 * lane], intrinsic[5 * lane + 1] = row[c.MASS_RATIO], row[c.CHI_1]
        intrinsic[5 * lane + 2], intrinsic[5 * lane + 3] = row[c.CHI_2], row[c.LAMBDA_1]
        intrinsic[5 * lane + 4] = row[c.LAMBDA_2]
    n_a = (contents[c.AMPLITUDE_NODES] + LANES - 1) // LANES * LANES
    n_p = (contents[c.PHASE_NODES] + LANES - 1) // LANES * LANES
    width = 2 * (n_a + n_p) + LANES
    linear = floats_in(scratch, 5 * LANES, width * LANES)
    rest = floats_in(scratch, (5 + width) * LANES, ANY)
    exponents = integers_at(arguments[c.EXPONENTS], ANY)
    outputs = regress(intrinsic, stop - start, contents, exponents, weights, rest)
    per_row = LANES + (contents[c.OUTPUTS] + LANES - 1) // LANES * LANES
    synthesis = floats_in(weights, contents[c.SYNTHESIS_AT], ANY)
    for first in range(0, stop - start, TILE):
        scalars = floats_in(outputs, first * per_row + LANES - 1, ANY)
        own = floats_in(linear, first * width, ANY)
        multiply(1 + contents[c.OUTPUTS], scalars, per_row, 1, synthesis, width, own, width)
    if arguments[c.ESTIMATES] != 0:
        estimates = floats_at(arguments[c.ESTIMATES], stop)
        for i in range(start, stop):
            estimates[i] = np.exp(outputs[(i - start) * per_row + LANES - 1 + contents[c.OUTPUTS]])
    for i in range(start, stop):
        if status[i] == c.OK:
            values = floats_in(linear, (i - start) * width, width)
            row = floats_in(parameters, i * c.COLUMNS, c.COLUMNS)
            evaluate_row(i, row, values, arguments, contents, weights, rest, plus[i], cross[2 * i + 1])
        else:
            _refuse_row(i, arguments)


@njit(**JIT_OPTIONS)
def _refuse_row(i: int, arguments: Integers) -> None:
    """NaN for everything that a row which is not evaluated would have had."""
    points, output = arguments[c.POINTS], arguments[c.OUTPUT]
    if arguments[c.ESTIMATES] != 0:
        floats_at(arguments[c.ESTIMATES], i + 1)[i] = np.nan
    size = points if output == c.AMPLITUDE_PHASE else 2 * points
    for address in (arguments[c.FIRST], arguments[c.SECOND]):
        if address != 0:
            if output in (c.STRAIN_SINGLE, c.POLARIZATIONS_SINGLE):
                singles_at(address + 4 * i * size, size)[:] = np.nan
            else:
                floats_at(address + 8 * i * size, size)[:] = np.nan
