"""A thinned grid on which sums are those of the full one.

The waveforms of a prior differ by phases whose rate is the difference of the times at which the binaries pass a
frequency, so products of two of them vary slowly although each of them does not. The grid has a few points for every
turn of the fastest of these products, all of them points of the full grid, and each has the weight that makes the sum
over the full grid of a locally polynomial function exact.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._modes import quadrupole_options
from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._interpolant import Alignment, FloatArray, evaluate_term
from bnserve_inference.roq._sampling import Prior
from bnserve_protocol import ParameterBatch, UniformGrid, WaveformModel

_STENCIL = 1e-3
"""Relative half-width of the difference that gives the time at a frequency."""
_POINTS_PER_TURN = 6.0
_POINTS_PER_E_FOLD = 20.0
"""For what varies with the frequency itself, such as the amplitude."""
_MARGIN = 1.2
"""The spread of the times is that of a sample."""
_ORDER = 6
"""Points of the polynomials between two grid points; from 8 on, weights at the ends of a coarse grid are negative."""
_GRAM_TOLERANCE = 1e-7
"""By how much an inner product of two unit waveforms may differ from the full grid's."""
_SAMPLE, _CHECKED = 512, 12
_STAGE = 7
"""Part of the key of the draws made here."""


@dataclass(frozen=True, eq=False)
class FrequencyGrid:
    """Points ``indices`` (M,) of the ``full`` grid, with the ``weights`` (M,) that stand for the sum over all of it.

    ``gram_error`` is the largest difference of inner products of unit waveforms to the full grid's, of a sample.
    """

    full: UniformGrid
    indices: NDArray[np.int64]
    weights: FloatArray
    gram_error: float

    @property
    def frequencies(self) -> FloatArray:
        """The points in Hz, ``(M,)``: the same bits as in the full grid."""
        return self.full.frequencies()[self.indices]

    def __len__(self) -> int:
        return len(self.indices)


def thinned_grid(
    model: WaveformModel, prior: Prior, full: UniformGrid, alignment: Alignment, seed: int
) -> FrequencyGrid:
    """The smallest grid of the family whose inner products are the full grid's to 1e-7.

    Raises
    ------
    ConstructionFailed
        The model's answers are not finite.
    OutOfDomain, OutOfBand
        The prior or the band is outside of the model's.
    """
    sample = ParameterBatch(np.concatenate([prior.draw(_SAMPLE, seed, _STAGE).values, prior.corners().values]))
    density = _density(full, *_time_spread(model, sample, full, alignment))
    checked = evaluate_term(model, full.frequencies(), prior.draw(_CHECKED, seed, _STAGE + 1), "linear", alignment)
    if not (np.isfinite(checked).all() and (np.abs(checked).max(axis=1) > 0.0).all()):
        raise ConstructionFailed("The model gives waveforms that are zero or not finite in this band.")
    checked /= np.linalg.norm(checked, axis=1)[:, None]
    exact = checked.conj() @ checked.T
    points_per_turn = 1.0
    while True:
        indices = _indices(density * points_per_turn)
        if len(indices) > len(full) // 2:
            return FrequencyGrid(full, np.arange(len(full)), np.ones(len(full)), 0.0)
        weights = summation_weights(indices)
        thinned = checked[:, indices]
        error = float(np.abs((thinned.conj() * weights) @ thinned.T - exact).max())
        if weights.min() > 0.0 and error <= _GRAM_TOLERANCE:
            return FrequencyGrid(full, indices, weights, error)
        points_per_turn *= 1.25


def summation_weights(indices: NDArray[np.int64], order: int = _ORDER) -> FloatArray:
    """Weights w with sum_i g(x_i) = sum_j w_j g(x_indices[j]) for functions g on 0 ... indices[-1].

    Exact if g is a polynomial of degree ``order`` - 1 around every interval: the sum over the points of an interval is
    that of the polynomial through the ``order`` nearest points of the grid.

    Parameters
    ----------
    indices
        Increasing, the first of them 0.
    """
    count = len(indices)
    order = min(order, count)
    weights = np.zeros(count)
    for left in range(count - 1):
        last = left == count - 2
        inside = np.arange(indices[left], indices[left + 1] + last, dtype=np.float64)
        start = min(max(left + 1 - order // 2, 0), count - order)
        stencil = indices[start : start + order].astype(np.float64)
        middle, half = 0.5 * (stencil[0] + stencil[-1]), 0.5 * (stencil[-1] - stencil[0])
        powers = np.arange(order)[:, None]
        moments = (((inside - middle) / half) ** powers).sum(axis=1)
        weights[start : start + order] += np.linalg.solve(((stencil - middle) / half) ** powers, moments)
    return weights


def _time_spread(
    model: WaveformModel, binaries: ParameterBatch, full: UniformGrid, alignment: Alignment
) -> tuple[FloatArray, FloatArray]:
    """Frequencies, and how far apart the binaries' times are there, in seconds; both ``(64,)``."""
    centres = np.geomspace(full.f_min * (1.0 + 2.0 * _STENCIL), full.f_max * (1.0 - 2.0 * _STENCIL), 64)
    sides = np.concatenate([centres * (1.0 - _STENCIL), centres * (1.0 + _STENCIL)])
    order = np.argsort(sides)
    options = quadrupole_options(model, alignment=alignment, above_band="error")
    answer = model.predict_amplitude_phase(sides[order], binaries, options=options)
    phase = np.empty_like(answer.phase)
    phase[:, order] = answer.phase
    times = (phase[:, :64] - phase[:, 64:]) / (4.0 * np.pi * _STENCIL * centres)
    if not np.isfinite(times).all():
        raise ConstructionFailed("The model gives phases that are not finite in this band.")
    return centres, np.ptp(times, axis=0)


def _density(full: UniformGrid, centres: FloatArray, spread: FloatArray) -> FloatArray:
    """Points of the thinned grid for every point of the full one, ``(len(full),)``."""
    frequencies = full.frequencies()
    falling = np.maximum.accumulate(spread[::-1])[::-1]
    turns = _MARGIN * np.interp(frequencies, centres, falling)
    return (_POINTS_PER_TURN * turns + _POINTS_PER_E_FOLD / frequencies) * full.delta_f


def _indices(density: FloatArray) -> NDArray[np.int64]:
    """Points such that the density between two of them integrates to at most one, both ends included."""
    done = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    wanted = np.linspace(0.0, done[-1], max(int(np.ceil(done[-1])), 2 * _ORDER) + 1)
    return np.unique(np.rint(np.interp(wanted, done, np.arange(len(done)))).astype(np.int64))
