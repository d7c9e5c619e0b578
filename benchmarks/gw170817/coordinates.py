"""Coordinates in which the posterior of a binary is nearly a normal distribution, for proposals.

Of the unit cube whose first six columns are chirp mass, mass ratio, spins and tides. The chirp mass and the spin of the
heavier star give way to the two combinations of post-Newtonian phases that the data fix best (Lee, Morisaki, Tagoshi
2022, arXiv:2203.05216, eqs. 14 to 20), the tide of the heavier star to the reduced tidal parameter, and every other
column u to the place where a normal distribution reaches u. All of it can be undone, and volumes are kept track of.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from benchmarks.gw170817 import priors
from bnserve_posterior.sampling import Coordinates

Floats = NDArray[np.float64]

CHIRP_MASS, MASS_RATIO, CHI_1, CHI_2, LAMBDA_1, LAMBDA_2 = range(6)
_SOLAR_MASS = 4.925490947641267e-6
"""Seconds."""
_REFERENCE = 200.0
"""Hz; the frequency at which the phases are compared."""
_FIRST, _SECOND = (0.974, 0.209, 0.0840), (-0.221, 0.823, 0.519)
_NEWTON_STEPS = 6
_EDGE = 1e-12
_TIDES = priors.LAMBDAS[1] - priors.LAMBDAS[0]


class _Phases(NamedTuple):
    """Phases (radians) at 200 Hz that go as f^(-5/3), f^-1, f^(-2/3); the spins add their ``along`` to the last."""

    zeroth: Floats
    second: Floats
    third: Floats
    along_1: Floats
    along_2: Floats


def _phases(chirp_mass: Floats, mass_ratio: Floats) -> _Phases:
    eta = mass_ratio / (1.0 + mass_ratio) ** 2
    x = np.pi * _SOLAR_MASS * _REFERENCE * chirp_mass
    scale = 3.0 / 32.0 * eta**-0.6 * x ** (-2.0 / 3.0)
    heavy, light = mass_ratio / (1.0 + mass_ratio), 1.0 / (1.0 + mass_ratio)
    return _Phases(
        3.0 / 128.0 * x ** (-5.0 / 3.0),
        5.0 / 96.0 * (743.0 / 336.0 + 2.75 * eta) * eta**-0.4 / x,
        -4.0 * np.pi * scale,
        scale / 12.0 * (113.0 * heavy**2 + 75.0 * eta),
        scale / 12.0 * (113.0 * light**2 + 75.0 * eta),
    )


def _best_measured(chirp_mass: Floats, mass_ratio: Floats, chi_1: Floats, chi_2: Floats) -> tuple[Floats, Floats]:
    phases = _phases(chirp_mass, mass_ratio)
    third = phases.third + phases.along_1 * chi_1 + phases.along_2 * chi_2
    first, second = (a * phases.zeroth + b * phases.second + c * third for a, b, c in (_FIRST, _SECOND))
    return first, second


def _tides(mass_ratio: Floats) -> tuple[Floats, Floats]:
    """What Lambda_1 and Lambda_2 add to the reduced tidal parameter."""
    heavy, light = mass_ratio / (1.0 + mass_ratio), 1.0 / (1.0 + mass_ratio)
    return 16 / 13 * (heavy + 12.0 * light) * heavy**4, 16 / 13 * (light + 12.0 * heavy) * light**4


def _log_volume(y: Floats, chirp_mass: Floats, mass_ratio: Floats, chi_1: Floats, chi_2: Floats) -> Floats:
    """ln abs(du / dy)."""
    phases, step = _phases(chirp_mass, mass_ratio), 1e-6 * chirp_mass
    above, below = (_best_measured(chirp_mass + d, mass_ratio, chi_1, chi_2) for d in (step, -step))
    slopes = [(high - low) / (2.0 * step) for high, low in zip(above, below, strict=True)]
    determinant = phases.along_1 * (slopes[0] * _SECOND[2] - slopes[1] * _FIRST[2])
    low, high = np.square(priors.CHIRP_MASSES)
    plain = y[:, [MASS_RATIO, CHI_2, *range(LAMBDA_2, y.shape[1])]]
    return (
        np.log(2.0 * chirp_mass / (high - low) * priors.spin_density(chi_1) / np.abs(determinant))
        - np.log(_TIDES * _tides(mass_ratio)[0])
        - 0.5 * np.sum(plain**2 + np.log(2.0 * np.pi), axis=1)
    )


def from_cube(u: Floats) -> tuple[Floats, Floats]:
    """Coordinates ``(N, D)`` of points of the unit cube, and ln of the volume ``abs(du / dy)``, ``(N,)``."""
    chirp_mass, mass_ratio = priors.chirp_masses(u[:, CHIRP_MASS]), priors.mass_ratios(u[:, MASS_RATIO])
    chi_1, chi_2 = priors.aligned_spins(u[:, CHI_1]), priors.aligned_spins(u[:, CHI_2])
    y = ndtri(np.clip(u, _EDGE, 1.0 - _EDGE))
    y[:, CHIRP_MASS], y[:, CHI_1] = _best_measured(chirp_mass, mass_ratio, chi_1, chi_2)
    tides = priors.LAMBDAS[0] + _TIDES * u[:, [LAMBDA_1, LAMBDA_2]]
    y[:, LAMBDA_1] = np.sum(np.stack(_tides(mass_ratio), axis=1) * tides, axis=1)
    return y, _log_volume(y, chirp_mass, mass_ratio, chi_1, chi_2)


def to_cube(y: Floats) -> tuple[Floats, Floats]:
    """The way back; coordinates of no binary of the prior give points outside the cube."""
    u = ndtr(y)
    mass_ratio, chi_2 = priors.mass_ratios(u[:, MASS_RATIO]), priors.aligned_spins(u[:, CHI_2])
    chirp_mass = _solve_chirp_mass(y, mass_ratio)
    phases = _phases(chirp_mass, mass_ratio)
    third = (y[:, CHIRP_MASS] - _FIRST[0] * phases.zeroth - _FIRST[1] * phases.second) / _FIRST[2]
    chi_1 = (third - phases.third - phases.along_2 * chi_2) / phases.along_1
    low, high = np.square(priors.CHIRP_MASSES)
    u[:, CHIRP_MASS] = (chirp_mass**2 - low) / (high - low)
    u[:, CHI_1] = np.where(np.abs(chi_1) < priors.LARGEST_SPIN, priors.spin_quantiles(chi_1), -1.0)
    heavy, light = _tides(mass_ratio)
    lighter = priors.LAMBDAS[0] + _TIDES * u[:, LAMBDA_2]
    u[:, LAMBDA_1] = ((y[:, LAMBDA_1] - light * lighter) / heavy - priors.LAMBDAS[0]) / _TIDES
    return u, _log_volume(y, chirp_mass, mass_ratio, chi_1, chi_2)


def _solve_chirp_mass(y: Floats, mass_ratio: Floats) -> Floats:
    """Newton's method on the combination of the two from which the spins drop out."""
    wanted = _SECOND[2] * y[:, CHIRP_MASS] - _FIRST[2] * y[:, CHI_1]
    a, b = (_SECOND[2] * _FIRST[k] - _FIRST[2] * _SECOND[k] for k in (0, 1))
    found = np.full(len(y), np.mean(priors.CHIRP_MASSES))
    for _ in range(_NEWTON_STEPS):
        phases = _phases(found, mass_ratio)
        slope = -(5.0 / 3.0 * a * phases.zeroth + b * phases.second) / found
        found = np.clip(found - (a * phases.zeroth + b * phases.second - wanted) / slope, 1.0, 1.4)
    return found


BINARY = Coordinates(from_cube, to_cube)
