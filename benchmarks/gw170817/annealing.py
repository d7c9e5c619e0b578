"""An annealed population (sequential Monte Carlo): a posterior and its evidence from a few hundred large batches.

Particles of the prior are brought to the posterior in steps of the likelihood's power, each as large as leaves half of
the population's effective size; after each they are resampled and moved by differential evolution within the unit cube,
half of them at a time along differences of the other half (Del Moral, Doucet, Jasra 2006; ter Braak 2006). All moves of
a half are one batch, which is what a likelihood in a service is fast at.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
LogLikelihood = Callable[[Floats], Floats]
_EFFECTIVE = 0.5
_JUMP = 0.1
"""How often a move is a whole difference, from one mode to another, instead of a scaled one."""


@dataclass(frozen=True)
class Annealing:
    """Particles, sweeps of moves after each step, sweeps at the end, of which every so many are kept, and the seed."""

    particles: int = 2000
    sweeps: int = 25
    final_sweeps: int = 100
    keep_every: int = 25
    seed: int = 1


class Population(NamedTuple):
    """Points in the unit cube ``(N, D)`` and log-likelihoods ``(N,)`` at a power of the likelihood; ln of the evidence
    so far; how many steps it took; and samples kept at the end."""

    points: Floats
    values: Floats
    power: float
    log_evidence: float
    step: int


def anneal(log_likelihood: LogLikelihood, dimensions: int, settings: Annealing, checkpoint: Path | None) -> Population:
    """Equally weighted draws from the posterior of a likelihood over the unit cube.

    Parameters
    ----------
    log_likelihood:
        Of points ``(N, D)``; -inf is allowed.
    checkpoint:
        An npz file, written after each step; a run that finds one goes on there, with the same result.
    """
    if checkpoint is not None and checkpoint.exists():
        now = _read(checkpoint)
    else:
        points = np.random.default_rng([settings.seed, 0]).random((settings.particles, dimensions))
        now = Population(points, log_likelihood(points), 0.0, 0.0, 0)
    while now.power < 1.0:
        random = np.random.default_rng([settings.seed, now.step + 1])
        now = _reweigh(now, random)
        for _ in range(settings.sweeps):
            now = sweep(log_likelihood, now, random)
        if checkpoint is not None:
            _write(checkpoint, now)
    random = np.random.default_rng([settings.seed, now.step + 1])
    kept = []
    for count in range(1, settings.final_sweeps + 1):
        now = sweep(log_likelihood, now, random)
        if count % settings.keep_every == 0:
            kept.append(now)
    return now._replace(
        points=np.concatenate([each.points for each in kept]), values=np.concatenate([each.values for each in kept])
    )


def sweep(log_likelihood: LogLikelihood, now: Population, random: np.random.Generator) -> Population:
    """Offer every particle one move: a scaled difference of two particles of the other half."""
    points, values = now.points.copy(), now.values.copy()
    count, dimensions = points.shape
    order = random.permutation(count)
    for mine, others in ((order[: count // 2], order[count // 2 :]), (order[count // 2 :], order[: count // 2])):
        first = random.integers(len(others), size=len(mine))
        second = (first + random.integers(1, len(others), size=len(mine))) % len(others)
        scale = 2.38 / np.sqrt(2.0 * dimensions) * np.exp(0.4 * random.standard_normal(len(mine)))
        scale[random.random(len(mine)) < _JUMP] = 1.0
        offered = points[mine] + scale[:, None] * (points[others[first]] - points[others[second]])
        offered += 1e-6 * random.standard_normal(offered.shape)
        inside = np.flatnonzero(((offered > 0.0) & (offered < 1.0)).all(axis=1))
        threshold = np.log(random.random(len(mine)))
        if len(inside) == 0:
            continue
        found = np.full(len(mine), -np.inf)
        found[inside] = log_likelihood(offered[inside])
        taken = now.power * (found - values[mine]) > threshold
        points[mine[taken]], values[mine[taken]] = offered[taken], found[taken]
    return now._replace(points=points, values=values)


def _reweigh(now: Population, random: np.random.Generator) -> Population:
    """Raise the power as far as the population bears, and resample it."""
    count = len(now.values)
    low, high = now.power, 1.0
    if _effective(now.values, high - now.power) < _EFFECTIVE * count:
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (
                (middle, high) if _effective(now.values, middle - now.power) > _EFFECTIVE * count else (low, middle)
            )
        high = low
    exponent = (high - now.power) * now.values
    weights = np.exp(exponent - exponent.max())
    log_mean = float(exponent.max() + np.log(weights.mean()))
    edges = np.cumsum(weights) / weights.sum()
    places = np.minimum(np.searchsorted(edges, (np.arange(count) + random.random()) / count), count - 1)
    return Population(now.points[places], now.values[places], high, now.log_evidence + log_mean, now.step + 1)


def _effective(values: Floats, power: float) -> float:
    weights = np.exp(power * (values - values.max()))
    return float(weights.sum() ** 2 / np.sum(weights**2))


def _write(path: Path, now: Population) -> None:
    partial = path.with_suffix(".part.npz")
    np.savez(partial, **now._asdict())
    partial.replace(path)


def _read(path: Path) -> Population:
    with np.load(path, allow_pickle=False) as file:
        return Population(
            file["points"], file["values"], float(file["power"]), float(file["log_evidence"]), int(file["step"])
        )
