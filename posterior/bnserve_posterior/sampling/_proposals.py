"""Places drawn from a mixture or, sometimes, from the prior: what a mixture has not seen is found as well."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._bending import Bending
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._problem import Coordinates, Problem
from bnserve_posterior.sampling._turning import emptiest, opened

Floats = NDArray[np.float64]
_ANYWHERE = 0.05
"""How often a place is a draw from the prior."""
_WIDENING = 1.2
"""Of scales: what is in the tails of a posterior is not in those of the points that a mixture is fitted to."""


class Proposal(NamedTuple):
    """A mixture of Student distributions in straightened coordinates, with a share of the prior; the coordinates'
    circles are cut open at ``turns``, ``(P,)``."""

    turns: Floats
    coordinates: Coordinates
    bending: Bending
    mixture: Mixture

    @classmethod
    def fit(
        cls, problem: Problem, points: Floats, weights: Floats, components: int, iterations: int,
        random: np.random.Generator,
    ) -> Proposal:  # fmt: skip
        """To points of the cube ``(N, D)`` with weights that sum to one."""
        turns = emptiest(points, weights, problem.coordinates)
        coordinates = opened(problem.coordinates, turns)
        y = coordinates.from_cube(points)[0]
        bending = Bending.fit(y, weights)
        mixture = Mixture.fit(bending.straight(y), weights, components, iterations, random)
        return cls(turns, coordinates, bending, mixture.widened(_WIDENING))

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """Points ``(count, D)`` whose density is :meth:`log_density`; some are outside of the cube."""
        anywhere = random.random((count, len(self.bending.centre)))
        points, volumes = self.coordinates.to_cube(self.bending.bent(self.mixture.draw(count, random)))
        points[~np.isfinite(volumes)] = -1.0
        return np.where(random.random((count, 1)) < _ANYWHERE, anywhere, points)

    def log_density(self, points: Floats) -> Floats:
        """ln of the density at points ``(N, D)`` in the cube."""
        y, volumes = self.coordinates.from_cube(points)
        mixture = self.mixture.log_density(self.bending.straight(y)) + self.bending.log_volume - volumes
        return np.logaddexp(np.log1p(-_ANYWHERE) + mixture, np.log(_ANYWHERE))


def inside(points: Floats) -> NDArray[np.intp]:
    """Which of the points are in the cube."""
    return np.flatnonzero(((points > 0.0) & (points < 1.0)).all(axis=1))
