"""One injection: drawn from the prior, put into seeded noise, sampled through a service; where the truth lies."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817 import priors, setting
from benchmarks.gw170817.analyses import BASIS
from benchmarks.gw170817.coordinates import BINARY
from benchmarks.gw170817.priors import LAMBDAS, aligned_spins, chirp_masses, mass_ratios
from benchmarks.gw170817.setting import total_mass
from benchmarks.pp.sampling import SETTINGS, kept, sampled
from bnserve_inference import LikelihoodOptions, roq_analysis
from bnserve_inference import likelihood as bound_likelihood
from bnserve_inference.roq import load_shipped_basis
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
PERIODIC = (NAMES.index("polarization_angle"),)
OPTIONS = LikelihoodOptions(
    prior=priors.RANGES | {"coalescence_time": TIMES},
    phase_marginalisation=True,
    distance_marginalisation=DistanceMarginalisation(minimum=DISTANCES[0], maximum=DISTANCES[1], power=2.0),
    modes=setting.MODES,
)


def cube_to_batch(u: Floats) -> LikelihoodBatch:
    """From the unit cube ``(N, 9)``, columns as in :data:`NAMES`, to parameters; the distance is left out."""
    column = dict(zip(NAMES, u.T, strict=True))
    q = mass_ratios(column["mass_ratio"])
    return LikelihoodBatch.coerce(
        PLACE
        | {
            "total_mass": total_mass(chirp_masses(column["chirp_mass"]), q),
            "mass_ratio": q,
            "chi_1": aligned_spins(column["chi_1"]),
            "chi_2": aligned_spins(column["chi_2"]),
            "lambda_1": LAMBDAS[0] + column["lambda_1"] * (LAMBDAS[1] - LAMBDAS[0]),
            "lambda_2": LAMBDAS[0] + column["lambda_2"] * (LAMBDAS[1] - LAMBDAS[0]),
            "inclination": np.arccos(1.0 - 2.0 * column["inclination"]),
            "polarization_angle": 0.5 * np.pi * column["polarization_angle"],
            "coalescence_time": TIMES[0] + column["coalescence_time"] * (TIMES[1] - TIMES[0]),
        }
    )


def draw(seed: int) -> tuple[Floats, LikelihoodParameters]:
    """A binary of the prior: its place in the unit cube ``(9,)``, and its parameters."""
    random = np.random.default_rng([seed, 170817])
    u = random.random(len(NAMES))
    low, high = np.power(DISTANCES, 3)
    row = cube_to_batch(u[None, :])
    values: dict[str, Any] = {name: float(row[name][0]) for name in LIKELIHOOD_NAMES}
    values["distance_mpc"] = float(np.cbrt(low + random.random() * (high - low)))
    values["reference_phase"] = float(random.uniform(0.0, 4.0 * np.pi))  # it is twice the orbital phase
    return u, LikelihoodParameters(**values)


def run(
    seed: int, asds: list[Floats], local: WaveformModel, model: Any, settings: Settings = SETTINGS
) -> dict[str, Any]:
    """Sample one injection; returns as :func:`benchmarks.pp.sampling.kept`."""
    started = time.perf_counter()
    truth, signal = draw(seed)
    data = setting.simulated(asds, local, signal, seed)
    analysis = roq_analysis(
        data, trigger_time=setting.TRIGGER, basis=load_shipped_basis(BASIS), model=local, options=OPTIONS
    )
    likelihood = bound_likelihood(model, analysis)
    problem = Problem(lambda u: likelihood.log_likelihood(cube_to_batch(u)), len(NAMES), BINARY, PERIODIC)
    found = sampled(problem, replace(settings, seed=seed))
    ranks = dict(zip(NAMES, found.weights @ (found.points < truth), strict=True))
    snr = setting.network_snr(setting.simulated(asds, local, signal, None))
    return kept(seed, ranks, snr, time.perf_counter() - started, found)
