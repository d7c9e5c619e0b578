"""A population on its way from the prior to the posterior (sequential Monte Carlo): it finds what there is.

Particles of the prior are brought to the posterior in steps of the likelihood's power, each as large as leaves half of
the population's effective size (Del Moral, Doucet, Jasra 2006). After each they are resampled and moved, until nearly
all of them have moved: to draws from a mixture fitted to the others, by steps as large as that is wide, and to twins
where a problem has them. Everything is asked in batches of a population.

What it ends with is where the posterior is, and not yet the posterior: its tails are thin, and the evidence that it
could give is wrong where the posterior is a small part of the prior, by more than its error. Importance sampling
follows (:mod:`bnserve_posterior.sampling._importance`).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._errors import LikelihoodEmpty
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._problem import Problem
from bnserve_posterior.sampling._proposals import Proposal, inside

Floats = NDArray[np.float64]
_EFFECTIVE = 0.5
_POOL = 5
"""Draws from the prior for every particle to begin with."""
_MOST_POOLS = 20
"""So many times that, where the likelihood is zero nearly everywhere."""
_FEWEST = 100
"""Points of the prior that are possible at all: fewer do not say where."""
_ROUNDS, _MOVED = 8, 0.95
"""At most so many rounds of moves after a step, until so many of the particles have moved."""
_PROPOSALS, _COMPONENTS, _ITERATIONS = 2, 25, 10
"""Draws from a mixture for each particle and round, and how that is fitted."""
_SETTLING, _PLACES = 10, 250
"""Rounds, and places of the particles in them for the square of the dimensions, at least: half as many leave half of
the effective samples of binaries, in nine dimensions and in thirteen."""
_REMEMBERED = 8000
"""At most so many points are fitted to."""


class Population(NamedTuple):
    """Points of the unit cube ``(N, D)`` and log-likelihoods ``(N,)`` at a power of the likelihood, and the number of
    the step."""

    points: Floats
    values: Floats
    power: float
    step: int


def begin(evaluate: Evaluator, particles: int, random: np.random.Generator) -> Population:
    """Draws from the prior.

    Raises
    ------
    LikelihoodEmpty
        Hardly any of them have a likelihood above zero.
    """
    points, values, tried = np.empty((0, evaluate.problem.dimensions)), np.empty(0), 0
    while len(values) < particles // 2 and tried < _MOST_POOLS * _POOL * particles:
        fresh = random.random((_POOL * particles, evaluate.problem.dimensions))
        found = evaluate(fresh)
        some = np.flatnonzero(found > -np.inf)
        points, values = np.concatenate([points, fresh[some]]), np.concatenate([values, found[some]])
        tried += len(fresh)
    if len(values) < _FEWEST:
        raise LikelihoodEmpty(
            f"Of {tried} draws from the prior {len(values)} have a likelihood above zero: look at the likelihood of a "
            "point that you know, or make the prior narrower."
        )
    return Population(points, values, 0.0, 0)


def advance(evaluate: Evaluator, now: Population, particles: int, random: np.random.Generator) -> Population:
    """One step of the power, and moves."""
    begun = now = _reweigh(now, particles, random)
    for now, _ in itertools.islice(_rounds(evaluate, begun, random), _ROUNDS):
        if (now.points != begun.points).any(axis=1).mean() >= _MOVED:
            break
    return now


def settled(evaluate: Evaluator, now: Population, random: np.random.Generator) -> Floats:
    """All places ``(R * N, D)`` where the particles are while they settle."""
    dimensions = evaluate.problem.dimensions
    rounds = max(_SETTLING, -(-_PLACES * dimensions**2 // len(now.values)))
    *_, (_, been) = itertools.islice(_rounds(evaluate, now, random), rounds)
    return been[1:].reshape(-1, dimensions)


def _rounds(evaluate: Evaluator, now: Population, random: np.random.Generator) -> Iterator[tuple[Population, Floats]]:
    """Rounds of moves, and the places ``(R, N, D)`` of all particles before them and after each.

    Each half is offered draws from mixtures fitted to where the other one has been: fitted to all, they would know each
    particle's own place better than the places around, and particles would leave where they are few.
    """
    halves = np.array_split(np.arange(len(now.values)), 2)
    been, proposals = now.points[None], []
    for number in itertools.count(1):
        if number & (number - 1) == 0:  # powers of two: there is twice as much to fit to
            proposals = [_fitted(evaluate.problem, been[:, others], random) for others in reversed(halves)]
        for mine, proposal in zip(halves, proposals, strict=True):
            now = _hop(evaluate, _propose(evaluate, now, mine, proposal, random), mine, random)
        been = np.concatenate([been, now.points[None]])
        yield now, been


def _fitted(problem: Problem, been: Floats, random: np.random.Generator) -> Proposal:
    """To places ``(R, N, D)``."""
    points = been.reshape(-1, problem.dimensions)
    points = points[random.permutation(len(points))[:_REMEMBERED]]
    uniform = np.full(len(points), 1.0 / len(points))
    return Proposal.fit(problem, points, uniform, _COMPONENTS, _ITERATIONS, random)


def _reweigh(now: Population, particles: int, random: np.random.Generator) -> Population:
    """Raise the power as far as leaves half of the particles' effective size, and resample."""
    wanted = _EFFECTIVE * min(particles, len(now.values))
    low, high = now.power, 1.0
    if _effective(now.values, high - now.power) < wanted:
        for _ in range(100):  # until no float is between
            middle = 0.5 * (low + high)
            low, high = (middle, high) if _effective(now.values, middle - now.power) > wanted else (low, middle)
    exponent = (high - now.power) * now.values
    edges = np.cumsum(np.exp(exponent - exponent.max()))
    places = np.searchsorted(edges, (np.arange(particles) + random.random()) / particles * edges[-1])
    places = random.permutation(np.minimum(places, len(edges) - 1))
    return Population(now.points[places], now.values[places], high, now.step + 1)


