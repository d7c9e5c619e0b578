"""The time between a frequency and the merger, from the phase of any waveform model."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np

from bnserve_protocol._grids import as_frequencies
from bnserve_protocol._model import EvaluationOptions

if TYPE_CHECKING:
    from bnserve_protocol._model import WaveformModel
    from bnserve_protocol._parameters import ParametersWithExtrinsic

_STEP = 1e-3
"""Relative spacing of the stencil: truncation below 1e-9, rounding below a nanosecond above 1 Hz."""


def time_until_merger(model: WaveformModel, frequency: float, parameters: ParametersWithExtrinsic) -> float:
    """Seconds from the moment the signal passes ``frequency`` (Hz) to the merger.

    In the stationary-phase approximation the signal passes f at t(f) = -(1/2 pi) d phase / d f; aligned at the
    merger, the merger is at t = 0. The derivative is the five-point central difference.
    """
    centre = float(as_frequencies([frequency])[0])
    stencil = centre * (1.0 + _STEP * np.array([-2.0, -1.0, 1.0, 2.0]))
    unshifted = dataclasses.replace(parameters, time_shift=0.0, reference_phase=0.0)
    phase = model.predict_amplitude_phase(stencil, unshifted, options=EvaluationOptions(alignment="merger")).phase
    derivative = (phase[0] - 8.0 * phase[1] + 8.0 * phase[2] - phase[3]) / (12.0 * _STEP * centre)
    return float(derivative / (2.0 * np.pi))
