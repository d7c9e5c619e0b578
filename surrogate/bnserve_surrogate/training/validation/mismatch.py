r"""The mismatch between waveforms that differ by known residuals, maximised over time and phase, without cancellation.

For :math:`h_b = h_a \exp(\Delta A + i \Delta\psi)` and weights :math:`w_j \propto |h_a|^2 / S_n` that sum to one, the
match is

.. math:: \mathcal F = \max_{t, \phi} \frac{\sum w e^{\Delta A} \cos\delta}{\sqrt{\sum w e^{2\Delta A}}},
          \qquad \delta = \Delta\psi - \phi - 2\pi f t .

It factorises into :math:`C = \langle e^{\Delta A}\rangle / \langle e^{2\Delta A}\rangle^{1/2}` and
:math:`R = \langle\cos\delta\rangle_p` with :math:`p \propto w e^{\Delta A}`. Both 1 - C (from a variance) and
:math:`1 - R = 2\langle\sin^2(\delta/2)\rangle_p` are sums of squares, so 1 - CR = (1 - C) + C (1 - R) keeps its
relative accuracy however small it is.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_surrogate.training.reduction.metric import spline_matrix
from bnserve_surrogate.training.validation._alignment import refine, search

FloatArray: TypeAlias = NDArray[np.float64]

SEARCH_ABOVE = 0.01
"""A local maximum of the match above 1 - 0.01 is the global one.

