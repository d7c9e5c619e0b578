"""Columns whose ends are the same place, turned so that their ends are where the fewest points are."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._problem import Coordinates, Problem

Floats = NDArray[np.float64]
_BINS = 32
"""Of a column: the ends of a turned one lie in the middle of the emptiest."""


def emptiest(points: Floats, weights: Floats, problem: Problem) -> Floats:
    """Where, in each periodic column, the least weight of points ``(N, D)`` is, ``(P,)``."""
    turns = []
    for column in problem.periodic:
        held, edges = np.histogram(points[:, column], _BINS, (0.0, 1.0), weights=weights)
        near = held + 0.5 * (np.roll(held, 1) + np.roll(held, -1))
        turns.append(edges[np.argmin(near)] + 0.5 / _BINS)
    return np.array(turns)


def turned(problem: Problem, turns: Floats) -> Coordinates:
    """The problem's coordinates of the cube whose periodic columns begin at ``turns``, ``(P,)``."""
    plain, columns = problem.coordinates, list(problem.periodic)
    if not columns:
        return plain

    def from_cube(points: Floats) -> tuple[Floats, Floats]:
        ours = points.copy()
        ours[:, columns] = np.mod(points[:, columns] - turns, 1.0)
        return plain.from_cube(ours)

    def to_cube(y: Floats) -> tuple[Floats, Floats]:
        points, volumes = plain.to_cube(y)
        points[:, columns] = np.mod(points[:, columns] + turns, 1.0)
        return points, volumes

    return Coordinates(from_cube, to_cube)
