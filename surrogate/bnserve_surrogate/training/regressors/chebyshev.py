"""Products of Chebyshev polynomials of several coordinates in [-1, 1]: the terms of a polynomial surrogate."""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol import InvalidParameters

FloatArray: TypeAlias = NDArray[np.float64]
Exponents: TypeAlias = NDArray[np.uint8]
"""Degrees of the factors of every term, shape (T, D)."""


def weighted_exponents(degree: float, weights: Sequence[float]) -> Exponents:
    """All terms whose weighted degree, sum_i weights[i] * e_i, is at most ``degree``; lexicographic, shape (T, D).

    A large weight spends few terms on a coordinate. Degree 8 with weights (1, 0.8, 1, 1.5, 1.5) has 706 terms.

    Raises
    ------
    InvalidParameters
        If a weight is not positive, the degree is negative, or a single degree would exceed 64.
    """
    if not (0.0 <= degree < np.inf) or not weights or min(weights) <= 0.0 or degree / min(weights) > 64.0:
        raise InvalidParameters(
            "A weighted degree needs a finite degree >= 0, positive weights, and at most degree 64 in each."
        )
    # A rounding error must not decide whether a term is in: 0.8 * 10 counts as 8.
    terms: list[tuple[tuple[int, ...], float]] = [((), degree * (1.0 + 1e-9))]
    for weight in weights:
        terms = [
            ((*exponents, power), room - power * weight)
            for exponents, room in terms
            for power in range(int(room / weight) + 1)
        ]
    return np.array([exponents for exponents, _ in terms], dtype=np.uint8)


def chebyshev_terms(coordinates: ArrayLike, exponents: ArrayLike) -> FloatArray:
    """Values of the terms, shape (T, N), one row per term: prod_i T_{e_i}(coordinates[:, i]).

    Parameters
    ----------
    coordinates
        Shape (N, D). Outside [-1, 1] the polynomials grow quickly, and are still polynomials.
    exponents
        Shape (T, D).
    """
    points, degrees = np.asarray(coordinates, dtype=np.float64), np.asarray(exponents)
    if points.ndim != 2 or degrees.ndim != 2 or points.shape[1] != degrees.shape[1]:
        raise ValueError(
            f"Got {degrees.shape} exponents for coordinates of shape {points.shape}; the columns must agree."
        )
    product = np.ones((len(degrees), len(points)))
    for axis in range(points.shape[1]):
        product *= _chebyshev_table(points[:, axis], int(degrees[:, axis].max(initial=0)))[degrees[:, axis]]
    return product


def _chebyshev_table(x: FloatArray, degree: int) -> FloatArray:
    """T_0(x) ... T_degree(x), shape (degree + 1, N), by the three-term recurrence."""
    table = np.ones((degree + 1, len(x)))
    if degree > 0:
        table[1] = x
    for n in range(2, degree + 1):
        table[n] = 2.0 * x * table[n - 1] - table[n - 2]
    return table
