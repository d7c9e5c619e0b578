"""A mixture of multivariate Student distributions that follows weighted points: proposals from all of them at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import gammaln, logsumexp

Floats = NDArray[np.float64]

FREEDOM = 8.0
"""Degrees of freedom: tails heavier than a posterior's, so that no importance weight is large."""
_RIDGE = 1e-4
"""Added to the variances, in units of all points' own: a component may not collapse on a point."""


class Mixture(NamedTuple):
    """Components of shares ``(K,)`` around means ``(K, D)`` with lower triangular scales ``(K, D, D)``."""

    shares: Floats
    means: Floats
    scales: Floats

    @classmethod
    def fit(
        cls, points: Floats, weights: Floats, components: int, iterations: int, random: np.random.Generator
    ) -> Mixture:
        """By expectation and maximisation, from ``points`` ``(N, D)`` with weights ``(N,)`` that sum to one.

        The number of components is less where the effective points are too few for their shapes.
        """
        dimensions = points.shape[1]
        effective = 1.0 / np.sum(weights**2)
        components = max(1, min(components, int(effective / (4 * dimensions))))
        centre = weights @ points
        width = np.sqrt(weights @ (points - centre) ** 2)
        width = np.where(width > 0.0, width, 1.0)
        x = (points - centre) / width
        ridge = _RIDGE * np.eye(dimensions)
        start = (x.T * weights) @ x / components ** (2.0 / dimensions) + ridge
        now = cls(
            np.full(components, 1.0 / components),
            x[random.choice(len(x), components, p=weights)],
            np.repeat(np.linalg.cholesky(start)[None], components, axis=0),
        )
        fewest = 2 * dimensions / effective
        monomials = _monomials(x)
        for _ in range(iterations):
            now = now._step(monomials, weights, (start, fewest), ridge)
        return cls(now.shares, now.means * width + centre, now.scales * width[:, None])

    def _step(self, monomials: Floats, weights: Floats, poor: tuple[Floats, float], ridge: Floats) -> Mixture:
        """One expectation and maximisation; a component of fewer points than ``poor[1]`` has the shape ``poor[0]``."""
        components, dimensions = self.means.shape
        half = 0.5 * (FREEDOM + dimensions)
        far = self._squares(monomials)
        far /= FREEDOM
        far += 1.0
        each = np.log(far)
        each *= -half
        each += (np.log(self.shares) - self._log_volumes())[:, None]
        each -= each.max(axis=0)
        held_by = np.exp(each, out=each)
        held_by *= weights / held_by.sum(axis=0)
        shares = held_by.sum(axis=1) + 1e-12
        held_by /= far  # far points count less
        moments = (1.0 + dimensions / FREEDOM) * (held_by @ monomials.T)
        pull = moments[:, 0] + 1e-12
        means = moments[:, 1 : 1 + dimensions] / pull[:, None]
        covariances: Floats = np.empty((components, dimensions, dimensions))
        first, second = np.triu_indices(dimensions)
        covariances[:, first, second] = covariances[:, second, first] = moments[:, 1 + dimensions :]
        covariances -= pull[:, None, None] * means[:, :, None] * means[:, None, :]
        covariances /= shares[:, None, None]
        covariances += ridge
        covariances[shares < poor[1]] = poor[0]
        return Mixture(shares / shares.sum(), means, np.asarray(np.linalg.cholesky(covariances)))

    def widened(self, factor: float) -> Mixture:
        """All scales larger by that factor."""
        return self._replace(scales=self.scales * factor)

    def with_guard(self, points: Floats, weights: Floats, share: float, factor: float) -> Mixture:
        """With one component more, of that share, of the shape of all the points times ``factor``: what no component
        holds has a density all the same (Hesterberg, Technometrics 37, 185 (1995))."""
        mean = weights @ points
        left = points - mean
        variances = weights @ left**2
        covariance = (left.T * weights) @ left + _RIDGE * np.diag(np.where(variances > 0.0, variances, 1.0))
        scale = factor * np.linalg.cholesky(covariance)
        return Mixture(
            np.append((1.0 - share) * self.shares, share),
            np.concatenate([self.means, mean[None]]),
            np.concatenate([self.scales, scale[None]]),
        )

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """Points ``(count, D)``."""
        chosen = random.choice(len(self.shares), size=count, p=self.shares)
        normal = random.standard_normal((count, self.means.shape[1]))
        normal *= np.sqrt(FREEDOM / random.chisquare(FREEDOM, count))[:, None]
        return self.means[chosen] + np.einsum("nij,nj->ni", self.scales[chosen], normal)

    def log_density(self, points: Floats) -> Floats:
        """ln of the density at ``points`` ``(N, D)``."""
        return np.asarray(logsumexp(self.log_densities(points), axis=0))

    def log_densities(self, points: Floats) -> Floats:
        """ln of each component's part of it, ``(K, N)``."""
        dimensions = points.shape[1]
        half = 0.5 * (FREEDOM + dimensions)
        constant = gammaln(half) - gammaln(0.5 * FREEDOM) - 0.5 * dimensions * np.log(FREEDOM * np.pi)
        centre = self.shares @ self.means
        width = np.sqrt(self.shares @ (np.sum(self.scales**2, axis=2) + (self.means - centre) ** 2))
        near = Mixture(self.shares, (self.means - centre) / width, self.scales / width[:, None])
        found = near._squares(_monomials((points - centre) / width))
        found /= FREEDOM
        found += 1.0
        np.log(found, out=found)
        found *= -half
        found += (np.log(self.shares) + constant - self._log_volumes())[:, None]
        return found

    def _squares(self, monomials: Floats) -> Floats:
        """Squared distances in units of every component ``(K, N)``: a polynomial of the second degree, which needs one
        product of matrices (2.5 ms of 25 components at 8,000 points in eleven dimensions, and 8 by differences)."""
        unscaled = np.linalg.inv(self.scales)
        inverses = unscaled.transpose(0, 2, 1) @ unscaled
        linear = np.einsum("kij,kj->ki", inverses, self.means)
        first, second = np.triu_indices(self.means.shape[1])
        products = inverses[:, first, second] * np.where(first == second, 1.0, 2.0)
        constants = np.sum(linear * self.means, axis=1)
        polynomials = np.concatenate([constants[:, None], -2.0 * linear, products], axis=1)
        return np.maximum(polynomials @ monomials, 0.0)

    def _log_volumes(self) -> Floats:
        """ln of the volume of every component's unit, ``(K,)``."""
        return np.asarray(np.log(np.diagonal(self.scales, axis1=1, axis2=2)).sum(axis=1))


def _monomials(x: Floats) -> Floats:
    """One, the columns of ``(N, D)``, and their products, ``(P, N)``."""
    columns = np.ascontiguousarray(x.T)
    first, second = np.triu_indices(len(columns))
    return np.concatenate([np.ones((1, len(x))), columns, columns[first] * columns[second]])
