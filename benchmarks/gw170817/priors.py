"""The paper's priors, as maps from the unit cube to what the likelihood takes.

Eleven parameters are sampled; the phase is integrated over by the likelihood, and so is the distance. Where the prior
is the same in other coordinates, those are used in which the posterior is simple: the place in the sky as angles to the
line between the two LIGO detectors, the time as that of the arrival at Hanford, and the polarisation angle over a
quarter of a turn, because another quarter turns the sign of a signal, which is a phase.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817 import setting
from bnserve_inference import Detector, sidereal_time
from bnserve_protocol import DistanceMarginalisation, LikelihoodBatch

Floats = NDArray[np.float64]

NAMES = (
    "chirp_mass", "mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2", "inclination", "zenith", "azimuth",
    "polarization_angle", "arrival_time",
)  # fmt: skip
"""What is sampled, in the order of the columns of the unit cube."""
CHIRP_MASSES, MASS_RATIOS = (1.1968, 1.1988), (1.0, 3.0)
LARGEST_SPIN, LAMBDAS = 0.5, (5.0, 5000.0)
DISTANCES = (1.0, 75.0)
ARRIVALS = (-0.05, 0.05)
"""Seconds around the trigger at which the merger may reach Hanford."""
COALESCENCE = (-0.08, 0.08)
"""The same at the centre of the Earth, which light reaches within 21.3 ms."""
LIGHT_SPEED = 299792458.0
RANGES = {
    "mass_ratio": MASS_RATIOS, "chi_1": (-LARGEST_SPIN, LARGEST_SPIN), "chi_2": (-LARGEST_SPIN, LARGEST_SPIN),
    "lambda_1": LAMBDAS, "lambda_2": LAMBDAS, "chirp_mass": CHIRP_MASSES, "coalescence_time": COALESCENCE,
}  # fmt: skip
"""The box of the analyses."""
DISTANCE = DistanceMarginalisation(minimum=DISTANCES[0], maximum=DISTANCES[1], power=2.0)
_TABLE = 4097


def _inverse(density: Floats, x: Floats, u: Floats) -> Floats:
    """The inverse of the distribution with that density (at ``x``, not normalised)."""
    steps = 0.5 * (density[1:] + density[:-1]) * np.diff(x)
    cumulative = np.concatenate([[0.0], np.cumsum(steps)])
    return np.interp(u, cumulative / cumulative[-1], x)


def mass_ratios(u: Floats) -> Floats:
    """q of a prior that is flat in both masses at fixed chirp mass: p(q) ~ (1 + q)^(2/5) q^(-6/5)."""
    q = np.linspace(*MASS_RATIOS, _TABLE)
    return _inverse((1.0 + q) ** 0.4 * q**-1.2, q, u)


def chirp_masses(u: Floats) -> Floats:
    """Mc of a prior that is flat in both masses: p(Mc) ~ Mc."""
    low, high = np.square(CHIRP_MASSES)
    return np.sqrt(low + u * (high - low))


def aligned_spins(u: Floats) -> Floats:
    """The aligned component of an isotropic spin of uniform size: P(abs(chi) < x chi_max) = x (1 - ln x)."""
    x = np.concatenate([[0.0], np.geomspace(1e-12, 1.0, _TABLE)])
    cumulative = np.concatenate([[0.0], x[1:] * (1.0 - np.log(x[1:]))])
    return LARGEST_SPIN * np.copysign(np.interp(np.abs(2.0 * u - 1.0), cumulative, x), u - 0.5)


def spin_quantiles(chi: Floats) -> Floats:
    """Where :func:`aligned_spins` has that value; for spins up to the largest."""
    x = np.clip(np.abs(chi) / LARGEST_SPIN, 1e-300, 1.0)
    return 0.5 + 0.5 * np.copysign(x * (1.0 - np.log(x)), chi)


def spin_density(chi: Floats) -> Floats:
    """Probability per unit of spin, du / dchi."""
    x = np.clip(np.abs(chi) / LARGEST_SPIN, 1e-300, 1.0 - 1e-12)
    return -0.5 / LARGEST_SPIN * np.log(x)


class Sky:
    """Places in the sky by their angles to the line from Hanford to Livingston, which fixes the delay between them."""

    def __init__(self) -> None:
        hanford, livingston = (Detector.named(name).location for name in ("H1", "L1"))
        axis = (livingston - hanford) / np.linalg.norm(livingston - hanford)
        other = np.cross(axis, [0.0, 0.0, 1.0])
        other /= np.linalg.norm(other)
        self._axes = np.array([other, np.cross(axis, other), axis])
        self._hanford = hanford
        self._sidereal = sidereal_time(setting.TRIGGER)[0]

    def place(self, cosine: Floats, azimuth: Floats) -> tuple[Floats, Floats, Floats]:
        """Right ascension, declination, and how much later (s) than at the Earth's centre the signal is at Hanford."""
        sine = np.sqrt(np.maximum(0.0, 1.0 - cosine**2))
        local = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)
        direction = local @ self._axes
        right_ascension = np.mod(np.arctan2(direction[:, 1], direction[:, 0]) + self._sidereal, 2.0 * np.pi)
        declination = np.arcsin(np.clip(direction[:, 2], -1.0, 1.0))
        return right_ascension, declination, -(direction @ self._hanford) / LIGHT_SPEED


class UnitCube:
    """From the unit cube, ``(N, 11)`` in the order of :data:`NAMES`, to a batch of the likelihood's parameters."""

    def __init__(self) -> None:
        self._sky = Sky()

    def __call__(self, u: Floats) -> LikelihoodBatch:
        """Rows of parameters; the distance is left out, which the likelihood integrates over."""
        column = dict(zip(NAMES, np.atleast_2d(u).T, strict=True))
        q = mass_ratios(column["mass_ratio"])
        right_ascension, declination, delay = self._sky.place(
            2.0 * column["zenith"] - 1.0, 2.0 * np.pi * column["azimuth"]
        )
        arrival = ARRIVALS[0] + column["arrival_time"] * (ARRIVALS[1] - ARRIVALS[0])
        return LikelihoodBatch.coerce(
            {
                "total_mass": setting.total_mass(chirp_masses(column["chirp_mass"]), q),
                "mass_ratio": q,
                "chi_1": aligned_spins(column["chi_1"]),
                "chi_2": aligned_spins(column["chi_2"]),
                "lambda_1": LAMBDAS[0] + column["lambda_1"] * (LAMBDAS[1] - LAMBDAS[0]),
                "lambda_2": LAMBDAS[0] + column["lambda_2"] * (LAMBDAS[1] - LAMBDAS[0]),
                "inclination": np.arccos(1.0 - 2.0 * column["inclination"]),
                "right_ascension": right_ascension,
                "declination": declination,
                "polarization_angle": 0.5 * np.pi * column["polarization_angle"],
                "coalescence_time": arrival - delay,
            }
        )
