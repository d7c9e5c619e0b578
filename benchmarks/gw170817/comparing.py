"""How far posteriors of one event are apart, and how far the surrogate is from the model that it was trained on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.stats import gaussian_kde

from benchmarks.generator_model import GeneratorModel
from benchmarks.gw170817.setting import CHIRP_MASS
from bnserve_inference import likelihood
from bnserve_posterior.likelihoods import full_likelihood
from bnserve_posterior.results import FullCheck, Samples, check_with_full
from bnserve_posterior.running import Outcome
from bnserve_surrogate.training.data.generators import TEOBResumSPA

Floats = NDArray[np.float64]
_POINTS = 100
_MOST_SAMPLES = 5000


def shown(values: Mapping[str, Floats]) -> dict[str, Floats]:
    """What is shown of samples, or of a binary, by label, ``(N,)`` each."""
    return {
        f"chirp mass - {CHIRP_MASS}\n[$10^{{-4}} M_\\odot$]": 1e4 * (values["chirp_mass"] - CHIRP_MASS),
        "mass ratio": values["mass_ratio"],
        "effective spin": values["chi_eff"],
        "reduced tide": values["lambda_tilde"],
        "distance [Mpc]": values["luminosity_distance"],
        "inclination": values["theta_jn"],
        "right ascension": values["ra"],
        "declination": values["dec"],
    }


def divergences(one: dict[str, Floats], other: dict[str, Floats]) -> dict[str, float]:
    """Jensen-Shannon divergence (nats) of every marginal distribution: 0.002 is what samplers differ by by chance.

    From smoothed densities at 100 points, as Romero-Shaw et al. (2020) compare posteriors of one event.
    """
    found = {}
    for name, ours in one.items():
        theirs = other[name]
        x = np.linspace(min(ours.min(), theirs.min()), max(ours.max(), theirs.max()), _POINTS)
        p, q = _density(ours, x), _density(theirs, x)
        middle = 0.5 * (p + q)
        found[name] = float(0.5 * (_relative_entropy(p, middle) + _relative_entropy(q, middle)))
    return found


def _density(values: Floats, x: Floats) -> Floats:
    density = gaussian_kde(values[:_MOST_SAMPLES])(x)
    return np.asarray(density / density.sum())


def _relative_entropy(p: Floats, q: Floats) -> float:
    some = p > 0.0
    return float(np.sum(p[some] * np.log(p[some] / q[some])))


def with_the_generator(outcome: Outcome, model: Any, count: int) -> FullCheck:
    """TEOBResumSPA's likelihood on the full grid beside the surrogate's (``model``), at samples of the posterior.

    The generator is evaluated in this process.
    """
    prepared, samples = outcome.prepared, outcome.samples
    generator = GeneratorModel(TEOBResumSPA())
    analysis = full_likelihood(prepared.event, prepared.data, prepared.cube, model)
    few = slice(0, min(count, len(samples)))
    ours = np.asarray(likelihood(model, analysis).log_likelihood(samples.batch.rows(few)))
    own = Samples({}, samples.batch.rows(few), samples.whole.rows(few), ours)
    return check_with_full(own, likelihood(generator, analysis).log_likelihood, count)


def tails(samples: Samples) -> dict[str, float]:
    """How much of the posterior is where samplers are short of it."""
    return {
        "abs(chi_1) > 0.2": float(np.mean(np.abs(samples.values["chi_1"]) > 0.2)),
        "heavier over lighter mass > 2": float(np.mean(samples.values["mass_ratio"] < 0.5)),
    }
