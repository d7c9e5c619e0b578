"""What the picture shows of one binary, from any waveform model: strain in time, its modes, time-frequency track."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic, WaveformModel, predict_time_domain

FloatArray: TypeAlias = NDArray[np.float64]
Mode: TypeAlias = tuple[int, int]

SAMPLING_RATE = 2.0**15
"""Hz; ten samples for every cycle at the end of the band."""
LOWEST = 80.0
"""Hz, from which on the strain is shown: some four seconds before the merger."""


@dataclass(frozen=True)
class Chirp:
    """One binary, its merger at t = 0."""

    parameters: ParametersWithExtrinsic
    times: FloatArray
    """Seconds."""
    strain: FloatArray
    """h_plus(t), dimensionless; of the shape of the times."""
    frequencies: FloatArray
    """Hz, from the beginning of the band to its end."""
    amplitudes: dict[Mode, FloatArray]
    """What each mode counts in abs(h_plus(f)), in 1/Hz, of the shape of the frequencies."""
    until_merger: FloatArray
    """Seconds until the merger when the (2, 2) mode passes the frequencies."""

    @property
    def amplitude(self) -> FloatArray:
        """That of the first mode, in 1/Hz."""
        return next(iter(self.amplitudes.values()))

    def seconds_from(self, frequency: float) -> float:
        """Time until the merger when the signal passes ``frequency`` (Hz)."""
        return float(np.interp(frequency, self.frequencies, self.until_merger))


def evaluate_chirp(
    model: WaveformModel, parameters: ParametersWithExtrinsic, modes: Sequence[Mode] | None = None
) -> Chirp:
    """Ask a model for everything that the picture shows of one binary.

    Parameters
    ----------
    model
        Local or remote.
    parameters
        Its ``time_shift`` counts as 0.
    modes
        Those that count; None for all that the model has.
    """
    options = EvaluationOptions(modes=None if modes is None else tuple(modes))
    centred = dataclasses.replace(parameters, time_shift=0.0)
    frequencies = np.geomspace(model.description.frequency_band[0], _end_of_band(model, centred), 4000)
    found = model.predict_modes(frequencies, centred, options=options)
    series = predict_time_domain(model, centred, sampling_rate=SAMPLING_RATE, f_min=LOWEST, options=options)
    return Chirp(
        parameters=centred,
        times=series.times,
        strain=series.plus,
        frequencies=frequencies,
        amplitudes=dict(zip(found.modes, np.abs(found.plus[0, :, None] * found.h[0]), strict=True)),
        until_merger=np.asarray(model.time_until_merger(frequencies, centred)),
    )


def _end_of_band(model: WaveformModel, parameters: ParametersWithExtrinsic) -> float:
    """Hz; above, the strain is zero."""
    description = model.description
    return description.training_band[1] * description.reference_mass / parameters.total_mass * (1.0 - 1e-9)
