"""The likelihood that was sampled against the full one, at samples of the posterior."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.results._samples import Samples
from bnserve_protocol import LikelihoodBatch

Floats = NDArray[np.float64]


class FullCheck(NamedTuple):
    """How a likelihood and the full one differ at ``samples`` of them.

    Largest and median abs of the difference in ln L; by how much ln of the evidence would shift; and the effective
    sample size of the weights that turn the one posterior into the other, over their number.
    """

    samples: int
    largest: float
    median: float
    shift: float
    efficiency: float


def check_with_full(samples: Samples, full: Callable[[LikelihoodBatch], Floats], count: int) -> FullCheck:
    """Compare at the first samples.

    Parameters
    ----------
    samples
        In random order.
    full
        ln L on the full grid, integrating over the same.
    count
        At most so many: a full grid takes milliseconds for each.

    Returns
    -------
    Differences of ln L (natural logarithm), and what follows from them.
    """
    rows = slice(0, min(count, len(samples)))
    exact = full(samples.batch.rows(rows))
    difference = exact - samples.log_likelihood[rows]
    weights = np.exp(difference - difference.max())
    return FullCheck(
        samples=len(difference),
        largest=float(np.abs(difference).max()),
        median=float(np.median(np.abs(difference))),
        shift=float(difference.max() + np.log(weights.mean())),
        efficiency=float(weights.sum() ** 2 / np.sum(weights**2) / len(weights)),
    )
