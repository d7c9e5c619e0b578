"""Likelihoods over the unit cube whose integrals are known."""

from dataclasses import dataclass

import numpy as np
from scipy.special import gammaln, ndtri

WIDTHS = np.array([0.02, 0.01, 0.05, 0.03])
FREEDOM = 6.0


def normal(u):
    """A normalised density in the unit cube, whose evidence is one."""
    return -0.5 * np.sum(((u - 0.4) / WIDTHS) ** 2, axis=1) - np.sum(np.log(WIDTHS * np.sqrt(2.0 * np.pi)))


@dataclass(frozen=True)
class HeavyTails:
    """Two modes of Student distributions, 0.7 and 0.3 of all, where normal quantiles of the columns are correlated; its
    evidence is one."""

    dimensions: int

    def __post_init__(self):
        random = np.random.default_rng(11)
        factors = 0.15 * (np.eye(self.dimensions) + 0.4 * random.standard_normal((2, self.dimensions, self.dimensions)))
        object.__setattr__(self, "factors", factors)
        object.__setattr__(self, "means", np.stack([np.full(self.dimensions, 0.6), np.full(self.dimensions, -0.6)]))

    def distances(self, u, mode):
        """Squared distances from a mode in units of its shape: of an F distribution, times the dimensions."""
        y = ndtri(u) - self.means[mode]
        return np.sum(np.linalg.solve(self.factors[mode], y.T) ** 2, axis=0)

    def __call__(self, u):
        y, half = ndtri(u), 0.5 * (FREEDOM + self.dimensions)
        constant = gammaln(half) - gammaln(0.5 * FREEDOM) - 0.5 * self.dimensions * np.log(FREEDOM * np.pi)
        each = [
            np.log(share) + constant - np.linalg.slogdet(self.factors[mode])[1]
            - half * np.log1p(self.distances(u, mode) / FREEDOM)
            for mode, share in enumerate((0.7, 0.3))
        ]  # fmt: skip
        return np.logaddexp(*each) + 0.5 * np.sum(y**2 + np.log(2.0 * np.pi), axis=1)


LARGEST_SPIN = 0.5
_X = np.concatenate([[0.0], np.geomspace(1e-12, 1.0, 4097)])
_CUMULATIVE = np.concatenate([[0.0], _X[1:] * (1.0 - np.log(_X[1:]))])


def aligned_spins(u):
    """The aligned component of an isotropic spin of uniform size: P(abs(chi) < x chi_max) = x (1 - ln x)."""
    return LARGEST_SPIN * np.copysign(np.interp(np.abs(2.0 * u - 1.0), _CUMULATIVE, _X), u - 0.5)


def effective_spin(u):
    """Of columns mass ratio and two spins, a measurement of the effective spin that moves with the mass ratio: a thin
    curved sheet, whose ends are large spins of opposite signs."""
    q = 1.0 + 2.0 * u[:, 0]
    mean = (q * aligned_spins(u[:, 1]) + aligned_spins(u[:, 2])) / (1.0 + q)
    return -0.5 * ((mean - 0.02 - 0.03 * (q - 1.0) ** 2) / 0.01) ** 2


def effective_spin_by_quadrature(points=240):
    """Evidence of :func:`effective_spin`, and which part has abs(chi_1) > 0.2, by sums over a grid."""
    middle = (np.arange(points) + 0.5) / points
    inner = (np.arange(8 * points) + 0.5) / (8 * points)
    total = tail = 0.0
    for u in middle:
        one, two = np.meshgrid(middle, inner, indexing="ij")
        values = np.exp(effective_spin(np.stack([np.full(one.size, u), one.ravel(), two.ravel()], axis=1)))
        total += values.mean() / points
        tail += values[np.abs(aligned_spins(one.ravel())) > 0.2].sum() / one.size / points
    return total, tail / total


def two_detectors(u):
    """A place in the sky seen by two detectors: a ring, with two modes on it, one across the ends of the azimuth.

    Columns are the cosine of the angle to their line, the azimuth, and the time. Its evidence is one.
    """
    zenith = -0.5 * ((u[:, 0] - 0.3) / 0.01) ** 2 - np.log(0.01 * np.sqrt(2.0 * np.pi))
    time = -0.5 * ((u[:, 2] - 0.5 - 0.2 * (u[:, 0] - 0.3)) / 0.002) ** 2 - np.log(0.002 * np.sqrt(2.0 * np.pi))
    around = np.logaddexp(50.0 * np.cos(2.0 * np.pi * u[:, 1]), 50.0 * np.cos(2.0 * np.pi * (u[:, 1] - 0.45)))
    return zenith + time + around - np.log(2.0 * np.i0(50.0))
