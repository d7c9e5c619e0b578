"""Gradients of the log-likelihood, backwards.

ln L is a function of inner products, which are linear and quadratic in the strain. What it changes by with them is
pulled back through the contraction to the strain (:mod:`.adjoint_kernel`), once for all parameters, and by the model to
the parameters of the binary; where a model does not do so, by its derivatives. The rest is analytic.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._derivatives import differentiates
from bnserve_inference._modes import modes_of, orders
from bnserve_inference._signals import Signals, Strain, Tile, calibration_errors
from bnserve_inference._time_integral import TimeIntegral
from bnserve_inference.adjoint_kernel import Adjoint, Bars, PulledBack
from bnserve_protocol import (
    DERIVATIVE_NAMES,
    Analysis,
    LikelihoodBatch,
    ParameterBatch,
    WaveformModel,
    gradient_names,
)

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
Evaluate: TypeAlias = Callable[[], tuple[Floats, Floats]]
_PLACE = ("right_ascension", "declination", "polarization_angle", "coalescence_time")


class _Differentiated(Protocol):
    """What a model has where it can be differentiated: :class:`bnserve_protocol.Derivatives`, or what takes derivatives
    back without forming those of the strain."""

    @property
    def h(self) -> Any: ...
    @property
    def plus(self) -> Floats: ...
    @property
    def cross(self) -> Complex: ...
    @property
    def plus_slope(self) -> Floats: ...
    @property
    def cross_slope(self) -> Complex: ...
    @property
    def status(self) -> NDArray[np.uint8]: ...
    @property
    def frequencies(self) -> Floats: ...
    def pull_back(self, bars: Complex, /) -> Floats:
        """From what a function changes by with h, ``(N, L, M)``, to what it changes by with the binary, ``(N, 6)``."""


class Marginal(NamedTuple):
    """ln L of <d|h>, ``(G, K)``, and <h|h>, ``(C, K)``; and the same with what it changes by with both, where a
    complex z counts as the real part of this times dz."""

    value: Callable[[Complex, NDArray[Any]], Floats]
    slopes: Callable[[Complex, NDArray[Any]], tuple[Floats, Complex, NDArray[Any]]]


class Gradients:
    """ln L and its gradient, of tiles of rows; a row's bits depend on the row, the analysis and the model alone.

    Parameters
    ----------
    model, analysis
        Of the likelihood.
    signals
        Of both.
    times
        Integrates over the time, where this is wanted.
    marginal
        All other integrals.

    Raises
    ------
    InvalidRequest
        The model has no derivatives.

    Attributes
    ----------
    names
        Of the columns.
    """

    def __init__(
        self, model: WaveformModel, analysis: Analysis, signals: Signals, times: TimeIntegral | None, marginal: Marginal
    ) -> None:
        advice = ": ask for log-likelihoods, or take one that has, as all shipped ones do"
        self._differentiate = differentiates(model, "predict_pullback", "predict_derivatives", advice=advice)
        self._signals, self._times, self._marginal = signals, times, marginal
        self._settings, self._modes = analysis.settings, modes_of(analysis.settings, model.description)
        self._adjoint = Adjoint(analysis, signals.group_of)
        self.names = gradient_names(analysis.settings)

    def of_rows(self, batch: LikelihoodBatch, fixed: dict[str, float]) -> tuple[Tile, Evaluate]:
        """The signals of some rows, and what evaluates ln L, ``(N,)``, and its gradient, ``(N, P)``."""
        waveforms = batch.waveform_batch(**fixed)
        found: _Differentiated = self._differentiate(
            self._signals.frequencies, waveforms, options=self._signals.options
        )
        h = np.asarray(found.h, dtype=np.complex128)
        passing = self._signals.passing(waveforms)
        tile = self._signals.of_strain(Strain(h, found.plus, found.cross, found.status), batch, passing)

        def evaluate() -> tuple[Floats, Floats]:
            values, bars = self._bars(tile)
            errors = calibration_errors(batch, self._settings)
            pulled = self._adjoint.pull_back(h, found.plus, found.cross, errors, bars, passing)
            return values, self._gradient(found, waveforms, pulled)

        return tile, evaluate

    def _bars(self, tile: Tile) -> tuple[Floats, list[Bars]]:
        """ln L, and what it changes by with the products of groups of modes."""
        if self._times is not None:
            values, of_places = self._times.slopes(tile.contract, tile.sky, *self._marginal)
            pairs = [self._signals.bars(each.products, each.norms) for each in of_places]
            found = [
                Bars(each.sky, *bars, each.step, each.by_node) for each, bars in zip(of_places, pairs, strict=True)
            ]
            return values, found
        inner = tile.contract(tile.sky, 1, 0.0, False)
        products = np.ascontiguousarray(inner.data[:, :, 0].T)
        values, by_products, by_norms = self._marginal.slopes(products, inner.norms)
        return values, [Bars(tile.sky, *self._signals.bars(by_products.T[:, :, None], by_norms))]

    def _gradient(self, found: _Differentiated, waveforms: ParameterBatch, pulled: PulledBack) -> Floats:
        """The columns of the gradient that the analysis has, ``(N, P)``."""
        if pulled.passing is not None:
            self._add_passing(found, pulled.passing, pulled.waves)
        binary = found.pull_back(pulled.waves)
        own = found.plus * pulled.factors[:, :, 0] + found.cross * pulled.factors[:, :, 1]
        tilted = found.plus_slope * pulled.factors[:, :, 0] + found.cross_slope * pulled.factors[:, :, 1]
        turns = np.array([-0.5 * order for _, order in self._modes])
        columns = dict(zip(DERIVATIVE_NAMES, binary.T, strict=True)) | dict(zip(_PLACE, pulled.sky.T, strict=True))
        columns["inclination"] = _sum(tilted.real)
        columns["reference_phase"] = _sum(turns * own.imag)
        columns["distance_mpc"] = -_sum(own.real) / waveforms["distance_mpc"]
        for place, detector in enumerate(self._settings.detectors):
            for kind, errors in zip(("amplitude", "phase"), pulled.errors, strict=True):
                for node in range(errors.shape[2]):
                    columns[f"recalib_{detector}_{kind}_{node}"] = errors[:, place, node]
        return np.stack([columns[name] for name in self.names], axis=1)

    def _add_passing(self, found: _Differentiated, bars: Floats, waves: Complex) -> None:
        """Add, to what ln L changes by with the strain, what it changes by with the times at which each group passes
        the frequencies, ``(N, G, M)``: minus d phase / d f of the strongest mode of each order, over 2 pi.

        By differences along the grid, right to 2e-3 at its ends: all of it is a millionth of the gradient.
        """
        f = found.frequencies
        for group, order in enumerate(orders(self._modes)):
            leading = min(place for place, mode in enumerate(self._modes) if mode[1] == order)
            by_phase = _slopes_back(bars[:, group] / (-2.0 * np.pi * f), np.log(f))
            with np.errstate(invalid="ignore", divide="ignore"):
                turned = 1j * by_phase / found.h[:, leading].conj()
            waves[:, leading] += np.where(np.isfinite(turned), turned, 0.0)


def _slopes_back(bars: Floats, x: Floats) -> Floats:
    """What ``np.gradient`` along the last axis, of numbers at ``x``, does backwards."""
    widths = np.diff(x)
    found = np.zeros_like(bars)
    found[:, 0] -= bars[:, 0] / widths[0]
    found[:, 1] += bars[:, 0] / widths[0]
    found[:, -2] -= bars[:, -1] / widths[-1]
    found[:, -1] += bars[:, -1] / widths[-1]
    left, right, inner = widths[:-1], widths[1:], bars[:, 1:-1]
    found[:, :-2] -= inner * (right / (left * (left + right)))
    found[:, 1:-1] += inner * ((right - left) / (left * right))
    found[:, 2:] += inner * (left / (right * (left + right)))
    return found


def _sum(modes: Floats) -> Floats:
    """Sums over the modes, in their order."""
    total = modes[:, 0].copy()
    for mode in range(1, modes.shape[1]):
        total += modes[:, mode]
    return total
