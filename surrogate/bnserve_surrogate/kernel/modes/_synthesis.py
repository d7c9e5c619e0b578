"""What modes need before any frequency: their harmonics, regressors and linear synthesis."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, COLUMNS, LANES, Argument, Column, Entry, Plan, PlanMode
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, integers_in, padded
from bnserve_surrogate.kernel._regression import synthesise

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
COEFFICIENTS = 5
"""Of each mode's harmonic, see :func:`bnserve_surrogate.kernel.modes._harmonics.harmonic`."""
_HEADER, _MODE = len(Plan), len(PlanMode)


@njit(inline="always")
def plan_mode(plan: Integers, k: int) -> Integers:
    """The places of mode number k."""
    return integers_in(plan, _HEADER + _MODE * k, _MODE)


@njit(inline="always")
def _factors(coefficients: Floats, order: int, cosine: float, sine: float) -> tuple[float, float]:
    """What a mode counts in the plus polarisation, and, times i, in the other one."""
    c, square = coefficients, cosine * cosine
    scale = sine if order & 1 else 1.0
    even, odd = c[0] + square * (c[2] + square * c[4]), cosine * (c[1] + square * c[3])
    return scale * even, 0.0 - scale * odd


@njit(**JIT_OPTIONS)
def fill_harmonics(i: int, cosine: float, sine: float, arguments: Integers) -> None:
    """Row ``i`` of both harmonic factors, from its inclination."""
    plan = integers_at(arguments[Argument.MODES], ANY)
    count = plan[Plan.MODES]
    numbers = floats_at(plan[Plan.NUMBERS], ANY)
    plus, cross = floats_at(arguments[Argument.PLUS], ANY), floats_at(arguments[Argument.CROSS], ANY)
    for k in range(count):
        mode = plan_mode(plan, k)
        place = i * count + mode[PlanMode.PLACE]
        coefficients = floats_in(numbers, COEFFICIENTS * k, COEFFICIENTS)
        plus[place], cross[2 * place + 1] = _factors(coefficients, mode[PlanMode.ORDER], cosine, sine)
        cross[2 * place] = 0.0 if cosine == cosine else np.nan


@njit(**JIT_OPTIONS)
def synthesise_modes(
    start: int, stop: int, arguments: Integers, contents: Integers, weights: Floats, coordinates: Floats,
    linear: Floats, ratios: Floats, scratch: Floats,
) -> None:  # fmt: skip
    """The linear synthesis of rows ``start`` to ``stop``, of the carrier and of every other mode; and their estimates.

    The estimate of a sum: what the errors of its modes have of the (2, 2)'s power, each as it is seen.
    """
    rows = stop - start
    plan = integers_at(arguments[Argument.MODES], ANY)
    if arguments[Argument.ESTIMATES] != 0:
        floats_at(arguments[Argument.ESTIMATES] + 8 * start, rows)[:] = 0.0
    exponents, width = integers_at(arguments[Argument.EXPONENTS], ANY), 4 * padded(contents[Entry.PHASE_NODES]) + LANES
    carrier = synthesise(coordinates, rows, contents, exponents, weights, width, linear, scratch)
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.POWER] == 0:
            _add_estimates(start, stop, mode, carrier, contents, arguments)
    for k in range(plan[Plan.MODES]):
        mode = plan_mode(plan, k)
        if mode[PlanMode.POWER] > 0:
            own, room = _arrays(mode), floats_in(ratios, mode[PlanMode.LINEAR_AT], ANY)
            columns = 4 * padded(own[0][Entry.PHASE_NODES])
            outputs = synthesise(coordinates, rows, own[0], own[1], own[2], columns, room, scratch)
            _add_estimates(start, stop, mode, outputs, own[0], arguments)


@njit(inline="always")
def _arrays(mode: Integers) -> Any:
    """Contents, exponents and weights of a mode."""
    contents, exponents = integers_at(mode[PlanMode.CONTENTS], ANY), integers_at(mode[PlanMode.EXPONENTS], ANY)
    return contents, exponents, floats_at(mode[PlanMode.WEIGHTS], ANY)


@njit(**JIT_OPTIONS)
def _add_estimates(
    start: int, stop: int, mode: Integers, outputs: Floats, contents: Integers, arguments: Integers
) -> None:
    """Add a mode's share, where the caller wants to know and the mode knows."""
    if arguments[Argument.ESTIMATES] == 0 or mode[PlanMode.ESTIMATES] == 0:
        return
    estimates = floats_at(arguments[Argument.ESTIMATES], stop)
    count = integers_at(arguments[Argument.MODES], 1)[Plan.MODES]
    plus, cross = floats_at(arguments[Argument.PLUS], ANY), floats_at(arguments[Argument.CROSS], ANY)
    parameters = floats_at(arguments[Argument.PARAMETERS], ANY)
    last = LANES - 1 + contents[Entry.OUTPUTS]
    per_row = LANES + padded(contents[Entry.OUTPUTS])
    for i in range(start, stop):
        square = np.cos(parameters[i * COLUMNS + Column.INCLINATION]) ** 2
        whole = 0.25 * (1.0 + square) * (1.0 + square) + square
        place = i * count + mode[PlanMode.PLACE]
        share = plus[place] * plus[place] + cross[2 * place + 1] * cross[2 * place + 1]
        estimates[i] += share / whole * np.exp(outputs[(i - start) * per_row + last])
