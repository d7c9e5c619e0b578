"""What an error at a frequency weighs in the mismatch of the whole waveform, on average over a data set."""

from __future__ import annotations

import numpy as np

from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generators import FloatArray, mass_seconds
from bnserve_surrogate.training.data.modes import LEADING_POWERS
from bnserve_surrogate.training.data.noise import noise_curve, trapezoid_weights
from bnserve_surrogate.training.data.residuals import baseline_amplitude
from bnserve_surrogate.training.data.sampling import training_band
from bnserve_surrogate.training.reduction.metric import MismatchMetric, dense_grid, spline_matrix
from bnserve_surrogate.training.sections import TrainingConfiguration

_WAVEFORMS = 1024
"""Of which the weights are the average."""


def mean_carrier(dataset: ResidualDataset, configuration: TrainingConfiguration) -> tuple[FloatArray, FloatArray]:
    """A dense grid of M x, (J,), and the mean square of (2, 2)'s amplitude on it, (J,), each waveform of unit SNR."""
    mass = mass_seconds(configuration.ranges.reference_mass)
    mx = dense_grid(dataset.mf_amplitude)
    to_dense = spline_matrix(dataset.mf_amplitude, mx).T
    noise = noise_curve(configuration.reduction.noise)(mx / mass)
    seen = (mx >= training_band(configuration)[0] * mass) * trapezoid_weights(mx) / noise
    every = max(1, len(dataset) // _WAVEFORMS)
    squares = np.zeros(len(mx))
    rows = range(0, len(dataset), every)
    for row in rows:
        ratio = np.exp(dataset.log_amplitude_ratio[row] @ to_dense)
        square = (ratio * baseline_amplitude(dataset.theta[row], mx)) ** 2
        squares += square / (seen @ square)
    return mx, squares / len(rows)


def ratio_weights(
    mode: tuple[int, int], mx: FloatArray, square: FloatArray, configuration: TrainingConfiguration
) -> FloatArray:
    """What the square of an error of R weighs on :func:`mean_carrier`'s grid, (J,)."""
    mass, (low, high) = mass_seconds(configuration.ranges.reference_mass), training_band(configuration)
    f = 0.5 * mode[1] * mx / mass
    inside = (f >= low) & (f <= high)
    noise = noise_curve(configuration.reduction.noise)(np.clip(f, low, high))
    power = np.cbrt(np.pi * mx) ** (2 * LEADING_POWERS.get(mode, 0))
    return np.where(inside, square * power / noise, 0.0) * trapezoid_weights(mx) * 0.5 * mode[1]


def mismatch_metric(dataset: ResidualDataset, configuration: TrainingConfiguration) -> MismatchMetric:
    """The metric with the mean weights |h|^2 / S_n of the data set, at its nodes.

    The amplitude and m / 2 times the phase of (2, 2) are part of every mode: what an error does there is added.
    """
    mx, square = mean_carrier(dataset, configuration)
    weights = ratio_weights((2, 2), mx, square, configuration)
    for number, mode in enumerate(dataset.modes.modes):
        ratio = np.mean(np.abs(dataset.ratios[:, number]) ** 2, axis=0) @ spline_matrix(dataset.modes.mx, mx).T
        weights += (0.5 * mode[1]) ** 2 * np.maximum(ratio, 0.0) * ratio_weights(mode, mx, square, configuration)
    return MismatchMetric.from_dense(dataset.mf_amplitude, dataset.mf_phase, mx, weights)
