"""A likelihood's batches in several threads at once: its compiled parts, and numpy's, do not wait for each other."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import LikelihoodBatch

Floats = NDArray[np.float64]
Evaluate = Callable[[LikelihoodBatch], Floats]
_FEWEST_ROWS = 128
"""Of a part: fewer are done before another thread has begun."""


@contextmanager
def in_threads(evaluate: Evaluate, threads: int) -> Iterator[Evaluate]:
    """The same function, whose rows are evaluated in so many threads; values do not depend on how many."""
    if threads == 1:
        yield evaluate
        return
    with ThreadPoolExecutor(threads, "likelihood") as pool:

        def spread(batch: LikelihoodBatch) -> Floats:
            parts = max(1, min(threads, len(batch) // _FEWEST_ROWS))
            ends = np.linspace(0, len(batch), parts + 1).astype(np.int64)
            pieces = [batch.rows(slice(*pair)) for pair in itertools.pairwise(ends)]
            return np.concatenate(list(pool.map(evaluate, pieces)))

        yield spread
