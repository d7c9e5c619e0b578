"""One injection: drawn from the prior, put into seeded noise, sampled through a service; where the truth lies."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.analyses import PHASE_TOLERANCE
from benchmarks.gw170817.annealing import Annealing, anneal
from benchmarks.gw170817.priors import aligned_spins, chirp_masses, mass_ratios
from benchmarks.gw170817.setting import CHIRP_MASS, DETECTORS, TRIGGER, total_mass
from bnserve_inference import DetectorData, LikelihoodOptions, interpolate_asd, relative_binning_analysis, simulate_data
from bnserve_inference import likelihood as bound_likelihood
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
DURATION, F_MIN, F_MAX = 32.0, 40.0, 1024.0
DISTANCES, TIMES, LAMBDAS = (20.0, 60.0), (-0.01, 0.01), (5.0, 5000.0)
SETTINGS = Annealing(particles=500, sweeps=10, final_sweeps=60, keep_every=20)


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


def read_asds(folder: Path) -> list[Floats]:
    """The event's noise curves on the grid of this test."""
    with np.load(folder / "gw170817" / "asd.npz", allow_pickle=False) as file:
        f = (int(file["first_bin"]) + np.arange(len(file["H1"]))) * float(file["delta_f"])
        points = int(DURATION * 1536) + 1
        return [interpolate_asd(f, 1e-23 * file[name].astype(float), DURATION, points) for name in DETECTORS]


def draw(seed: int) -> tuple[Floats, LikelihoodParameters]:
    """A binary of the prior: its place in the unit cube ``(9,)``, and its parameters."""
    random = np.random.default_rng([seed, 170817])
    u = random.random(len(NAMES))
    low, high = np.power(DISTANCES, 3)
    row = cube_to_batch(u[None, :])
    values = {name: float(row[name][0]) for name in LIKELIHOOD_NAMES}
    values["distance_mpc"] = float(np.cbrt(low + random.random() * (high - low)))
    values["reference_phase"] = float(random.uniform(0.0, 2.0 * np.pi))
    return u, LikelihoodParameters(**values)


def run(seed: int, asds: list[Floats], local: WaveformModel, model: Any) -> dict[str, Any]:
    """Sample one injection.

    Returns
    -------
    result:
        ``seed``, ``ranks`` (the fraction of the posterior below the truth, by parameter), ``snr``, ``calls``,
        ``seconds``, ``log_evidence``.
    """
    started = time.perf_counter()
    truth, signal = draw(seed)
    settings = {
        "model": local, "parameters": signal, "trigger_time": TRIGGER, "start_time": TRIGGER - DURATION + 2.0,
        "duration": DURATION, "f_min": F_MIN,
    }  # fmt: skip
    data = simulate_data(DETECTORS, asds, seed=seed, **settings)
    options = LikelihoodOptions(
        prior={"coalescence_time": TIMES},
        phase_marginalisation=True,
        distance_marginalisation=DistanceMarginalisation(minimum=DISTANCES[0], maximum=DISTANCES[1], power=2.0),
    )
    analysis = relative_binning_analysis(
        data,
        trigger_time=TRIGGER,
        f_min=F_MIN,
        f_max=F_MAX,
        fiducial=_fiducial(),
        model=local,
        phase_tolerance=PHASE_TOLERANCE,
        options=options,
    )
    likelihood, calls = bound_likelihood(model, analysis), 0

    def log_likelihood(u: Floats) -> Floats:
        nonlocal calls
        calls += len(u)
        return likelihood.log_likelihood(cube_to_batch(u))

    found = anneal(log_likelihood, len(NAMES), Annealing(**{**vars(SETTINGS), "seed": seed}), None)
    return {
        "seed": seed,
        "ranks": {name: float(np.mean(found.points[:, column] < truth[column])) for column, name in enumerate(NAMES)},
        "snr": round(_snr(simulate_data(DETECTORS, asds, seed=None, **settings)), 2),
        "calls": calls,
        "seconds": round(time.perf_counter() - started, 2),
        "log_evidence": round(found.log_evidence, 3),
    }


def _fiducial() -> Any:
    """The same for all: relative binning may not know the truth."""
    middle = {"mass_ratio": 1.4, "lambda_1": 500.0, "lambda_2": 500.0, "chi_1": 0.0, "chi_2": 0.0, "inclination": 0.0}
    values = middle | PLACE | {"polarization_angle": 0.0, "distance_mpc": 40.0, "coalescence_time": 0.0}
    return LikelihoodBatch.coerce(values | {"total_mass": float(total_mass(CHIRP_MASS, 1.4))}).waveform_batch()


def _snr(data: list[DetectorData]) -> float:
    squares = [
        4.0 / DURATION * np.sum(np.abs(strain / asd) ** 2)
        for strain, asd in (detector.checked(F_MIN, F_MAX) for detector in data)
    ]
    return float(np.sqrt(sum(squares)))
