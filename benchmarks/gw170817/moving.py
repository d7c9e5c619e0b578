"""Moves of a population that leave its distribution as it is (Metropolis, Hastings)."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.mixture import Mixture

Floats = NDArray[np.float64]
LogLikelihood = Callable[[Floats], Floats]
Transform = Callable[[Floats], tuple[Floats, Floats]]
_JUMP = 0.1
"""How often a move is a whole difference, from one mode to another, instead of a scaled one."""
_ANYWHERE = 0.1
"""How often a proposal is a draw from the prior: what a mixture has not seen is found as well."""
_BLUR = 1e-3
"""Differences are blurred by this part of themselves: copies of one particle part again."""


class Coordinates(NamedTuple):
    """From the unit cube and back; each also gives ln of the volume ``abs(du / dy)``, ``(N,)``."""

    from_cube: Transform
    to_cube: Transform


def cube_itself(points: Floats) -> tuple[Floats, Floats]:
    """No other coordinates than those of the cube, either way."""
    return points.copy(), np.zeros(len(points))


PLAIN = Coordinates(cube_itself, cube_itself)


class Population(NamedTuple):
    """Points in the unit cube ``(N, D)`` and log-likelihoods ``(N,)`` at a power of the likelihood; ln of the evidence
    so far; and how many steps it took."""

    points: Floats
    values: Floats
    power: float
    log_evidence: float
    step: int


def evolve(
    log_likelihood: LogLikelihood, now: Population, coordinates: Coordinates, random: np.random.Generator
) -> Population:
    """Offer every particle one move along a difference of two particles of the other half of the population."""
    count, dimensions = now.points.shape
    order = random.permutation(count)
    for mine, others in ((order[: count // 2], order[count // 2 :]), (order[count // 2 :], order[: count // 2])):
        y, volumes = coordinates.from_cube(now.points)
        first = random.integers(len(others), size=len(mine))
        second = (first + random.integers(1, len(others), size=len(mine))) % len(others)
        scale = 2.38 / np.sqrt(2.0 * dimensions) * np.exp(0.4 * random.standard_normal(len(mine)))
        scale[random.random(len(mine)) < _JUMP] = 1.0
        step = scale[:, None] * (y[others[first]] - y[others[second]])
        step *= 1.0 + _BLUR * random.standard_normal(step.shape)
        now = _offer(log_likelihood, now, mine, coordinates.to_cube(y[mine] + step), volumes[mine], random)
    return now


def propose(
    log_likelihood: LogLikelihood,
    now: Population,
    mixture: Mixture,
    coordinates: Coordinates,
    random: np.random.Generator,
) -> Population:
    """Offer every particle a place drawn from the mixture or, sometimes, from the prior."""
    y, volumes = coordinates.from_cube(now.points)
    count, dimensions = now.points.shape
    offered, places, theirs = mixture_or_prior(mixture, count, dimensions, coordinates, random)
    balance = volumes - log_proposal(mixture, y, volumes)
    their_balance = theirs - log_proposal(mixture, offered, theirs)
    return _offer(log_likelihood, now, np.arange(len(y)), (places, their_balance), balance, random)


def mixture_or_prior(
    mixture: Mixture, count: int, dimensions: int, coordinates: Coordinates, random: np.random.Generator
) -> tuple[Floats, Floats, Floats]:
    """Draws whose density is :func:`log_proposal`: coordinates and points of the cube ``(N, D)``, volumes ``(N,)``."""
    anywhere = random.random((count, dimensions))
    y, drawn = coordinates.from_cube(anywhere)[0], mixture.draw(count, random)
    y = np.where(random.random((count, 1)) < _ANYWHERE, y, drawn)
    return y, *coordinates.to_cube(y)


def log_proposal(mixture: Mixture, y: Floats, volumes: Floats) -> Floats:
    """ln of the density of proposals at coordinates ``(N, D)``; the prior's density there is the volume."""
    return np.logaddexp(np.log1p(-_ANYWHERE) + mixture.log_density(y), np.log(_ANYWHERE) + volumes)


def _offer(
    log_likelihood: LogLikelihood,
    now: Population,
    mine: NDArray[np.intp],
    offered: tuple[Floats, Floats],
    log_volumes: Floats,
    random: np.random.Generator,
) -> Population:
    """Take or leave a place for each of the particles ``mine``; volumes are those of the proposals' balance as well."""
    places, theirs = offered
    threshold = np.log(random.random(len(mine)))
    inside = np.flatnonzero(((places > 0.0) & (places < 1.0)).all(axis=1) & np.isfinite(theirs))
    if len(inside) == 0:
        return now
    found, before = log_likelihood(places[inside]), now.values[mine[inside]]
    taken = now.power * (found - before) + theirs[inside] - log_volumes[inside] > threshold[inside]
    points, values = now.points.copy(), now.values.copy()
    points[mine[inside[taken]]], values[mine[inside[taken]]] = places[inside[taken]], found[taken]
    return now._replace(points=points, values=values)
