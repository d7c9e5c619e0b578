"""The time between a frequency and the merger, from the phase of any waveform model."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._grids import as_frequencies
from bnserve_protocol._model import EvaluationOptions
from bnserve_protocol._parameters import ParameterBatch

if TYPE_CHECKING:
    from bnserve_protocol._model import WaveformModel
    from bnserve_protocol._parameters import ParametersWithExtrinsic

_STEP = 1e-3
"""Relative spacing of the stencil: truncation below 1e-9, rounding below a nanosecond above 1 Hz."""


@dataclasses.dataclass(frozen=True, slots=True)
class MergerStencil:
    """The question to a model, and how to read its answer, for the time from ``frequency`` (Hz) to the merger.

    In the stationary-phase approximation the signal passes f at t(f) = -(1/2 pi) d phase / d f; aligned at the
    merger, the merger is at t = 0. The derivative is the five-point central difference. Whoever cannot call
    :func:`time_until_merger` (an asynchronous model) evaluates :attr:`phase` of ``unshifted(parameters)`` on
    :attr:`frequencies` with :attr:`options` and hands it to :meth:`seconds`.
    """

    frequency: float

    options = EvaluationOptions(alignment="merger")

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """The four frequencies of the stencil in Hz.

        Raises
        ------
        InvalidFrequencies
            The frequency is not positive and finite.
        """
        centre = float(as_frequencies([self.frequency])[0])
        return centre * (1.0 + _STEP * np.array([-2.0, -1.0, 1.0, 2.0]))

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

    def seconds(self, phase: NDArray[np.float64]) -> float:
        """The time until merger in seconds from the phase (radians) on the stencil."""
        derivative = (phase[0] - 8.0 * phase[1] + 8.0 * phase[2] - phase[3]) / (12.0 * _STEP * float(self.frequency))
        return float(derivative / (2.0 * np.pi))


def time_until_merger(model: WaveformModel, frequency: float, parameters: ParametersWithExtrinsic) -> float:
    """Seconds from the moment the signal passes ``frequency`` (Hz) to the merger; see :class:`MergerStencil`."""
    stencil = MergerStencil(frequency)
    answer = model.predict_amplitude_phase(stencil.frequencies, stencil.unshifted(parameters), options=stencil.options)
    return stencil.seconds(answer.phase)
