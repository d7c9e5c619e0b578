"""Sums of exponentials over very many frequencies at the few times around a trigger.

The time window is short, so that a coarse grid of frequencies resolves it: every frequency of the data is spread
over the nearest points of that grid, one Fourier transform follows, and the kernel's own transform is divided out (a
non-uniform fast Fourier transform of type 1 with the kernel of Barnett, Magland and af Klinteberg 2019, SIAM J. Sci.
Comput. 41).
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_WIDTH = 14
"""Coarse points that a frequency is spread over: an error of 1e-13 on a grid twice as fine as it must be."""
_BETA = 2.30 * _WIDTH
_CELLS = 8
"""Coarse cells whose frequencies are spread by one matrix product."""


class Spreading:
    """Sums ``sum_k rows[j, k] data[d, k] exp(-2 pi i f_k t)`` for t within ``reach`` of ``centre`` (seconds).

    Parameters
    ----------
    f_min, f_max
        Range of the frequencies in Hz.
    centre, reach
        The times, in seconds.
    shape
        ``(D, L)``: numbers of detectors and of rows.
    """

    def __init__(self, f_min: float, f_max: float, centre: float, reach: float, shape: tuple[int, int]) -> None:
        self.period = 4.0 * reach
        self.centre, self.reach = centre, reach
        self._step = 1.0 / self.period
        self._first = f_min - _WIDTH * self._step
        points = int((f_max - self._first) / self._step) + 2 * _WIDTH + _CELLS
        self._sums = np.zeros((*shape, points), dtype=np.complex128)

    def add(self, frequencies: Floats, rows: Complex | Floats, data: Complex) -> None:
        """Add increasing frequencies ``(m,)`` with rows ``(L, m)`` and data ``(D, m)``."""
        cells = ((frequencies - self._first) / self._step).astype(np.int64) // _CELLS
        turned = data * np.exp(-2j * np.pi * frequencies * self.centre)
        edges = np.flatnonzero(np.diff(cells, prepend=-1, append=-1))
        for start, stop in itertools.pairwise(edges):
            place = slice(start, stop)
            first = int(cells[start]) * _CELLS - _WIDTH // 2
            coarse = self._first + self._step * (first + np.arange(_CELLS + _WIDTH + 1))
            spread = _kernel((frequencies[place, None] - coarse) / (0.5 * _WIDTH * self._step))
            target = self._sums[:, :, first : first + len(coarse)]
            for detector, values in zip(target, turned[:, place], strict=True):
                detector += rows[:, place] @ (values[:, None] * spread)

    def raster(self, step: float, width: float, margin: int) -> Floats:
        """Uniform times in seconds, at most ``step`` apart: ``width`` around the centre and ``margin`` steps beyond."""
        per_period = max(self._sums.shape[2], int(np.ceil(self.period / step)))
        half = int(np.ceil(width * per_period / self.period)) + margin
        return np.asarray(self.centre + self.period / per_period * np.arange(-half, half + 1), dtype=np.float64)

    def over(self, detector: int, raster: Floats) -> Complex:
        """The sums at the times of a raster, ``(n, L)``."""
        half = len(raster) // 2
        per_period = round(self.period * 2 * half / (raster[-1] - raster[0]))
        k = np.arange(-half, half + 1)
        offsets = k * (self.period / per_period)
        factor = np.exp(-2j * np.pi * self._first * offsets) / _kernel_transform(offsets * self._step)
        found = np.empty((len(k), self._sums.shape[1]), dtype=np.complex128)
        for j, row in enumerate(self._sums[detector]):
            found[:, j] = np.fft.fft(row, per_period)[k % per_period] * factor
        return found

    def at(self, detector: int, times: Floats) -> Complex:
        """The sums at times in seconds ``(n,)``, ``(n, L)``."""
        offsets = times - self.centre
        points = self._first + self._step * np.arange(self._sums.shape[2])
        turns = np.exp(-2j * np.pi * points * offsets[:, None])
        return (turns / _kernel_transform(offsets * self._step)[:, None]) @ self._sums[detector].T


def _kernel(x: Floats) -> Floats:
    inside = np.clip(1.0 - x * x, 0.0, None)
    return np.where(np.abs(x) < 1.0, np.exp(_BETA * (np.sqrt(inside) - 1.0)), 0.0)


def _kernel_transform(offsets: Floats) -> Floats:
    """Fourier transform of the kernel, at times in units of the coarse grid's period."""
    nodes, weights = np.polynomial.legendre.leggauss(120)
    turns = np.cos(np.pi * _WIDTH * offsets[:, None] * nodes)
    return 0.5 * _WIDTH * (turns @ (weights * _kernel(nodes)))
