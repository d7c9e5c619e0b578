"""Draws from the density exp(F) on an interval, by the inverse of its distribution function."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._log_quadrature import ValuesAt, clenshaw_curtis, masses

Floats = NDArray[np.float64]
InnerAt = Callable[[NDArray[np.int64], Floats], tuple[NDArray[Any], NDArray[Any]]]
"""Two arrays ``(..., K)`` of rows at places, ``(K,)`` of both."""

_ORDER = 8
_NODES = clenshaw_curtis(_ORDER)[0]
_HALVINGS = 52
"""Of a cell: the last digit of a float64."""


def _antiderivative() -> Floats:
    """Chebyshev coefficients on [0, 1] of the antiderivatives of the nodes' polynomials, ``(nodes, order + 2)``."""
    chebyshev = np.polynomial.chebyshev
    values = np.linalg.inv(chebyshev.chebvander(2.0 * _NODES - 1.0, _ORDER))  # of coefficients by nodes
    return np.array([chebyshev.chebint(column, scl=0.5, lbnd=-1.0) for column in values.T])


_INTEGRALS = _antiderivative()


def draw(knots: Floats, values_at: ValuesAt, uniforms: Floats) -> Floats:
    """Places ``(N,)`` between 0 and n - 1, in steps, where the distribution function has the values ``uniforms``.

    A row's bits depend on the row alone. Parameters are as of
    :func:`~bnserve_inference._log_quadrature.log_mean_exponential`, whose error they have; NaN where F is not finite,
    or the error too large.
    """
    good = np.flatnonzero(np.isfinite(knots).all(axis=1))
    places = np.full(len(knots), np.nan)
    if len(good) == 0:
        return places
    starts, widths, shares = np.zeros(len(good)), np.full(len(good), np.nan), np.zeros(len(good))
    found = masses(knots[good], lambda rows, at: values_at(good[rows], at))
    for row, (start, width, mass) in enumerate(found):
        if len(mass) == 0:
            continue
        reached = np.cumsum(mass)
        wanted = uniforms[good[row]] * reached[-1]
        which = min(int(np.searchsorted(reached, wanted, side="right")), len(mass) - 1)
        starts[row], widths[row] = start[which], width[which]
        shares[row] = (wanted - (reached[which] - mass[which])) / mass[which]
    at = starts[:, None] + np.where(np.isfinite(widths), widths, 0.0)[:, None] * _NODES
    values = values_at(np.repeat(good, len(_NODES)), at.reshape(-1)).reshape(at.shape)
    inside = _inverse(np.exp(values - values.max(axis=1, keepdims=True)), np.clip(shares, 0.0, 1.0))
    places[good] = starts + widths * inside
    return places


def at_each(inner_at: InnerAt, places: Floats) -> tuple[NDArray[Any], NDArray[Any]]:
    """Two arrays ``(..., N)`` of N rows, each at its place; NaN there is taken for zero.

    The places are asked for twice: numpy multiplies complex vectors of a single number in another order than longer
    ones, and a row would have other bits alone.
    """
    count = len(places)
    found = inner_at(np.tile(np.arange(count), 2), np.tile(np.where(np.isfinite(places), places, 0.0), 2))
    return found[0][..., :count], found[1][..., :count]


def _inverse(density: Floats, shares: Floats) -> Floats:
    """Where in [0, 1] the integrals of densities, known at the nodes, ``(N, nodes)``, reach these shares of all."""
    coefficients = np.zeros((_INTEGRALS.shape[1], len(density)))
    for node, integral in enumerate(_INTEGRALS):  # in a fixed order, whatever the number of rows
        coefficients += integral[:, None] * density[:, node]

    def reached(x: Floats) -> Floats:
        return np.asarray(np.polynomial.chebyshev.chebval(2.0 * x - 1.0, coefficients, tensor=False))

    low, high = np.zeros(len(density)), np.ones(len(density))
    wanted = shares * reached(high)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        below = reached(middle) < wanted
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)
