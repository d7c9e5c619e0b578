"""Islands of points: groups with next to nothing between them, each of which has a shape of its own."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_FEWEST = 4
"""Points of an island for each dimension: of fewer the shape is not known."""
_BINS = 50
_VALLEY = 0.1
"""Two peaks of a column are two islands where so little of the lower one is between them."""
_SAME = 1e-9
"""A column of which all values are that near to each other has no valley."""
_PEAK, _PART = 8.0, 0.002
"""Points in a bin of a peak, and their part of all, at least."""


def islands(y: Floats, weights: Floats) -> list[NDArray[np.intp]]:
    """Rows of points ``(N, D)`` by island, the heaviest first; weights sum to one."""
    found, left = [], [np.arange(len(y))]
    while left:
        rows = left.pop()
        parted = _parted(y[rows])
        if parted is None:
            found.append(rows)
        else:
            left += [rows[parted], rows[~parted]]
    return sorted(found, key=lambda rows: -float(weights[rows].sum()))


def _parted(y: Floats) -> NDArray[np.bool_] | None:
    """Which points are on one side of the deepest valley of any column, if it is deep."""
    least, deepest, best = _FEWEST * y.shape[1], _VALLEY, None
    if len(y) < 2 * least:
        return None
    for column in y.T:
        low, high = np.quantile(column, [0.001, 0.999])
        if high - low <= _SAME * max(abs(low), abs(high)):
            continue
        counts, edges = np.histogram(column, _BINS, (low, high))
        smooth = np.convolve(np.convolve(counts, [0.25, 0.5, 0.25]), [0.25, 0.5, 0.25])[2:-2]
        left, right = np.maximum.accumulate(smooth), np.maximum.accumulate(smooth[::-1])[::-1]
        lower = np.minimum(left, right)
        high = lower > max(_PEAK, _PART * len(y))
        depth = np.where(high, smooth / np.where(high, lower, 1.0), 1.0)
        at = edges[int(np.argmin(depth))] + 0.5 * (edges[1] - edges[0])
        if depth.min() < deepest and least <= np.sum(column <= at) <= len(y) - least:
            deepest, best = depth.min(), column <= at
    return best
