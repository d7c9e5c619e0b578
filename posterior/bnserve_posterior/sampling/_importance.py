"""Importance sampling: it makes a posterior that a population found right, tails and evidence.

The draws are from two mixtures of Student distributions, wider than what they are fitted to: where particles of two
populations have been that know nothing of each other. The weight of a draw is its likelihood over the mean of both
densities (Veach, Guibas 1995). No mixture is fitted to the draws that the posterior and its evidence are from: they are
independent, and their errors are what they say.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._pareto import FINITE, pareto_k
from bnserve_posterior.sampling._population import Population
from bnserve_posterior.sampling._problem import Problem
from bnserve_posterior.sampling._proposals import Proposal, inside

Floats = NDArray[np.float64]
_COMPONENTS = 100
"""Of a mixture, where there are points enough."""
_TWINS = 0.05
"""For each point: places that hardly any particle has been to have a density there, as small as they are."""
_ITERATIONS = 15
"""Of a mixture's fit; twice as many make no difference."""
_SLOWLY = 1.4
"""Where the variance of weights is infinite, evidences scatter so much more than the weights at hand say: measured in
eleven runs of a binary neutron star with k-hat from 0.49 to 0.66."""


class Draws(NamedTuple):
    """Draws from R proposals: points of the cube ``(N, D)``, ln likelihoods ``(N,)``, the number of the proposal each
    is from ``(N,)``, ln of each proposal's density there ``(R, N)``, and how many each drew, with those outside of the
    prior, ``(R,)``."""

    points: Floats
    values: Floats
    origins: NDArray[np.int64]
    densities: Floats
    counts: NDArray[np.int64]


class Weighted(NamedTuple):
    """Weights ``(N,)`` that sum to one, ln of the evidence and its standard error, effective samples, and k-hat."""

    weights: Floats
    log_evidence: float
    log_evidence_error: float
    effective: float
    k_hat: float


def draw(
    evaluate: Evaluator, proposals: Sequence[Proposal], counts: Sequence[int], random: np.random.Generator
) -> Draws:
    """So many draws from each of the proposals."""
    drawn = [proposal.draw(count, random) for proposal, count in zip(proposals, counts, strict=True)]
    some = [points[inside(points)] for points in drawn]
    points = np.concatenate(some)
    origins = np.repeat(np.arange(len(some)), [len(each) for each in some])
    densities = np.array([proposal.log_density(points) for proposal in proposals])
    return Draws(points, evaluate(points), origins, densities, np.array(counts, dtype=np.int64))


def joined(one: Draws, other: Draws) -> Draws:
    """All draws from the same proposals."""
    return Draws(
        np.concatenate([one.points, other.points]),
        np.concatenate([one.values, other.values]),
        np.concatenate([one.origins, other.origins]),
        np.concatenate([one.densities, other.densities], axis=1),
        one.counts + other.counts,
    )


def weighted(draws: Draws) -> Weighted:
    """What all the draws say together."""
    shares = draws.counts / draws.counts.sum()
    mean = logsumexp(draws.densities, axis=0, b=shares[:, None])
    return _weighted(draws.values - mean, int(draws.counts.sum()))


def of_origin(draws: Draws, origin: int) -> Draws:
    """The draws from one proposal, as if there were no other."""
    mine, only = draws.origins == origin, slice(origin, origin + 1)
    return Draws(
        draws.points[mine], draws.values[mine], np.zeros(mine.sum(), dtype=np.int64), draws.densities[only, mine],
        draws.counts[only],
    )  # fmt: skip


def _weighted(log_weights: Floats, count: int) -> Weighted:
    top = log_weights.max(initial=-np.inf)
    if top == -np.inf:  # nothing possible was drawn
        return Weighted(np.zeros(len(log_weights)), -np.inf, np.inf, 0.0, np.inf)
    weights = np.exp(log_weights - top)
    total, squares = float(weights.sum()), float(np.sum(weights**2))
    k_hat = pareto_k(np.concatenate([weights, np.zeros(count - len(weights))]))
    error = float(np.sqrt(max(0.0, squares / total**2 - 1.0 / count)))
    error *= _SLOWLY if k_hat > FINITE else 1.0
    return Weighted(weights / total, float(top + np.log(total / count)), error, total**2 / squares, k_hat)


def fitted(problem: Problem, points: Floats, random: np.random.Generator) -> Proposal:
    """A proposal fitted to points of the cube ``(N, D)``, and to twins of some."""
    if problem.twins is not None:
        some = points[random.random(len(points)) < _TWINS]
        points = np.concatenate([points, problem.twins(some, random)])
        points = points[inside(points)]
    return Proposal.fit(problem, points, np.full(len(points), 1.0 / len(points)), _COMPONENTS, _ITERATIONS, random)


def population_of(draws: Draws, particles: int, random: np.random.Generator) -> Population:
    """So many of the draws, by their weights; none counts for more than the root of their number (Ionides 2008)."""
    weights = weighted(draws).weights
    if not weights.any():
        weights = np.full(len(weights), 1.0 / len(weights))
    weights = np.minimum(weights, 1.0 / np.sqrt(len(weights)))
    chosen = random.choice(len(weights), particles, p=weights / weights.sum())
    return Population(draws.points[chosen], draws.values[chosen], 1.0, 0)
