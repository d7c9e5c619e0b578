"""The time between a frequency and the merger, from the phase of any waveform model."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._batches import ParameterBatch
from bnserve_protocol._grids import as_frequencies
from bnserve_protocol._options import EvaluationOptions

if TYPE_CHECKING:
    from bnserve_protocol._model import ModelDescription, WaveformModel
    from bnserve_protocol._parameters import ParametersWithExtrinsic

_STEP = 1e-3
"""Relative spacing of the stencil: truncation below 1e-9, rounding below a nanosecond above 1 Hz."""
_AROUND = ((-2.0, -1.0, 1.0, 2.0), (1.0, -8.0, 8.0, -1.0))
_UP_TO = ((-4.0, -3.0, -2.0, -1.0, 0.0), (3.0, -16.0, 36.0, -48.0, 25.0))
"""Places in units of the spacing, and weights of twelve derivatives of fourth order: central, and from below."""


@dataclasses.dataclass(frozen=True, slots=True)
class MergerStencil:
    """The question to a model, and how to read its answer, for the time from ``frequency`` (Hz) to the merger.

    In the stationary-phase approximation the signal passes f at t(f) = -(1/2 pi) d phase / d f; aligned at the
    merger, the merger is at t = 0. The derivative is the five-point central difference; with ``from_below``, the
    five-point difference of ``frequency`` and four below it, because a model's phase ends at the top of its band.
    Whoever cannot call :func:`time_until_merger` (an asynchronous model) takes the stencil :meth:`within` the model's
    band, evaluates :attr:`phase` of ``unshifted(parameters)`` on :attr:`frequencies` with :attr:`options`, under which
    nothing above the band is answered, and hands it to :meth:`seconds`.

    Raises
    ------
    InvalidFrequencies
        The frequency is not positive and finite.
    """

    frequency: float
    from_below: bool = False

    options = EvaluationOptions(alignment="merger", above_band="error", modes=((2, 2),))

    @classmethod
    def within(
        cls, description: ModelDescription, frequency: float, parameters: ParametersWithExtrinsic
    ) -> MergerStencil:
        """The stencil for one binary of a model that does not reach above the model's band.

        Raises
        ------
        InvalidFrequencies, InvalidParameters
            The frequency is not positive and finite; not one binary.
        """
        around = cls(frequency)
        mass = float(ParameterBatch.one(parameters)["total_mass"][0])
        inside = float(around.frequencies[-1]) * mass <= description.training_band[1] * description.reference_mass
        return around if inside else cls(frequency, from_below=True)

    def __post_init__(self) -> None:
        object.__setattr__(self, "frequency", float(as_frequencies([self.frequency])[0]))

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """The frequencies of the stencil in Hz: four around the one given, or five up to it."""
        return np.asarray(self.frequency * (1.0 + _STEP * np.array(self._rule[0])))

    @staticmethod
    def unshifted(parameters: ParametersWithExtrinsic) -> ParametersWithExtrinsic:
        """The same binary without its time and phase shift, which do not matter here and only cost digits.

        Raises
        ------
        InvalidParameters
            Not one binary.
        """
        one = ParameterBatch.one(parameters).row(0)
        return dataclasses.replace(one, time_shift=0.0, reference_phase=0.0)

    def slope(self, phase: NDArray[np.float64]) -> NDArray[np.float64]:
        """d phase / d f in radians per Hz, shape (...,), from the phase (radians) on the stencil, (..., n)."""
        weighted = [weight * phase[..., place] for place, weight in enumerate(self._rule[1])]
        return np.asarray(sum(weighted) / (12.0 * _STEP * self.frequency))

    def seconds(self, phase: NDArray[np.float64]) -> float:
        """The time until merger in seconds from the phase (radians) on the stencil."""
        return float(self.slope(phase) / (2.0 * np.pi))

    @property
    def _rule(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        return _UP_TO if self.from_below else _AROUND


def time_until_merger(model: WaveformModel, frequency: float, parameters: ParametersWithExtrinsic) -> float:
    """Seconds from the moment the signal passes ``frequency`` (Hz) to the merger; see :class:`MergerStencil`.

    Raises
    ------
    OutOfBand
        The frequency is above the model's band.
    """
    stencil = MergerStencil.within(model.description, frequency, parameters)
    answer = model.predict_amplitude_phase(stencil.frequencies, stencil.unshifted(parameters), options=stencil.options)
    return stencil.seconds(answer.phase)
