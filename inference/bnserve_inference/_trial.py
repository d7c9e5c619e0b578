"""What a basis makes of the likelihood: everywhere, as a search needs it, and beside what a judge says.

The place in the sky, the orientation and the distance are not varied: in every detector by itself, a waveform arrives
when, as large and with the phase that it fits best. With <d|h> = z and <h|h> = n of a waveform of any size, ln L is
abs(z)^2 / 2 n there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Nodes
from bnserve_inference._calibration import calibration_factors
from bnserve_inference._comparison import Comparison
from bnserve_inference._fine_bins import Judge
from bnserve_inference._weights import Weights
from bnserve_protocol import Calibration, EvaluationOptions, ParameterBatch, WaveformModel

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_STEP = 5e-4
"""Seconds between times of arrival; the maximum is where a parabola through the logarithms of three squares has its."""
_MOST_BYTES = 2**27
"""Of the products at all times; with more, the times are further apart."""
_ROWS = 64


@dataclass(frozen=True, eq=False)
class CalibrationErrors:
    """Errors of K binaries in D detectors at the nodes, ``(K, D, nodes)`` each."""

    calibration: Calibration
    amplitude: Floats
    phase: Floats

    @classmethod
    def draw(cls, calibration: Calibration, rows: int, detectors: int, seed: int) -> CalibrationErrors:
        """Normal, as wide as the calibration says."""
        amplitude, phase = np.random.default_rng(seed).standard_normal((2, rows, detectors, calibration.nodes))
        return cls(calibration, calibration.amplitude_width * amplitude, calibration.phase_width * phase)

    def of(self, rows: NDArray[np.int64]) -> CalibrationErrors:
        """Those of some of the binaries."""
        return replace(self, amplitude=self.amplitude[rows], phase=self.phase[rows])

    def factors(self, frequencies: Floats) -> Complex:
        """``(K, D, 1, M)``."""
        found = calibration_factors(self.calibration, self.amplitude, self.phase, frequencies)
        return np.asarray(found[:, :, None])


class Arrivals:
    """When signals of one group of modes fit best, in each detector by itself.

    Parameters
    ----------
    weights
        Of the basis.
    rows
        Which of their nodes are those of the group.
    """

    def __init__(self, weights: Weights, rows: slice) -> None:
        count = len(weights.nodes[rows])
        whole = 8 * weights.detectors * count * weights.times.width / _STEP
        self.times = weights.raster(_STEP * max(1.0, whole / _MOST_BYTES))
        self._tables = [
            weights.over(detector, self.times)[:, rows].astype(np.complex64) for detector in range(weights.detectors)
        ]

    def best(self, detector: int, strain: NDArray[np.complex64]) -> tuple[Floats, Floats]:
        """Of strain at the nodes, ``(N, L)``: the largest abs(<d|h>)^2, and the time, ``(N,)`` each."""
        products = strain @ self._tables[detector].T
        squares = np.square(products.real) + np.square(products.imag)
        rows, last = np.arange(len(strain)), len(self.times) - 1
        places = np.argmax(squares, axis=1)
        tops = squares[rows, places]
        inner = (places > 0) & (places < last) & (tops > 0.0)
        around = [np.where(inner, squares[rows, np.clip(places + side, 0, last)], 1.0) for side in (-1, 1)]
        before, after = (np.log(np.maximum(side, 1e-30) / np.where(inner, tops, 1.0)).astype(float) for side in around)
        bend = np.where(inner, np.minimum(before + after, -1e-30), -1.0)
        shift = np.where(inner, np.clip(0.5 * (after - before) / -bend, -0.5, 0.5), 0.0)
        rise = np.where(inner, -0.125 * (after - before) ** 2 / bend, 0.0)
        return tops * np.exp(np.minimum(rise, 0.5)), self.times[places] + shift * (self.times[1] - self.times[0])


class Trial:
    """The likelihood of one mode with a basis.

    Parameters
    ----------
    model
        Makes waveforms.
    options
        Ask the model for the mode; binaries that it does not cover are flagged.
    basis, weights, quadratic
        The basis with its sums over the data, and over the noise, ``(D, Q)``.
    """

    def __init__(
        self, model: WaveformModel, options: EvaluationOptions, basis: Nodes, weights: Weights, quadratic: Floats
    ) -> None:
        self._model, self._options = model, options
        self._linear_nodes, self._quadratic_nodes = basis.linear_nodes, basis.quadratic_nodes
        self._weights, self._quadratic = weights, quadratic
        self._arrivals = Arrivals(weights, slice(None))

    def values(self, batch: ParameterBatch) -> Floats:
        """ln L where it is largest, ``(N,)``; -inf for what the model does not cover."""
        strain, power, missing = self._at_nodes(batch)
        return highest(self._arrivals, strain, power @ self._quadratic.T, missing)

    def compare(self, batch: ParameterBatch, errors: CalibrationErrors | None, judge: Judge) -> Comparison:
        """Basis and judge at binaries that the model covers, under calibration errors if there are any."""
        strain, power, _ = self._at_nodes(batch)
        shape = len(batch), self._weights.detectors
        linear: NDArray[Any] = np.ones((*shape, 1, 1))
        quadratic: Floats = np.ones((*shape, 1))
        if errors is not None:
            linear = errors.factors(self._linear_nodes)
            quadratic = np.square(np.abs(errors.factors(self._quadratic_nodes)[:, :, 0]))
        n = np.sum(quadratic * power[:, None, :] * self._quadratic, axis=2)
        z, times = np.empty(shape, dtype=np.complex128), np.empty(shape)
        for d in range(shape[1]):
            there = strain * linear[:, d, 0]
            times[:, d] = self._arrivals.best(d, there.astype(np.complex64))[1]
            z[:, d] = np.sum(there * self._weights.at(d, times[:, d]), axis=1)

        def signal(f: Floats) -> Complex:
            h = self._model.predict_factored(f, batch, options=self._options).h
            return np.asarray(h, dtype=np.complex128)[:, None]

        found = judge.products(signal, times, None if errors is None else errors.factors)
        return Comparison.of(z[..., None], n[..., None, None].astype(np.complex128), *found)

    def _at_nodes(self, batch: ParameterBatch) -> tuple[Complex, Floats, NDArray[np.bool_]]:
        """Strain ``(K, L)``, its squared modulus ``(K, Q)``, and which rows the model does not cover."""
        linear = self._model.predict_factored(self._linear_nodes, batch, options=self._options)
        quadratic = linear
        if self._quadratic_nodes is not self._linear_nodes:
            quadratic = self._model.predict_factored(self._quadratic_nodes, batch, options=self._options)
        power = np.square(np.abs(np.asarray(quadratic.h)))
        return np.asarray(linear.h, dtype=np.complex128), power, np.asarray(linear.status) != 0


def highest(arrivals: Arrivals, strain: Complex, norms: Floats, missing: NDArray[np.bool_]) -> Floats:
    """ln L where it is largest of strain at the nodes ``(N, L)`` with <h|h> of ``(N, D)``; -inf where it is missing."""
    found, single = np.zeros(len(strain)), strain.astype(np.complex64)
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # rows that the model flagged are NaN
        for start in range(0, len(strain), _ROWS):
            rows = slice(start, start + _ROWS)
            for d in range(norms.shape[1]):
                squares = arrivals.best(d, single[rows])[0]
                found[rows] += np.where(norms[rows, d] > 0.0, 0.5 * squares / norms[rows, d], 0.0)
    return np.where(missing | ~np.isfinite(found), -np.inf, found)
