"""One injection: drawn from the prior, put into seeded noise, sampled through a service; where the truth lies."""

from __future__ import annotations

import sys
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
from bnserve_inference import LikelihoodOptions, roq_analysis
from bnserve_inference import likelihood as bound_likelihood
from bnserve_inference.roq import load_shipped_basis
from bnserve_posterior.sampling import Posterior, PosteriorUnreliable, Problem, Settings, sample
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
SETTINGS = Settings(particles=600, effective=3000)
"""Ranks of a hundred injections need no more."""
_TRIES = 4
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


def _sampled(problem: Problem, settings: Settings) -> Posterior:
    """With twice the particles where these are too few: no injection is left out."""
    for _ in range(_TRIES - 1):
        try:
            return sample(problem, settings)
        except PosteriorUnreliable as error:
            print(f"seed {settings.seed}, {settings.particles} particles: {error}", file=sys.stderr, flush=True)
            settings = replace(settings, particles=2 * settings.particles)
    return sample(problem, settings)


def run(
    seed: int, asds: list[Floats], local: WaveformModel, model: Any, settings: Settings = SETTINGS
) -> dict[str, Any]:
    """Sample one injection.

    Returns
    -------
    result:
        ``seed``, ``ranks`` (the fraction of the posterior below the truth, by parameter), ``snr``, ``calls``,
        ``seconds``, ``log_evidence``, its error and that of either half, ``k_hat``, and the ``effective`` samples.
    """
    started = time.perf_counter()
    truth, signal = draw(seed)
    data = setting.simulated(asds, local, signal, seed)
    analysis = roq_analysis(
        data, trigger_time=setting.TRIGGER, basis=load_shipped_basis(BASIS), model=local, options=OPTIONS
    )
    likelihood = bound_likelihood(model, analysis)
    problem = Problem(lambda u: likelihood.log_likelihood(cube_to_batch(u)), len(NAMES), BINARY, PERIODIC)
    found = _sampled(problem, replace(settings, seed=seed))
    below = found.weights @ (found.points < truth)
    return {
        "seed": seed,
        "ranks": {name: round(float(rank), 5) for name, rank in zip(NAMES, below, strict=True)},
        "snr": round(setting.network_snr(setting.simulated(asds, local, signal, None)), 2),
        "calls": found.likelihoods,
        "seconds": round(time.perf_counter() - started, 2),
        "log_evidence": round(found.log_evidence, 3),
        "log_evidence_error": round(found.log_evidence_error, 3),
        "log_evidences": [[round(number, 3) for number in each] for each in found.log_evidences],
        "k_hat": round(found.k_hat, 2),
        "effective": round(found.effective, 1),
    }
