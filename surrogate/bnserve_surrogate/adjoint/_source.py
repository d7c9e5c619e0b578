"""Source of the compiled adjoint: from what changes with modes to what changes with their parameters. Compiled by
:mod:`.build`.

What the phase and the logarithm of the amplitude are linear in comes first: over the frequencies the bars are summed,
times the powers of the series and of the splines' cells. So a parameter costs nothing at a frequency, and no derivative
of a mode is ever formed.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import RowStatus
from bnserve_surrogate.adjoint._layout import SUMS
from bnserve_surrogate.adjoint._ratio import bars_at
from bnserve_surrogate.adjoint._regression import regress_back
from bnserve_surrogate.adjoint._row import row_back
from bnserve_surrogate.kernel._layout import ANY, COLUMNS, LANES, Argument, Entry, Plan, PlanMode
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import bytes_at, floats_at, floats_in, integers_at, padded
from bnserve_surrogate.kernel._regression import synthesise
from bnserve_surrogate.kernel.modes._synthesis import _arrays, plan_mode
from bnserve_surrogate.tangents._layout import TANGENTS
from bnserve_surrogate.tangents._room import row_of
from bnserve_surrogate.tangents._source import _coordinates

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def pull_back(arguments: Integers) -> int:
    """Derivatives of a function of the modes of rows on a prepared grid: see :mod:`._layout`. Returns zero."""
    rows = arguments[Argument.ROWS]
    for start in range(0, rows, LANES):
        _tile(start, min(start + LANES, rows), arguments)
    return 0


@njit(**JIT_OPTIONS)
def _tile(start: int, stop: int, arguments: Integers) -> None:
    """Up to eight rows."""
    contents, exponents = (
        integers_at(arguments[Argument.CONTENTS], 1 << 16),
        integers_at(arguments[Argument.EXPONENTS], ANY),
    )
    weights, room = floats_at(arguments[Argument.WEIGHTS], ANY), floats_at(arguments[Argument.SCRATCH], ANY)
    sums, scratch = floats_in(room, 0, SUMS), floats_in(room, SUMS, ANY)
    parameters = floats_at(arguments[Argument.PARAMETERS], stop * COLUMNS)
    status, rows = bytes_at(arguments[Argument.STATUS], stop), stop - start
    out = floats_at(arguments[Argument.PLUS] + 8 * TANGENTS * start, TANGENTS * rows)
    jacobian = floats_in(scratch, 10 * LANES, 25 * LANES)
    coordinates = _coordinates(start, stop, contents, weights, parameters, scratch, jacobian)
    sizes = (padded(contents[Entry.AMPLITUDE_NODES]), padded(contents[Entry.PHASE_NODES]))
    width = 2 * (sizes[0] + sizes[1]) + LANES
    linear = floats_in(scratch, 40 * LANES, TANGENTS * LANES * width)
    bars = floats_in(linear, LANES * width, LANES * width)
    beyond = 40 * LANES + TANGENTS * LANES * width
    extra = integers_at(arguments[Argument.MODES], ANY)[Plan.LINEAR] if arguments[Argument.MODES] != 0 else 0
    ratios, rest = floats_in(scratch, beyond, TANGENTS * extra), floats_in(scratch, beyond + TANGENTS * extra, ANY)
    synthesise(coordinates, rows, contents, exponents, weights, width, linear, rest)
    _clear(bars, LANES * width)
    if extra > 0:
        _ratios(rows, arguments, coordinates, ratios, rest)
    for i in range(start, stop):
        own = floats_in(out, TANGENTS * (i - start), TANGENTS)
        if status[i] == RowStatus.OK:
            row = floats_in(parameters, i * COLUMNS, COLUMNS)
            state = row_of(
                arguments, contents, weights, linear, ratios, i - start, row, (sizes[0], sizes[1], width), rest
            )
            row_back(i, state, sums, bars, own)
        else:
            own[:] = np.nan
    regress_back(coordinates, jacobian, rows, contents, exponents, weights, width, bars, rest, out)
    if extra > 0:
        _ratios_back(rows, arguments, coordinates, jacobian, ratios, rest, out)


@njit(**JIT_OPTIONS)
def _clear(numbers: Floats, count: int) -> None:
    for i in range(count):
        numbers[i] = 0.0


@njit(**JIT_OPTIONS)
def _ratios(rows: int, arguments: Integers, coordinates: Floats, ratios: Floats, scratch: Floats) -> None:
    """The linear synthesis of the ratios of all modes, and no bars of it yet."""
    plan = integers_at(arguments[Argument.MODES], ANY)
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.POWER] > 0:
            contents, exponents, weights = _arrays(mode)
            count = padded(contents[Entry.PHASE_NODES])
            own = floats_in(ratios, TANGENTS * mode[PlanMode.LINEAR_AT], 8 * LANES * count)
            synthesise(coordinates, rows, contents, exponents, weights, 4 * count, own, scratch)
            _clear(floats_in(ratios, bars_at(mode, count), 4 * LANES * count), 4 * LANES * count)


@njit(**JIT_OPTIONS)
def _ratios_back(
    rows: int, arguments: Integers, coordinates: Floats, jacobian: Floats, ratios: Floats, scratch: Floats, out: Floats
) -> None:
    """What the bars of all ratios say of the parameters."""
    plan = integers_at(arguments[Argument.MODES], ANY)
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.POWER] > 0:
            contents, exponents, weights = _arrays(mode)
            count = padded(contents[Entry.PHASE_NODES])
            bars = floats_in(ratios, bars_at(mode, count), 4 * LANES * count)
            regress_back(coordinates, jacobian, rows, contents, exponents, weights, 4 * count, bars, scratch, out)
