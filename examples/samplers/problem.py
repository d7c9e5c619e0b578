"""What the examples of samplers look for: a binary neutron star in simulated noise of three detectors.

Four parameters are sampled; the others are taken as known, and the phase is integrated out.
The analysis is built here and uploaded once; from then on parameters go to the server, log-likelihoods come back.
"""

import argparse
import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_client import Analysis, Likelihood, LikelihoodBatch, LikelihoodParameters, Model
from bnserve_inference import (
    DetectorData,
    LikelihoodOptions,
    interpolate_asd,
    read_asd,
    relative_binning_analysis,
    simulate_data,
)

Floats = NDArray[np.float64]

DETECTORS, TRIGGER = ("H1", "L1", "V1"), 1187008882.4
DURATION, SAMPLING = 16.0, 4096.0
START = TRIGGER - DURATION + 2.0
F_MIN, F_MAX = 50.0, 1024.0  # Hz; from 50 Hz on, the binary lives for less than DURATION

SIGNAL = {
    "chirp_mass": 1.1975, "mass_ratio": 1.4, "distance_mpc": 60.0, "coalescence_time": 0.002,
    "lambda_1": 300.0, "lambda_2": 700.0, "chi_1": 0.01, "chi_2": 0.0, "inclination": 2.5,
    "right_ascension": 3.45, "declination": -0.41, "polarization_angle": 0.3,
}  # fmt: skip
PRIOR = {
    "chirp_mass": (1.197, 1.1985),  # solar masses, uniform, as all but the distance
    "mass_ratio": (1.0, 2.0),
    "distance_mpc": (40.0, 80.0),  # uniform in volume
    "coalescence_time": (-0.002, 0.006),  # seconds from TRIGGER
}
SAMPLED = tuple(PRIOR)
FIXED = {name: value for name, value in SIGNAL.items() if name not in PRIOR}
LOW, HIGH = np.array(list(PRIOR.values())).T
DISTANCE = SAMPLED.index("distance_mpc")
TRUTH = np.array([SIGNAL[name] for name in SAMPLED])


def columns(points: Floats) -> dict[str, Floats | float]:
    """Points of the sampled parameters, ``(N, 4)`` or ``(4,)``, as what a likelihood takes."""
    named = dict(zip(SAMPLED, points.T, strict=True))
    chirp_mass, q = named.pop("chirp_mass"), named["mass_ratio"]
    return FIXED | named | {"total_mass": chirp_mass * ((1.0 + q) ** 2 / q) ** 0.6}


def from_unit_cube(cube: Floats) -> Floats:
    """The prior as a map from the unit cube, ``(..., 4)`` both."""
    points = LOW + (HIGH - LOW) * np.asarray(cube)
    low, high = PRIOR["distance_mpc"]
    points[..., DISTANCE] = np.cbrt(low**3 + (high**3 - low**3) * np.asarray(cube)[..., DISTANCE])
    return points


def log_prior(points: Floats) -> Floats:
    """Its logarithm up to a constant, ``(N,)`` for points ``(N, 4)``."""
    inside = ((points >= LOW) & (points <= HIGH)).all(axis=1)
    return np.where(inside, 2.0 * np.log(np.abs(points[:, DISTANCE]) + 1e-300), -np.inf)


@dataclass
class Problem:
    """The likelihood for samplers: of points in arrays, counted. It can be pickled and used by any process."""

    likelihood: Likelihood
    requests: int = 0

    @classmethod
    def pose(cls, model: Model, asd_files: list[str]) -> "Problem":
        """Simulate, build the analysis, upload it."""
        return cls(model.likelihood(build_analysis(model, simulate(model, asd_files))))

    def log_likelihood(self, points: Floats) -> Floats:
        """Of the sampled parameters ``(N, 4)``, ``(N,)``; one request, however many points."""
        self.requests += 1
        return self.likelihood.log_likelihood(columns(points))

    def log_likelihood_of_one(self, point: Floats) -> float:
        """Of one point ``(4,)``."""
        return float(self.log_likelihood(np.asarray(point)[np.newaxis])[0])


def advanced_ligo_asd(frequencies: Floats) -> Floats:
    """The analytic fit to the design sensitivity of Advanced LIGO (Ajith 2011, eq. 4.7), in 1/sqrt(Hz)."""
    x = frequencies / 215.0
    return np.sqrt(1e-49 * (x**-4.14 - 5.0 * x**-2 + 111.0 * (1.0 - x**2 + 0.5 * x**4) / (1.0 + 0.5 * x**2)))


def simulate(model: Model, asd_files: list[str]) -> list[DetectorData]:
    """The injection in seeded noise; ASDs from files where they are given."""
    points = int(DURATION * SAMPLING / 2) + 1
    coarse = np.linspace(20.0, SAMPLING / 2, 2000)
    if asd_files:
        asds = [read_asd(path, DURATION, points) for path in asd_files]
    else:
        asds = [interpolate_asd(coarse, advanced_ligo_asd(coarse), DURATION, points)] * len(DETECTORS)
    return simulate_data(
        DETECTORS, asds, model=model, parameters=LikelihoodParameters(**columns(TRUTH)), trigger_time=TRIGGER,
        start_time=START, duration=DURATION, seed=20170817, f_min=F_MIN,
    )  # fmt: skip


def build_analysis(model: Model, data: list[DetectorData]) -> Analysis:
    """Its analysis by relative binning; an analysis of real data takes a trigger's parameters for the fiducial ones."""
    return relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, model=model,
        fiducial=LikelihoodBatch.coerce(columns(TRUTH)).waveform_batch(),
        options=LikelihoodOptions(
            prior={"coalescence_time": PRIOR["coalescence_time"]}, phase_marginalisation=True
        ),
    )  # fmt: skip


def arguments(description: str) -> argparse.Namespace:
    """What every one of the examples may be told."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("address", nargs="?", default="http://127.0.0.1:8000", help="of the server (also unix:PATH)")
    parser.add_argument("--short", action="store_true", help="seconds instead of minutes, with fewer samples")
    parser.add_argument(
        "--asd", nargs=len(DETECTORS), metavar=DETECTORS, default=[], help="text files: Hz and 1/sqrt(Hz)"
    )
    return parser.parse_args()


def report(samples: Floats, weights: Floats | None, seconds: float, counts: str, evidence: str = "") -> None:
    """Print what was found beside what was injected; end with an error where the two do not agree.

    Parameters
    ----------
    samples, weights:
        Of the posterior, ``(N, 4)`` and ``(N,)``.
    """
    mean = np.average(samples, axis=0, weights=weights)
    spread = np.sqrt(np.average((samples - mean) ** 2, axis=0, weights=weights))
    print(f"{'parameter':<18} {'injected':>12} {'mean':>12} {'std':>12}")
    for row in zip(SAMPLED, TRUTH, mean, spread, strict=True):
        print("{:<18} {:12.6g} {:12.6g} {:12.3g}".format(*row))
    if evidence:
        print(f"log evidence: {evidence}")
    print(f"{counts}, {seconds:.1f} s")
    missed = [name for name, off in zip(SAMPLED, np.abs(mean - TRUTH) > 4.0 * spread, strict=True) if off]
    vague = [name for name in ("chirp_mass", "distance_mpc", "coalescence_time")
             if not spread[SAMPLED.index(name)] < 0.2 * np.ptp(PRIOR[name])]  # fmt: skip
    if missed or vague:
        sys.exit(f"Not what was injected: {missed or 'none'}; no better known than before: {vague or 'none'}.")
    print("The posterior holds what was injected.")
