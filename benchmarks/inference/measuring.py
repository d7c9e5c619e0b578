"""Times and errors of likelihoods through a service."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817 import setting
from bnserve_inference import LikelihoodOptions, full_analysis, relative_binning_analysis, roq_analysis
from bnserve_inference.roq import load_shipped_basis
from bnserve_protocol import LIKELIHOOD_NAMES, Analysis, LikelihoodBatch, WaveformModel

Floats = NDArray[np.float64]
ROWS = 4096
"""Samples in a call: what a service takes at once."""
PHASE_TOLERANCE = 0.2
"""Radians across a bin, to begin with: bins are placed anew until they serve the whole prior."""


def plain_analyses(event: setting.Injected, model: WaveformModel) -> dict[str, Analysis]:
    """The three kinds for the same data, with the phase integrated over as samplers like it, and nothing else."""
    options = LikelihoodOptions(prior=setting.RANGES, phase_marginalisation=True, modes=setting.MODES)
    band: dict[str, Any] = {"trigger_time": setting.TRIGGER, "f_min": setting.F_MIN, "f_max": setting.F_MAX}
    basis = load_shipped_basis(setting.BASIS)
    return {
        "roq": roq_analysis(event.data, trigger_time=setting.TRIGGER, basis=basis, model=model, options=options),
        "relative_binning": relative_binning_analysis(
            event.data,
            **band,
            fiducial=setting.fiducial(),
            model=model,
            phase_tolerance=PHASE_TOLERANCE,
            options=options,
        ),
        "full": full_analysis(event.data, **band, options=options),
    }


def prior_samples(rows: int, seed: int = 3) -> LikelihoodBatch:
    """Draws from the prior, distances included."""
    random = np.random.default_rng(seed)
    cube = setting.prior_cube()
    batch = cube.batch(cube(random.random((rows, len(cube)))))
    batch.values[:, LIKELIHOOD_NAMES.index("distance_mpc")] = random.uniform(*setting.DISTANCES, rows)
    return LikelihoodBatch(batch.values)


def posterior_points(count: int) -> LikelihoodBatch:
    """Draws from the posterior of the injection, at most 1000, as ``benchmarks.gw170817`` leaves in ``draws.npz``."""
    with np.load(Path(__file__).with_name("posterior_points.npz"), allow_pickle=False) as file:
        values = file["values"]
    return LikelihoodBatch(values[:count])


def in_turns(calls: Mapping[str, Callable[[], float]], rounds: int) -> dict[str, list[float]]:
    """Every call's own measurements, in turns, so that what disturbs one disturbs all; the first round is not kept."""
    found: dict[str, list[float]] = {name: [] for name in calls}
    for turn in range(rounds + 1):
        for name, call in calls.items():
            value = call()
            if turn:
                found[name].append(value)
    return found


def microseconds(call: Callable[[], object], rows: int) -> float:
    """Of one sample in a call of that many."""
    started = time.perf_counter()
    call()
    return 1e6 * (time.perf_counter() - started) / rows


def described(values: list[float]) -> dict[str, float]:
    """Median, and the least disturbed round."""
    return {"median": round(statistics.median(values), 2), "best": round(min(values), 2)}
