"""Places drawn from a mixture or, sometimes, from the prior: what a mixture has not seen is found as well."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._bending import Bending
from bnserve_posterior.sampling._islands import islands
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._problem import Coordinates, Problem
from bnserve_posterior.sampling._turning import emptiest, opened

Floats = NDArray[np.float64]
_ANYWHERE = 0.05
"""How often a place is a draw from the prior."""
_FEWEST_COMPONENTS = 3
"""Of the mixture of a small island."""
_WIDENING = 1.2
"""Of scales: what is in the tails of a posterior is not in those of the points that a mixture is fitted to."""


class Part(NamedTuple):
    """Of a proposal: how often it is drawn from, and a mixture of Student distributions in straightened coordinates."""

    share: float
    bending: Bending
    mixture: Mixture


class Proposal(NamedTuple):
    """Parts, one for each island of the points, with a share of the prior; the coordinates' circles are cut open at
    ``turns``, ``(P,)``."""

    turns: Floats
    coordinates: Coordinates
    parts: tuple[Part, ...]

    @classmethod
    def fit(
        cls, problem: Problem, points: Floats, weights: Floats, components: int, iterations: int,
        random: np.random.Generator,
    ) -> Proposal:  # fmt: skip
        """To points of the cube ``(N, D)`` with weights that sum to one."""
        turns = emptiest(points, weights, problem.coordinates)
        coordinates = opened(problem.coordinates, turns)
        y = coordinates.from_cube(points)[0]
        parts = []
        for rows in islands(y, weights):
            share = float(weights[rows].sum())
            own, most = weights[rows] / share, max(_FEWEST_COMPONENTS, math.ceil(components * share))
            bending = Bending.fit(y[rows], own)
            mixture = Mixture.fit(bending.straight(y[rows]), own, most, iterations, random)
            parts.append(Part(share, bending, mixture.widened(_WIDENING)))
        return cls(turns, coordinates, tuple(parts))

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """Points ``(count, D)`` whose density is :meth:`log_density`; some are outside of the cube."""
        shares = np.array([part.share for part in self.parts])
        counts = random.multinomial(count, shares / shares.sum())
        drawn = [part.bending.bent(part.mixture.draw(n, random)) for n, part in zip(counts, self.parts, strict=True)]
        points, volumes = self.coordinates.to_cube(np.concatenate(drawn))
        points[~np.isfinite(volumes)] = -1.0
        return np.where(random.random((count, 1)) < _ANYWHERE, random.random(points.shape), points)

    def log_density(self, points: Floats) -> Floats:
        """ln of the density at points ``(N, D)`` in the cube."""
        y, volumes = self.coordinates.from_cube(points)
        each = [
            np.log(part.share) + part.mixture.log_density(part.bending.straight(y)) + part.bending.log_volume
            for part in self.parts
        ]
        mixture = np.logaddexp.reduce(each, axis=0) - volumes
        return np.logaddexp(np.log1p(-_ANYWHERE) + mixture, np.log(_ANYWHERE))


def inside(points: Floats) -> NDArray[np.intp]:
    """Which of the points are in the cube."""
    return np.flatnonzero(((points > 0.0) & (points < 1.0)).all(axis=1))
