r"""Minimise :math:`1 - R = 2\langle\sin^2(\delta/2)\rangle_p` over the line taken off a phase, locally or globally."""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

FloatArray: TypeAlias = NDArray[np.float64]
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
