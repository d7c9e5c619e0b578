r"""The mismatch between waveforms that differ by known residuals, maximised over time and phase, without cancellation.

For :math:`h_b = h_a \exp(\Delta A + i \Delta\psi)` and weights :math:`w_j \propto |h_a|^2 / S_n` that sum to one, the
match is

.. math:: \mathcal F = \max_{t, \phi} \frac{\sum w e^{\Delta A} \cos\delta}{\sqrt{\sum w e^{2\Delta A}}},
          \qquad \delta = \Delta\psi - \phi - 2\pi f t .

It factorises into :math:`C = \langle e^{\Delta A}\rangle / \langle e^{2\Delta A}\rangle^{1/2}` and
:math:`R = \langle\cos\delta\rangle_p` with :math:`p \propto w e^{\Delta A}`. Both 1 - C (from a variance) and
:math:`1 - R = 2\langle\sin^2(\delta/2)\rangle_p` are sums of squares, so 1 - CR = (1 - C) + C (1 - R) keeps its
relative accuracy however small it is.

1 - R is minimised over the line taken off the phase: locally, and globally where that leaves more than a little.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_surrogate.training.reduction.metric import spline_matrix

FloatArray: TypeAlias = NDArray[np.float64]

SEARCH_ABOVE = 0.01
"""A local maximum of the match above 1 - 0.01 is the global one.

