"""Linear weights as functions of the time of arrival, for any basis.

With data d and noise S on the grid f_k, and rows B_j of a basis whose nodes are F_j,

    w_j(t) = 4 / T sum_k conj(d_k) / S_k B_j(f_k) exp(-2 pi i (f_k - F_j) t).

Without its node's own oscillation a weight varies slowly, because B_j lives around F_j: a coarse grid of times and cubic
B-splines are enough. The sum is taken once over pieces of frequency, as Chebyshev moments within each piece, after which
any time costs little.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._splines import MARGIN, b_spline_coefficients, b_spline_midpoints
from bnserve_protocol import AnalysisInvalid, TimeGrid

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

ARRIVAL_MARGIN = 0.0214
"""Seconds that light needs from the centre of the Earth to a detector, a little more."""
LARGEST_TABLE = 512 * 2**20
"""Bytes of weights; a time prior that needs more is too wide for weights that are interpolated over time."""
_WIDEST_TURN = 4.0
"""Radians by which a piece's ends turn against its middle over half the range of times."""
_FIRST_INTERVALS = 24


@dataclass(frozen=True)
class TimeRange:
    """Where weights are wanted, in seconds from the trigger."""

    start: float
    stop: float

    @property
    def centre(self) -> float:
        """Its middle."""
        return 0.5 * (self.start + self.stop)

    @property
    def reach(self) -> float:
        """Farthest time from the centre at which the moments must hold, with room for the spline's ends."""
        half = 0.5 * (self.stop - self.start)
        return half * (1.0 + 2.0 * (MARGIN + 2) / _FIRST_INTERVALS)


class Moments:
    """Chebyshev moments of ``rows times data``, piece by piece of frequency, for every detector.

    Parameters
    ----------
    nodes:
        F_j in Hz, ``(L,)``.
    times:
        Range in which :meth:`weights` may be asked for.
    delta_f:
        Step of the grid in Hz.
    """

    def __init__(self, nodes: Floats, times: TimeRange, delta_f: float) -> None:
        self.nodes, self.times, self._delta_f = nodes, times, delta_f
        self.width = max(16, int(2.0 * _WIDEST_TURN / (2.0 * np.pi * delta_f * times.reach)))
        turn = np.pi * delta_f * self.width * times.reach
        self._terms = int(turn + 8.0 * turn ** (1.0 / 3.0) + 12.0)
        self._centres: list[float] = []
        self._pieces: list[Complex] = []

    def add(self, frequencies: Floats, rows: Complex, data: Complex) -> None:
        """Add consecutive frequencies ``(m,)`` with rows ``(L, m)`` and ``4 / T conj(d) / S`` of D detectors ``(D, m)``."""
        for start in range(0, len(frequencies), self.width):
            place = slice(start, start + self.width)
            f = frequencies[place]
            centre = 0.5 * (f[0] + f[-1])
            half = 0.5 * self._delta_f * self.width
            chebyshev = np.polynomial.chebyshev.chebvander((f - centre) / half, self._terms - 1)
            turned = data[:, place] * np.exp(-2j * np.pi * f * self.times.centre)
            self._centres.append(float(centre))
            self._pieces.append(np.stack([rows[:, place] @ (row[:, None] * chebyshev) for row in turned]))

    def weights(self, times: Floats) -> Complex:
        """w_j(t), complex ``(D, T, L)``, at ``times`` in seconds from the trigger."""
        offsets = times - self.times.centre
        half = 0.5 * self._delta_f * self.width
        series = _turning_series(2.0 * np.pi * half * offsets, self._terms)
        total = np.zeros((len(self._pieces[0]), len(times), len(self.nodes)), dtype=np.complex128)
        for centre, piece in zip(self._centres, self._pieces, strict=True):
            total += np.exp(-2j * np.pi * centre * offsets)[:, None] * (series @ piece.transpose(0, 2, 1))
        return total * np.exp(2j * np.pi * self.nodes * times[:, None])


def _turning_series(turns: Floats, terms: int) -> Complex:
    """Chebyshev coefficients in x of exp(-i turn x) on [-1, 1], complex ``(len(turns), terms)``."""
    samples = terms + 16
    angles = np.pi * (np.arange(samples) + 0.5) / samples
    values = np.exp(-1j * turns[:, None] * np.cos(angles))
    coefficients = (2.0 / samples) * values @ np.cos(angles[:, None] * np.arange(terms))
    coefficients[:, 0] *= 0.5
    return coefficients


def time_table(moments: Moments, amplitudes: Floats, tolerance: float) -> tuple[TimeGrid, Complex, float]:
    """B-spline coefficients of the weights on the coarsest grid of times that is good enough.

    Parameters
    ----------
    moments:
        Of the basis and the data.
    amplitudes:
        Size of the strain at the nodes, ``(D, L)``, of a signal whose norm is one in every detector.
    tolerance:
        Of the interpolation error of <d|h> for such a signal, as the root of the sum of squares over the nodes.

    Returns
    -------
    The grid, the coefficients ``(D, T, L)``, and the largest error found halfway between samples.

    Raises
    ------
    AnalysisInvalid
        The table would be larger than :data:`LARGEST_TABLE`.
    """
    times = moments.times
    intervals = _FIRST_INTERVALS
    while True:
        step = (times.stop - times.start) / intervals
        _refuse_huge(intervals, amplitudes, times)
        knots = times.start + step * np.arange(-MARGIN, intervals + 1 + MARGIN)
        samples = moments.weights(knots).transpose(1, 0, 2)
        coefficients = b_spline_coefficients(samples)
        middles = times.start + step * (np.arange(intervals) + 0.5)
        truth = moments.weights(middles).transpose(1, 0, 2)
        errors = np.abs(b_spline_midpoints(coefficients) - truth) * amplitudes
        error = float(np.sqrt((errors**2).sum(axis=2)).max())
        if error <= tolerance:
            table = np.ascontiguousarray(coefficients.transpose(1, 0, 2))
            return TimeGrid(start=times.start - step, step=step), table, error
        finer = intervals * (error / tolerance) ** 0.25 * 1.05
        intervals = max(intervals + 8, min(int(finer) + 1, 4 * intervals))


def _refuse_huge(intervals: int, amplitudes: Floats, times: TimeRange) -> None:
    if intervals * amplitudes.size * 16 > LARGEST_TABLE:
        raise AnalysisInvalid(
            f"Weights for coalescence times over {times.stop - times.start:.3g} s would need more than "
            f"{LARGEST_TABLE // 2**20} MiB; narrow the prior of 'coalescence_time'."
        )


def linear_moments(
    chunks: Iterable[tuple[slice, Complex]],
    nodes: Floats,
    frequencies: Floats,
    data: Sequence[Complex],
    times: TimeRange,
) -> Moments:
    """Moments of a basis that comes in chunks ``(place in the grid, (L, m))``; ``data`` is ``4 / T conj(d) / S``."""
    moments = Moments(nodes, times, float(frequencies[1] - frequencies[0]))
    stacked = np.array(data)
    for place, rows in chunks:
        moments.add(frequencies[place], rows, stacked[:, place])
    return moments


def quadratic_weights(chunks: Iterable[tuple[slice, Floats]], densities: Sequence[Floats]) -> Floats:
    """q_m = sum_k 4 / (T S_k) B_m(f_k), float64 ``(D, Q)``; ``densities`` is ``4 / (T S)`` of every detector."""
    stacked = np.array(densities)
    return np.sum([stacked[:, place] @ np.ascontiguousarray(rows.real).T for place, rows in chunks], axis=0)
