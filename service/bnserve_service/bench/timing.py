"""Timing calls of microseconds on a machine that others use, too: shuffled rounds, medians, a linear fit.

The procedure is that of the paper's appendix on benchmarks (arXiv:2210.15684): every combination of approximant, grid
size and parameters is a case; all cases are timed in several epochs, in another order each time.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Hashable, Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

Case = TypeVar("Case", bound=Hashable)


class LinearCost(NamedTuple):
    """The fit t = overhead + per_point N, both in seconds."""

    overhead: float
    per_point: float

    def at(self, points: int) -> float:
        """Seconds that the fit gives for this many points."""
        return self.overhead + self.per_point * points


def grid_sizes(count: int, smallest: int = 10, largest: int = 253_056) -> list[int]:
    """Different whole numbers near a logarithmically spaced grid, as in the paper; at most ``count`` of them."""
    return sorted({round(float(value)) for value in np.geomspace(smallest, largest, count)})


def fit_cost(points: Sequence[int], seconds: Sequence[float]) -> LinearCost:
    """Least squares of the relative errors of t = t_o + t_p N, both kept from being negative.

    Relative, because the times of one fit differ by factors of thousands and each is as well known as the others.
    """
    sizes, times = np.asarray(points, dtype=float), np.asarray(seconds, dtype=float)
    design = np.column_stack([np.ones_like(sizes), sizes]) / times[:, None]
    overhead, per_point = np.linalg.lstsq(design, np.ones_like(times), rcond=None)[0]
    if overhead < 0.0:
        overhead, per_point = 0.0, _alone(design[:, 1])
    elif per_point < 0.0:
        overhead, per_point = _alone(design[:, 0]), 0.0
    return LinearCost(float(overhead), float(per_point))


def _alone(column: NDArray[np.float64]) -> float:
    return float(column.sum() / (column @ column))


def shuffled(
    cases: Mapping[Case, Callable[[], Sequence[float]]],
    epochs: int,
    seed: int = 0,
    after_epoch: Callable[[int], Any] = lambda epoch: None,
) -> dict[Case, list[float]]:
    """Time every case once in each epoch, in another order each time.

    Parameters
    ----------
    cases
        For each case a function that returns the seconds of one or several calls.
    epochs
        How often all of them.
    seed
        Of the orders.
    after_epoch
        Called with the number of epochs done, to show progress.

    Returns
    -------
    All seconds of each case.
    """
    order, shuffle = list(cases), random.Random(seed)
    seconds: dict[Case, list[float]] = {case: [] for case in cases}
    for epoch in range(epochs):
        shuffle.shuffle(order)
        for case in order:
            seconds[case].extend(cases[case]())
        after_epoch(epoch + 1)
    return seconds


def timed(call: Callable[[], object], calls: int = 1) -> Callable[[], list[float]]:
    """A function that makes some calls and returns the seconds of each, after one that does not count."""

    def measure() -> list[float]:
        call()
        return seconds_of(call, calls)

    return measure


def seconds_of(call: Callable[[], object], calls: int) -> list[float]:
    """Seconds of each of some calls."""
    found = []
    for _ in range(calls):
        started = time.perf_counter()
        call()
        found.append(time.perf_counter() - started)
    return found
