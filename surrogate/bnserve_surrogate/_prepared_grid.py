"""What depends on the frequency grid alone, computed once per grid."""

from __future__ import annotations

import threading
from collections import OrderedDict
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import GridLike, UniformGrid, as_frequencies


class PreparedGrid(NamedTuple):
    """Frequencies in Hz with their logarithms and cube roots, each ``(M,)`` and read-only."""

    frequencies: NDArray[np.float64]
    log_frequencies: NDArray[np.float64]
    cube_roots: NDArray[np.float64]


class GridCache:
    """The grids used last. A hit is decided by comparing all frequencies, so a changed array is a different grid."""

    def __init__(self, max_grids: int = 8) -> None:
        self._max_grids = max_grids
        self._lock = threading.Lock()
        self._grids: OrderedDict[object, PreparedGrid] = OrderedDict()

    def prepare(self, grid: GridLike) -> PreparedGrid:
        """Check and prepare a grid, or find it prepared.

        Raises
        ------
        InvalidFrequencies
        """
        key, known = self._find(grid)
        if known is not None:
            return known
        frequencies = as_frequencies(grid)
        if not isinstance(grid, UniformGrid):
            frequencies = frequencies.copy()
            key = self._key(frequencies)
        prepared = PreparedGrid(frequencies, np.log(frequencies), np.cbrt(frequencies))
        for array in prepared:
            array.flags.writeable = False
        with self._lock:
            self._grids[key] = prepared
            self._grids.move_to_end(key)
            while len(self._grids) > self._max_grids:
                self._grids.popitem(last=False)
        return prepared

    def _find(self, grid: GridLike) -> tuple[object, PreparedGrid | None]:
        if isinstance(grid, UniformGrid):
            return grid, self._grids.get(grid)
        if not isinstance(grid, np.ndarray) or grid.dtype != np.float64 or grid.ndim != 1 or grid.size == 0:
            return None, None
        key = self._key(grid)
        known = self._grids.get(key)
        if known is not None and np.array_equal(known.frequencies, grid):
            return key, known
        return key, None

    @staticmethod
    def _key(frequencies: NDArray[np.float64]) -> object:
        middle = len(frequencies) // 2
        return len(frequencies), float(frequencies[0]), float(frequencies[middle]), float(frequencies[-1])
