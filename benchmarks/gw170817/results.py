"""What a finished run is turned into: figures, and the same posterior with other likelihoods."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.generator_model import GeneratorModel
from benchmarks.gw170817 import analyses, checks, setting
from benchmarks.gw170817.priors import UnitCube
from benchmarks.gw170817.sampling import Posterior, equal_weights
from bnserve_inference import likelihood
from bnserve_protocol import LIKELIHOOD_NAMES, LikelihoodBatch, WaveformModel
from bnserve_surrogate.training.generators import TEOBResumSPA

Floats = NDArray[np.float64]


def summary(posterior: Posterior) -> dict[str, Any]:
    """The sampler's own figures."""
    cost = posterior.cost
    return {
        "posterior_minutes": round(cost.wall / 60.0, 3),
        "likelihood_seconds": round(cost.likelihood, 2),
        "sampler_processor_seconds": round(cost.processor, 1),
        "likelihood_calls": cost.calls,
        "likelihood_requests": cost.requests,
        "log_evidence": round(posterior.log_evidence, 3),
        "samples": len(posterior.weights),
        "largest_log_likelihood": round(float(posterior.log_likelihood.max()), 3),
    }


def check(
    posterior: Posterior, event: setting.Event, local: WaveformModel, model: Any, cube: UnitCube, options: Namespace
) -> dict[str, Any]:
    """Other likelihoods at draws of the posterior; what was computed is kept in the folder of the run.

    Writes ``draws.npz`` there: ``values`` (N, 13) with distances, ``log_likelihood`` of every kind (N,).
    """
    chosen = equal_weights(posterior, options.checks)
    batch = cube(posterior.points[chosen])
    sampled = posterior.log_likelihood[chosen]
    values = batch.values.copy()
    distance = likelihood(model, analyses.kept("distance", event, local, options.work))
    values[:, LIKELIHOOD_NAMES.index("distance_mpc")] = checks.distances(distance, batch)
    arrays: dict[str, Floats] = {"values": values, options.kind: sampled}
    folder: Path = options.work / options.kind
    found: dict[str, Any] = {"checks": len(batch)}
    other = "relative_binning" if options.kind == "roq" else "roq"
    for kind in (other, "full"):
        arrays[kind] = likelihood(model, analyses.kept(kind, event, local, options.work)).log_likelihood(batch)
        found |= _compared(f"{options.kind}_and_{kind}", arrays[kind], sampled)
    if options.calibration_draws:
        arrays["calibration"] = _calibrated(batch, event, local, model, options)
        found |= _compared("calibration_envelopes", arrays["calibration"], sampled)
    arrays["generator"] = _generated(batch, event, options)
    few = len(arrays["generator"])
    found |= {"generator_checks": few}
    found |= _compared("surrogate_and_generator", arrays["generator"], arrays["full"][:few])
    np.savez(folder / "draws.npz", **arrays)
    return found


def _compared(name: str, exact: Floats, sampled: Floats) -> dict[str, float]:
    delta = np.abs(exact - sampled)
    _, shift, efficiency = checks.reweighted(exact, sampled)
    return {
        f"{name}_max_abs_delta_lnl": round(float(delta.max()), 5),
        f"{name}_median_abs_delta_lnl": round(float(np.median(delta)), 5),
        f"{name}_log_evidence_shift": round(shift, 4),
        f"{name}_reweighting_efficiency": round(efficiency, 4),
    }


def _calibrated(batch: LikelihoodBatch, event: setting.Event, local: WaveformModel, model: Any, o: Namespace) -> Floats:
    bound = likelihood(model, analyses.kept("calibration", event, local, o.work))
    prior = checks.CalibrationPrior(o.data, analyses.CALIBRATION)
    return checks.calibrated(bound, batch, prior, o.calibration_draws)


def _generated(batch: LikelihoodBatch, event: setting.Event, options: Namespace) -> Floats:
    """TEOBResumSPA itself on the full grid: the generator is evaluated in this process."""
    few = batch.rows(slice(0, options.generator_checks))
    full = analyses.kept("full", event, GeneratorModel(TEOBResumSPA()), options.work)
    return np.asarray(likelihood(GeneratorModel(TEOBResumSPA()), full).log_likelihood(few))
