"""A population on its way from the prior to the posterior (sequential Monte Carlo): it finds what there is.

Particles of the prior are brought to the posterior in steps of the likelihood's power, each as large as leaves half of
the population's effective size (Del Moral, Doucet, Jasra 2006). After each they are resampled and moved, until nearly
all of them have moved: along differences of other particles (differential evolution, ter Braak 2006), and to draws from
a mixture fitted to all. Everything is asked in batches of a population.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling import _proposals
from bnserve_posterior.sampling._errors import LikelihoodEmpty
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._proposals import Places

Floats = NDArray[np.float64]
_EFFECTIVE = 0.5
_POOL = 5
"""Draws from the prior for every particle to begin with."""
_MOST_POOLS = 20
"""So many times that, where the likelihood is zero nearly everywhere."""
_FEWEST = 100
"""Points of the prior that are possible at all: fewer do not say where."""
_ROUNDS, _MOVED = 6, 0.9
"""At most so many rounds of moves after a step, until so many of the particles have moved."""
_PROPOSALS = 2
"""Draws from a mixture for each particle and round."""
_JUMP = 0.1
"""How often a move is a whole difference, from one mode to another, instead of a scaled one."""
_BLUR = 1e-3
"""Differences are blurred by this part of themselves: copies of one particle part again."""


class Population(NamedTuple):
    """Points of the unit cube ``(N, D)`` and log-likelihoods ``(N,)`` at a power of the likelihood; ln of the evidence
    so far; the draw from the prior that each descends from, ``(N,)``; and how many steps it took."""

    points: Floats
    values: Floats
    power: float
    log_evidence: float
    ancestors: NDArray[np.int64]
    step: int


def begin(evaluate: Evaluator, particles: int, random: np.random.Generator) -> Population:
    """Draws from the prior.

    Raises
    ------
    LikelihoodEmpty
        Hardly any of them have a likelihood above zero.
    """
    points, values = np.empty((0, evaluate.dimensions)), np.empty(0)
    for _ in range(_MOST_POOLS):
        fresh = random.random((_POOL * particles, evaluate.dimensions))
        found = evaluate(fresh)
        some = np.flatnonzero(found > -np.inf)
        points, values = np.concatenate([points, fresh[some]]), np.concatenate([values, found[some]])
        tried = evaluate.likelihoods
        if len(values) >= particles // 2:
            break
    if len(values) < _FEWEST:
        raise LikelihoodEmpty(
            f"Of {tried} draws from the prior {len(values)} have a likelihood above zero: look at the likelihood of a "
            "point that you know, or make the prior narrower."
        )
    return Population(points, values, 0.0, float(np.log(len(values) / tried)), np.arange(len(values)), 0)


def advance(evaluate: Evaluator, now: Population, particles: int, random: np.random.Generator) -> Population:
    """One step of the power, and moves."""
    now = _reweigh(now, particles, random)
    moved = np.zeros(len(now.values), dtype=bool)
    for _ in range(_ROUNDS):
        before = now.points
        now = _evolve(evaluate, now, random)
        uniform = np.full(len(now.values), 1.0 / len(now.values))
        mixture = Mixture.fit(evaluate.coordinates.from_cube(now.points)[0], uniform, evaluate.components, random)
        for _ in range(_PROPOSALS):
            now = _propose(evaluate, now, mixture, random)
        moved |= (now.points != before).any(axis=1)
        if moved.mean() >= _MOVED:
            break
    return now


def evidence_error(now: Population) -> float:
    """Standard error of ln of the evidence, from one run: by how many draws of the prior have descendants.

    Lee and Whiteley (2018, arXiv:1509.00394, eq. 6); moves that hardly move make it larger.
    """
    count = len(now.values)
    families = np.bincount(now.ancestors) / count
    variance = 1.0 - (count / (count - 1.0)) ** (now.step + 1) * (1.0 - np.sum(families**2))
    return float(np.sqrt(max(variance, 1.0 / count)))


def _reweigh(now: Population, particles: int, random: np.random.Generator) -> Population:
    """Raise the power as far as leaves half of the particles' effective size, and resample."""
    wanted = _EFFECTIVE * min(particles, len(now.values))
    low, high = now.power, 1.0
    if _effective(now.values, high - now.power) < wanted:
        for _ in range(100):  # until no float is between
            middle = 0.5 * (low + high)
            low, high = (middle, high) if _effective(now.values, middle - now.power) > wanted else (low, middle)
    exponent = (high - now.power) * now.values
    weights = np.exp(exponent - exponent.max())
    log_mean = float(exponent.max() + np.log(weights.mean()))
    edges = np.cumsum(weights) / weights.sum()
    places = np.searchsorted(edges, (np.arange(particles) + random.random()) / particles)
    places = np.minimum(places, len(weights) - 1)
    evidence = now.log_evidence + log_mean
    return Population(now.points[places], now.values[places], high, evidence, now.ancestors[places], now.step + 1)


def _effective(values: Floats, power: float) -> float:
    weights = np.exp(power * (values - values.max()))
    return float(weights.sum() ** 2 / np.sum(weights**2))


def _evolve(evaluate: Evaluator, now: Population, random: np.random.Generator) -> Population:
    """Offer every particle one move along a difference of two particles of the other half of the population."""
    count, dimensions = now.points.shape
    order = random.permutation(count)
    for mine, others in ((order[: count // 2], order[count // 2 :]), (order[count // 2 :], order[: count // 2])):
        y, volumes = evaluate.coordinates.from_cube(now.points)
        first = random.integers(len(others), size=len(mine))
        second = (first + random.integers(1, len(others), size=len(mine))) % len(others)
        scale = 2.38 / np.sqrt(2.0 * dimensions) * np.exp(0.4 * random.standard_normal(len(mine)))
        scale[random.random(len(mine)) < _JUMP] = 1.0
        step = scale[:, None] * (y[others[first]] - y[others[second]])
        step *= 1.0 + _BLUR * random.standard_normal(step.shape)
        there = y[mine] + step
        places = Places(there, *evaluate.coordinates.to_cube(there))
        now = _offer(evaluate, now, mine, places, places.volumes - volumes[mine], random)
    return now


def _propose(evaluate: Evaluator, now: Population, mixture: Mixture, random: np.random.Generator) -> Population:
    """Offer every particle a place drawn from the mixture."""
    here = Places.of(now.points, evaluate.coordinates)
    there = _proposals.draw(mixture, len(now.points), evaluate.coordinates, random)
    balance = there.volumes - _proposals.log_density(mixture, there)
    balance -= here.volumes - _proposals.log_density(mixture, here)
    return _offer(evaluate, now, np.arange(len(now.points)), there, balance, random)


def _offer(
    evaluate: Evaluator, now: Population, mine: NDArray[np.intp], there: Places, balance: Floats,
    random: np.random.Generator,
) -> Population:  # fmt: skip
    """Take or leave a place for each of the particles ``mine`` (Metropolis, Hastings)."""
    threshold = np.log(random.random(len(mine)))
    inside = there.inside()
    found, before = evaluate(there.points[inside]), now.values[mine[inside]]
    taken = now.power * (found - before) + balance[inside] > threshold[inside]
    points, values = now.points.copy(), now.values.copy()
    points[mine[inside[taken]]], values[mine[inside[taken]]] = there.points[inside[taken]], found[taken]
    return now._replace(points=points, values=values)
