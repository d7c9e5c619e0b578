"""Islands of points: groups with nothing between them, each of which has a shape of its own."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_FEWEST = 4
"""Points of an island for each dimension: of fewer the shape is not known."""
_WIDE = 1.0
"""An empty stretch of a column parts two islands where it is wider than this many standard deviations of either."""


def islands(y: Floats, weights: Floats) -> list[NDArray[np.intp]]:
    """Rows of points ``(N, D)`` by island, the heaviest first; weights sum to one."""
    found, left = [], [np.arange(len(y))]
    while left:
        rows = left.pop()
        parted = _parted(y[rows], _FEWEST * y.shape[1])
        if parted is None:
            found.append(rows)
        else:
            left += [rows[parted], rows[~parted]]
    return sorted(found, key=lambda rows: -float(weights[rows].sum()))


def _parted(y: Floats, fewest: int) -> NDArray[np.bool_] | None:
    """Which points are on one side of the widest empty stretch of any column, if it is wide."""
    if len(y) < 2 * fewest:
        return None
    widest, best = _WIDE, None
    for column in y.T:
        ordered = np.sort(column)
        number = np.arange(1, len(ordered))
        sums, squares = np.cumsum(ordered - ordered.mean()), np.cumsum((ordered - ordered.mean()) ** 2)
        before = squares[:-1] / number - (sums[:-1] / number) ** 2
        after = (squares[-1] - squares[:-1]) / number[::-1] - ((sums[-1] - sums[:-1]) / number[::-1]) ** 2
        spread = np.sqrt(np.maximum(np.maximum(before, after), 0.0)) + 1e-300
        wide = (np.diff(ordered) / spread)[fewest - 1 : len(ordered) - fewest]
        if len(wide) and wide.max() > widest:
            widest, best = wide.max(), column <= ordered[fewest - 1 + int(np.argmax(wide))]
    return best
