"""Importance sampling that adapts: it makes a posterior that a population found right, tails and evidence.

A mixture of Student distributions, wider than what it is fitted to, is fitted to the population, then to weighted draws
from itself (population Monte Carlo, Cappe et al. 2008), until weights are no more equal than before. The posterior and
its evidence are from draws that no mixture was fitted to: they are independent, and their errors are what they say.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling import _proposals
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._pareto import pareto_k
from bnserve_posterior.sampling._proposals import Places

Floats = NDArray[np.float64]


class Draws(NamedTuple):
    """Places of the prior that were drawn, ln likelihoods and ln weights ``(N,)``, and how many were drawn, with those
    outside of the prior: the sum of the weights over that number is the evidence."""

    places: Places
    values: Floats
    log_weights: Floats
    drawn: int

    def joined(self, other: Draws) -> Draws:
        """With draws from the same mixture."""
        return Draws(
            Places(*(np.concatenate(pair) for pair in zip(self.places, other.places, strict=True))),
            np.concatenate([self.values, other.values]),
            np.concatenate([self.log_weights, other.log_weights]),
            self.drawn + other.drawn,
        )


class Weighted(NamedTuple):
    """Weights ``(N,)`` that sum to one, ln of the evidence and its standard error, effective samples, and k-hat."""

    weights: Floats
    log_evidence: float
    log_evidence_error: float
    effective: float
    k_hat: float


def draw(evaluate: Evaluator, mixture: Mixture, count: int, random: np.random.Generator) -> Draws:
    """So many draws from a mixture and the prior."""
    drawn = _proposals.draw(mixture, count, evaluate.coordinates, random)
    inside = drawn.inside()
    places = Places(*(each[inside] for each in drawn))
    values = evaluate(places.points)
    return Draws(places, values, values + places.volumes - _proposals.log_density(mixture, places), count)


def weighted(draws: Draws) -> Weighted:
    """What the draws say."""
    top = draws.log_weights.max()
    weights = np.exp(draws.log_weights - top)
    total, squares = weights.sum(), np.sum(weights**2)
    variance = (squares / draws.drawn - (total / draws.drawn) ** 2) / draws.drawn
    error = float(np.sqrt(variance) / (total / draws.drawn))
    evidence = float(top + np.log(total / draws.drawn))
    outside = np.concatenate([weights, np.zeros(draws.drawn - len(weights))])
    return Weighted(weights / total, evidence, error, float(total**2 / squares), pareto_k(outside))


def fitted(evaluate: Evaluator, draws: Draws, components: int, random: np.random.Generator) -> Mixture:
    """A mixture fitted to weighted draws; none counts for more than the root of their number (Ionides 2008)."""
    log_weights = draws.log_weights - draws.log_weights.max()
    weights = np.exp(log_weights)
    weights = np.minimum(weights, weights.mean() * np.sqrt(len(weights)))
    return Mixture.fit(draws.places.y, weights / weights.sum(), components, random)
