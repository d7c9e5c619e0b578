"""Derivatives of the regressor's coordinates."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import SPIN_ORBIT_WEIGHT, TIDAL_EXPONENT
from bnserve_surrogate.kernel._layout import COORDINATES, LANES, Column, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.tangents._layout import INTRINSIC

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_RAW, _SYMMETRIC = COORDINATES["raw"], COORDINATES["symmetric"]


@njit(**JIT_OPTIONS)
def fill_jacobian(row: Floats, contents: Integers, scaling: Floats, lane: int, out: Floats) -> None:
    """The derivatives of one row's five coordinates, scaled as these are: ``out[p, axis, lane]``, ``(5, 5, 8)``.

    ``scaling`` is as :func:`~bnserve_surrogate.kernel._regression.fill_coordinates` takes it: tides weaker than the
    least trained ones change nothing that was learnt.
    """
    kind, least = contents[Entry.COORDINATES], scaling[10]
    for place in range(INTRINSIC * 5):
        out[place * LANES + lane] = 0.0
    if kind == _RAW:
        _set(Column.MASS_RATIO, 0, 1.0, lane, out)
        _set(Column.CHI_1, 1, 1.0, lane, out)
        _set(Column.CHI_2, 2, 1.0, lane, out)
        _set(Column.LAMBDA_1, 3, 1.0 if row[Column.LAMBDA_1] >= least else 0.0, lane, out)
        _set(Column.LAMBDA_2, 4, 1.0 if row[Column.LAMBDA_2] >= least else 0.0, lane, out)
    else:
        _physical(row, least, kind == _SYMMETRIC, lane, out)
    for p in range(INTRINSIC):
        for axis in range(5):
            out[(5 * p + axis) * LANES + lane] *= scaling[5 + axis]


@njit(inline="always")
def _set(p: int, axis: int, value: float, lane: int, out: Floats) -> None:
    out[(5 * p + axis) * LANES + lane] = value


@njit(**JIT_OPTIONS)
def _physical(row: Floats, least: float, symmetric: bool, lane: int, out: Floats) -> None:
    """Of the coordinates that :func:`~bnserve_surrogate._coordinates.transform_physical` writes, or the others."""
    q, chi_1, chi_2 = row[Column.MASS_RATIO], row[Column.CHI_1], row[Column.CHI_2]
    x_1, x_2 = q / (1.0 + q), 1.0 / (1.0 + q)
    slope = x_2 * x_2
    _set(Column.MASS_RATIO, 0, 1.0 / q, lane, out)
    of_product = slope * (x_2 - x_1)
    along = slope * (chi_1 - chi_2) - SPIN_ORBIT_WEIGHT * of_product * (chi_1 + chi_2)
    _set(Column.MASS_RATIO, 3, along, lane, out)
    _set(Column.CHI_1, 3, x_1 - SPIN_ORBIT_WEIGHT * x_1 * x_2, lane, out)
    _set(Column.CHI_2, 3, x_2 - SPIN_ORBIT_WEIGHT * x_1 * x_2, lane, out)
    _set(Column.CHI_1, 4, 0.5, lane, out)
    _set(Column.CHI_2, 4, -0.5, lane, out)
    lambda_1, lambda_2 = max(row[Column.LAMBDA_1], least), max(row[Column.LAMBDA_2], least)
    one, other = lambda_1**TIDAL_EXPONENT, lambda_2**TIDAL_EXPONENT
    # Of the tides of the heavier and of the lighter star.
    by_ratio = (slope * one, 0.0 - slope * other)
    first = TIDAL_EXPONENT * x_1 * one / lambda_1 if row[Column.LAMBDA_1] >= least and lambda_1 > 0.0 else 0.0
    second = TIDAL_EXPONENT * x_2 * other / lambda_2 if row[Column.LAMBDA_2] >= least and lambda_2 > 0.0 else 0.0
    if symmetric:
        _set(Column.MASS_RATIO, 1, by_ratio[0] - by_ratio[1], lane, out)
        _set(Column.MASS_RATIO, 2, by_ratio[0] + by_ratio[1], lane, out)
        _set(Column.LAMBDA_1, 1, first, lane, out)
        _set(Column.LAMBDA_1, 2, first, lane, out)
        _set(Column.LAMBDA_2, 1, 0.0 - second, lane, out)
        _set(Column.LAMBDA_2, 2, second, lane, out)
    else:
        _set(Column.MASS_RATIO, 1, by_ratio[0], lane, out)
        _set(Column.MASS_RATIO, 2, by_ratio[1], lane, out)
        _set(Column.LAMBDA_1, 1, first, lane, out)
        _set(Column.LAMBDA_2, 2, second, lane, out)
