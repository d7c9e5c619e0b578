"""Places drawn from a mixture or, sometimes, from the prior: what a mixture has not seen is found as well."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from bnserve_posterior.sampling._bending import Bending
from bnserve_posterior.sampling._islands import islands
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._problem import Coordinates, Problem
from bnserve_posterior.sampling._turning import emptiest, on_lines, opened

Floats = NDArray[np.float64]
_ANYWHERE = 0.05
"""How often a place is a draw from the prior."""
_FEWEST_COMPONENTS = 5
"""Of the mixture of a small island."""
_WIDENING = 1.2
"""Of scales: what is in the tails of a posterior is not in those of the points that a mixture is fitted to."""
_GUARD = 0.1, 1.5
"""Share of a component that is as wide as all of an island, and its factor to that."""
_STEP, _SPREAD = 0.5, 0.5
"""Of a component's width, and of the logarithm of that: a fifth of the steps is taken in eleven dimensions."""


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
        y, circles = problem.coordinates.from_cube(points)[0], list(problem.coordinates.circles)
        turns = emptiest(y[:, circles], weights)
        y[:, circles] = on_lines(y[:, circles], turns)
        parts = []
        for rows in islands(y, weights):
            share = float(weights[rows].sum())
            own, most = weights[rows] / share, max(_FEWEST_COMPONENTS, math.ceil(components * share))
            bending = Bending.fit(y[rows], own)
            straight = bending.straight(y[rows])
            mixture = Mixture.fit(straight, own, most, iterations, random).widened(_WIDENING)
            parts.append(Part(share, bending, mixture.with_guard(straight, own, *_GUARD)))
        return cls(turns, opened(problem.coordinates, turns), tuple(parts))

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """Points ``(count, D)`` whose density is :meth:`log_density`, each of them; some are outside of the cube."""
        shares = np.array([part.share for part in self.parts])
        counts = random.multinomial(count, shares / shares.sum())
        drawn = [part.bending.bent(part.mixture.draw(n, random)) for n, part in zip(counts, self.parts, strict=True)]
        points, volumes = self.coordinates.to_cube(random.permutation(np.concatenate(drawn)))
        points[~np.isfinite(volumes)] = -1.0
        return np.where(random.random((count, 1)) < _ANYWHERE, random.random(points.shape), points)

    def log_density(self, points: Floats) -> Floats:
        """ln of the density at points ``(N, D)`` in the cube."""
        y, volumes = self.coordinates.from_cube(points)
        mixture = logsumexp(self._log_densities(y), axis=0) - volumes
        return np.logaddexp(np.log1p(-_ANYWHERE) + mixture, np.log(_ANYWHERE))

    def step(self, points: Floats, random: np.random.Generator) -> tuple[Floats, Floats]:
        """A step from each of the points ``(N, D)``, and ln of the factor ``(N,)`` by which the ratio of the target
        there and here is to be multiplied before it is taken or left (Metropolis, Hastings).

        It is as large as the component that holds the point is wide; that another may hold the place where it leads to
        is part of the factor.
        """
        y, volumes = self.coordinates.from_cube(points)
        held = self._log_densities(y)
        chosen = np.argmax(held + random.gumbel(size=held.shape), axis=0)
        there, first = y.copy(), 0
        for part in self.parts:
            sizes = _STEP * np.exp(_SPREAD * random.standard_normal(len(y)))
            step = sizes[:, None] * random.standard_normal(y.shape)
            rows = np.flatnonzero((chosen >= first) & (chosen < first + len(part.mixture.shares)))
            scales = part.mixture.scales[chosen[rows] - first]
            moved = part.bending.straight(y[rows]) + np.einsum("nij,nj->ni", scales, step[rows])
            there[rows] = part.bending.bent(moved)
            first += len(part.mixture.shares)
        found, theirs = self.coordinates.to_cube(there)
        found[~np.isfinite(theirs)] = -1.0
        among = np.arange(len(y))
        hold = self._log_densities(there)
        held_by = held[chosen, among] - logsumexp(held, axis=0)
        return found, theirs - volumes + hold[chosen, among] - logsumexp(hold, axis=0) - held_by

    def _log_densities(self, y: Floats) -> Floats:
        """ln of each component's part of the density at coordinates ``(N, D)``, of all islands, ``(K, N)``."""
        return np.concatenate([
            math.log(part.share) + part.bending.log_volume + part.mixture.log_densities(part.bending.straight(y))
            for part in self.parts
        ])  # fmt: skip


def inside(points: Floats) -> NDArray[np.intp]:
    """Which of the points are in the cube."""
    return np.flatnonzero(((points > 0.0) & (points < 1.0)).all(axis=1))
