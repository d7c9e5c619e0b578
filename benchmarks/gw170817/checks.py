"""What is done with posterior samples: distances, other likelihoods at the same places, uncertain calibration."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.priors import DISTANCES
from benchmarks.gw170817.setting import DATA, DETECTORS
from bnserve_inference import read_envelope
from bnserve_protocol import LIKELIHOOD_NAMES, Calibration, Likelihood, LikelihoodBatch

Floats = NDArray[np.float64]
_DISTANCES = 128
_PIECE = 64


def distances(likelihood: Likelihood, batch: LikelihoodBatch, seed: int = 7) -> Floats:
    """Draws in Mpc from the posterior of the distance given all else, ``(N,)``: what was integrated over, given back.

    Parameters
    ----------
    likelihood:
        Of an analysis that does not integrate over the distance.
    """
    grid = np.linspace(*DISTANCES, _DISTANCES)
    draws = np.random.default_rng(seed).random(len(batch))
    result = np.empty(len(batch))
    for start in range(0, len(batch), _PIECE):
        part = batch.values[start : start + _PIECE]
        rows = np.repeat(part, _DISTANCES, axis=0)
        rows[:, LIKELIHOOD_NAMES.index("distance_mpc")] = np.tile(grid, len(part))
        values = likelihood.log_likelihood(LikelihoodBatch(rows)).reshape(len(part), _DISTANCES)
        density = np.exp(values - values.max(axis=1, keepdims=True)) * grid**2
        for row, u in zip(range(start, start + len(part)), draws[start : start + _PIECE], strict=True):
            steps = density[row - start][1:] + density[row - start][:-1]
            cumulative = np.concatenate([[0.0], np.cumsum(steps)])
            result[row] = np.interp(u * cumulative[-1], cumulative, grid)
    return result


def reweighted(exact: Floats, sampled: Floats) -> tuple[Floats, float, float]:
    """Posterior draws of one likelihood turned into those of another by weights.

    Returns
    -------
    weights:
        ``(N,)``, summing to one.
    shift:
        ln of the ratio of the evidences.
    efficiency:
        Effective sample size over N.
    """
    ratio = exact - sampled
    weights = np.exp(ratio - ratio.max())
    shift = float(ratio.max() + np.log(weights.mean()))
    weights /= weights.sum()
    return weights, shift, float(1.0 / np.sum(weights**2) / len(weights))


class CalibrationPrior:
    """The event's calibration envelopes at the nodes of an analysis: independent normal errors at each."""

    def __init__(self, calibration: Calibration) -> None:
        # bajes, whose files these are, multiplies the template with them.
        self._envelopes = {
            name: read_envelope(DATA / f"{name}_CalEnv.txt", calibration, correction="template") for name in DETECTORS
        }

    def draw(self, count: int, random: np.random.Generator) -> tuple[Mapping[str, Floats], Mapping[str, Floats]]:
        """Amplitude and phase errors by detector, ``(count, nodes)``."""
        parts = ([(e.amplitude, e.amplitude_width) for e in self._envelopes.values()],
                 [(e.phase, e.phase_width) for e in self._envelopes.values()])  # fmt: skip
        amplitude, phase = (
            {
                name: mean + width * random.standard_normal((count, len(mean)))
                for name, (mean, width) in zip(self._envelopes, part, strict=True)
            }
            for part in parts
        )
        return amplitude, phase


def calibrated(
    likelihood: Likelihood, batch: LikelihoodBatch, prior: CalibrationPrior, draws: int, seed: int = 11
) -> Floats:
    """ln of the likelihood averaged over that many draws of calibration errors, ``(N,)``; each row has its own draws.

    The integral over the 60 errors at fixed parameters of the binary, by sampling the envelopes (Payne et al. 2020).
    """
    random = np.random.default_rng(seed)
    result = np.empty(len(batch))
    for start in range(0, len(batch), _PIECE):
        part = batch.values[start : start + _PIECE]
        amplitude, phase = prior.draw(len(part) * draws, random)
        rows = LikelihoodBatch(np.repeat(part, draws, axis=0), amplitude, phase, batch.absent)
        values = likelihood.log_likelihood(rows).reshape(len(part), draws)
        top = values.max(axis=1)
        result[start : start + len(part)] = top + np.log(np.mean(np.exp(values - top[:, None]), axis=1))
    return result
