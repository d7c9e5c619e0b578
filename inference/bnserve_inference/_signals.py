"""The signals of a tile of rows: strain of the model at the nodes of an analysis, and its inner products.

A signal of one mode is contracted as it always was. Modes are contracted in groups: those of one order m, where the
orbital phase is integrated over or the analysis has weights for each order, and all of them otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._modes import evaluation_options, modes_of, orders
from bnserve_inference._passing import passing_times
from bnserve_inference._phase_integral import PhaseIntegral
from bnserve_inference.kernel import Contraction, Sky
from bnserve_inference.modes_kernel import GroupProducts, ModesContraction
from bnserve_inference.moving_kernel import MovingContraction
from bnserve_protocol import (
    Analysis,
    AnalysisSettings,
    ComplexArray,
    EvaluationOptions,
    LikelihoodBatch,
    ParameterBatch,
    WaveformModel,
)

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]


class InnerProducts(NamedTuple):
    """Sums over the detectors.

    ``data``, complex ``(N, G, times)``: <d|h> of each group. ``norms``, ``(C, N)``: <h|h>, or, complex, its series in
    the orbital phase (:class:`PhaseIntegral`). ``spectrum``, complex ``(N, G, L)`` if asked for: the terms of the sum
    over nodes at the last time.
    """

    data: Complex
    norms: NDArray[np.float64] | NDArray[np.complex128]
    spectrum: Complex | None


Contract: TypeAlias = Callable[[Floats, int, float, bool], InnerProducts]
"""Inner products of a tile, of the places of the rows (columns as :class:`Sky`), a number of times, the seconds between
them, and whether the spectrum is wanted."""


class Strain(NamedTuple):
    """The modes of N rows: ``h`` complex ``(N, L, M)``, what each counts in the polarisations, ``(N, L)``, and the
    status of the rows as the model gave it."""

    h: Complex
    plus: Floats
    cross: Complex
    status: NDArray[np.uint8]


class Tile(NamedTuple):
    """The signals of N rows.

    ``status`` as the model gave it; ``empty``: the rows that are zero at all frequencies, because they lie above the
    model's band; ``sky`` ``(N, 7)``.
    """

    status: NDArray[np.uint8]
    empty: NDArray[np.bool_]
    sky: Floats
    contract: Contract


class Signals:
    """Signals of an analysis.

    Attributes
    ----------
    frequencies
        Where the model is evaluated, ``(M,)`` in Hz.
    options
        What it is asked with.
    samples
        Complex numbers of one row.
    group_of
        The group of each mode, from 0 on: modes of one are contracted together.
    groups
        Number of those whose <d|h> is given apart.
    """

    frequencies: Floats
    options: EvaluationOptions
    samples: int
    group_of: Sequence[int]
    groups: int

    def tile(self, batch: LikelihoodBatch, fixed: dict[str, float]) -> Tile:
        """The signals of some rows; ``fixed`` parameters have one value in all of them."""
        waveforms = batch.waveform_batch(**fixed)
        return self.of_strain(self._strain(waveforms), batch, self.passing(waveforms))

    def of_strain(self, strain: Strain, batch: LikelihoodBatch, passing: Floats | None) -> Tile:
        """The signals of some rows, of strain that was evaluated."""
        raise NotImplementedError

    def passing(self, waveforms: ParameterBatch) -> Floats | None:
        """When each group passes the frequencies, ``(N, G, M)`` in seconds from the coalescence, where that has to be
        asked of the model."""
        return None

    def bars(self, products: Complex, norms: NDArray[Any]) -> tuple[Complex, Complex]:
        """What ln L changes by with <d|h> of each group of modes, ``(N, G, K)``, and with <h|h'> of their pairs,
        ``(N, P)``; of what it changes by with :class:`InnerProducts`, ``(N, G, K)`` and ``(C, N)``.
        """
        raise NotImplementedError

    def _strain(self, waveforms: ParameterBatch) -> Strain:
        raise NotImplementedError


class OneMode(Signals):
    """Signals of a single mode."""

    groups, group_of = 1, (0,)

    def __init__(self, model: WaveformModel, analysis: Analysis) -> None:
        modes = modes_of(analysis.settings, model.description)
        self._model, self._settings, self._contraction = model, analysis.settings, Contraction(analysis)
        self.options = evaluation_options(model, modes, analysis.settings)
        self.frequencies = self._contraction.frequencies
        self.samples = len(self.frequencies)

    def of_strain(self, strain: Strain, batch: LikelihoodBatch, passing: Floats | None) -> Tile:
        """As :meth:`Signals.of_strain`."""
        h, contraction, errors = strain.h[:, 0], self._contraction, calibration_errors(batch, self._settings)

        def contract(sky: Floats, times: int, step: float, spectrum: bool) -> InnerProducts:
            inner = contraction(h, sky, errors, times, step, spectrum)
            terms = None if inner.spectrum is None else inner.spectrum[:, None]
            return InnerProducts(inner.data[:, None], inner.norm[None], terms)

        sky = places(batch)
        sky[:, Sky.PLUS] = strain.plus[:, 0]
        sky[:, Sky.CROSS_REAL], sky[:, Sky.CROSS_IMAGINARY] = strain.cross[:, 0].real, strain.cross[:, 0].imag
        return Tile(strain.status, _empty(h), sky, contract)

    def bars(self, products: Complex, norms: NDArray[Any]) -> tuple[Complex, Complex]:
        """As :meth:`Signals.bars`."""
        return products, norms.T.astype(np.complex128)

    def _strain(self, waveforms: ParameterBatch) -> Strain:
        return _of_one_mode(self._model, self.frequencies, waveforms, self.options)


class SeveralModes(Signals):
    """Signals of several modes.

    Parameters
    ----------
    model, analysis
        Of the likelihood.
    phases
        Integrates over the phase, where orders differ and this is wanted.
    """

    def __init__(self, model: WaveformModel, analysis: Analysis, phases: PhaseIntegral | None) -> None:
        modes = modes_of(analysis.settings, model.description)
        apart = analysis.settings.kind != "full" or phases is not None
        different = orders(modes)
        self.group_of = group_of = [different.index(order) if apart else 0 for _, order in modes]
        self._model, self._settings, self._contraction = model, analysis.settings, ModesContraction(analysis, group_of)
        self.options = evaluation_options(model, modes, analysis.settings)
        self._phases, self._groups = phases, max(group_of) + 1
        self.frequencies = self._contraction.frequencies
        self.samples = len(self.frequencies) * len(modes)
        self.groups = 1 if phases is None else self._groups

    def of_strain(self, strain: Strain, batch: LikelihoodBatch, passing: Floats | None) -> Tile:
        """As :meth:`Signals.of_strain`."""
        h, plus, cross, status = strain
        errors = calibration_errors(batch, self._settings)

        def contract(sky: Floats, times: int, step: float, spectrum: bool) -> InnerProducts:
            return self._combined(self._contraction(h, plus, cross, sky, errors, times, step, spectrum))

        return Tile(status, _empty(h.reshape(len(h), -1)), _whole(places(batch)), contract)

    def bars(self, products: Complex, norms: NDArray[Any]) -> tuple[Complex, Complex]:
        """As :meth:`Signals.bars`."""
        if self._phases is not None:
            return products, self._phases.bars_of_pairs(norms)
        groups = range(self._groups)
        twice = [1.0 if other == group else 2.0 for group in groups for other in groups[group:]]
        shape = len(products), self._groups, products.shape[2]
        return np.broadcast_to(products, shape), norms[0][:, None] * np.array(twice, dtype=np.complex128)

    def _strain(self, waveforms: ParameterBatch) -> Strain:
        found = self._model.predict_modes(self.frequencies, waveforms, options=self.options)
        return Strain(np.asarray(found.h, dtype=np.complex128), found.plus, found.cross, found.status)

    def _combined(self, found: GroupProducts) -> InnerProducts:
        """The products that are wanted of those of the groups."""
        terms = found.spectrum
        if self._phases is not None:
            return InnerProducts(found.data, self._phases.norms(found.pairs), terms)
        data = _summed(found.data)[:, None]
        return InnerProducts(data, self._norms(found.pairs)[None], None if terms is None else _summed(terms)[:, None])

    def _norms(self, pairs: Complex) -> Floats:
        """<h|h> of the sum of all groups, ``(N,)``."""
        total, at = np.zeros(len(pairs)), 0
        for group in range(self._groups):
            for other in range(group, self._groups):
                total += (1.0 if other == group else 2.0) * pairs[:, at].real
                at += 1
        return total


class Moving(SeveralModes):
    """As :class:`SeveralModes`, of one mode or several, in detectors that move or whose arms are not short.

    The modes of each order are a group of their own, because they pass frequencies together.
    """

    def __init__(self, model: WaveformModel, analysis: Analysis, phases: PhaseIntegral | None) -> None:
        self._modes = modes_of(analysis.settings, model.description)
        different = orders(self._modes)
        self.group_of = group_of = [different.index(order) for _, order in self._modes]
        self._model, self._settings = model, analysis.settings
        self._moving = MovingContraction(analysis, group_of)
        self.options = evaluation_options(model, self._modes, analysis.settings)
        self._phases, self._groups = phases, len(different)
        self.frequencies = self._moving.frequencies
        self.samples = len(self.frequencies) * len(self._modes)
        self.groups = 1 if phases is None else self._groups
        self._asks = analysis.settings.moves and analysis.settings.kind == "full"

    def passing(self, waveforms: ParameterBatch) -> Floats | None:
        """As :meth:`Signals.passing`."""
        if not self._asks:
            return None
        return passing_times(self._model, waveforms, self.frequencies, self._modes, self._settings.alignment)

    def of_strain(self, strain: Strain, batch: LikelihoodBatch, passing: Floats | None) -> Tile:
        """As :meth:`Signals.of_strain`."""
        h, plus, cross, status = strain
        errors = calibration_errors(batch, self._settings)

        def contract(sky: Floats, times: int, step: float, spectrum: bool) -> InnerProducts:
            found = self._moving.inner_products(h, plus, cross, sky, errors, times, step, spectrum, passing=passing)
            return self._combined(found)

        return Tile(status, _empty(h.reshape(len(h), -1)), _whole(places(batch)), contract)

    def _strain(self, waveforms: ParameterBatch) -> Strain:
        if len(self._modes) > 1:
            return super()._strain(waveforms)
        return _of_one_mode(self._model, self.frequencies, waveforms, self.options)


def signals_of(model: WaveformModel, analysis: Analysis, phases: PhaseIntegral | None) -> Signals:
    """Those of the modes of an analysis, in detectors as it has them."""
    if analysis.settings.moves or any(name.startswith("arms/") for name in analysis.arrays):
        return Moving(model, analysis, phases)
    if len(modes_of(analysis.settings, model.description)) == 1:
        return OneMode(model, analysis)
    return SeveralModes(model, analysis, phases)


def _of_one_mode(
    model: WaveformModel, frequencies: Floats, waveforms: ParameterBatch, options: EvaluationOptions
) -> Strain:
    one = model.predict_factored(frequencies, waveforms, options=options)
    return Strain(np.asarray(one.h, dtype=np.complex128)[:, None], one.plus[:, None], one.cross[:, None], one.status)


def places(batch: LikelihoodBatch) -> Floats:
    """Places and times of the rows, columns as in :class:`Sky`; the factors of the strain are not filled in."""
    sky = np.empty((len(batch), len(Sky)))
    sky[:, Sky.RIGHT_ASCENSION] = batch["right_ascension"]
    sky[:, Sky.DECLINATION] = batch["declination"]
    sky[:, Sky.POLARIZATION] = batch["polarization_angle"]
    sky[:, Sky.TIME] = batch["coalescence_time"]
    return sky


def _whole(sky: Floats) -> Floats:
    """The same, of polarisations that are the real and the imaginary part of one."""
    sky[:, Sky.PLUS], sky[:, Sky.CROSS_REAL], sky[:, Sky.CROSS_IMAGINARY] = 1.0, 0.0, 1.0
    return sky


def calibration_errors(batch: LikelihoodBatch, settings: AnalysisSettings) -> tuple[Floats, Floats] | None:
    """Of a batch, amplitude and phase as ``(N, D, nodes)`` each; None where the batch has none."""
    if settings.calibration is None or not batch.calibration_amplitude:
        return None
    zero = np.zeros((len(batch), settings.calibration.nodes))
    amplitude, phase = (
        np.stack([arrays.get(name, zero) for name in settings.detectors], axis=1)
        for arrays in (batch.calibration_amplitude, batch.calibration_phase)
    )
    return amplitude, phase


def _summed(groups: Complex) -> Complex:
    """Sums over the second axis, in its order."""
    total = groups[:, 0].copy()
    for group in range(1, groups.shape[1]):
        total += groups[:, group]
    return total


def _empty(h: ComplexArray) -> NDArray[np.bool_]:
    """The rows, (N,), that are zero at all frequencies (N, M)."""
    empty = np.asarray(h[:, 0] == 0.0)
    for row in np.flatnonzero(empty):
        empty[row] = not h[row].any()
    return empty