Were there a better one at another time, the waveform shifted by that time would match itself to cos(2 acos 0.99) =
0.96: no broad-band signal does, outside the peak we are on. Below, every time shift that the residuals suggest is
tried.
"""
_ELEMENTS = 2_000_000
"""Numbers per temporary array: rows are taken in pieces, so that memory does not grow with their number."""


class Mismatch(NamedTuple):
    """Mismatch (N,), and what achieves it: ``phase + 2 pi f time`` is the best line through the phase difference.

    Shapes (N,). ``time`` is in the inverse unit of the frequencies, ``phase`` in radians, at f = 0.
    """

    mismatch: FloatArray
    time: FloatArray
    phase: FloatArray


def mismatch(
    frequencies: ArrayLike, weights: ArrayLike, log_amplitude_difference: ArrayLike, phase_difference: ArrayLike
) -> Mismatch:
    """One minus the match, maximised over time and phase, of N pairs of waveforms.

    Parameters
    ----------
    frequencies
        Shape (J,), increasing. Dense enough for ``phase_difference`` to change by less than pi between neighbours.
    weights
        |h|^2 / S_n times quadrature weights, of the waveforms that the differences are measured from; not negative,
        shape (J,) or (N, J). The norm does not matter. See
        :func:`~bnserve_surrogate.training.data.noise.noise_weights`.
    log_amplitude_difference, phase_difference
        log(A_b / A_a) and psi_b - psi_a in radians, shape (N, J). The sign of the phase does not matter.

    Raises
    ------
    ValueError
        On wrong shapes, numbers that are not finite, or negative or vanishing weights.
    """
    grid, dense_weights, log_amplitude, phase = _checked(
        frequencies, weights, log_amplitude_difference, phase_difference
    )
    rows = max(1, _ELEMENTS // len(grid))
    pieces = [_empty()]
    for start in range(0, len(phase), rows):
        piece = slice(start, start + rows)
        row_weights = dense_weights if dense_weights.ndim == 1 else dense_weights[piece]
        pieces.append(_mismatch_rows(grid, row_weights, log_amplitude[piece], phase[piece]))
    return Mismatch(*(np.concatenate(column) for column in zip(*pieces, strict=True)))


class NodeMismatch:
    """:func:`mismatch` of residual differences that are given at nodes: they are splined to a dense grid first.

    Parameters
    ----------
    amplitude_nodes, phase_nodes
        Shapes (n_A,) and (n_phi,), increasing.
    frequencies
        The dense grid, shape (J,), inside both.
    weights
        Shape (J,), or (N, J) with one row for every waveform that will be compared.
    """

    def __init__(
        self, amplitude_nodes: ArrayLike, phase_nodes: ArrayLike, frequencies: ArrayLike, weights: ArrayLike
    ) -> None:
        self.frequencies = np.asarray(frequencies, dtype=np.float64)
        self.weights = np.asarray(weights, dtype=np.float64)
        self._amplitude_spline = np.ascontiguousarray(spline_matrix(amplitude_nodes, self.frequencies).T)
        self._phase_spline = np.ascontiguousarray(spline_matrix(phase_nodes, self.frequencies).T)

    def __call__(self, log_amplitude_difference: ArrayLike, phase_difference: ArrayLike) -> Mismatch:
        """Mismatch of N differences at the nodes, shapes (N, n_A) and (N, n_phi)."""
        log_amplitude = np.asarray(log_amplitude_difference, dtype=np.float64)
        phase = np.asarray(phase_difference, dtype=np.float64)
        if len(log_amplitude) != len(phase):
            raise ValueError(f"Got {len(log_amplitude)} amplitude differences and {len(phase)} phase differences.")
        _require_finite(log_amplitude, phase)
        rows = max(1, _ELEMENTS // len(self.frequencies))
        pieces = [_empty()]
        for start in range(0, len(phase), rows):
            piece = slice(start, start + rows)
            weights = self.weights if self.weights.ndim == 1 else self.weights[piece]
            dense = log_amplitude[piece] @ self._amplitude_spline, phase[piece] @ self._phase_spline
            pieces.append(mismatch(self.frequencies, weights, *dense))
        return Mismatch(*(np.concatenate(column) for column in zip(*pieces, strict=True)))


def _empty() -> Mismatch:
    return Mismatch(np.empty(0), np.empty(0), np.empty(0))


def _mismatch_rows(
    frequencies: FloatArray, weights: FloatArray, log_amplitude: FloatArray, phase: FloatArray
) -> Mismatch:
    amplitude_loss, density = _amplitude_loss(weights, log_amplitude)
    phase_loss, slope, constant = refine(frequencies, density, phase)
    poor = np.flatnonzero(phase_loss > SEARCH_ABOVE)
    if len(poor):
        better = search(frequencies, density[poor], phase[poor], slope[poor])
        won = better[0] < phase_loss[poor]
        for ours, theirs in zip((phase_loss, slope, constant), better, strict=True):
            ours[poor[won]] = theirs[won]
    return Mismatch(amplitude_loss + (1.0 - amplitude_loss) * phase_loss, slope / (2.0 * np.pi), constant)


def _amplitude_loss(weights: FloatArray, log_amplitude: FloatArray) -> tuple[FloatArray, FloatArray]:
    """1 - C, shape (N,), and the probabilities p of the phase average, shape (N, J).

    With y = exp(dA - <dA>) - 1: C = (1 + <y>) / sqrt((1 + <y>)^2 + Var y) = (1 + s)^(-1/2), s = Var y / (1 + <y>)^2.
    """
    probability = weights / weights.sum(axis=-1, keepdims=True)
    centre = np.sum(probability * log_amplitude, axis=1, keepdims=True)
    excess = np.expm1(log_amplitude - centre)
    mean = np.sum(probability * excess, axis=1, keepdims=True)
    variance = np.sum(probability * (excess - mean) ** 2, axis=1)
    loss = -np.expm1(-0.5 * np.log1p(variance / (1.0 + mean[:, 0]) ** 2))
    density = probability * (1.0 + excess)
    return loss, density / density.sum(axis=1, keepdims=True)


def _checked(
    frequencies: ArrayLike, weights: ArrayLike, log_amplitude: ArrayLike, phase: ArrayLike
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    grid, scale, amplitude, angle = (
        np.asarray(array, dtype=np.float64) for array in (frequencies, weights, log_amplitude, phase)
    )
    if grid.ndim != 1 or angle.ndim != 2 or angle.shape[1] != len(grid) or amplitude.shape != angle.shape:
        raise ValueError(
            "Differences must have shape (N, J) for J frequencies; "
            f"got {amplitude.shape} and {angle.shape} for frequencies of shape {grid.shape}."
        )
    if scale.shape not in (grid.shape, angle.shape):
        raise ValueError(f"Weights must have shape {grid.shape} or {angle.shape}; got {scale.shape}.")
    _require_finite(grid, scale, amplitude, angle)
    if (scale < 0.0).any() or not (scale.sum(axis=-1) > 0.0).all():
        raise ValueError("Weights must not be negative and must not all vanish.")
    return grid, scale, amplitude, angle


def _require_finite(*arrays: FloatArray) -> None:
    if not all(np.isfinite(array).all() for array in arrays):
        raise ValueError("Frequencies, weights and differences must be finite; screen failed waveforms first.")
