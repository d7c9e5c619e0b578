"""Populations of binary neutron stars that are drawn: how many there are at which redshift, and what they are.

Laws that are simple and stated, so that forecasts of different detectors are of the same binaries.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import FieldError, InvalidRequest

Floats = NDArray[np.float64]

_HUBBLE, _MATTER = 67.66, 0.30966
"""km/s/Mpc, and the part of matter in a flat universe (Planck 2018, arXiv:1807.06209, last column of table 2)."""
_LIGHT = 299792.458
"""km/s."""
_GRID = 2049
"""Redshifts at which distances are integrated: to 1e-6 of them."""
_MOST_REDSHIFT = 20.0
"""The rate of mergers is known from none beyond ten."""
_MASS, _WIDTH, _MASSES = 1.33, 0.09, (1.06, 1.60)
"""Solar masses: a Gaussian, as of the double neutron stars in our galaxy (Oezel, Freire 2016, arXiv:1603.02698); what
is beyond three widths is drawn again."""
_LAMBDA, _REFERENCE, _POWER = 400.0, 1.4, -6.0
"""Lambda = 400 (m / 1.4 Msun)^-6: radii that are alike (De et al. 2018, arXiv:1804.08583)."""
_SPIN = 0.05
_BEGIN, _YEAR = 1.9e9, 3.15576e7
"""GPS seconds."""


def luminosity_distance(redshift: Floats) -> Floats:
    """Mpc ``(N,)`` of redshifts ``(N,)``, in the flat universe of Planck 2018 (arXiv:1807.06209)."""
    grid = np.linspace(0.0, max(1e-6, float(np.max(redshift, initial=0.0))), _GRID)
    x, w = np.polynomial.legendre.leggauss(4)
    half = 0.5 * np.diff(grid)[:, None]
    steps = (half * w / _expansion(grid[:-1, None] + half * (1.0 + x))).sum(axis=1)
    comoving = _LIGHT / _HUBBLE * np.concatenate([[0.0], np.cumsum(steps)])
    return np.asarray((1.0 + redshift) * np.interp(redshift, grid, comoving))


def draw_population(count: int, seed: int, *, most_redshift: float = 10.0) -> dict[str, Floats]:
    """Binaries that merge in one year, as the columns of a catalogue, ``(count,)`` each.

    Mergers follow the formation of stars (Madau, Dickinson 2014, arXiv:1403.0007, eq. 15), seen at a rate smaller by
    1 + z, in the comoving volume up to a redshift. Masses are Gaussian in the source's frame (1.33 and 0.09 solar
    masses), Lambda = 400 (m / 1.4 Msun)^-6, spins along the orbital angular momentum uniform up to 0.05; orientations,
    places and times are uniform.

    Raises
    ------
    InvalidRequest
        No binaries, or redshifts that are none.
    """
    if count < 1 or not 0.0 < most_redshift <= _MOST_REDSHIFT:
        raise InvalidRequest(
            f"A population has binaries, up to a redshift of 0 to {_MOST_REDSHIFT:g}; got {count} up to "
            f"{most_redshift!r}.",
            errors=[FieldError(reason="no population", parameter="count", value=count)],
        )
    random = np.random.default_rng(seed)
    redshift = _redshifts(random.uniform(size=count), most_redshift)
    masses = _masses(random, count)
    tides = _LAMBDA * (masses / _REFERENCE) ** _POWER
    return {
        "mass_1_source": masses[0], "mass_2_source": masses[1], "redshift": redshift,
        "luminosity_distance": luminosity_distance(redshift), "lambda_1": tides[0], "lambda_2": tides[1],
        "chi_1": random.uniform(-_SPIN, _SPIN, count), "chi_2": random.uniform(-_SPIN, _SPIN, count),
        "theta_jn": np.arccos(random.uniform(-1.0, 1.0, count)), "ra": random.uniform(0.0, 2.0 * np.pi, count),
        "dec": np.arcsin(random.uniform(-1.0, 1.0, count)), "psi": random.uniform(0.0, np.pi, count),
        "phase": random.uniform(0.0, 2.0 * np.pi, count), "geocent_time": _BEGIN + random.uniform(0.0, _YEAR, count),
    }  # fmt: skip


def _expansion(redshift: Floats) -> Floats:
    """H(z) / H(0)."""
    return np.sqrt(_MATTER * (1.0 + redshift) ** 3 + 1.0 - _MATTER)


def _redshifts(uniform: Floats, most: float) -> Floats:
    """Where the distribution function of the mergers' redshifts has these values."""
    grid = np.linspace(0.0, most, _GRID)
    comoving = luminosity_distance(grid) / (1.0 + grid)
    stars = (1.0 + grid) ** 2.7 / (1.0 + ((1.0 + grid) / 2.9) ** 5.6)
    density = stars / (1.0 + grid) * comoving**2 / _expansion(grid)
    whole = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(grid) * (density[1:] + density[:-1]))])
    return np.asarray(np.interp(uniform * whole[-1], whole, grid))


def _masses(random: np.random.Generator, count: int) -> Floats:
    """Of the heavier and the lighter star, ``(2, count)``."""
    found = random.normal(_MASS, _WIDTH, (2, count))
    while (beyond := (found < _MASSES[0]) | (found > _MASSES[1])).any():
        found[beyond] = random.normal(_MASS, _WIDTH, int(beyond.sum()))
    return np.asarray(np.sort(found, axis=0)[::-1])
