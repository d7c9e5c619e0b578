"""Linear weights as functions of the time of arrival, for any basis.

With data d and noise S on the grid f_k, and rows B_j of a basis whose nodes are F_j,

    w_j(t) = 4 / T sum_k conj(d_k) / S_k B_j(f_k) exp(-2 pi i (f_k - F_j) t).

Without its node's own oscillation a weight varies more slowly, the more so the more B_j lives around F_j; quintic
B-splines on a grid of times that is as coarse as a tolerance allows interpolate it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._band import Band
from bnserve_inference._splines import MARGIN, b_spline_coefficients, b_spline_midpoints
from bnserve_inference._spreading import Spreading
from bnserve_protocol import AnalysisInvalid, TimeGrid

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

ARRIVAL_MARGIN = 0.0214
"""Seconds that light needs from the centre of the Earth to a detector, a little more."""
LARGEST_TABLE = 512 * 2**20
"""Bytes of weights; a time prior that needs more is too wide for weights that are interpolated over time."""
_FEWEST_INTERVALS = 128
_SPARE = MARGIN // 2 - 3
"""Knots at either end that are not kept."""


@dataclass(frozen=True)
class TimeRange:
    """Where weights are wanted, in seconds from the trigger."""

    start: float
    stop: float

    @property
    def width(self) -> float:
        """Seconds."""
        return self.stop - self.start


class Weights(Protocol):
    """Weights as functions of time, of L nodes (of every order of modes) and D detectors."""

    @property
    def nodes(self) -> Floats:
        """F_j in Hz, ``(L,)``."""

    @property
    def times(self) -> TimeRange:
        """Where they are wanted."""

    @property
    def detectors(self) -> int:
        """D."""

    def raster(self, step: float, margin: int = 0) -> Floats:
        """Uniform times, at most ``step`` seconds apart, over the range and so many steps beyond on either side: an odd
        number, ``(n,)``."""

    def over(self, detector: int, raster: Floats) -> Complex:
        """``w_j(t) exp(-2 pi i F_j t)`` in one detector, at the times of a raster: ``(n, L)``. Strain at the nodes
        times these is <d|h>."""

    def at(self, detector: int, times: Floats) -> Complex:
        """The same at any few times."""


class BasisWeights:
    """The weights of a basis that is given by its rows.

    Parameters
    ----------
    chunks
        The basis: ``(place in the grid, rows (L, m))``.
    nodes
        F_j in Hz, ``(L,)``.
    band
        The data.
    times
        Where the weights are wanted.
    """

    def __init__(self, chunks: Iterable[tuple[slice, Complex]], nodes: Floats, band: Band, times: TimeRange) -> None:
        self.nodes, self.times, self.detectors = nodes, times, len(band.detectors)
        reach = 0.5 * times.width * (1.0 + 2.0 * (MARGIN + 2) / _FEWEST_INTERVALS)
        centre = 0.5 * (times.start + times.stop)
        self._sums = Spreading(band.f_min, band.f_max, centre, reach, (self.detectors, len(nodes)))
        for place, rows in chunks:
            self._sums.add(band.grid(place), rows, band.piece(place)[0])

    def raster(self, step: float, margin: int = 0) -> Floats:
        """See :class:`Weights`."""
        return self._sums.raster(step, 0.5 * self.times.width, margin)

    def over(self, detector: int, raster: Floats) -> Complex:
        """See :class:`Weights`."""
        return self._sums.over(detector, raster)

    def at(self, detector: int, times: Floats) -> Complex:
        """See :class:`Weights`."""
        return self._sums.at(detector, times)


def time_table(weights: Weights, amplitudes: Floats, tolerance: float) -> tuple[TimeGrid, Complex, float]:
    """B-spline coefficients of the weights on the coarsest grid of times that is good enough.

    Parameters
    ----------
    weights
        Of the basis and the data.
    amplitudes
        Size of the strain at the nodes, ``(D, L)``, of a signal whose norm is one in every detector.
    tolerance
        Of the interpolation error of <d|h> for such a signal, as the root of the sum of squares over the nodes.

    Returns
    -------
    The grid, the coefficients ``(D, T, L)``, and the largest error found halfway between samples.

    Raises
    ------
    AnalysisInvalid
        The table would be larger than :data:`LARGEST_TABLE`.
    """
    intervals, error = _FEWEST_INTERVALS, math.inf
    while True:
        _refuse_huge(intervals, amplitudes, weights.times)
        times = weights.raster(weights.times.width / (2 * intervals), MARGIN)
        tables, errors = [], []
        for detector, sizes in enumerate(amplitudes):
            table, error = _interpolated(weights, detector, times, sizes)
            tables.append(table)
            errors.append(error)
            if error > 2.0 * tolerance:
                break
        error = max(errors)
        if error <= tolerance:
            return TimeGrid(start=float(times[2 * _SPARE]), step=float(times[2] - times[0])), np.stack(tables), error
        finer = intervals * (error / tolerance) ** (1.0 / 6.0) * 1.02
        intervals = max(intervals + 8, min(int(finer) + 1, 3 * intervals))


def _interpolated(weights: Weights, detector: int, times: Floats, sizes: Floats) -> tuple[Complex, float]:
    """The spline through every other one of the times, and its error for strain of some sizes at the nodes."""
    fine = weights.over(detector, times)
    fine *= np.exp(2j * np.pi * weights.nodes * times[:, None])
    knots, between = fine[::2], fine[1::2]  # both ends are knots
    coefficients = b_spline_coefficients(knots)
    errors = np.abs(b_spline_midpoints(coefficients)[_SPARE:-_SPARE] - between[2 + _SPARE : -2 - _SPARE]) * sizes
    return coefficients[_SPARE:-_SPARE], float(np.sqrt((errors**2).sum(axis=1)).max())


def _refuse_huge(intervals: int, amplitudes: Floats, times: TimeRange) -> None:
    if intervals * amplitudes.size * 16 > LARGEST_TABLE:
        raise AnalysisInvalid(
            f"Weights for arrivals over {times.width:.3g} s would need more than {LARGEST_TABLE // 2**20} MiB: "
            "narrow the prior of 'coalescence_time'."
        )


def quadratic_weights(chunks: Iterable[tuple[slice, Floats]], band: Band) -> Floats:
    """q_m = sum_k 4 / (T S_k) B_m(f_k), float64 ``(D, Q)``."""
    return np.sum([band.piece(place)[1] @ np.ascontiguousarray(rows.real).T for place, rows in chunks], axis=0)
