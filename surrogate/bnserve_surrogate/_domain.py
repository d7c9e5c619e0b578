"""Which rows a model may not evaluate, and what is said about them.

Beside those outside its domain, rows whose strain is larger than their numbers can be: infinity is no answer.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    PARAMETER_NAMES,
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    FieldError,
    InvalidParameters,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    ParameterDescription,
    RowStatus,
)
from bnserve_surrogate._artifact import limits_of
from bnserve_surrogate.kernel import EDGE, LEAST_MF, MOST_PHASE

_MAX_ERRORS = 20
"""Individual problems listed in one exception; the sentence gives their total."""
NEAR = 1e-40
"""Mpc. At 1 Mpc the strain of any binary stays below 1e-13 per Hz on all frequencies that are evaluated, so that only
nearer binaries than 3e-52 Mpc exceed complex64: nobody else has to be looked at. (The question takes 1.5 us for a
batch.)"""
_DISTANCE = PARAMETER_NAMES.index("distance_mpc")


def refuse_rows(
    batch: ParameterBatch,
    status: NDArray[np.uint8],
    frequencies: NDArray[np.float64],
    ranges: list[ParameterDescription],
    mf_band: tuple[float, float],
    least_mf: float = LEAST_MF,
) -> None:
    """Say what is wrong with the rows that the kernel did not evaluate.

    Parameters
    ----------
    batch
        N binaries.
    status
        What the kernel says of each, ``(N,)``: at least one is not OK.
    frequencies
        Increasing, in Hz.
    ranges
        The trained range of every parameter, in the order of the batch's columns.
    mf_band
        The trained band in M f (dimensionless).
    least_mf
        M f below which the phase exceeds double precision.

    Raises
    ------
    InvalidParameters
        A value is not finite, a distance is not positive, or the shifts of phase and time are so large that the phase
        is lost to rounding.
    OutOfDomain
        A value is outside its range.
    OutOfBand
        Frequencies outside the band where the options forbid it, or so low that the phase is lost to rounding.
    """
    values, finite = batch.values, np.isfinite(batch.values)
    if not finite.all():
        problems = _problems(~finite, values, ranges)
        raise InvalidParameters(_sentence(problems, int((~finite).sum()), "is not finite"), errors=problems)
    distance = values[:, 5] > 0.0
    if not distance.all():
        row = int(np.argmin(distance))
        problem = FieldError(reason="must be positive", parameter="distance_mpc", row=row, value=float(values[row, 5]))
        raise InvalidParameters(f"Row {row}: distance_mpc = {values[row, 5]} Mpc must be positive.", errors=[problem])
    with np.errstate(over="ignore"):
        shift = np.abs(values[:, 8]) + (2.0 * np.pi * frequencies[-1]) * np.abs(values[:, 9])
    if not (shift <= MOST_PHASE).all():
        row = int(np.argmin(shift <= MOST_PHASE))
        raise InvalidParameters(
            f"Row {row}: reference_phase = {values[row, 8]} and time_shift = {values[row, 9]} turn the phase by "
            f"{shift[row]:.3g} radians, of which double precision leaves no fraction of a turn; use smaller ones.",
            errors=[
                FieldError(reason="too large", parameter=name, row=row) for name in ("reference_phase", "time_shift")
            ],
        )
    minimum, maximum = limits_of(ranges)
    inside = (values >= minimum) & (values <= maximum)
    if not inside.all():
        problems = _problems(~inside, values, ranges)
        raise OutOfDomain(
            _sentence(problems, int((~inside).sum()), "is outside the trained range")
            + ' Use out_of_domain="flag" to get such rows back as NaN.',
            errors=problems,
        )
    raise _out_of_band(int(np.argmax(status == RowStatus.OUT_OF_BAND)), values, frequencies, mf_band, least_mf)


def refuse_reference_above(batch: ParameterBatch, evaluated: NDArray[np.bool_], frequency: float, top: float) -> None:
    """Refuse a reference ``frequency`` (Hz) above the band, which ends at the M f ``top``: no phase was learnt there.

    Raises
    ------
    OutOfBand
        It is above that of a row that is ``evaluated``, (N,).
    """
    masses = batch["total_mass"]
    above = evaluated & (frequency * masses * SOLAR_MASS_SECONDS > top * (1.0 + EDGE))
    if above.any():
        row = int(np.argmax(above))
        raise OutOfBand(
            f"Row {row}: reference_frequency = {frequency:g} Hz is above the model's band, which ends at "
            f"{top / (masses[row] * SOLAR_MASS_SECONDS):.6g} Hz at total mass {masses[row]:g} Msun; use a lower one.",
            errors=[FieldError(reason="above the band", parameter="reference_frequency", row=row, value=frequency)],
        )


def _out_of_band(
    row: int,
    values: NDArray[np.float64],
    frequencies: NDArray[np.float64],
    mf_band: tuple[float, float],
    least_mf: float,
) -> OutOfBand:
    hint = (
        " So low, its phase exceeds double precision."
        if frequencies[0] * values[row, 7] * SOLAR_MASS_SECONDS < least_mf
        else ""
    )
    low, high = (edge / (values[row, 7] * SOLAR_MASS_SECONDS) for edge in mf_band)
    return OutOfBand(
        f"Row {row}: the frequencies {frequencies[0]:g} to {frequencies[-1]:g} Hz do not fit the model's band at "
        f"total mass {values[row, 7]:g} Msun, {low:.6g} to {high:.6g} Hz.{hint}",
        errors=[FieldError(reason="outside the band", parameter="frequencies", row=row)],
    )


def _problems(
    bad: NDArray[np.bool_], values: NDArray[np.float64], ranges: list[ParameterDescription]
) -> list[FieldError]:
    problems = []
    for row, column in np.argwhere(bad)[:_MAX_ERRORS]:
        entry = ranges[column]
        value = float(values[row, column])
        low = "" if entry.minimum is None else f"{entry.minimum:g}"
        high = "" if entry.maximum is None else f"{entry.maximum:g}"
        reason = f"outside [{low}, {high}]" if np.isfinite(value) else "not finite"
        problems.append(
            FieldError(
                reason=reason, parameter=entry.name, row=int(row), value=value if np.isfinite(value) else str(value)
            )
        )
    return problems


def _sentence(problems: list[FieldError], total: int, what: str) -> str:
    first = problems[0]
    more = f" ({total} values in all)" if total > 1 else ""
    where = f"; it is {first.reason}" if "outside" in first.reason else ""
    return f"Row {first.row}: {first.parameter} = {first.value} {what}{where}{more}."


def refuse_overflow(
    batch: ParameterBatch,
    arrays: list[NDArray[Any]],
    of_rows: list[NDArray[Any]],
    status: NDArray[np.uint8],
    options: EvaluationOptions,
) -> None:
    """Flag the rows that were evaluated and are not finite, as those that were not evaluated are.

    Parameters
    ----------
    batch
        N binaries.
    arrays
        What was evaluated of them, each ``(N, M)``; the rows of those that overflow become NaN.
    of_rows
        The same of single numbers, each ``(N,)``.
    status
        Of every row; those that overflow become ``NOT_FINITE``.
    options
        Whether such rows are flagged.

    Raises
    ------
    InvalidParameters
        There is one, and the options do not have it flagged.
    """
    for row in np.flatnonzero((batch.values[:, _DISTANCE] < NEAR) & (status == RowStatus.OK)):
        if all(np.isfinite(array[row]).all() for array in arrays):
            continue
        if options.out_of_domain == "error":
            distance = float(batch.values[row, _DISTANCE])
            raise InvalidParameters(
                f"Row {row}: at distance_mpc = {distance:g} the strain is larger than the largest number of "
                f"{arrays[0].dtype}; use a larger distance.",
                errors=[FieldError(reason="too small", parameter="distance_mpc", row=int(row), value=distance)],
            )
        status[row] = RowStatus.NOT_FINITE
        for array in (*arrays, *of_rows):
            array[row] = complex(np.nan, np.nan) if array.dtype.kind == "c" else np.nan
