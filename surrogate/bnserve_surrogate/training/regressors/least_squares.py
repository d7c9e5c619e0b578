r"""Least squares for many samples and many outputs, through the normal equations, with care.

Minimises :math:`\frac1N \sum_i \|y_i - B_i c\|^2 + \rho \|c\|^2`. The Gram matrix of Chebyshev products is well
conditioned; what squaring the condition number costs is won back by iterative refinement against the samples. Terms
that depend linearly on others (a coordinate that does not vary makes such) are found by pivoting and get coefficients
zero.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_solve, lapack, solve_triangular

FloatArray: TypeAlias = NDArray[np.float64]
Basis: TypeAlias = Callable[[FloatArray], FloatArray]
"""Points (n, D) -> values of the T terms, shape (T, n)."""

_ROWS = 8192
"""Samples per piece: bounds the memory to T times this."""
_RANK_TOLERANCE = 1e-12
"""Pivots of the Gram matrix (unit diagonal) below this belong to dependent terms."""
_REFINEMENTS = 2
"""Each gains the digits that the Cholesky factor has; two reach rounding for condition numbers up to 1e6."""


@dataclass(frozen=True)
class Solution:
    """Coefficients and what is needed to judge and thin them.

    ``coefficients``: (T, K). ``independent``: indices (r,) of the terms that were used. ``scale``: (r,), makes the Gram
    matrix's diagonal one. ``factor``: lower Cholesky factor (r, r) of the scaled matrix G + ridge.
    """

    coefficients: FloatArray
    independent: NDArray[np.intp]
    scale: FloatArray
    factor: FloatArray


def solve(basis: Basis, points: FloatArray, targets: FloatArray, ridge: float = 0.0) -> Solution:
    """Least-squares coefficients of ``basis`` for targets (N, K) at points (N, D)."""
    gram, moment = _normal_equations(basis, points, targets)
    gram[np.diag_indices_from(gram)] += ridge
    independent = _independent_terms(gram)
    scale = 1.0 / np.sqrt(gram[independent, independent])
    scaled = gram[np.ix_(independent, independent)] * np.multiply.outer(scale, scale)
    factor = np.asarray(np.linalg.cholesky(scaled), dtype=np.float64)
    coefficients = np.zeros(moment.shape)
    gradient = moment
    for refinement in range(_REFINEMENTS + 1):
        if refinement:
            gradient = _gradient(basis, points, targets, coefficients) - ridge * coefficients
        step = cho_solve((factor, True), gradient[independent] * scale[:, None])
        coefficients[independent] += step * scale[:, None]
    return Solution(coefficients, independent, scale, factor)


def leave_one_out_residuals(basis: Basis, points: FloatArray, targets: FloatArray, solution: Solution) -> FloatArray:
    """y_i minus the prediction of the fit that would not have seen sample i, (N, K): residual / (1 - leverage)."""
    residuals = np.empty(targets.shape)
    for piece, terms in _pieces(basis, points):
        used = terms[solution.independent] * solution.scale[:, None]
        leverage = np.sum(solve_triangular(solution.factor, used, lower=True) ** 2, axis=0) / len(points)
        residual = targets[piece] - terms.T @ solution.coefficients
        # A leverage of one means that a sample determines a term alone; rounding must not make it more than one.
        residuals[piece] = residual / np.maximum(1.0 - leverage, 1e-6)[:, None]
    return residuals


def most_useful_terms(solution: Solution, terms: int, output_weights: FloatArray) -> NDArray[np.intp]:
    r"""Indices, increasing, of the ``terms`` terms that are left when the least useful one is removed again and again.

    Removing term t and refitting the others raises the loss by :math:`\sum_k w_k c_{tk}^2 / (G^{-1})_{tt}`; each step
    takes the smallest, and updates the coefficients and the inverse as if refitted.
    """
    inverse = cho_solve((solution.factor, True), np.eye(len(solution.factor)))
    coefficients = solution.coefficients[solution.independent] / solution.scale[:, None] * np.sqrt(output_weights)
    left = np.arange(len(inverse))
    while len(left) > terms:
        cost = np.sum(coefficients**2, axis=1) / np.diagonal(inverse)
        worst = int(np.argmin(cost))
        column = inverse[:, worst] / inverse[worst, worst]
        coefficients -= np.multiply.outer(column, coefficients[worst])
        inverse -= np.multiply.outer(column, inverse[worst])
        # The last one takes the place of the removed one: no copy of the matrix.
        last = len(left) - 1
        for array in (left, coefficients, inverse, inverse.T):
            array[worst] = array[last]
        left, coefficients, inverse = left[:last], coefficients[:last], inverse[:last, :last]
    return np.sort(solution.independent[left])


def _pieces(basis: Basis, points: FloatArray) -> Iterator[tuple[slice, FloatArray]]:
    for start in range(0, len(points), _ROWS):
        piece = slice(start, start + _ROWS)
        yield piece, basis(points[piece])


def _normal_equations(basis: Basis, points: FloatArray, targets: FloatArray) -> tuple[FloatArray, FloatArray]:
    gram, moment = np.zeros((1, 1)), np.zeros((1, 1))
    for piece, terms in _pieces(basis, points):
        gram = gram + terms @ terms.T
        moment = moment + terms @ targets[piece]
    return gram / len(points), moment / len(points)


def _gradient(basis: Basis, points: FloatArray, targets: FloatArray, coefficients: FloatArray) -> FloatArray:
    total = np.zeros(coefficients.shape)
    for piece, terms in _pieces(basis, points):
        total += terms @ (targets[piece] - terms.T @ coefficients)
    return total / len(points)


def _independent_terms(gram: FloatArray) -> NDArray[np.intp]:
    """Indices, increasing, of a maximal set of terms that are linearly independent over the samples."""
    diagonal = np.diagonal(gram)
    present = np.flatnonzero(diagonal > 0.0)
    scale = 1.0 / np.sqrt(diagonal[present])
    scaled = gram[np.ix_(present, present)] * np.multiply.outer(scale, scale)
    _, pivots, rank, _ = lapack.dpstrf(scaled, lower=1, tol=_RANK_TOLERANCE)
    return np.sort(present[np.asarray(pivots[:rank], dtype=np.intp) - 1])