Were there a better one at another time, the waveform shifted by that time would match itself to cos(2 acos 0.99) =
0.96: no broad-band signal does, outside the peak we are on. Below, every time shift that the residuals suggest is
tried.
"""
_ELEMENTS = 2_000_000
"""Numbers per temporary array: rows are taken in pieces, so that memory does not grow with their number."""
Aligned: TypeAlias = tuple[FloatArray, FloatArray, FloatArray]
"""1 - R, slope in radians per unit of frequency, constant in radians at f = 0: each of shape (N,)."""
MAX_STEPS = 60
"""Newton steps per local search; three are typical, tens only where the search starts on the flank of a low peak."""
PEAKS = 4
"""Highest peaks of the coarse scan that are climbed."""
_STEP = 0.1
"""Step of the coarse scan, in units of 1 / (spread of the frequencies): peaks of R are about one unit wide."""
_LEAST_CURVATURE = 1e-6
"""Keeps Newton steps finite where a curvature changes sign; a step that is too long is not accepted anyway."""
_MAX_SCAN = 65_536
"""Longest scan; residuals that would need more are noise, for which any answer is as good."""


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
    amplitude_loss, density = _amplitude_loss(dense_weights, log_amplitude)
    phase_loss, slope, constant = refine(grid, density, phase)
    poor = np.flatnonzero(phase_loss > SEARCH_ABOVE)
    if len(poor):
        better = search(grid, density[poor], phase[poor], slope[poor])
        won = better[0] < phase_loss[poor]
        for ours, theirs in zip((phase_loss, slope, constant), better, strict=True):
            ours[poor[won]] = theirs[won]
    return Mismatch(amplitude_loss + (1.0 - amplitude_loss) * phase_loss, slope / (2.0 * np.pi), constant)


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
        pieces = [Mismatch(np.empty(0), np.empty(0), np.empty(0))]
        for start in range(0, len(phase), rows):
            piece = slice(start, start + rows)
            weights = self.weights if self.weights.ndim == 1 else self.weights[piece]
            dense = log_amplitude[piece] @ self._amplitude_spline, phase[piece] @ self._phase_spline
            pieces.append(mismatch(self.frequencies, weights, *dense))
        return Mismatch(*(np.concatenate(column) for column in zip(*pieces, strict=True)))


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


class _Frame:
    """Frequencies in units in which their mean is 0 and their variance 1, per row: constant and slope decouple."""

    def __init__(self, frequencies: FloatArray, density: FloatArray) -> None:
        self.density = density
        self.mean = density @ frequencies
        centred = frequencies - self.mean[:, None]
        self.spread = np.sqrt(np.sum(density * centred**2, axis=1))
        # All weight on one frequency: any slope will do, so none is sought.
        self.spread = np.where(self.spread > 0.0, self.spread, np.inf)
        self.variable = centred / self.spread[:, None]

    def line(self, constant: FloatArray, slope: FloatArray) -> FloatArray:
        return constant[:, None] + slope[:, None] * self.variable

    def average(self, values: FloatArray) -> FloatArray:
        return np.einsum("nj,nj->n", self.density, values)

    def loss(self, phase: FloatArray) -> FloatArray:
        return 2.0 * self.average(np.sin(0.5 * phase) ** 2)

    def rows(self, chosen: NDArray[np.intp]) -> "_Frame":
        part = object.__new__(_Frame)
        part.density, part.mean, part.spread, part.variable = (
            array[chosen] for array in (self.density, self.mean, self.spread, self.variable)
        )
        return part


def refine(frequencies: FloatArray, density: FloatArray, phase: FloatArray) -> Aligned:
    """The nearest minimum from a linear least-squares start; shapes (J,), (N, J) and (N, J)."""
    frame = _Frame(frequencies, density)
    constant = frame.average(phase)
    slope = frame.average((phase - constant[:, None]) * frame.variable)
    return _descend(frame, phase, constant, slope)


def search(frequencies: FloatArray, density: FloatArray, phase: FloatArray, slope: FloatArray) -> Aligned:
    """The best of the minima below the highest peaks of a scan over slopes, which is centred on ``slope`` (N,)."""
    columns = [
        _search_row(frequencies, density[row : row + 1], phase[row : row + 1] - slope[row] * frequencies)
        for row in range(len(phase))
    ]
    loss, offset, constant = (np.concatenate(column) for column in zip(*columns, strict=True))
    return loss, slope + offset, constant


def _search_row(frequencies: FloatArray, density: FloatArray, phase: FloatArray) -> Aligned:
    slopes = _scan_slopes(frequencies, density[0], phase[0])
    overlap = _scan(frequencies, density[0], phase[0], slopes)
    height = np.abs(overlap)
    padded = np.concatenate([[-1.0], height, [-1.0]])
    peaks = np.flatnonzero((height >= padded[:-2]) & (height >= padded[2:]))
    peaks = peaks[np.argsort(height[peaks])[::-1][:PEAKS]]
    frame = _Frame(frequencies, density).rows(np.zeros(len(peaks), dtype=np.intp))
    starts = np.angle(overlap[peaks]), slopes[peaks] * frame.spread
    loss, slope, constant = _descend(frame, np.repeat(phase, len(peaks), axis=0), *starts)
    best = [int(np.argmin(loss))]
    return loss[best], slope[best], constant[best]


def _scan_slopes(frequencies: FloatArray, density: FloatArray, phase: FloatArray) -> FloatArray:
    """Slopes to try: R is large only if the line is tangent to the phase where there is weight (stationary phase)."""
    mean = density @ frequencies
    spread = np.sqrt(density @ (frequencies - mean) ** 2)
    cumulative = np.cumsum(density)
    inside = np.flatnonzero((cumulative > 1e-3) & (cumulative < 1.0 - 1e-3))
    first, last = max(inside[0] - 1, 0), inside[-1] + 1
    local = np.diff(phase[first : last + 1]) / np.diff(frequencies[first : last + 1])
    margin = 4.0 / spread
    low, high = local.min() - margin, local.max() + margin
    points = min(int(np.ceil((high - low) * spread / _STEP)) + 1, _MAX_SCAN)
    return np.linspace(low, high, points)


def _scan(
    frequencies: FloatArray, density: FloatArray, phase: FloatArray, slopes: FloatArray
) -> NDArray[np.complex128]:
    r""":math:`\langle e^{i (\phi - s (f - \bar f))} \rangle` for equally spaced slopes s, by products of unit vectors.

    s = s_a + s_b with some sqrt(T) values each: 2 sqrt(T) J exponentials and a matrix product, not T J exponentials.
    """
    coarse = int(np.ceil(np.sqrt(len(slopes))))
    step = slopes[1] - slopes[0]
    centred = frequencies - density @ frequencies
    starts = slopes[0] + coarse * step * np.arange(-(-len(slopes) // coarse))
    left = density * np.exp(1j * (phase - np.multiply.outer(starts, centred)))
    right = np.exp(-1j * np.multiply.outer(centred, step * np.arange(coarse)))
    return np.asarray((left @ right).ravel()[: len(slopes)])


def _descend(frame: _Frame, phase: FloatArray, constant: FloatArray, slope: FloatArray) -> Aligned:
    """Newton steps, away from saddles and maxima, where they lower the loss; else unit gradient steps.

    In the normalised frame the Hessian never exceeds the identity, so a unit gradient step cannot raise the loss.
    """
    residual = phase - frame.line(constant, slope)
    loss = frame.loss(residual)
    active = np.arange(len(phase))
    for _ in range(MAX_STEPS):
        part = frame.rows(active)
        gradient, newton = _steps(part, residual[active])
        open_ = np.sum(gradient**2, axis=0) > 1e-20 * loss[active] + 1e-300
        active, gradient, newton, part = (
            active[open_],
            gradient[:, open_],
            newton[:, open_],
            part.rows(np.flatnonzero(open_)),
        )
        if not len(active):
            break
        step, moved = newton, residual[active] - part.line(*newton)
        lower = part.loss(moved)
        failed = np.flatnonzero(~(lower <= loss[active]))
        if len(failed):
            step[:, failed] = gradient[:, failed]
            moved[failed] = residual[active[failed]] - part.rows(failed).line(*gradient[:, failed])
            lower[failed] = part.loss(moved)[failed]
        gained = lower < loss[active]
        kept = active[gained]
        constant[kept] += step[0, gained]
        slope[kept] += step[1, gained]
        residual[kept], loss[kept] = moved[gained], lower[gained]
        active = kept
    per_frequency = slope / frame.spread
    return loss, per_frequency, constant - per_frequency * frame.mean


def _steps(frame: _Frame, residual: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Descent steps (constant, slope), (2, N) each: the gradient's, and Newton's with the moduli of the curvatures."""
    sine, cosine = np.sin(residual), np.cos(residual)
    gradient = np.stack([frame.average(sine), frame.average(frame.variable * sine)])
    mixed = frame.average(frame.variable * cosine)
    hessian = np.array([[frame.average(cosine), mixed], [mixed, frame.average(frame.variable**2 * cosine)]])
    curvatures, directions = np.linalg.eigh(np.moveaxis(hessian, -1, 0))
    along = np.einsum("nij,in->nj", directions, gradient) / np.maximum(np.abs(curvatures), _LEAST_CURVATURE)
    return gradient, np.einsum("nij,nj->in", directions, along)
