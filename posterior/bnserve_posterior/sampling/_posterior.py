"""What a run finds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Posterior:
    """Weighted points of the unit cube, and how well they are known.

    Parameters
    ----------
    points, weights, log_likelihood:
        ``(N, D)``; ``(N,)``, which sum to one; ``(N,)``.
    log_evidence, log_evidence_error:
        ln of the evidence by importance sampling, and its standard error.
    effective:
        Effective samples: 1 / sum of the squared weights.
    k_hat:
        Shape of the generalised Pareto distribution that the largest weights follow (Vehtari et al. 2024,
        arXiv:1507.02646): up to 0.7 all else can be believed.
    log_evidences:
        The same evidence and its error from the draws of either mixture alone: of two runs that know nothing of each
        other, and agree within three of their combined errors.
    likelihoods:
        How many were evaluated, over all interruptions.
    """

    points: Floats
    weights: Floats
    log_likelihood: Floats
    log_evidence: float
    log_evidence_error: float
    effective: float
    k_hat: float
    log_evidences: tuple[tuple[float, float], ...]
    likelihoods: int

    def draw(self, count: int, seed: int = 5) -> NDArray[np.intp]:
        """Which points are ``count`` samples of equal weight, ``(count,)``, in random order: by systematic resampling.

        More than :attr:`effective` of them are no more information.
        """
        random = np.random.default_rng(seed)
        edges = np.cumsum(self.weights)
        places = (np.arange(count) + random.random()) / count * edges[-1]
        return random.permutation(np.minimum(np.searchsorted(edges, places), len(edges) - 1))
