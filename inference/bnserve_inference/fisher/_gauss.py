"""Gauss quadrature of integrals that are divided by a noise curve.

A signal is smooth and noise is not: the nodes and weights of each panel are those of the polynomials that are
orthogonal under the noise itself (Gautschi 2004, *Orthogonal Polynomials*, section 2.2: Stieltjes' procedure on a
measure made discrete), so eight of them integrate what is smooth to degree 15 whatever lines the noise has.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

POINTS = 8
"""Nodes of a panel: the lanes of a vector."""
_FINE = 16
"""Points between two knots of the noise, where it is a power law."""


def gauss(edges: Floats, density: Callable[[Floats], Floats], knots: Floats) -> tuple[Floats, Floats]:
    """Nodes and weights of integrals over frequency, ``(P, 8)`` each, in P panels.

    Parameters
    ----------
    edges
        Of the panels, Hz, ``(P + 1,)``, increasing.
    density
        What the integrand is multiplied with, positive; its weights come with it.
    knots
        Frequencies between which it is smooth.
    """
    logs = np.log(edges)
    half, middle = 0.5 * np.diff(logs), 0.5 * (logs[1:] + logs[:-1])
    x, mass, panel = _points(logs, density, knots)
    x = (x - middle[panel, None]) / half[panel, None]
    starts = np.searchsorted(panel, np.arange(len(half)))

    def total(values: Floats) -> Floats:
        return np.asarray(np.add.reduceat(values.sum(axis=1), starts))

    whole = total(mass)
    mass = mass / np.where(whole > 0.0, whole, 1.0)[panel, None]
    matrix, square = np.zeros((len(half), POINTS, POINTS)), np.zeros(len(half))
    before, now = np.zeros_like(x), np.ones_like(x)
    for k in range(POINTS):
        matrix[:, k, k] = total(mass * x * now * now)
        after = (x - matrix[panel, k, k, None]) * now - np.sqrt(square)[panel, None] * before
        square = total(mass * after * after)
        if k + 1 < POINTS:
            matrix[:, k, k + 1] = matrix[:, k + 1, k] = np.sqrt(square)
        before, now = now, after / np.sqrt(np.where(square > 0.0, square, 1.0))[panel, None]
    places, vectors = np.linalg.eigh(matrix)
    return np.exp(middle[:, None] + half[:, None] * places), whole[:, None] * vectors[:, 0] ** 2


def _points(
    logs: Floats, density: Callable[[Floats], Floats], knots: Floats
) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Places in log f and masses of the measure made discrete, ``(Q, 16)``, and the panel of each of the Q pieces."""
    inside = np.log(knots[(knots > 0.0) & np.isfinite(knots)])
    cuts = np.concatenate([logs, inside[(inside > logs[0]) & (inside < logs[-1])]])
    cuts = np.unique(cuts)
    middle, half = 0.5 * (cuts[1:] + cuts[:-1])[:, None], 0.5 * np.diff(cuts)[:, None]
    x, weights = np.polynomial.legendre.leggauss(_FINE)
    places = middle + half * x
    f = np.exp(places)
    panel = np.searchsorted(logs, middle[:, 0]) - 1
    return places, half * weights * f * density(f), panel


def slopes(x: Floats) -> Floats:
    """Matrices of the derivatives of polynomials through the nodes of panels, ``(P, 8)`` to ``(P, 8, 8)`` (Berrut,
    Trefethen 2004, SIAM Review 46, 501, section 9.3)."""
    difference = x[:, :, None] - x[:, None, :] + np.eye(x.shape[1])
    weights = 1.0 / difference.prod(axis=2)
    found = weights[:, None, :] / weights[:, :, None] / difference
    diagonal = np.arange(x.shape[1])
    found[:, diagonal, diagonal] = 0.0
    found[:, diagonal, diagonal] = -found.sum(axis=2)
    return np.asarray(found)
