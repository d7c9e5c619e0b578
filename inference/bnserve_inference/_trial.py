"""What a basis makes of the likelihood, and what the full grid says.

The place in the sky, the orientation and the distance are not varied: in every detector by itself, a waveform arrives
when, as large and with the phase that it fits best. With <d|h> = z and <h|h> = n of a waveform h of any size, ln L of
a h is Re(conj(a) z) - abs(a)^2 n / 2, which is largest, abs(z)^2 / 2 n, at a = z / n.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Band, Basis
from bnserve_inference._calibration import calibration_factors
from bnserve_inference._weights import Weights
from bnserve_protocol import Calibration, EvaluationOptions, ParameterBatch, WaveformModel

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_STEP, _COARSE = 1e-4, 5
"""Seconds between times of arrival, which miss a thousandth of ln L, and how many of them a search goes on by."""
_MOST_BYTES = 2**28
"""Of the products at all times; with more, the times are further apart."""
_ROWS = 64
_PIECE = 2**19
"""Complex numbers that are worked on at once: 8 MiB."""


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

    def factors(self, frequencies: Floats) -> Complex:
        """``(K, D, M)``."""
        return calibration_factors(self.calibration, self.amplitude, self.phase, frequencies)


@dataclass(frozen=True, eq=False)
class Comparison:
    """ln L of K binaries with a basis and on the full grid, each ``(K,)``.

    Attributes
    ----------
    approximate, exact
        With the basis and on the full grid, at the size and phase that fit best with the basis.
    best
        On the full grid, at the size and phase that fit best there.
    linear, quadratic
        Largest errors of the two terms at either place.
    total
        Largest error of ln L at either place.
    """

    approximate: Floats
    exact: Floats
    best: Floats
    linear: Floats
    quadratic: Floats
    total: Floats


class Trial:
    """The likelihood with a basis.

    Parameters
    ----------
    band, model
        Of the analysis.
    options
        Ask the model for the mode; binaries that it does not cover are flagged.
    basis, weights, quadratic
        The basis with its sums over the data, and over the noise, ``(D, Q)``.
    group
        Which of the rows of the weights are those of the mode: whole multiples of the nodes are before them.
    """

    def __init__(
        self, band: Band, model: WaveformModel, options: EvaluationOptions, basis: Basis, weights: Weights,
        quadratic: Floats, group: int = 0,
    ) -> None:  # fmt: skip
        self._band, self._model, self._options = band, model, options
        self._linear_nodes, self._quadratic_nodes = basis.linear_nodes, basis.quadratic_nodes
        self._quadratic = quadratic
        whole = 16 * len(band.data) * len(weights.nodes) * weights.times.width / _STEP
        self._times, self._all = weights.products(_STEP * max(1.0, whole / _MOST_BYTES))
        count = len(basis.linear_nodes)
        self._group, self._products = group, self._all[:, :, group * count : (group + 1) * count]
        self._coarse = self._products[:, :: max(1, int(_COARSE * _MOST_BYTES / max(whole, _MOST_BYTES)))].astype(
            np.complex64
        )

    def values(self, batch: ParameterBatch) -> Floats:
        """ln L where it is largest, ``(N,)``; -inf for what the model does not cover."""
        strain, power, missing = self._at_nodes(batch)
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # rows that the model flagged are NaN
            norms, single, found = power @ self._quadratic.T, strain.astype(np.complex64), np.empty(len(batch))
            for start in range(0, len(batch), _ROWS):
                rows = slice(start, start + _ROWS)
                sizes = self._coarse @ single[rows].T  # (D, T, K)
                peaks = np.max(np.square(sizes.real) + np.square(sizes.imag), axis=1).T
                found[rows] = np.sum(np.where(norms[rows] > 0.0, 0.5 * peaks / norms[rows], 0.0), axis=1)
        return np.where(missing | ~np.isfinite(found), -np.inf, found)

    def compare(self, batch: ParameterBatch, errors: CalibrationErrors | None) -> Comparison:
        """Basis and full grid at binaries that the model covers, under calibration errors if there are any."""
        strain, power, _ = self._at_nodes(batch)
        shape = len(batch), len(self._products)
        linear: NDArray[Any] = np.ones((*shape, 1))
        quadratic: Floats = np.ones((*shape, 1))
        if errors is not None:
            linear = errors.factors(self._linear_nodes)
            quadratic = np.square(np.abs(errors.factors(self._quadratic_nodes)))
        n = np.sum(quadratic * power[:, None, :] * self._quadratic, axis=2)
        z, times = np.empty(shape, dtype=np.complex128), np.empty(shape)
        for d, products in enumerate(self._products):
            over_times = (strain * linear[:, d]) @ products.T
            places = np.argmax(np.abs(over_times), axis=1)
            z[:, d], times[:, d] = over_times[np.arange(len(batch)), places], self._times[places]
        return _compared(z, n, *self._on_the_grid(batch, times, errors))

    def arrivals(self, detector: int, strain: Complex) -> tuple[Floats, Complex]:
        """When the mode fits best in a detector, ``(K,)``, of the strain of every group at the nodes, ``(K, G, L)``,
        and <d|h> of all groups then, ``(K, G)``."""
        table = self._all[detector].reshape(len(self._times), strain.shape[1], -1)
        places = np.argmax(np.abs(strain[:, self._group] @ table[:, self._group].T), axis=1)
        return self._times[places], np.einsum("kgj,kgj->kg", strain, table[places])

    def _at_nodes(self, batch: ParameterBatch) -> tuple[Complex, Floats, NDArray[np.bool_]]:
        """Strain ``(K, L)``, its squared modulus ``(K, Q)``, and which rows the model does not cover."""
        linear = self._model.predict_factored(self._linear_nodes, batch, options=self._options)
        quadratic = linear
        if self._quadratic_nodes is not self._linear_nodes:
            quadratic = self._model.predict_factored(self._quadratic_nodes, batch, options=self._options)
        power = np.square(np.abs(np.asarray(quadratic.h)))
        return np.asarray(linear.h, dtype=np.complex128), power, np.asarray(linear.status) != 0

    def _on_the_grid(
        self, batch: ParameterBatch, times: Floats, errors: CalibrationErrors | None
    ) -> tuple[Complex, Floats]:
        """<d|h> at ``times`` and <h|h> on the full grid, ``(K, D)`` each."""
        band = self._band
        z, n = np.zeros(times.shape, dtype=np.complex128), np.zeros(times.shape)
        for place, f, ramp in pieces(band, times):
            strain = np.asarray(self._model.predict_factored(f, batch, options=self._options).h)
            factors = None if errors is None else errors.factors(f)
            for d in range(times.shape[1]):
                there = strain if factors is None else strain * factors[:, d]
                turned = np.einsum("km,km->k", there * band.data[d][place], ramp[:, d])
                z[:, d] += turned * np.exp(-2j * np.pi * f[0] * times[:, d])
                n[:, d] += np.square(np.abs(there)) @ band.densities[d][place]
        return z, n


def pieces(band: Band, times: Floats) -> Iterator[tuple[slice, Floats, Complex]]:
    """The grid in pieces: places ``(m,)``, frequencies, and, of arrivals at ``times`` ``(K, D)``, exp(-2 pi i (f - f_0)
    t) with the first frequency f_0 of the piece, ``(K, D, m)``."""
    count, piece = len(band.frequencies), max(64, _PIECE // times.size)
    ramp = np.exp(-2j * np.pi / band.duration * np.arange(piece) * times[:, :, None])
    for start in range(0, count, piece):
        place = slice(start, min(start + piece, count))
        yield place, band.frequencies[place], ramp[:, :, : place.stop - start]


def _compared(z: Complex, n: Floats, z_full: Complex, n_full: Floats) -> Comparison:
    """Of products with a basis and on the full grid, ``(K, D)`` each."""
    linear, quadratic, total, values = [], [], [], []
    for a in (_ratio(z, n), _ratio(z_full, n_full)):
        one = np.sum((a.conj() * (z - z_full)).real, axis=1)
        other = np.sum(0.5 * np.square(np.abs(a)) * (n - n_full), axis=1)
        linear.append(np.abs(one))
        quadratic.append(np.abs(other))
        total.append(np.abs(one - other))
        values.append(np.sum((a.conj() * z_full).real - 0.5 * np.square(np.abs(a)) * n_full, axis=1))
    return Comparison(
        approximate=0.5 * np.sum((_ratio(z, n).conj() * z).real, axis=1),
        exact=values[0],
        best=values[1],
        linear=np.maximum(*linear),
        quadratic=np.maximum(*quadratic),
        total=np.maximum(*total),
    )


def _ratio(z: Complex, n: Floats) -> Complex:
    """z / n, and nothing in a detector that has no say in the band."""
    return np.divide(z, n, out=np.zeros_like(z), where=n > 0.0)
