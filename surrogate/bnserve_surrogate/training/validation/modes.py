"""How far each mode beside (2, 2) is from the generator's, in the unit of the whole waveform's mismatch."""

from __future__ import annotations

import numpy as np

from bnserve_protocol import MEGAPARSEC_SECONDS, EvaluationOptions, ParameterBatch, WaveformModel
from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generators import FloatArray, mass_seconds
from bnserve_surrogate.training.data.modes import LEADING_POWERS
from bnserve_surrogate.training.data.noise import noise_curve, trapezoid_weights
from bnserve_surrogate.training.validation.mismatch import Mismatch


def mode_errors(
    model: WaveformModel,
    dataset: ResidualDataset,
    batch: ParameterBatch,
    truth: tuple[FloatArray, FloatArray],
    aligned: Mismatch,
    band: tuple[float, float],
    noise: str,
) -> dict[str, FloatArray]:
    """Half the noise-weighted square of a mode's error over the square of (2, 2), both face-on, (N,) for each mode.

    Time and orbital phase are those at which (2, 2) agrees best, so that these numbers, weighted with the squares of
    the harmonics at an inclination, and (2, 2)'s mismatch add up to a bound on that of the whole waveform.

    Parameters
    ----------
    model
        Which has the modes of the data set.
    dataset
        Fresh waveforms.
    batch
        Their parameters, face-on, at 1 Mpc and one total mass.
    truth
        Logarithm of the amplitude, in units of nu M^2, and psi of (2, 2) at the data set's nodes, (N, n) each.
    aligned
        Shifts of time and phase by which (2, 2) is best.
    band
        Hz, of the integral.
    noise
        Name of a noise curve.
    """
    if not dataset.modes.modes:
        return {}
    mx, total_mass = dataset.modes.mx, float(batch["total_mass"][0])
    x = mx / mass_seconds(total_mass)
    size, psi = np.exp(truth[0]) * strain_scale(batch), truth[1]
    square = (size**2 * _weights(x, band, noise)).sum(axis=1)
    errors = {}
    for number, mode in enumerate(dataset.modes.modes):
        half = 0.5 * mode[1]
        f = half * x
        theirs = size * np.cbrt(np.pi * mx) ** LEADING_POWERS[mode] * dataset.ratios[:, number]
        own = EvaluationOptions(alignment="merger", modes=(mode,))
        # Without the carrier's phase: what is left of both is smooth.
        line = half * (psi + aligned.phase[:, None] + 2.0 * np.pi * np.multiply.outer(aligned.time, x))
        ours = model.predict_modes(f, batch, options=own).h[:, 0] * np.exp(1j * line)
        errors[f"{mode[0]}{mode[1]}"] = (
            0.5 * (np.abs(ours - theirs) ** 2 * _weights(f, band, noise)).sum(axis=1) / square
        )
    return errors


def _weights(f: FloatArray, band: tuple[float, float], noise: str) -> FloatArray:
    inside = (f >= band[0] * (1.0 - 1e-9)) & (f <= band[1] * (1.0 + 1e-9))
    return np.where(inside, trapezoid_weights(f) / noise_curve(noise)(np.clip(f, *band)), 0.0)


def strain_scale(batch: ParameterBatch) -> FloatArray:
    """Strain in 1/Hz of a face-on amplitude of one, (N, 1), for binaries at 1 Mpc of one total mass."""
    q, mass = batch["mass_ratio"], mass_seconds(float(batch["total_mass"][0]))
    return np.asarray((q / (1.0 + q) ** 2 * mass**2 / MEGAPARSEC_SECONDS)[:, None])
