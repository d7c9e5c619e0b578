"""A mixture of multivariate Student distributions that follows a population: proposals from all of it at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import gammaln, logsumexp

Floats = NDArray[np.float64]

FREEDOM = 8.0
"""Degrees of freedom: tails heavier than a posterior's, so that no importance weight is large."""
_ITERATIONS = 20
_RIDGE = 1e-4
"""Added to the variances, in units of the population's own: a component may not collapse on a point."""


class Mixture(NamedTuple):
    """Components of weights ``(K,)`` around means ``(K, D)`` with lower triangular scales ``(K, D, D)``."""

    weights: Floats
    means: Floats
    scales: Floats

    @classmethod
    def fit(cls, points: Floats, components: int, random: np.random.Generator) -> Mixture:
        """By expectation and maximisation (normal components), from ``points`` ``(N, D)``, N well above D."""
        centre, width = points.mean(axis=0), points.std(axis=0)
        x = (points - centre) / np.where(width > 0.0, width, 1.0)
        count, dimensions = x.shape
        components = max(1, min(components, count // (4 * dimensions)))
        ridge = _RIDGE * np.eye(dimensions)
        start = np.cov(x.T) / components ** (2.0 / dimensions) + ridge
        products = (x[:, :, None] * x[:, None, :]).reshape(count, -1)
        now = cls(
            np.full(components, 1.0 / components),
            x[random.choice(count, components, replace=False)],
            np.repeat(np.linalg.cholesky(start)[None], components, axis=0),
        )
        for _ in range(_ITERATIONS):
            each = now._log_normal(x)
            share = np.exp(each - logsumexp(each, axis=0))
            held = share.sum(axis=1) + 1e-3
            means = (share @ x) / held[:, None]
            squares = (share @ products / held[:, None]).reshape(components, dimensions, dimensions)
            covariances = squares - means[:, :, None] * means[:, None, :] + ridge
            covariances[held < 2 * dimensions] = start  # too few points to have a shape of its own
            now = cls(held / held.sum(), means, np.linalg.cholesky(covariances))
        return cls(now.weights, now.means * width + centre, now.scales * width[:, None])

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """Points ``(count, D)``."""
        chosen = random.choice(len(self.weights), size=count, p=self.weights / self.weights.sum())
        normal = random.standard_normal((count, self.means.shape[1]))
        normal *= np.sqrt(FREEDOM / random.chisquare(FREEDOM, count))[:, None]
        return self.means[chosen] + np.einsum("nij,nj->ni", self.scales[chosen], normal)

    def log_density(self, points: Floats) -> Floats:
        """ln of the density at ``points`` ``(N, D)``."""
        dimensions = points.shape[1]
        half = 0.5 * (FREEDOM + dimensions)
        constant = gammaln(half) - gammaln(0.5 * FREEDOM) - 0.5 * dimensions * np.log(FREEDOM * np.pi)
        squares, volumes = self._squares(points)
        each = constant - volumes[:, None] - half * np.log1p(squares / FREEDOM)
        return np.asarray(logsumexp(each, axis=0, b=self.weights[:, None]))

    def _log_normal(self, x: Floats) -> Floats:
        squares, volumes = self._squares(x)
        return np.log(self.weights)[:, None] - volumes[:, None] - 0.5 * squares

    def _squares(self, x: Floats) -> tuple[Floats, Floats]:
        """Squared distances in units of every component ``(K, N)``, and ln of their volumes ``(K,)``."""
        unscaled = np.linalg.inv(self.scales)
        columns = unscaled.reshape(-1, x.shape[1]).T
        centres = np.einsum("kij,kj->ki", unscaled, self.means).ravel()
        squares = np.square(x @ columns - centres).reshape(len(x), *self.means.shape).sum(axis=2).T
        return squares, np.log(np.diagonal(self.scales, axis1=1, axis2=2)).sum(axis=1)
