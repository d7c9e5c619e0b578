"""One injection: drawn from the prior, put into seeded noise, sampled through a service; where the truth lies."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817 import setting
from benchmarks.pp.sampling import SETTINGS, kept, sampled
from bnserve_inference import Detector, LikelihoodOptions, roq_analysis
from bnserve_inference import likelihood as bound_likelihood
from bnserve_inference.roq import load_shipped_basis
from bnserve_posterior.priors import PriorCube, coordinates_of, priors_of
from bnserve_posterior.sampling import Problem, Settings
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    DistanceMarginalisation,
    LikelihoodBatch,
    LikelihoodParameters,
    WaveformModel,
)

Floats = NDArray[np.float64]

NAMES = (
    "chirp_mass", "mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2", "inclination", "polarization_angle",
    "coalescence_time",
)  # fmt: skip
"""What is sampled; the place in the sky is fixed, phase and distance are integrated over."""
PLACE = {"right_ascension": 3.44616, "declination": -0.408084}
DISTANCES, TIMES = (12.0, 30.0), (-0.01, 0.01)
OPTIONS = LikelihoodOptions(
    prior=setting.RANGES | {"coalescence_time": TIMES},
    phase_marginalisation=True,
    distance_marginalisation=DistanceMarginalisation(minimum=DISTANCES[0], maximum=DISTANCES[1], power=2.0),
    modes=setting.MODES,
)
_BILBY = {"inclination": "theta_jn", "polarization_angle": "psi"}
"""Names of priors where they are others."""


def prior_cube() -> PriorCube:
    """The prior of the event at that place, of nine parameters."""
    place = {"ra": PLACE["right_ascension"], "dec": PLACE["declination"]}
    given = {**setting.paper_event().prior, **place, "luminosity_distance": DISTANCES}
    given["geocent_time"] = setting.TRIGGER + TIMES[0], setting.TRIGGER + TIMES[1]
    return PriorCube(
        priors_of(given, setting.TRIGGER)[0], setting.TRIGGER, ("phase", "luminosity_distance"), quadrupole=True
    )


def places(cube: PriorCube, u: Floats) -> Floats:
    """Points of the cube ``(N, 9)``, columns in its order, from such in the order of :data:`NAMES`.

    bilby's mass ratio is the inverse of ours.
    """
    column = dict(zip(NAMES, u.T, strict=True))
    column["mass_ratio"] = 1.0 - column["mass_ratio"]
    ours = {_BILBY.get(name, name): name for name in NAMES}
    return np.stack([column[ours[name]] for name in cube.names], axis=1)


def draw(cube: PriorCube, seed: int) -> LikelihoodParameters:
    """A binary of the prior."""
    random = np.random.default_rng([seed, 170817])
    u = random.random(len(NAMES))
    low, high = np.power(DISTANCES, 3)
    row = cube.batch(cube(places(cube, u[None])))
    values: dict[str, Any] = {name: float(row[name][0]) for name in LIKELIHOOD_NAMES}
    values["distance_mpc"] = float(np.cbrt(low + random.random() * (high - low)))
    values["reference_phase"] = float(random.uniform(0.0, 4.0 * np.pi))  # it is twice the orbital phase
    return LikelihoodParameters(**values)


def ranked(batch: LikelihoodBatch) -> dict[str, Floats]:
    """What is ranked of binaries, by the names in :data:`NAMES`."""
    q = batch["mass_ratio"]
    return {name: batch[name] for name in NAMES[1:]} | {"chirp_mass": batch["total_mass"] * (q / (1.0 + q) ** 2) ** 0.6}


def run(
    seed: int, asds: list[Floats], local: WaveformModel, model: Any, settings: Settings = SETTINGS
) -> dict[str, Any]:
    """Sample one injection; returns as :func:`benchmarks.pp.sampling.kept`."""
    started = time.perf_counter()
    cube = prior_cube()
    signal = draw(cube, seed)
    data = setting.simulated(asds, local, signal, seed)
    analysis = roq_analysis(
        data, trigger_time=setting.TRIGGER, basis=load_shipped_basis(setting.BASIS), model=local, options=OPTIONS
    )
    likelihood = bound_likelihood(model, analysis)
    sites = [Detector.named(name) for name in setting.DETECTORS]
    problem = Problem(lambda u: likelihood.log_likelihood(cube.batch(cube(u))), len(cube), coordinates_of(cube, sites))
    found = sampled(problem, replace(settings, seed=seed))
    truth, values = ranked(LikelihoodBatch.coerce(signal)), ranked(cube.batch(cube(found.points)))
    ranks = {name: found.weights @ (values[name] < truth[name]) for name in NAMES}
    snr = setting.network_snr(setting.simulated(asds, local, signal, None))
    return kept(seed, ranks, snr, time.perf_counter() - started, found)
