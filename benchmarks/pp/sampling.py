"""What the networks have in common: sampling an injection, and what is kept of it."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from bnserve_posterior.sampling import Posterior, PosteriorUnreliable, Problem, Settings, sample

SETTINGS = Settings(particles=600, effective=3000)
"""Ranks of a hundred injections need no more."""
_TRIES = 4


def sampled(problem: Problem, settings: Settings) -> Posterior:
    """With twice the particles where these are too few: no injection is left out."""
    for _ in range(_TRIES - 1):
        try:
            return sample(problem, settings)
        except PosteriorUnreliable as error:
            print(f"seed {settings.seed}, {settings.particles} particles: {error}", file=sys.stderr, flush=True)
            settings = replace(settings, particles=2 * settings.particles)
    return sample(problem, settings)


def kept(seed: int, ranks: Mapping[str, Any], snr: float, seconds: float, found: Posterior) -> dict[str, Any]:
    """Of an injection.

    Returns
    -------
    result:
        ``seed``, ``ranks`` (the fraction of the posterior below the truth, by parameter), ``snr``, ``calls``,
        ``seconds``, ``log_evidence``, its error and that of either half, ``k_hat``, and the ``effective`` samples.
    """
    return {
        "seed": seed,
        "ranks": {name: round(float(np.asarray(rank)), 5) for name, rank in ranks.items()},
        "snr": round(snr, 2),
        "calls": found.likelihoods,
        "seconds": round(seconds, 2),
        "log_evidence": round(found.log_evidence, 3),
        "log_evidence_error": round(found.log_evidence_error, 3),
        "log_evidences": [[round(number, 3) for number in each] for each in found.log_evidences],
        "k_hat": round(found.k_hat, 2),
        "effective": round(found.effective, 1),
    }
