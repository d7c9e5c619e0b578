"""The signals of a tile of rows: strain of the model at the nodes of an analysis, and its inner products.

A signal of one mode is contracted as it always was. Modes are contracted in groups: those of one order m, where the
orbital phase is integrated over or the analysis has weights for each order, and all of them otherwise.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._modes import evaluation_options, modes_of, orders
from bnserve_inference._passing import passing_times
from bnserve_inference._phase_integral import PhaseIntegral
from bnserve_inference.kernel import Contraction, Sky
from bnserve_inference.modes_kernel import GroupProducts, ModesContraction
from bnserve_inference.moving_kernel import MovingContraction
from bnserve_protocol import Analysis, AnalysisSettings, ComplexArray, LikelihoodBatch, ParameterBatch, WaveformModel

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


class Tile(NamedTuple):
    """The signals of N rows.

    ``status`` as the model gave it; ``empty``: the rows that are zero at all frequencies, because they lie above the
    model's band; ``sky`` ``(N, 7)``.
    """

    status: NDArray[np.uint8]
    empty: NDArray[np.bool_]
    sky: Floats
    contract: Contract


class OneMode:
    """Signals of a single mode.

    Attributes
    ----------
    frequencies
        Where the model is evaluated, ``(M,)`` in Hz.
    samples
        Complex numbers of one row.
    groups
        Of modes, whose <d|h> is given apart.
    """

    groups = 1

    def __init__(self, model: WaveformModel, analysis: Analysis) -> None:
        modes = modes_of(analysis.settings, model.description)
        self._model, self._settings, self._contraction = model, analysis.settings, Contraction(analysis)
        self._options = evaluation_options(model, modes, analysis.settings)
        self.frequencies = self._contraction.frequencies
        self.samples = len(self.frequencies)

    def tile(self, batch: LikelihoodBatch, fixed: dict[str, float]) -> Tile:
        """The signals of some rows; ``fixed`` parameters have one value in all of them."""
        factored = self._model.predict_factored(self.frequencies, batch.waveform_batch(**fixed), options=self._options)
        h, contraction = np.asarray(factored.h, dtype=np.complex128), self._contraction
        errors = calibration_errors(batch, self._settings)

        def contract(sky: Floats, times: int, step: float, spectrum: bool) -> InnerProducts:
            inner = contraction(h, sky, errors, times, step, spectrum)
            terms = None if inner.spectrum is None else inner.spectrum[:, None]
            return InnerProducts(inner.data[:, None], inner.norm[None], terms)

        sky = _places(batch)
        sky[:, Sky.PLUS] = factored.plus
        sky[:, Sky.CROSS_REAL], sky[:, Sky.CROSS_IMAGINARY] = factored.cross.real, factored.cross.imag
        return Tile(factored.status, _empty(factored.h), sky, contract)


class SeveralModes:
    """Signals of several modes; attributes and methods as those of :class:`OneMode`.

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
        group_of = [different.index(order) if apart else 0 for _, order in modes]
        self._model, self._settings, self._contraction = model, analysis.settings, ModesContraction(analysis, group_of)
        self._options = evaluation_options(model, modes, analysis.settings)
        self._phases, self._groups = phases, max(group_of) + 1
        self.frequencies = self._contraction.frequencies
        self.samples = len(self.frequencies) * len(modes)
        self.groups = 1 if phases is None else self._groups

    def tile(self, batch: LikelihoodBatch, fixed: dict[str, float]) -> Tile:
        """As :meth:`OneMode.tile`."""
        modes = self._model.predict_modes(self.frequencies, batch.waveform_batch(**fixed), options=self._options)
        h = np.asarray(modes.h, dtype=np.complex128)
        errors = calibration_errors(batch, self._settings)

        def contract(sky: Floats, times: int, step: float, spectrum: bool) -> InnerProducts:
            return self._combined(self._contraction(h, modes.plus, modes.cross, sky, errors, times, step, spectrum))

        sky = _places(batch)
        sky[:, Sky.PLUS], sky[:, Sky.CROSS_REAL], sky[:, Sky.CROSS_IMAGINARY] = 1.0, 0.0, 1.0
        return Tile(modes.status, _empty(h.reshape(len(h), -1)), sky, contract)

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
        group_of = [different.index(order) for _, order in self._modes]
        self._model, self._settings = model, analysis.settings
        self._moving = MovingContraction(analysis, group_of)
        self._options = evaluation_options(model, self._modes, analysis.settings)
        self._phases, self._groups = phases, len(different)
        self.frequencies = self._moving.frequencies
        self.samples = len(self.frequencies) * len(self._modes)
        self.groups = 1 if phases is None else self._groups
        self._asks = analysis.settings.moves and analysis.settings.kind == "full"

    def tile(self, batch: LikelihoodBatch, fixed: dict[str, float]) -> Tile:
        """As :meth:`OneMode.tile`."""
        waveforms = batch.waveform_batch(**fixed)
        h, plus, cross, status = self._strain(waveforms)
        errors, passing = calibration_errors(batch, self._settings), None
        if self._asks:
            passing = passing_times(self._model, waveforms, self.frequencies, self._modes, self._settings.alignment)

        def contract(sky: Floats, times: int, step: float, spectrum: bool) -> InnerProducts:
            found = self._moving.inner_products(h, plus, cross, sky, errors, times, step, spectrum, passing=passing)
            return self._combined(found)

        sky = _places(batch)
        sky[:, Sky.PLUS], sky[:, Sky.CROSS_REAL], sky[:, Sky.CROSS_IMAGINARY] = 1.0, 0.0, 1.0
        return Tile(status, _empty(h.reshape(len(h), -1)), sky, contract)

    def _strain(self, batch: ParameterBatch) -> tuple[Complex, Floats, Complex, NDArray[np.uint8]]:
        """Modes ``(N, L, M)``, what they count in the polarisations, ``(N, L)``, and the status of the rows."""
        if len(self._modes) == 1:
            one = self._model.predict_factored(self.frequencies, batch, options=self._options)
            return np.asarray(one.h, dtype=np.complex128)[:, None], one.plus[:, None], one.cross[:, None], one.status
        several = self._model.predict_modes(self.frequencies, batch, options=self._options)
        return np.asarray(several.h, dtype=np.complex128), several.plus, several.cross, several.status


def signals_of(model: WaveformModel, analysis: Analysis, phases: PhaseIntegral | None) -> OneMode | SeveralModes:
    """Those of the modes of an analysis, in detectors as it has them."""
    if analysis.settings.moves or any(name.startswith("arms/") for name in analysis.arrays):
        return Moving(model, analysis, phases)
    if len(modes_of(analysis.settings, model.description)) == 1:
        return OneMode(model, analysis)
    return SeveralModes(model, analysis, phases)


def _places(batch: LikelihoodBatch) -> Floats:
    """Places and times of the rows, columns as in :class:`Sky`; the factors of the strain are not filled in."""
    sky = np.empty((len(batch), len(Sky)))
    sky[:, Sky.RIGHT_ASCENSION] = batch["right_ascension"]
    sky[:, Sky.DECLINATION] = batch["declination"]
    sky[:, Sky.POLARIZATION] = batch["polarization_angle"]
    sky[:, Sky.TIME] = batch["coalescence_time"]
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
