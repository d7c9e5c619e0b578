"""Circles among the coordinates, cut open where the fewest points are."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from bnserve_posterior.sampling._problem import Coordinates, log_normal

Floats = NDArray[np.float64]
_BINS = 32
"""Of a circle: it is cut open in the middle of the emptiest."""
_EDGE = 1e-15
"""Nearer than this to a cut is this far from it: the cut itself is at infinity."""


def emptiest(points: Floats, weights: Floats, coordinates: Coordinates) -> Floats:
    """Where, on each circle, the least weight of points ``(N, D)`` of the cube is, ``(P,)``."""
    if not coordinates.circles:
        return np.empty(0)
    turns, y = [], coordinates.from_cube(points)[0]
    for column in coordinates.circles:
        held, edges = np.histogram(y[:, column], _BINS, (0.0, 1.0), weights=weights)
        near = held + 0.5 * (np.roll(held, 1) + np.roll(held, -1))
        turns.append(edges[np.argmin(near)] + 0.5 / _BINS)
    return np.array(turns)


def opened(coordinates: Coordinates, turns: Floats) -> Coordinates:
    """The same, but circles are lines: each is cut open at one of ``turns``, ``(P,)``, which is at infinity."""
    columns = list(coordinates.circles)
    if not columns:
        return coordinates

    def from_cube(points: Floats) -> tuple[Floats, Floats]:
        y, volumes = coordinates.from_cube(points)
        y[:, columns] = ndtri(np.clip(np.mod(y[:, columns] - turns, 1.0), _EDGE, 1.0 - _EDGE))
        return y, volumes + log_normal(y[:, columns])

    def to_cube(y: Floats) -> tuple[Floats, Floats]:
        closed = y.copy()
        closed[:, columns] = np.mod(ndtr(y[:, columns]) + turns, 1.0)
        points, volumes = coordinates.to_cube(closed)
        return points, volumes + log_normal(y[:, columns])

    return Coordinates(from_cube, to_cube)
