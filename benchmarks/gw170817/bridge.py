"""The evidence from samples of a posterior: bridge sampling (Meng, Wong 1996) to a mixture whose volume is known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.mixture import Mixture
from benchmarks.gw170817.moving import Coordinates, LogLikelihood, log_proposal, mixture_or_prior

Floats = NDArray[np.float64]
_ITERATIONS = 200
_SETTLED = 1e-9


def evidence_between(
    log_likelihood: LogLikelihood,
    points: Floats,
    values: Floats,
    effective: float,
    components: int,
    draws: int,
    coordinates: Coordinates,
    random: np.random.Generator,
) -> tuple[float, float]:
    """ln of the evidence, and its standard error.

    Parameters
    ----------
    log_likelihood, coordinates:
        As for :func:`~benchmarks.gw170817.annealing.anneal`.
    points, values:
        Samples of S sweeps of N particles ``(S, N, D)`` and their log-likelihoods ``(S, N)``. The mixture is fitted to
        every other particle; the rest is compared with it, so that it does not fit those better than the posterior.
    effective:
        How many independent samples all of them are worth.
    components, draws:
        Of the mixture.
    """
    dimensions = points.shape[2]
    mixture = Mixture.fit(coordinates.from_cube(points[:, ::2].reshape(-1, dimensions))[0], components, random)
    y, volumes = coordinates.from_cube(points[:, 1::2].reshape(-1, dimensions))
    of_samples = values[:, 1::2].reshape(-1) + volumes - log_proposal(mixture, y, volumes)
    offered, places, volumes = mixture_or_prior(mixture, draws, dimensions, coordinates, random)
    inside = np.flatnonzero(((places > 0.0) & (places < 1.0)).all(axis=1) & np.isfinite(volumes))
    of_draws = np.full(draws, -np.inf)
    found = log_likelihood(places[inside]) + volumes[inside]
    of_draws[inside] = found - log_proposal(mixture, offered[inside], volumes[inside])
    return bridge(of_samples, of_draws, 0.5 * effective)


def bridge(of_samples: Floats, of_draws: Floats, effective: float) -> tuple[float, float]:
    """ln of the ratio of two volumes and its standard error, from ln of the ratio of their densities.

    Parameters
    ----------
    of_samples:
        At samples of the one whose volume is looked for, worth ``effective`` independent ones.
    of_draws:
        At independent draws of the other, whose volume is one; -inf is allowed.
    """
    shift = float(np.median(of_samples))
    above, below = np.exp(of_samples - shift), np.exp(of_draws - shift)
    part = effective / (effective + len(of_draws))
    ratio = 1.0
    for _ in range(_ITERATIONS):
        before = ratio
        upper = below / (part * below + (1.0 - part) * ratio)
        lower = 1.0 / (part * above + (1.0 - part) * ratio)
        ratio = float(upper.mean() / lower.mean())
        if abs(ratio - before) < _SETTLED * ratio:
            break
    variance = upper.var() / upper.mean() ** 2 / len(of_draws) + lower.var() / lower.mean() ** 2 / effective
    return float(np.log(ratio) + shift), float(np.sqrt(variance))
