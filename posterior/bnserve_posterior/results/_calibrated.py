"""Calibration errors integrated over, by importance sampling.

Samples of the posterior of perfect detectors, or rather of those with the means of all errors, get errors from their
envelopes, some draws each. The ratio of the likelihoods with and without is the weight of a sample with a draw in the
posterior of both (Payne et al. 2020, arXiv:2009.10193): its mean over the draws is that of the sample, and its mean
over all is the ratio of the evidences. No dimension is added to what is sampled.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling import BELIEVED, PosteriorUnreliable, pareto_k
from bnserve_protocol import LikelihoodBatch

Floats = NDArray[np.float64]
Evaluate = Callable[[LikelihoodBatch], Floats]
_SEED = 60


class Drawing(Protocol):
    """Draws errors for samples."""

    def drawn(self, batch: LikelihoodBatch, random: np.random.Generator) -> LikelihoodBatch:
        """The samples with a draw of all errors each."""


class Calibrated(NamedTuple):
    """How much calibration errors change: ``draws`` for each sample, by how much ln of the evidence shifts and the
    standard error of that, effective over all samples, and k-hat of the weights."""

    draws: int
    shift: float
    shift_error: float
    efficiency: float
    k_hat: float


class Recalibrated(NamedTuple):
    """Samples of equal weight with their errors: which of those that were given, with errors, and ln L."""

    rows: NDArray[np.intp]
    batch: LikelihoodBatch
    log_likelihood: Floats
    found: Calibrated


def recalibrated(
    batch: LikelihoodBatch, log_likelihood: Floats, envelopes: Drawing, evaluate: Evaluate, draws: int, seed: int
) -> Recalibrated:
    """Samples of the posterior with calibration errors.

    Parameters
    ----------
    batch, log_likelihood
        Samples of equal weight of the posterior with the means of all errors, and ln L there, ``(N,)``.
    envelopes, evaluate
        Draw errors, and ln L with them.
    draws, seed
        For each sample, and of these.

    Raises
    ------
    PosteriorUnreliable
        The weights have too heavy a tail.
    """
    values = np.stack([evaluate(_drawn(batch, envelopes, seed, draw)) for draw in range(draws)])
    ratios = values - log_likelihood
    top = ratios.max()
    each = np.exp(ratios - top)
    weights = each.mean(axis=0)
    count, mean = len(weights), float(weights.mean())
    efficiency = float(mean**2 / np.mean(weights**2))
    error = float(weights.std() / mean / np.sqrt(count))
    found = Calibrated(draws, float(top + np.log(mean)), error, efficiency, pareto_k(weights))
    if found.k_hat > BELIEVED:
        raise PosteriorUnreliable(
            f"Calibration errors change the posterior so much that the weights of its samples have a Pareto shape of "
            f"{found.k_hat:.2f}, above {BELIEVED}: take more 'draws' in [calibration] ({draws} were not enough), more "
            "effective samples, or narrower envelopes."
        )
    random = np.random.default_rng([_SEED, seed, draws])
    edges, wanted = np.cumsum(weights), max(1, int(efficiency * count))
    places = (np.arange(wanted) + random.random()) / wanted * edges[-1]
    rows = random.permutation(np.minimum(np.searchsorted(edges, places), count - 1))
    inside = np.cumsum(each[:, rows], axis=0)
    which = np.minimum((inside < random.random(wanted) * inside[-1]).sum(axis=0), draws - 1)
    chosen = _chosen(batch, envelopes, seed, rows, which)
    return Recalibrated(rows, chosen, values[which, rows], found)


def _drawn(batch: LikelihoodBatch, envelopes: Drawing, seed: int, draw: int) -> LikelihoodBatch:
    return envelopes.drawn(batch, np.random.default_rng([_SEED, seed, 1 + draw, len(batch)]))


def _chosen(
    batch: LikelihoodBatch, envelopes: Drawing, seed: int, rows: NDArray[np.intp], which: NDArray[np.intp]
) -> LikelihoodBatch:
    """Of each row that draw, made again: all of them at once would be gigabytes."""
    first = _drawn(batch, envelopes, seed, 0).rows(rows)
    amplitude, phase = dict(first.calibration_amplitude), dict(first.calibration_phase)
    for draw in np.unique(which):
        here = np.flatnonzero(which == draw)
        other = _drawn(batch, envelopes, seed, int(draw)).rows(rows[here])
        for ours, theirs in ((amplitude, other.calibration_amplitude), (phase, other.calibration_phase)):
            for name, values in theirs.items():
                ours[name][here] = values
    return LikelihoodBatch(batch.values[rows], amplitude, phase, batch.absent)
