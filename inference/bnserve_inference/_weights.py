"""Linear weights as functions of the time of arrival, for any basis.

With data d and noise S on the grid f_k, and rows B_j of a basis whose nodes are F_j,

    w_j(t) = 4 / T sum_k conj(d_k) / S_k B_j(f_k) exp(-2 pi i (f_k - F_j) t).

Without its node's own oscillation a weight varies more slowly, the more so the more B_j lives around F_j; quintic
B-splines on a grid of times that is as coarse as a tolerance allows interpolate it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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


class Weights:
    """The weights of a basis as functions of time, for every detector.

    Parameters
    ----------
    chunks
        The basis: ``(place in the grid, rows (L, m))``.
    nodes
        F_j in Hz, ``(L,)``.
    frequencies
        The grid f_k in Hz, ``(M,)``.
    data
        ``4 / T conj(d) / S`` of D detectors, complex ``(M,)`` each.
    times
        Where the weights are wanted.
    """

    def __init__(
        self,
        chunks: Iterable[tuple[slice, Complex]],
        nodes: Floats,
        frequencies: Floats,
        data: Sequence[Complex],
        times: TimeRange,
    ) -> None:
        self.nodes, self.times = nodes, times
        stacked = np.array(data)
        reach = 0.5 * times.width * (1.0 + 2.0 * (MARGIN + 2) / _FEWEST_INTERVALS)
        centre = 0.5 * (times.start + times.stop)
        ends = float(frequencies[0]), float(frequencies[-1])
        self._sums = Spreading(*ends, centre, reach, (len(stacked), len(nodes)))
        for place, rows in chunks:
            self._sums.add(frequencies[place], rows, stacked[:, place])

    def fewest(self) -> int:
        """Fewest intervals that :meth:`sampled` can divide the range into."""
        return max(_FEWEST_INTERVALS, int(np.ceil(self._sums.points * self.times.width / self._sums.period)))

    def sampled(self, intervals: int) -> tuple[float, float, Complex]:
        """Samples at most ``width / intervals`` apart over the range and :data:`MARGIN` beyond on either side.

        Returns
        -------
        The first time, the step, and the weights ``(D, n, L)``.
        """
        per_period = int(np.ceil(intervals * self._sums.period / self.times.width))
        step = self._sums.period / per_period
        half = int(np.ceil(0.5 * self.times.width / step)) + MARGIN
        times, sums = self._sums.transform(per_period, -half, 2 * half + 1)
        return float(times[0]), step, sums * np.exp(2j * np.pi * self.nodes * times[:, None])

    def products(self, step: float) -> tuple[Floats, Complex]:
        """What turns strain at the nodes into <d|h>, at times at most ``step`` seconds apart over the range.

        Returns
        -------
        The times ``(n,)`` and the sums ``w_j(t) exp(-2 pi i F_j t)``, ``(D, n, L)``.
        """
        per_period = max(self._sums.points, int(np.ceil(self._sums.period / step)))
        half = int(np.ceil(0.5 * self.times.width * per_period / self._sums.period))
        return self._sums.transform(per_period, -half, 2 * half + 1)


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
    intervals = weights.fewest()
    while True:
        _refuse_huge(intervals, amplitudes, weights.times)
        start, step, fine = weights.sampled(2 * intervals)
        knots, between = fine[:, ::2], fine[:, 1::2]  # both ends are knots
        coefficients = b_spline_coefficients(knots)
        errors = np.abs(b_spline_midpoints(coefficients) - between[:, 2:-2]) * amplitudes[:, None, :]
        error = float(np.sqrt((errors[:, _SPARE:-_SPARE] ** 2).sum(axis=2)).max())
        if error <= tolerance:
            table = np.ascontiguousarray(coefficients[:, _SPARE:-_SPARE])
            return TimeGrid(start=start + 2.0 * step * _SPARE, step=2.0 * step), table, error
        finer = intervals * (error / tolerance) ** (1.0 / 6.0) * 1.02
        intervals = max(intervals + 8, min(int(finer) + 1, 3 * intervals))


def _refuse_huge(intervals: int, amplitudes: Floats, times: TimeRange) -> None:
    if intervals * amplitudes.size * 16 > LARGEST_TABLE:
        raise AnalysisInvalid(
            f"Weights for arrivals over {times.width:.3g} s would need more than {LARGEST_TABLE // 2**20} MiB: "
            "narrow the prior of 'coalescence_time'."
        )


def quadratic_weights(chunks: Iterable[tuple[slice, Floats]], densities: Sequence[Floats]) -> Floats:
    """q_m = sum_k 4 / (T S_k) B_m(f_k), float64 ``(D, Q)``; ``densities`` is ``4 / (T S)`` of every detector."""
    stacked = np.array(densities)
    return np.sum([stacked[:, place] @ np.ascontiguousarray(rows.real).T for place, rows in chunks], axis=0)
