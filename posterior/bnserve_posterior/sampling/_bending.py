"""Coordinates learnt from weighted points, in which curved ridges are straight.

Each coordinate, from the widest to the one that the others determine best, less a polynomial of those before
it: a triangular map whose volume is constant and which is undone one coordinate after the other. What is left of a
banana is its thickness.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_RIDGE = 1e-3
"""Of the least squares, in units of the points' own spread: few points do not bend."""
_POINTS_PER_TERM = {1: 0, 2: 10, 3: 60}
"""Effective points for each term of a polynomial, by its degree; the third costs a second for ten thousand points."""
_ORDERING = 2000
"""At most so many points say which coordinate is before which."""
_FARTHEST, _FARTHEST_CUBES = 8.0, 4.0
"""Standard deviations: farther out polynomials stay as they are here, and do not run away."""


class Bending(NamedTuple):
    """Centre and width ``(D,)``, the order of the coordinates, and each one's polynomial of those before it, ``(D, T)``
    with zeros behind, of a degree."""

    centre: Floats
    width: Floats
    order: NDArray[np.int64]
    polynomials: Floats
    degree: int

    @classmethod
    def fit(cls, y: Floats, weights: Floats) -> Bending:
        """To points ``(N, D)`` with weights that sum to one."""
        centre = weights @ y
        width = np.sqrt(weights @ (y - centre) ** 2)
        width = np.where(width > 0.0, width, 1.0)
        z = (y - centre) / width
        dimensions = y.shape[1]
        effective = 1.0 / np.sum(weights**2)
        degree = max(d for d, points in _POINTS_PER_TERM.items() if effective > points * _count(dimensions, d))
        order = _order(z, weights, degree)
        z = z[:, order]
        products, sums = _moments(_terms(z, degree), z, weights)
        polynomials = np.zeros((dimensions, _count(dimensions, degree)))
        for column in range(dimensions):
            before = _count(column, degree)
            polynomials[column, :before] = np.linalg.solve(products[:before, :before], sums[:before, column])
        return cls(centre, width, order, polynomials, degree)

    def straight(self, y: Floats) -> Floats:
        """From coordinates ``(N, D)`` to straight ones."""
        z = ((y - self.centre) / self.width)[:, self.order]
        return np.asarray(z - (self.polynomials @ _terms(z, self.degree)).T)

    def bent(self, x: Floats) -> Floats:
        """The way back."""
        z = x.copy()
        terms = np.ones((self.polynomials.shape[1], len(x)))
        for column in range(z.shape[1]):
            before, after = _count(column, self.degree), _count(column + 1, self.degree)
            z[:, column] += self.polynomials[column, :before] @ terms[:before]
            _add_terms(terms[before:after], z, column, self.degree)
        y = np.empty_like(z)
        y[:, self.order] = z
        return y * self.width + self.centre

    @property
    def log_volume(self) -> float:
        """ln of the volume of straight coordinates over that of coordinates."""
        return float(-np.sum(np.log(self.width)))


def _order(z: Floats, weights: Floats, degree: int) -> NDArray[np.int64]:
    """The columns of ``(N, D)``, from the one of which polynomials of all others leave the most variance."""
    some = slice(None, None, -(-len(z) // _ORDERING))
    z, weights = z[some], weights[some] / weights[some].sum()
    terms, left = _terms(z, degree), []
    products, sums = _moments(terms, z, weights)
    for column in range(z.shape[1]):
        others = np.flatnonzero(~_has(column, z.shape[1], degree))
        polynomial = np.linalg.solve(products[np.ix_(others, others)], sums[others, column])
        left.append(weights @ (z[:, column] - polynomial @ terms[others]) ** 2)
    return np.argsort(left)[::-1].astype(np.int64)


def _moments(terms: Floats, z: Floats, weights: Floats) -> tuple[Floats, Floats]:
    """Weighted products of terms ``(T, N)`` with each other and with the columns of ``(N, D)``, for least squares."""
    roots = np.sqrt(weights)
    heavy = terms * roots
    return heavy @ heavy.T + _RIDGE * np.eye(len(terms)), heavy @ (z * roots[:, None])


def _count(columns: int, degree: int) -> int:
    """Terms of a polynomial."""
    each = {1: 1, 2: 1 + (columns + 1) / 2, 3: 2 + (columns + 1) / 2 + columns}
    return 1 + int(columns * each[degree])


def _terms(z: Floats, degree: int) -> Floats:
    """Of polynomials of the columns ``(N, D)``, ``(T, N)``: those of the first columns are before those with the next.

    One and the columns; in the second degree their products; in the third, nearer by, squares times columns, and fourth
    powers.
    """
    dimensions = z.shape[1]
    terms = np.ones((_count(dimensions, degree), len(z)))
    for column in range(dimensions):
        _add_terms(terms[_count(column, degree) : _count(column + 1, degree)], z, column, degree)
    return terms


def _add_terms(terms: Floats, z: Floats, column: int, degree: int) -> None:
    """Those with a column, and none after it."""
    own = np.clip(z[:, : column + 1].T, -_FARTHEST, _FARTHEST)
    terms[0] = own[column]
    if degree > 1:
        np.multiply(own, own[column], out=terms[1 : column + 2])
    if degree > 2:
        near = np.clip(own, -_FARTHEST_CUBES, _FARTHEST_CUBES)
        square = near[column] ** 2
        np.multiply(near, square, out=terms[column + 2 : 2 * column + 3])
        np.multiply(near[:-1] ** 2, near[column], out=terms[2 * column + 3 : -1])
        terms[-1] = square**2


def _has(column: int, dimensions: int, degree: int) -> NDArray[np.bool_]:
    """Which terms have a column: those that change with it."""
    z = np.full((1, dimensions), 2.0)
    there = _terms(z, degree)[:, 0]
    z[0, column] = 1.0
    return np.asarray(_terms(z, degree)[:, 0] != there)
