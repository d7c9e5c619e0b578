"""What is sampled: a likelihood over the unit cube, and coordinates in which its posterior is simple."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

Floats = NDArray[np.float64]
LogLikelihood = Callable[[Floats], Floats]
Transform = Callable[[Floats], tuple[Floats, Floats]]
Twins = Callable[[Floats, np.random.Generator], Floats]
"""From points ``(N, D)`` of the cube to others ``(N, D)`` where the likelihood may be much the same."""
_LOWEST, _HIGHEST = 1e-300, 1.0 - 2.0**-53
"""First and last place between the edges, which are at infinity; numbers near 0 are finer than those near 1."""


class Coordinates(NamedTuple):
    """From the unit cube and back; each also gives ln of the volume ``abs(du / dy)``, ``(N,)``.

    Columns of ``circles`` are places on a circle, from 0 to 1, where they begin anew.
    """

    from_cube: Transform
    to_cube: Transform
    circles: tuple[int, ...] = ()


def normal_quantiles(points: Floats) -> tuple[Floats, Floats]:
    """Where a normal distribution reaches each column, ``(N, D)``, and ln of the volume, ``(N,)``."""
    y = ndtri(np.clip(points, _LOWEST, _HIGHEST))
    return y, log_normal(y)


def normal_probabilities(y: Floats) -> tuple[Floats, Floats]:
    """The way back."""
    return ndtr(y), log_normal(y)


def log_normal(y: Floats) -> Floats:
    """ln of the density of standard normal columns ``(N, D)``, ``(N,)``."""
    return np.asarray(-0.5 * np.sum(y**2 + np.log(2.0 * np.pi), axis=1))


def plain(circles: Sequence[int] = ()) -> Coordinates:
    """Where a normal distribution reaches each column of the cube, so that posteriors at an edge of the prior have none
    there; columns of ``circles`` as they are."""
    rings = list(circles)

    def from_cube(points: Floats) -> tuple[Floats, Floats]:
        y, volumes = normal_quantiles(points)
        volumes -= log_normal(y[:, rings])
        y[:, rings] = points[:, rings]
        return y, volumes

    def to_cube(y: Floats) -> tuple[Floats, Floats]:
        points, volumes = normal_probabilities(y)
        volumes -= log_normal(y[:, rings])
        points[:, rings] = y[:, rings]
        return points, volumes

    return Coordinates(from_cube, to_cube, tuple(circles))


PLAIN = plain()
"""Without circles."""


@dataclass(frozen=True)
class Problem:
    """A likelihood over the unit cube.

    Parameters
    ----------
    log_likelihood:
        ln of the likelihood at points ``(N, D)`` of the cube, ``(N,)``; -inf is allowed. It may raise: a run with a
        checkpoint goes on from there.
    dimensions:
        D, 1 to 20.
    coordinates:
        In which the posterior is nearly a mixture of few normal distributions.
    twins:
        From points ``(N, D)`` to others where the likelihood may be much the same, one of few at random: the way back
        is as probable, and volumes stay what they are. What a population finds in one place it then finds in all.
    """

    log_likelihood: LogLikelihood
    dimensions: int
    coordinates: Coordinates = PLAIN
    twins: Twins | None = None


@dataclass(frozen=True)
class Settings:
    """Of the sampler.

    Parameters
    ----------
    effective:
        Effective samples that the posterior must have.
    particles:
        Of each of the two populations that find it.
    batch:
        Points in one call of the likelihood, at most.
    seed:
        Of all that is random.
    """

    effective: int = 10_000
    particles: int = 3000
    batch: int = 4000
    seed: int = 1


class Progress(NamedTuple):
    """How far a run is: what it does now, in words; the step; the power of the likelihood (1 at the end); ln of the
    evidence and effective samples so far, NaN before importance sampling; and likelihoods evaluated."""

    stage: str
    step: int
    power: float
    log_evidence: float
    effective: float
    likelihoods: int
