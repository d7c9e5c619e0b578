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
        some = slice(None, None, -(-len(z) // _ORDERING))
        left = [_left(z[some], weights[some] / weights[some].sum(), column, degree) for column in range(dimensions)]
        order = np.argsort(left)[::-1].astype(np.int64)
        z = z[:, order]
        polynomials = np.zeros((dimensions, _count(dimensions, degree)))
        for column in range(dimensions):
            before = _terms(z[:, :column], degree)
            polynomials[column, : before.shape[1]] = _least_squares(before, z[:, column], weights)
        return cls(centre, width, order, polynomials, degree)

    def straight(self, y: Floats) -> Floats:
        """From coordinates ``(N, D)`` to straight ones."""
        z = ((y - self.centre) / self.width)[:, self.order]
        return z - np.stack([self._polynomial(z, column) for column in range(z.shape[1])], axis=1)

    def bent(self, x: Floats) -> Floats:
        """The way back."""
        z = x.copy()
        for column in range(z.shape[1]):
            z[:, column] += self._polynomial(z, column)
        y = np.empty_like(z)
        y[:, self.order] = z
        return y * self.width + self.centre

    @property
    def log_volume(self) -> float:
        """ln of the volume of straight coordinates over that of coordinates."""
        return float(-np.sum(np.log(self.width)))

    def _polynomial(self, z: Floats, column: int) -> Floats:
        terms = _terms(z[:, :column], self.degree)
        return terms @ self.polynomials[column, : terms.shape[1]]


def _left(z: Floats, weights: Floats, column: int, degree: int) -> float:
    """Variance of a column that a polynomial of all others leaves."""
    others = _terms(np.delete(z, column, axis=1), degree)
    return float(weights @ (z[:, column] - others @ _least_squares(others, z[:, column], weights)) ** 2)


def _count(dimensions: int, degree: int) -> int:
    """Terms of a polynomial."""
    return _terms(np.zeros((1, dimensions)), degree).shape[1]


def _terms(z: Floats, degree: int) -> Floats:
    """One and the columns; in the second degree their products; in the third, nearer by, squares times columns, and
    fourth powers."""
    z = np.clip(z, -_FARTHEST, _FARTHEST)
    parts = [np.ones((len(z), 1)), z]
    if degree > 1:
        first, second = np.triu_indices(z.shape[1])
        parts.append(z[:, first] * z[:, second])
    if degree > 2:
        near = np.clip(z, -_FARTHEST_CUBES, _FARTHEST_CUBES)
        cubes = near[:, :, None] ** 2 * near[:, None, :]
        parts += [cubes.reshape(len(z), -1), near**4]
    return np.concatenate(parts, axis=1)


def _least_squares(terms: Floats, values: Floats, weights: Floats) -> Floats:
    heavy = terms.T * weights
    return np.asarray(np.linalg.solve(heavy @ terms + _RIDGE * np.eye(terms.shape[1]), heavy @ values))
