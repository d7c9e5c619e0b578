"""Whether importance weights can be believed: the tail of their distribution."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
BELIEVED = 0.7
"""Up to this k-hat an estimate by importance sampling is reliable (Vehtari et al. 2024)."""
FINITE = 0.5
"""Up to this k-hat the variance of the weights is finite."""
_SMALLEST_TAIL = 5
_PRIOR_POINTS, _PRIOR_MEAN = 10.0, 0.5
"""A weak prior on the shape, as the authors have it: ten points that say one half."""


def pareto_k(weights: Floats) -> float:
    """k-hat of weights ``(N,)``, none negative: the shape of the generalised Pareto distribution of the largest.

    Vehtari, Simpson, Gelman, Yao, Gabry (2024, arXiv:1507.02646); infinite where too few weights differ to say.
    """
    count = int(np.ceil(min(0.2 * len(weights), 3.0 * np.sqrt(len(weights)))))
    largest = np.sort(weights)[-count - 1 :]
    threshold, tail = largest[0], largest[1:]
    if threshold == tail[-1] and threshold > 0.0:
        return -np.inf  # all alike
    excess = (tail - threshold)[tail > threshold]
    if len(excess) < _SMALLEST_TAIL:
        return np.inf
    shape = _shape(excess / excess[-1])
    return float((len(excess) * shape + _PRIOR_POINTS * _PRIOR_MEAN) / (len(excess) + _PRIOR_POINTS))


def _shape(x: Floats) -> float:
    """Of a generalised Pareto distribution with samples ``x``, increasing: Zhang and Stephens (2009)."""
    count = len(x)
    tries = 30 + int(np.sqrt(count))
    quartile = x[int(count / 4 + 0.5) - 1]
    theta = 1.0 / x[-1] + (1.0 - np.sqrt(tries / (np.arange(1, tries + 1) - 0.5))) / (3.0 * quartile)
    shapes = np.mean(np.log1p(-theta[:, None] * x), axis=1)
    likelihoods = count * (np.log(-theta / shapes) - shapes - 1.0)
    weights = np.exp(likelihoods - likelihoods.max())
    return float(np.mean(np.log1p(-np.sum(weights * theta) / weights.sum() * x)))
