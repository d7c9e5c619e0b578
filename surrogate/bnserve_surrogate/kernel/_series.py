"""The post-Newtonian series of one binary, in the powers in which the kernel evaluates it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import (
    AMPLITUDE_POWERS,
    FROZEN_AMPLITUDE,
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    amplitude_coefficients,
    amplitude_prefactor,
    mass_scale,
    phase_coefficients,
)
from bnserve_surrogate.kernel._layout import Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_in

Floats = NDArray[np.float64]

_STRAIN = SOLAR_MASS_SECONDS**2 / MEGAPARSEC_SECONDS
"""(G Msun / c^3)^2 over one Mpc / c: strain in 1/Hz of a face-on source with nu A = 1 at one solar mass and one Mpc."""


@njit(**JIT_OPTIONS)
def legendre(mf: float, series: Any) -> float:
    """Psi - f dPsi/df of the baseline: what a phase that starts from zero at ``mf`` has for a constant.

    In the stationary-phase approximation Psi(f) = 2 pi f t(f) - phi(t(f)), where 2 pi t(f) = dPsi/df, so the
    signal's phase phi is f dPsi/df - Psi.
    """
    v = (np.pi * mf) ** (1.0 / 3.0)
    log_v = np.log(v)
    result = 0.0
    power = v**-5
    for k in range(PHASE_POWERS):
        plain = series[0, k] + log_v * (series[1, k] + log_v * series[2, k])
        slope = (k - 5) * plain + series[1, k] + 2.0 * log_v * series[2, k]
        result += power * (plain - slope / 3.0)
        power *= v
    return result


@njit(**JIT_OPTIONS)
def fill_phase_powers(unit: float, series: Any, plain: Floats, logarithmic: Floats) -> None:
    """A phase's coefficients, ``(3, 16)``, in powers of v and log v, as those of x^(1/3) and log x: 16 and 8."""
    scale = (np.pi * unit) ** (1.0 / 3.0)
    log_scale = np.log(scale)
    power = 1.0 / (scale * scale * scale * scale * scale)
    for k in range(PHASE_POWERS):
        plain[k] = power * (series[0, k] + log_scale * (series[1, k] + log_scale * series[2, k]))
        if 5 <= k <= 11:
            logarithmic[k - 5] = power * (series[1, k] + 2.0 * log_scale * series[2, k]) / 3.0
        power *= scale
    logarithmic[7] = np.pi * unit * series[2, 8] / 9.0


@njit(**JIT_OPTIONS)
def fill_series(
    row: Floats, unit: float, band: Floats, gauge: Floats, alignment: int, room: Floats, out: Floats
) -> float:
    """Coefficients of the baseline in powers of x^(1/3) and log x for one row; returns the frozen amplitude.

    x times ``unit`` is M f: with the total mass in seconds x is f in Hz, with one it is M f.
    ``out``: 8 of the amplitude, 16 and 10 of the phase (see :func:`amplitudes` and :func:`phases`).
    """
    mass_ratio, chi_1, chi_2 = row[Column.MASS_RATIO], row[Column.CHI_1], row[Column.CHI_2]
    total_mass = row[Column.TOTAL_MASS]
    work = floats_in(room, 0, (PHASE_LOG_POWERS, PHASE_POWERS))
    scale = (np.pi * unit) ** (1.0 / 3.0)
    strain = _STRAIN * mass_scale(mass_ratio) * (total_mass * total_mass) / row[Column.DISTANCE]
    amplitude_coefficients(mass_ratio, chi_1, chi_2, out)
    power = strain * amplitude_prefactor(mass_ratio) / (scale * scale * scale * np.sqrt(scale))
    for k in range(AMPLITUDE_POWERS):
        out[k] *= power
        power *= scale
    phase_coefficients(mass_ratio, chi_1, chi_2, row[Column.LAMBDA_1], row[Column.LAMBDA_2], work)
    logarithmic = out[AMPLITUDE_POWERS + PHASE_POWERS :]
    fill_phase_powers(unit, work, out[AMPLITUDE_POWERS:], logarithmic)
    logarithmic[8] = row[Column.REFERENCE_PHASE] - gauge[2 * alignment]
    if alignment == 1 and band[2] > 0.0:
        logarithmic[8] += legendre(band[2], work)
    logarithmic[9] = (
        2.0 * np.pi * row[Column.TIME_SHIFT] * (unit / (total_mass * SOLAR_MASS_SECONDS))
        - gauge[2 * alignment + 1] * unit
    )
    return strain * FROZEN_AMPLITUDE
