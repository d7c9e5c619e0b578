"""Weights of bins as functions of time, from the sums that fine bins hold of the data.

The cardinal splines of the bins are long, and each is made of what the values and the second derivatives at two edges
count in a bin: fine frequencies are summed to these, bin by bin, and one matrix makes weights of edges of them.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._fiducial import FiducialBasis
from bnserve_inference._fine_bins import FineBins
from bnserve_inference._weights import TimeRange
from bnserve_protocol import WaveformModel

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
Turned = Callable[[slice], NDArray[np.float64] | Complex]
"""exp(-2 pi i f t) of some of the fine frequencies at all times, ``(m, n)``."""


class BinWeights:
    """See :class:`._weights.Weights`: those of the edges, for every order after the other.

    Parameters
    ----------
    basis
        The bins.
    fine
        The data.
    model
        That of the fiducial waveform.
    times
        Where the weights are wanted.
    """

    def __init__(self, basis: FiducialBasis, fine: FineBins, model: WaveformModel, times: TimeRange) -> None:
        self.nodes, self.times, self.detectors = basis.all_nodes, times, len(fine.linear)
        self._fine, self._curvatures, self._edges = fine, basis.curvatures, len(basis.linear_nodes)
        inside = int(np.searchsorted(fine.frequencies, basis.linear_nodes[-1], side="right"))
        bins, self._shares = basis.shares(fine.frequencies[:inside])
        self._starts = np.searchsorted(bins, np.arange(self._edges))
        self._at_edges = np.stack([basis.reference(model, order, basis.linear_nodes) for order in basis.orders])

    def pairs(self) -> Complex:
        """Quadratic weights of the pairs of orders, ``(D, P, L)``."""

        def at_once(place: slice) -> Floats:
            return np.ones((place.stop - place.start, 1))

        weights = self._fine.quadratic[:, :, : self._shares.shape[1]]
        detectors, pairs = weights.shape[:2]
        found = self._of_edges(weights.reshape(detectors * pairs, -1), at_once, 1).reshape(detectors, pairs, -1)
        first, second = np.triu_indices(len(self._at_edges))
        return np.ascontiguousarray(found / (self._at_edges[first].conj() * self._at_edges[second]))

    def raster(self, step: float, margin: int = 0) -> Floats:
        """See :class:`._weights.Weights`."""
        half = int(np.ceil(0.5 * self.times.width / step))
        steps = np.arange(-half - margin, half + margin + 1) / half
        return 0.5 * (self.times.start + self.times.stop) + 0.5 * self.times.width * steps

    def over(self, detector: int, raster: Floats) -> Complex:
        """See :class:`._weights.Weights`."""
        width = int(np.sqrt(len(raster))) + 1
        since, f = raster - self._fine.centre, self._fine.frequencies
        heads, steps = since[::width], since[:width] - since[0]

        def turned(place: slice) -> Complex:
            turns = -2j * np.pi * f[place, None]
            both = np.exp(turns * heads)[:, :, None] * np.exp(turns * steps)[:, None, :]
            return np.asarray(both.reshape(len(turns), -1)[:, : len(since)])

        return self._at_times(detector, turned, len(raster))

    def at(self, detector: int, times: Floats) -> Complex:
        """See :class:`._weights.Weights`."""
        turns, f = -2j * np.pi * (times - self._fine.centre), self._fine.frequencies
        return self._at_times(detector, lambda place: np.exp(f[place, None] * turns), len(times))

    def _at_times(self, detector: int, turned: Turned, count: int) -> Complex:
        found = self._of_edges(self._fine.linear[detector, :, : self._shares.shape[1]], turned, count)
        return np.ascontiguousarray((found / self._at_edges[:, :, None]).reshape(-1, count).T)

    def _of_edges(self, weights: Complex, turned: Turned, count: int) -> Complex:
        """What weights ``(R, n)`` of the fine frequencies, ``turned`` in each bin as at so many times, are as weights
        of edges: ``(R, L, count)``."""
        values = np.zeros((self._edges, len(weights), count), dtype=np.complex128)
        bends = np.zeros_like(values)
        for left in range(self._edges - 1):
            place = slice(self._starts[left], self._starts[left + 1])
            if place.start == place.stop:  # bins may be narrower than there is anything to tell
                continue
            shares = self._shares[:, None, place] * weights[:, place]
            there = (shares.reshape(-1, shares.shape[2]) @ turned(place)).reshape(4, len(weights), count)
            values[left : left + 2] += there[:2]
            bends[left : left + 2] += there[2:]
        values.view(np.float64)[:] += np.tensordot(self._curvatures.T, bends.view(np.float64), 1)
        return np.moveaxis(values, 0, 1)