def _effective(values: Floats, power: float) -> float:
    weights = np.exp(power * (values - values.max()))
    return float(weights.sum() ** 2 / np.sum(weights**2))


def _propose(
    evaluate: Evaluator, now: Population, mine: NDArray[np.intp], proposal: Proposal, random: np.random.Generator
) -> Population:
    """Offer each of one half draws from a mixture, and steps as large as that is wide."""
    for _ in range(_PROPOSALS):
        there = proposal.draw(len(mine), random)
        balance, some = np.full(len(mine), -np.inf), inside(there)
        balance[some] = proposal.log_density(now.points[mine[some]]) - proposal.log_density(there[some])
        now = _offer(evaluate, now, mine, there, balance, random)
        now = _offer(evaluate, now, mine, *proposal.step(now.points[mine], random), random)
    return now


def _hop(evaluate: Evaluator, now: Population, mine: NDArray[np.intp], random: np.random.Generator) -> Population:
    """Offer each of one half one of its twins, if there are any."""
    if evaluate.problem.twins is None:
        return now
    there = evaluate.problem.twins(now.points[mine], random)
    return _offer(evaluate, now, mine, there, np.zeros(len(mine)), random)


def _offer(
    evaluate: Evaluator, now: Population, mine: NDArray[np.intp], there: Floats, balance: Floats,
    random: np.random.Generator,
) -> Population:  # fmt: skip
    """Take or leave a place for each of the particles ``mine`` (Metropolis, Hastings)."""
    threshold = np.log(random.random(len(mine))) - balance
    possible = inside(there)
    possible = possible[np.isfinite(threshold[possible])]
    found, before = evaluate(there[possible]), now.values[mine[possible]]
    taken = now.power * (found - before) > threshold[possible]
    points, values = now.points.copy(), now.values.copy()
    points[mine[possible[taken]]], values[mine[possible[taken]]] = there[possible[taken]], found[taken]
    return now._replace(points=points, values=values)
