"""What a finished run is turned into: figures, and the same posterior with other likelihoods."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.generator_model import GeneratorModel
from benchmarks.gw170817 import analyses, checks, setting
from benchmarks.gw170817.marginals import Shown, divergences, physical
from benchmarks.gw170817.priors import UnitCube
from benchmarks.gw170817.sampling import Sampled
from bnserve_inference import likelihood
from bnserve_posterior.sampling import Posterior
from bnserve_protocol import LIKELIHOOD_NAMES, LikelihoodBatch, WaveformModel
from bnserve_surrogate.training.data.generators import TEOBResumSPA

Floats = NDArray[np.float64]

OTHER = {"roq": "relative_binning", "relative_binning": "roq"}


def summary(sampled: Sampled, cube: UnitCube) -> dict[str, Any]:
    """The sampler's own figures, and how much of the posterior is in its tails."""
    posterior, cost = sampled
    batch = cube(posterior.points)
    return {
        "posterior_minutes": round(cost.wall / 60.0, 3),
        "likelihood_seconds": round(cost.likelihood, 2),
        "sampler_processor_seconds": round(cost.processor, 1),
        "likelihood_calls": posterior.likelihoods,
        "likelihood_requests": cost.requests,
        "log_evidence": round(posterior.log_evidence, 3),
        "log_evidence_error": round(posterior.log_evidence_error, 3),
        "log_evidences": [[round(number, 3) for number in each] for each in posterior.log_evidences],
        "k_hat": round(posterior.k_hat, 2),
        "effective_samples": round(posterior.effective),
        "draws": len(posterior.weights),
        "largest_log_likelihood": round(float(posterior.log_likelihood.max()), 3),
        "part_with_abs_chi_1_above_0.2": round(float(posterior.weights[np.abs(batch["chi_1"]) > 0.2].sum()), 4),
        "part_with_mass_ratio_above_2": round(float(posterior.weights[batch["mass_ratio"] > 2.0].sum()), 4),
    }


def of_posterior(posterior: Posterior, cube: UnitCube) -> Shown:
    """What is shown of it: as many draws as it is worth, so that what weighs nothing stretches no axis."""
    batch = cube(posterior.points[posterior.draw(int(posterior.effective))])
    return Shown(physical(batch), np.full(len(batch), 1.0 / len(batch)))


def check(
    posteriors: Mapping[str, Posterior],
    event: setting.Event,
    local: WaveformModel,
    model: Any,
    cube: UnitCube,
    options: Namespace,
) -> tuple[dict[str, Any], dict[str, Shown]]:
    """Other likelihoods at draws of the posterior, and all posteriors beside each other.

    Writes ``draws.npz`` to the folder of the run: ``values`` (N, 13) with distances, ``log_likelihood`` of every kind.
    A posterior that was not sampled is the one that was, with weights: at milliseconds a likelihood nobody samples the
    full grid.

    Returns
    -------
    Figures, and what the corner plot shows, by likelihood.
    """
    first, posterior = options.kind, posteriors[options.kind]
    chosen = posterior.draw(options.checks)
    batch, sampled = cube(posterior.points[chosen]), posterior.log_likelihood[chosen]
    found: dict[str, Any] = {"checks": len(batch)}
    arrays: dict[str, Floats] = {"values": _with_distances(batch, event, local, model, options), first: sampled}
    for kind in (OTHER[first], "full"):
        arrays[kind] = likelihood(model, analyses.kept(kind, event, local, options.work)).log_likelihood(batch)
        found |= _compared(f"{first}_and_{kind}", arrays[kind], sampled)
    arrays["generator"] = _generated(batch, event, options)
    few = len(arrays["generator"])
    found |= {"generator_checks": few}
    found |= _compared("surrogate_and_generator", arrays["generator"], arrays["full"][:few])
    if options.calibration_draws:
        some = slice(0, options.calibration_checks)
        arrays["calibration"] = _calibrated(batch.rows(some), event, local, model, options)
        found |= {"calibration_checks": len(arrays["calibration"])}
        found |= _compared("calibration_envelopes", arrays["calibration"], sampled[some])
    np.savez(options.work / first / "draws.npz", allow_pickle=False, **arrays)
    shown = {kind: of_posterior(each, cube) for kind, each in posteriors.items()}
    for kind in (OTHER[first], "full"):
        if kind not in shown:
            shown[kind] = Shown(physical(batch), checks.reweighted(arrays[kind], sampled)[0])
    drawn = Shown(physical(batch), np.full(len(batch), 1.0 / len(batch)))
    for kind in list(shown)[1:]:
        apart = divergences(shown[first] if kind in posteriors else drawn, shown[kind])
        worst = max(apart, key=lambda name: apart[name])
        found |= {f"{first}_and_{kind}_largest_divergence": round(apart[worst], 5)}
        found |= {f"{first}_and_{kind}_largest_divergence_of": worst.partition(" [")[0]}
    return found, shown


def _with_distances(
    batch: LikelihoodBatch, event: setting.Event, local: WaveformModel, model: Any, options: Namespace
) -> Floats:
    values = batch.values.copy()
    distance = likelihood(model, analyses.kept("distance", event, local, options.work))
    values[:, LIKELIHOOD_NAMES.index("distance_mpc")] = checks.distances(distance, batch)
    return values


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
    prior = checks.CalibrationPrior(analyses.CALIBRATION)
    return checks.calibrated(bound, batch, prior, o.calibration_draws)


def _generated(batch: LikelihoodBatch, event: setting.Event, options: Namespace) -> Floats:
    """TEOBResumSPA itself on the full grid: the generator is evaluated in this process."""
    few = batch.rows(slice(0, options.generator_checks))
    full = analyses.kept("full", event, GeneratorModel(TEOBResumSPA()), options.work)
    return np.asarray(likelihood(GeneratorModel(TEOBResumSPA()), full).log_likelihood(few))
