"""What the picture shows of one binary, from any waveform model: strain in time, amplitude, time-frequency track."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic, UniformGrid, WaveformModel

FloatArray: TypeAlias = NDArray[np.float64]

MERGER_AT_ZERO = EvaluationOptions(alignment="merger")
SEGMENT = 32.0
"""Seconds of the inverse transform: longer than the signal from the lower edge on, so that nothing wraps around."""
SAMPLING_RATE = 2.0**15
"""Hz; ten samples for every cycle at the end of the band."""
LOWER_EDGE = (40.0, 50.0)
"""Hz: the signal is faded in between, some 20 s before the merger; without it, the edge would ring."""


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
    amplitude: FloatArray
    """abs(h_plus(f)) in 1/Hz, of the shape of the frequencies."""
    until_merger: FloatArray
    """Seconds until the merger when the signal passes the frequencies, (1 / 2 pi) d phase / d f."""

    def seconds_from(self, frequency: float) -> float:
        """Time until the merger when the signal passes ``frequency`` (Hz)."""
        return float(np.interp(frequency, self.frequencies, self.until_merger))


def evaluate_chirp(model: WaveformModel, parameters: ParametersWithExtrinsic) -> Chirp:
    """Ask a model for everything that the picture shows of one binary.

    Parameters
    ----------
    model
        Local or remote.
    parameters
        Its ``time_shift`` counts as 0.
    """
    centred = dataclasses.replace(parameters, time_shift=0.0)
    frequencies = np.geomspace(model.description.frequency_band[0], _end_of_band(model, centred), 4000)
    amplitude, phase = model.predict_amplitude_phase(frequencies, centred, options=MERGER_AT_ZERO)
    plus = 0.5 * (1.0 + np.cos(parameters.inclination) ** 2)
    times, strain = strain_in_time(model, centred)
    return Chirp(
        parameters=centred,
        times=times,
        strain=strain,
        frequencies=frequencies,
        amplitude=plus * amplitude,
        until_merger=np.gradient(phase, frequencies, edge_order=2) / (2.0 * np.pi),
    )


def strain_in_time(model: WaveformModel, parameters: ParametersWithExtrinsic) -> tuple[FloatArray, FloatArray]:
    """Times in seconds and h_plus(t), the inverse of h(f) = integral of h(t) exp(-2 pi i f t) dt.

    The strain is real, so its spectrum at negative frequencies is the conjugate of that at positive ones, which is
    what ``irfft`` assumes. The segment ends an eighth of its length after the merger.
    """
    samples = int(SEGMENT * SAMPLING_RATE)
    grid = UniformGrid(f_min=LOWER_EDGE[0], f_max=_end_of_band(model, parameters), delta_f=1.0 / SEGMENT)
    spectrum = np.zeros(samples // 2 + 1, dtype=np.complex128)
    plus = model.predict(grid, parameters, options=MERGER_AT_ZERO).plus
    first = int(LOWER_EDGE[0] * SEGMENT)
    spectrum[first : first + len(grid)] = plus * _fade_in(grid.frequencies())
    after = samples // 8
    strain = np.roll(np.fft.irfft(spectrum, samples) * SAMPLING_RATE, -after)
    return (np.arange(samples) + after - samples) / SAMPLING_RATE, strain


def _end_of_band(model: WaveformModel, parameters: ParametersWithExtrinsic) -> float:
    """Hz; above, the strain is zero."""
    description = model.description
    return description.training_band[1] * description.reference_mass / parameters.total_mass * (1.0 - 1e-9)


def _fade_in(frequencies: FloatArray) -> FloatArray:
    """From 0 to 1 across the lower edge, as half a cosine."""
    position = np.clip((frequencies - LOWER_EDGE[0]) / (LOWER_EDGE[1] - LOWER_EDGE[0]), 0.0, 1.0)
    return 0.5 - 0.5 * np.cos(np.pi * position)
