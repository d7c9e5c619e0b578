"""Residuals of a waveform to the post-Newtonian baseline, and the linear trend of the phase that carries no physics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bnserve_surrogate.training.data.baseline import baseline_amplitude, baseline_phase
from bnserve_surrogate.training.data.generators import REFERENCE_MASS, FloatArray, mass_seconds

FLATTENING_HZ = 40.0
"""Default upper end of the interval of the average slope, at the reference mass: the baseline still holds there."""


def log_amplitude_ratio(theta: FloatArray, mf: FloatArray, amplitude: FloatArray) -> FloatArray:
    """log(amplitude / baseline amplitude) of one waveform, (n,)."""
    return np.log(amplitude / baseline_amplitude(theta, mf))


def phase_difference(theta: FloatArray, mf: FloatArray, psi: FloatArray) -> FloatArray:
    """psi less the baseline's phase, (n,) in radians, linear trend included."""
    return psi - baseline_phase(theta, mf)


@dataclass(frozen=True)
class FlattenedPhase:
    """Phase residuals without their linear trends, which are kept.

    ``residual + constant + 2 pi mf time_shift`` is what there was. A positive time shift delays the signal: psi
    grows by 2 pi f t, h is multiplied by exp(-2 pi i f t).

    Parameters
    ----------
    residual
        (N, n) radians; zero at the first frequency and at the upper end of the interval.
    time_shift
        (N,) in units of the total mass: average slope of the residual over 2 pi.
    constant
        (N,) radians: the trend at zero frequency.
    """

    residual: FloatArray
    time_shift: FloatArray
    constant: FloatArray

    def time_shift_seconds(self, total_mass: float = REFERENCE_MASS) -> FloatArray:
        """The time shifts in seconds for binaries of ``total_mass`` solar masses, (N,)."""
        return self.time_shift * mass_seconds(total_mass)

    def restored(self, mf: FloatArray) -> FloatArray:
        """The residuals with their trends, (N, n)."""
        return self.residual + self.constant[:, None] + 2.0 * np.pi * self.time_shift[:, None] * mf


def flatten_phase(mf: FloatArray, psi_residual: FloatArray, mf_upper: float | None = None) -> FlattenedPhase:
    """Remove from every row the straight line through its first sample and its value at ``mf_upper``.

    Parameters
    ----------
    mf
        (n,) increasing dimensionless frequencies.
    psi_residual
        (N, n) radians; not changed.
    mf_upper
        Upper end of the interval of the average slope; its nearest sample above the first is used. By default 40 Hz at
        the reference mass.
    """
    wanted = FLATTENING_HZ * mass_seconds() if mf_upper is None else mf_upper
    upper = max(1, int(np.argmin(np.abs(mf - wanted))))
    rows = np.atleast_2d(psi_residual)
    slope = (rows[:, upper] - rows[:, 0]) / (mf[upper] - mf[0])
    constant = rows[:, 0] - slope * mf[0]
    return FlattenedPhase(rows - constant[:, None] - slope[:, None] * mf, slope / (2.0 * np.pi), constant)
