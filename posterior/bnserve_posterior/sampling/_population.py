"""A population on its way from the prior to the posterior (sequential Monte Carlo): it finds what there is.

Particles of the prior are brought to the posterior in steps of the likelihood's power, each as large as leaves half of
the population's effective size (Del Moral, Doucet, Jasra 2006). After each they are resampled and moved, until nearly
all of them have moved: along differences of other particles (differential evolution, ter Braak 2006), and to draws from
a mixture fitted to all, and to twins where a problem has them. Everything is asked in batches of a population.

What it ends with is where the posterior is, and not yet the posterior: its tails are thin, and the evidence that it
could give is wrong where the posterior is a small part of the prior, by more than its error. Importance sampling
follows (:mod:`bnserve_posterior.sampling._importance`).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._errors import LikelihoodEmpty
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._problem import Coordinates
from bnserve_posterior.sampling._proposals import Proposal, inside
from bnserve_posterior.sampling._turning import emptiest, opened

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
_PROPOSALS, _COMPONENTS, _ITERATIONS = 2, 10, 6
"""Draws from a mixture for each particle and round, and how that is fitted: quickly."""
_REMEMBERED = 4000
"""At most so many points are fitted to while particles settle."""
_JUMP = 0.1
"""How often a move is a whole difference, from one mode to another, instead of a scaled one."""
_BLUR = 1e-3
"""Differences are blurred by this part of themselves: copies of one particle part again."""


Halves = tuple[NDArray[np.intp], NDArray[np.intp]]
"""Which particles are moved, and those of the other half, by which."""


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
    now = _reweigh(now, particles, random)
    uniform = np.full(particles, 1.0 / particles)
    coordinates = opened(evaluate.problem.coordinates, emptiest(now.points, uniform, evaluate.problem.coordinates))
    moved = np.zeros(particles, dtype=bool)
    for _ in range(_ROUNDS):
        before = now.points
        order = random.permutation(particles)
        halves = order[: particles // 2], order[particles // 2 :]
        for mine, others in (halves, halves[::-1]):
            now = _evolve(evaluate, now, (mine, others), coordinates, random)
            now = _propose(evaluate, now, mine, now.points[others], random)
            now = _hop(evaluate, now, mine, random)
        moved |= (now.points != before).any(axis=1)
        if moved.mean() >= _MOVED:
            break
    return now


def settle(evaluate: Evaluator, now: Population, rounds: int, random: np.random.Generator) -> tuple[Population, Floats]:
    """Rounds of moves at the power that it has; returns all the places where its particles were, ``(rounds N, D)``.

    Each half is offered draws from mixtures fitted to where the other one was.
    """
    particles = len(now.values)
    order = random.permutation(particles)
    halves = order[: particles // 2], order[particles // 2 :]
    been = [now.points]
    for _ in range(rounds):
        for mine, others in (halves, halves[::-1]):
            there = np.concatenate([points[others] for points in been])
            there = there[random.permutation(len(there))[:_REMEMBERED]]
            now = _propose(evaluate, now, mine, there, random)
            now = _hop(evaluate, now, mine, random)
        been.append(now.points)
    return now, np.concatenate(been[1:])


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
    places = np.minimum(places, len(edges) - 1)
    return Population(now.points[places], now.values[places], high, now.step + 1)


def _effective(values: Floats, power: float) -> float:
    weights = np.exp(power * (values - values.max()))
    return float(weights.sum() ** 2 / np.sum(weights**2))


def _evolve(
    evaluate: Evaluator, now: Population, halves: Halves, coordinates: Coordinates, random: np.random.Generator
) -> Population:
    """Offer each of one half a move along a difference of two particles of the other."""
    mine, others = halves
    y, volumes = coordinates.from_cube(now.points)
    first = random.integers(len(others), size=len(mine))
    second = (first + random.integers(1, len(others), size=len(mine))) % len(others)
    scale = 2.38 / np.sqrt(2.0 * y.shape[1]) * np.exp(0.4 * random.standard_normal(len(mine)))
    scale[random.random(len(mine)) < _JUMP] = 1.0
    step = scale[:, None] * (y[others[first]] - y[others[second]])
    step *= 1.0 + _BLUR * random.standard_normal(step.shape)
    there, theirs = coordinates.to_cube(y[mine] + step)
    return _offer(evaluate, now, mine, there, theirs - volumes[mine], random)


def _propose(
    evaluate: Evaluator, now: Population, mine: NDArray[np.intp], others: Floats, random: np.random.Generator
) -> Population:
    """Offer each of one half draws from a mixture fitted to points of the other.

    Fitted to all, it would know each particle's own place better than the places around: particles would leave where
    they are few.
    """
    uniform = np.full(len(others), 1.0 / len(others))
    proposal = Proposal.fit(evaluate.problem, others, uniform, _COMPONENTS, _ITERATIONS, random)
    for _ in range(_PROPOSALS):
        there = proposal.draw(len(mine), random)
        balance, some = np.full(len(mine), -np.inf), inside(there)
        balance[some] = proposal.log_density(now.points[mine[some]]) - proposal.log_density(there[some])
        now = _offer(evaluate, now, mine, there, balance, random)
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
