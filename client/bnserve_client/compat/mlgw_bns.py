"""The names of mlgw_bns 0.12 with a model of bnserve behind them; see ``docs/guides/mlgw_bns.md``.

``predict`` has all modes of the model, or those of the attribute ``modes``; amplitude and phase are those of (2, 2),
which mlgw_bns has alone.

Signs, phase and time are those of mlgw_bns: time as in the post-Newtonian baseline, and ``reference_phase`` is the
phase at the lowest frequency that the model was trained on, or at the first of the grid where that is lower.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_client import _chosen
from bnserve_client._lal_meaning import QUADRUPOLE, is_single, modes_of
from bnserve_protocol import PARAMETER_NAMES, EvaluationOptions, InvalidRequest, Mode, OutOfBand, WaveformModel
from bnserve_protocol import ParametersWithExtrinsic as _Binary
from bnserve_protocol import __version__ as _version

__all__ = ["FrequencyTooHighError", "FrequencyTooLowError", "Model", "ParameterRanges", "ParametersWithExtrinsic"]
__version__ = f"0.12.1+bnserve.{_version}"
"""Whose interface it is, and what is behind it."""

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_EXTENSIONS = ("extend_with_post_newtonian", "extend_with_zeros_at_high_frequency")
_DIFFERENCES = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
"""Central differences of order 8."""


class FrequencyTooLowError(ValueError):
    """A frequency is below the band, and ``extend_with_post_newtonian`` is False."""


class FrequencyTooHighError(ValueError):
    """A frequency is above the band, and ``extend_with_zeros_at_high_frequency`` is False."""


@dataclasses.dataclass
class ParametersWithExtrinsic:
    """One binary; as :class:`bnserve_protocol.ParametersWithExtrinsic`, and can be changed.

    Parameters
    ----------
    mass_ratio
        q = m1 / m2 >= 1.
    lambda_1, lambda_2, chi_1, chi_2
        Tidal polarisabilities and aligned dimensionless spins, of the heavier and of the lighter star.
    distance_mpc, inclination, total_mass
        Luminosity distance in Mpc, radians, and solar masses in the detector frame.
    reference_phase
        Radians: the phase at the lowest frequency of training, or of the grid where that is lower.
    time_shift
        Seconds: 2 pi f ``time_shift`` is added to the phase.
    """

    mass_ratio: float
    lambda_1: float
    lambda_2: float
    chi_1: float
    chi_2: float
    distance_mpc: float
    inclination: float
    total_mass: float
    reference_phase: float = 0.0
    time_shift: float = 0.0

    @classmethod
    def gw170817(cls) -> ParametersWithExtrinsic:
        """The binary that mlgw_bns calls so: equal masses, no spins (that of bnserve is another)."""
        return cls(1.0, 400.0, 400.0, 0.0, 0.0, 40.0, 5.0 * np.pi / 6.0, 2.8)


class ParameterRanges(NamedTuple):
    """Where a model was trained: the lowest and the highest value of each parameter."""

    mass_range: tuple[float, float]
    q_range: tuple[float, float]
    lambda1_range: tuple[float, float]
    lambda2_range: tuple[float, float]
    chi1_range: tuple[float, float]
    chi2_range: tuple[float, float]


class Model:
    """A model of bnserve with the methods of mlgw_bns's; made by :meth:`default`.

    Parameters
    ----------
    model
        A model of bnserve, remote or local. (Files of mlgw_bns are not read: train a model, ``bnserve train``.)

    Attributes
    ----------
    extend_with_post_newtonian, extend_with_zeros_at_high_frequency
        Whether frequencies below and above the band are answered; True. False for an error.
    modes
        ``[(l, m), ...]`` that :meth:`predict` sums; None, all that the model has.
    """

    def __init__(self, model: WaveformModel) -> None:
        if not hasattr(model, "predict_amplitude_phase"):
            raise InvalidRequest(
                "Files of mlgw_bns cannot be loaded here: Model.default(name) is a model of bnserve, and "
                "`bnserve train` makes another."
            )
        self.extend_with_post_newtonian = self.extend_with_zeros_at_high_frequency = True
        self.modes: Sequence[Mode] | None = None
        self._model = model
        self._of_22 = None if is_single(model.description) else QUADRUPOLE
        """None to an older server, which knows nothing of modes."""

    @classmethod
    def default(cls, model_name: str | None = None, **settings: bool) -> Model:
        """The model of this name of the service at ``BNSERVE_URL``; where that is not set, the one of this process.

        Parameters
        ----------
        model_name
            Without it that of ``BNSERVE_MODEL``, or ``"default"``. The token is that of ``BNSERVE_TOKEN``.
        settings
            The attributes, see :class:`Model`.

        Raises
        ------
        InvalidRequest
            A setting that is none, or is of training.
        PackageMissing, ConnectionFailed, ModelUnknown, Unauthorized, ...
            As :func:`bnserve_client.Model.connect`, and without an address where no models are installed.
        """
        unknown = settings.keys() - set(_EXTENSIONS)
        if unknown:
            raise InvalidRequest(f"'{min(unknown)[:80]}' is no setting here: known are {', '.join(_EXTENSIONS)}.")
        model = cls(_chosen.chosen_model(name=model_name))
        vars(model).update(settings)
        return model

    @property
    def parameter_ranges(self) -> ParameterRanges:
        """What the model takes."""
        of = {parameter.name: parameter for parameter in self._model.description.parameters}
        names = ("total_mass", "mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2")
        return ParameterRanges(*((float(of[name].minimum), float(of[name].maximum)) for name in names))  # type: ignore[arg-type]  # these are bounded

    def predict(self, frequencies: Any, params: ParametersWithExtrinsic) -> tuple[Complex, Complex]:
        """``hp, hc``, complex ``(M,)`` in 1/Hz, at increasing frequencies in Hz.

        Raises
        ------
        FrequencyTooLowError, FrequencyTooHighError
            Outside the band, where it is not extended.
        ValueError
            Outside the range of parameters, or no frequencies: ``OutOfDomain`` and others of :mod:`bnserve_client`.
        """
        grid = np.atleast_1d(np.asarray(frequencies, dtype=np.float64))
        binary = _binary(params)
        try:
            zero = self._phase_of_zero(grid, binary)
            turn = zero % (4.0 * np.pi)  # of odd modes
            shifted = dataclasses.replace(binary, reference_phase=binary.reference_phase - turn)
            chosen = None if self.modes is None else modes_of(self._model.description, self.modes)
            hp, hc = self._model.predict(grid, shifted, options=self._options(chosen))
        except OutOfBand as error:
            raise self._of_band(grid, binary, error) from None
        return np.asarray(hp), np.asarray(hc)

    def predict_amplitude_phase(self, frequencies: Any, params: ParametersWithExtrinsic) -> tuple[Floats, Floats]:
        """Amplitude (1/Hz, face on) and continuous phase (radians), ``(M,)``. Raises as :meth:`predict`."""
        grid = np.atleast_1d(np.asarray(frequencies, dtype=np.float64))
        binary = _binary(params)
        try:
            zero = self._phase_of_zero(grid, binary)
            amplitude, phase = self._model.predict_amplitude_phase(grid, binary, options=self._options(self._of_22))
        except OutOfBand as error:
            raise self._of_band(grid, binary, error) from None
        return np.asarray(amplitude), phase - zero

    _predict_amplitude_phase = predict_amplitude_phase  # its name in mlgw_bns

    def time_until_merger(
        self, frequency: float, params: ParametersWithExtrinsic, delta_f: float | None = None
    ) -> float:
        """Seconds until the signal that passes ``frequency`` (Hz) ends: its phase's derivative over 2 pi.

        As in mlgw_bns it knows nothing of the merger, and has ``time_shift`` and the baseline's time in it; that of
        :class:`bnserve_client.Model` is until the merger.

        Parameters
        ----------
        delta_f
            Steps of the difference in Hz; a thousandth of the frequency where it is None.
        """
        step = frequency / 1000.0 if delta_f is None else delta_f
        _, phase = self.predict_amplitude_phase(frequency + step * np.arange(-4, 5), params)
        return float(_DIFFERENCES @ (phase - phase[4]) / (2.0 * np.pi * step))

    def _options(self, modes: tuple[Mode, ...] | None) -> EvaluationOptions:
        return EvaluationOptions(
            modes=modes,
            below_band="extend" if self.extend_with_post_newtonian else "error",
            above_band="zero" if self.extend_with_zeros_at_high_frequency else "error",
        )

    def _lowest(self, total_mass: float) -> float:
        """The lowest frequency of training at this mass, in Hz."""
        description = self._model.description
        return description.training_band[0] * description.reference_mass / total_mass

    def _phase_of_zero(self, grid: Floats, binary: _Binary) -> float:
        """The phase, without reference_phase and time_shift, of where mlgw_bns has zero."""
        if not binary.total_mass > 0.0:
            return 0.0  # the model refuses it
        still = dataclasses.replace(binary, reference_phase=0.0, time_shift=0.0)
        of_22 = EvaluationOptions(modes=self._of_22)
        first = min(self._lowest(binary.total_mass), *grid[:1].tolist())
        return float(self._model.predict_amplitude_phase(np.array([first]), still, options=of_22).phase[0])

    def _of_band(self, grid: Floats, binary: _Binary, error: OutOfBand) -> ValueError:
        too_low = not self.extend_with_post_newtonian and grid[0] < self._lowest(binary.total_mass)
        if not too_low and self.extend_with_zeros_at_high_frequency:
            return error  # so low that there is no phase
        kind = FrequencyTooLowError if too_low else FrequencyTooHighError
        return kind(f"{error} Set the attribute '{_EXTENSIONS[not too_low]}' of the model to True to extend it.")


def _binary(params: Any) -> _Binary:
    return _Binary(*(getattr(params, name) for name in PARAMETER_NAMES))
