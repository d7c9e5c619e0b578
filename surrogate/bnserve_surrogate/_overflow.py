"""Rows whose strain is larger than their numbers can be: infinity is no answer, and such a row is not OK."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    PARAMETER_NAMES,
    EvaluationOptions,
    FieldError,
    InvalidParameters,
    ParameterBatch,
    RowStatus,
)

NEAR = 1e-40
"""Mpc. At 1 Mpc the strain of any binary stays below 1e-13 per Hz on all frequencies that are evaluated, so that only
nearer binaries than 3e-52 Mpc exceed complex64: nobody else has to be looked at. (The question takes 1.5 us for a
batch.)"""
_DISTANCE = PARAMETER_NAMES.index("distance_mpc")


def is_any_near(batch: ParameterBatch) -> bool:
    """Whether the strain of any row may be too large."""
    return bool((batch.values[:, _DISTANCE] < NEAR).any())


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
    batch:
        N binaries.
    arrays:
        What was evaluated of them, each ``(N, M)``; the rows of those that overflow become NaN.
    of_rows:
        The same of single numbers, each ``(N,)``.
    status:
        Of every row; those that overflow become ``NOT_FINITE``.
    options:
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
