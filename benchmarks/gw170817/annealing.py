"""An annealed population (sequential Monte Carlo): a posterior, its evidence, and how well that is known.

Particles of the prior are brought to the posterior in steps of the likelihood's power, each as large as leaves half of
the population's effective size (Del Moral, Doucet, Jasra 2006). After each they are resampled and moved: half of them
along differences of the other half (differential evolution, ter Braak 2006), and to draws from a mixture fitted to all.
In the end more such moves make the samples, and the evidence is that of bridge sampling between them and draws from the
mixture (:mod:`benchmarks.gw170817.bridge`). Everything is asked in batches of a population.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.bridge import evidence_between
from benchmarks.gw170817.mixture import Mixture
from benchmarks.gw170817.moving import Coordinates, LogLikelihood, Population, evolve, propose

Floats = NDArray[np.float64]
_EFFECTIVE = 0.5


@dataclass(frozen=True)
class Annealing:
    """Draws from the prior to begin with; particles; after each step, so many times, so many sweeps of differential
    evolution and of a mixture of so many components; in the end so many sweeps to settle, and so many of which every so
    many are kept; draws from the last mixture for the evidence; and the seed."""

    pool: int = 20_000
    particles: int = 2000
    rounds: int = 2
    evolutions: int = 2
    proposals: int = 4
    components: int = 15
    settling_sweeps: int = 0
    final_sweeps: int = 20
    keep_every: int = 5
    draws: int = 10_000
    seed: int = 1


class Draws(NamedTuple):
    """Points of the unit cube ``(N, D)`` and log-likelihoods ``(N,)``, equally weighted; how many independent ones they
    are worth; ln evidence, its standard error, and what the annealing itself made of it (less exact)."""

    points: Floats
    values: Floats
    effective: float
    log_evidence: float
    log_evidence_error: float
    annealed_log_evidence: float


def anneal(
    log_likelihood: LogLikelihood,
    dimensions: int,
    settings: Annealing,
    coordinates: Coordinates,
    checkpoint: Path | None,
) -> Draws:
    """Draws from the posterior of a likelihood over the unit cube.

    Parameters
    ----------
    log_likelihood:
        Of points ``(N, D)``; -inf is allowed.
    coordinates:
        In which moves are made.
    checkpoint:
        An npz file, written after each step; a run that finds one goes on there, with the same result.
    """
    if checkpoint is not None and checkpoint.exists():
        now = _read(checkpoint)
    else:
        points = np.random.default_rng([settings.seed, 0]).random((settings.pool, dimensions))
        now = Population(points, log_likelihood(points), 0.0, 0.0, 0)
    while now.power < 1.0:
        random = np.random.default_rng([settings.seed, now.step + 1])
        now = _reweigh(now, settings.particles, random)
        for _ in range(settings.rounds):
            for _ in range(settings.evolutions):
                now = evolve(log_likelihood, now, coordinates, random)
            mixture = Mixture.fit(coordinates.from_cube(now.points)[0], settings.components, random)
            for _ in range(settings.proposals):
                now = propose(log_likelihood, now, mixture, coordinates, random)
        if checkpoint is not None:
            _write(checkpoint, now)
    return _finished(log_likelihood, now, settings, coordinates)


def _finished(log_likelihood: LogLikelihood, now: Population, settings: Annealing, coordinates: Coordinates) -> Draws:
    """Sweeps at full power, and the evidence from the last of them."""
    random = np.random.default_rng([settings.seed, now.step + 1])
    kept, accepted = [], []
    for sweep in range(-settings.settling_sweeps, settings.final_sweeps):
        if sweep % settings.keep_every == 0:
            now = evolve(log_likelihood, now, coordinates, random)
            mixture = Mixture.fit(coordinates.from_cube(now.points)[0], settings.components, random)
        before, now = now, propose(log_likelihood, now, mixture, coordinates, random)
        accepted.append(np.mean(before.values != now.values))
        if sweep > 0 and (sweep + 1) % settings.keep_every == 0:
            kept.append(now)
    remembered = (1.0 - np.mean(accepted)) ** settings.keep_every
    effective = len(now.values) * (1.0 + (len(kept) - 1) * (1.0 - remembered) / (1.0 + remembered))
    points = np.concatenate([each.points for each in kept])
    evidence, error = evidence_between(
        log_likelihood, np.array([each.points for each in kept]), np.array([each.values for each in kept]),
        effective, settings.components, settings.draws, coordinates, random,
    )  # fmt: skip
    values = np.concatenate([each.values for each in kept])
    return Draws(points, values, float(effective), evidence, error, now.log_evidence)


def _reweigh(now: Population, particles: int, random: np.random.Generator) -> Population:
    """Raise the power as far as leaves half of the particles' effective size, and resample."""
    wanted = _EFFECTIVE * particles
    low, high = now.power, 1.0
    if _effective(now.values, high - now.power) < wanted:
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if _effective(now.values, middle - now.power) > wanted else (low, middle)
        high = low
    exponent = (high - now.power) * now.values
    weights = np.exp(exponent - exponent.max())
    log_mean = float(exponent.max() + np.log(weights.mean()))
    edges = np.cumsum(weights) / weights.sum()
    places = np.searchsorted(edges, (np.arange(particles) + random.random()) / particles)
    places = np.minimum(places, len(weights) - 1)
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
