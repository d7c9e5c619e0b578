"""Looking for the binaries that fit: a population of points that cools down (Neal 2001; ter Braak 2006).

What is looked for are the places where an approximate likelihood would lead a sampler, right or wrong.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_POPULATION, _STAGES, _MOVES = 1024, 12, 2
"""25,000 likelihoods in all: half a second."""
_COLDEST = 6.0
"""Temperature at the end, at which half of the population is within 25 of the maximum."""
_SCALES = 4.0
"""Decades of distance from the start at which half of the population begins, along every axis by itself."""


def climb(value: Callable[[Floats], Floats], start: Floats | None, dimensions: int, seed: int) -> tuple[Floats, Floats]:
    """Points of the unit cube that are distributed as exp(value / 6), roughly.

    Parameters
    ----------
    value:
        Of points ``(N, dimensions)``: ``(N,)``, -inf where there is none.
    start:
        A point ``(dimensions,)`` that may be near the maximum, or None.
    seed:
        Of all random numbers.

    Returns
    -------
    Points ``(N, dimensions)`` and their values ``(N,)``; all of them -inf if there was nothing else.
    """
    random = np.random.default_rng(seed)
    points = _first(start, dimensions, random)
    values = value(points)
    if not np.isfinite(values).any():
        return points, values
    warmest = max(float(values.max() - values[np.isfinite(values)].min()), _COLDEST)
    before = np.inf
    for temperature in np.geomspace(warmest, _COLDEST, _STAGES):
        below = np.where(np.isfinite(values), values - values.max(), -1e300)
        kept = _resampled(below * (1.0 / temperature - 1.0 / before), random)
        points, values, before = points[kept], values[kept], temperature
        for _ in range(_MOVES):
            moved = _moved(points, random)
            found = value(moved)
            better = np.log1p(-random.random(len(points))) < (found - values) / temperature
            points[better], values[better] = moved[better], found[better]
    return points, values


def _first(start: Floats | None, dimensions: int, random: np.random.Generator) -> Floats:
    """Half of them crowd at the edges of the cube; with a start, the other half crowds around it."""
    unit = random.random((_POPULATION, dimensions))
    half = _POPULATION // 2
    unit[:half] = 0.5 - 0.5 * np.cos(np.pi * unit[:half])
    if start is not None:
        unit[half:] = start + 10.0 ** (-_SCALES * random.random((half, dimensions))) * (unit[half:] - start)
        unit[-1] = start
    return unit


def _resampled(log_weights: Floats, random: np.random.Generator) -> NDArray[np.int64]:
    cumulative = np.cumsum(np.exp(log_weights))
    wanted = (random.random() + np.arange(len(log_weights))) / len(log_weights) * cumulative[-1]
    return np.minimum(np.searchsorted(cumulative, wanted), len(log_weights) - 1)


def _moved(points: Floats, random: np.random.Generator) -> Floats:
    """Steps along differences of two points, of many lengths, reflected at the walls."""
    count, dimensions = points.shape
    one, other = random.integers(count, size=(2, count))
    length = 2.38 / np.sqrt(2.0 * dimensions) * 10.0 ** (-random.random((count, 1)))
    wandering = 1e-5 * random.standard_normal((count, dimensions))
    moved = np.abs(points + length * (points[one] - points[other]) + wandering) % 2.0
    return np.asarray(np.where(moved > 1.0, 2.0 - moved, moved))
