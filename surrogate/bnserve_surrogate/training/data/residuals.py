"""Residuals of a waveform to the post-Newtonian baseline, and the linear trend of the phase that carries no physics."""

from __future__ import annotations

import hashlib
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import (
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    phase_coefficients,
    taylorf2_amplitude,
    taylorf2_phase,
)

FloatArray: TypeAlias = NDArray[np.float64]

REFERENCE_MASS = 2.8
"""Total mass in solar masses at which frequencies in Hz are quoted during training."""


def mass_seconds(total_mass: float = REFERENCE_MASS) -> float:
    """G M / c^3 in seconds for a total mass in solar masses: M f = f in Hz times this."""
    return total_mass * SOLAR_MASS_SECONDS


_PROBES = np.array([[1.1, 0.02, -0.03, 300.0, 500.0], [2.7, -0.4, 0.45, 6.0, 4500.0]])
FLATTENING_MF = 40.0 * mass_seconds()
"""Upper end of the interval of the average slope, 40 Hz at 2.8 solar masses: the baseline still holds there."""
_SIGNIFICANT_DIGITS = 9
"""Changes of the formulae show; the last bits of another machine's logarithm do not."""


def baseline_phase(theta: FloatArray, mf: FloatArray) -> FloatArray:
    """TaylorF2 phase of one binary ``theta`` (5,) at ``mf`` (n,), in radians, (n,)."""
    return taylorf2_phase(mf, *theta[:, None])[0]


def baseline_amplitude(theta: FloatArray, mf: FloatArray) -> FloatArray:
    """Frozen TaylorF2 amplitude of one binary ``theta`` (5,) at ``mf`` (n,), (n,)."""
    return taylorf2_amplitude(mf, *theta[:3, None])[0]


def merger_phase(theta: FloatArray, mf: float) -> FloatArray:
    """Psi - f dPsi/df of the baseline at ``mf`` for parameters (N, 5), in radians, (N,).

    It is the phase of the baseline's signal in time when it passes ``mf``, up to the sign. A generator whose signal has
    phase zero there has it for a constant that varies by 1e5 radians over the box; without it a phase shift of hundreds
    remains, which is learnt to 1e-4.
    """
    series = np.empty((PHASE_LOG_POWERS, PHASE_POWERS, len(theta)))
    phase_coefficients(*theta.T, series)
    v = np.cbrt(np.pi * mf)
    log_v = np.log(v)
    powers = np.arange(PHASE_POWERS)[:, None] - 5.0
    plain = series[0] + log_v * (series[1] + log_v * series[2])
    slope = powers * plain + series[1] + 2.0 * log_v * series[2]
    return np.asarray((v**powers * (plain - slope / 3.0)).sum(axis=0))


def baseline_fingerprint(mf: FloatArray) -> str:
    """A digest of what the baseline gives for two binaries at ``mf``: residuals to another baseline are other data."""
    samples = mf[:: max(1, mf.size // 16)]
    values = np.concatenate(
        [part for theta in _PROBES for part in (baseline_phase(theta, samples), baseline_amplitude(theta, samples))]
    )
    text = " ".join(f"{value:.{_SIGNIFICANT_DIGITS}g}" for value in values)
    return hashlib.sha256(text.encode()).hexdigest()


def log_amplitude_ratio(theta: FloatArray, mf: FloatArray, amplitude: FloatArray) -> FloatArray:
    """log(amplitude / baseline amplitude) of one waveform, (n,)."""
    return np.log(amplitude / baseline_amplitude(theta, mf))


def phase_difference(theta: FloatArray, mf: FloatArray, psi: FloatArray) -> FloatArray:
    """psi less the baseline's phase, (n,) in radians, linear trend included."""
    return psi - baseline_phase(theta, mf)


class FlattenedPhase(NamedTuple):
    """Phase residuals (N, n) in radians without their linear trends, which are kept.

    ``residual + constant + 2 pi mf time_shift`` is what there was: ``constant`` (N,) in radians, ``time_shift`` (N,) in
    units of the total mass. A positive time shift delays the signal: psi grows by 2 pi f t, h is multiplied by exp(-2
    pi i f t). The residual is zero at the first frequency and at the upper end of the interval.
    """

    residual: FloatArray
    time_shift: FloatArray
    constant: FloatArray


def flatten_phase(mf: FloatArray, psi_residual: FloatArray) -> FlattenedPhase:
    """Remove from every row the straight line through its first sample and its value at :data:`FLATTENING_MF`.

    Parameters
    ----------
    mf
        (n,) increasing dimensionless frequencies; the nearest above the first is used.
    psi_residual
        (N, n) radians; not changed.
    """
    upper = max(1, int(np.argmin(np.abs(mf - FLATTENING_MF))))
    rows = np.atleast_2d(psi_residual)
    slope = (rows[:, upper] - rows[:, 0]) / (mf[upper] - mf[0])
    constant = rows[:, 0] - slope * mf[0]
    return FlattenedPhase(rows - constant[:, None] - slope[:, None] * mf, slope / (2.0 * np.pi), constant)
