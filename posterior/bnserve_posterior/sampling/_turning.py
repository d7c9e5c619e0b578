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


def emptiest(places: Floats, weights: Floats) -> Floats:
    """Where, on each circle, the least weight of points is that are at ``places`` ``(N, P)``, ``(P,)``."""
    turns = np.empty(places.shape[1])
    for circle, column in enumerate(places.T):
        held, edges = np.histogram(column, _BINS, (0.0, 1.0), weights=weights)
        near = held + 0.5 * (np.roll(held, 1) + np.roll(held, -1))
        turns[circle] = edges[np.argmin(near)] + 0.5 / _BINS
    return turns


def on_lines(places: Floats, turns: Floats) -> Floats:
    """Places on circles ``(N, P)`` when each is cut open at one of ``turns``, ``(P,)``, which is at infinity."""
    return np.asarray(ndtri(np.clip(np.mod(places - turns, 1.0), _EDGE, 1.0 - _EDGE)))


def opened(coordinates: Coordinates, turns: Floats) -> Coordinates:
    """The same, but circles are lines."""
    columns = list(coordinates.circles)
    if not columns:
        return coordinates

    def from_cube(points: Floats) -> tuple[Floats, Floats]:
        y, volumes = coordinates.from_cube(points)
        y[:, columns] = on_lines(y[:, columns], turns)
        return y, volumes + log_normal(y[:, columns])

    def to_cube(y: Floats) -> tuple[Floats, Floats]:
        closed = y.copy()
        closed[:, columns] = np.mod(ndtr(y[:, columns]) + turns, 1.0)
        points, volumes = coordinates.to_cube(closed)
        return points, volumes + log_normal(y[:, columns])

    return Coordinates(from_cube, to_cube)
