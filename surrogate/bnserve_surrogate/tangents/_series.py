"""Derivatives of the post-Newtonian series of one binary.

By complex steps: a function that is made of additions, multiplications and divisions is evaluated at x + i h with
h = 1e-30, and its imaginary part over h is the derivative, to rounding (Squire, Trapp 1998, SIAM Review 40, 110). So
there is one source of the physics, and no step to choose.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.baseline import (
    AMPLITUDE_POWERS,
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    add_point_mass_phase,
    add_self_spin_phase,
    add_spin_orbit_phase,
    add_spin_spin_phase,
    add_tidal_phase,
    amplitude_coefficients,
    quadrupole_fit,
    spin_induced_quadrupole,
)
from bnserve_surrogate.kernel._layout import Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_in
from bnserve_surrogate.kernel._series import fill_phase_powers, legendre
from bnserve_surrogate.tangents._layout import INTRINSIC, WORK

Floats = NDArray[np.float64]

STEP = 1e-30
PLAIN, LOGARITHMIC = AMPLITUDE_POWERS, AMPLITUDE_POWERS + PHASE_POWERS
"""Places of the phase's coefficients in a series; as :func:`~bnserve_surrogate.kernel._series.fill_series` has them."""
CONSTANT, SLOPE, FROZEN = LOGARITHMIC + 8, LOGARITHMIC + 9, LOGARITHMIC + 10


@njit(**JIT_OPTIONS)
def _phase(p: int, q: Any, chi_1: Any, chi_2: Any, lambdas: Any, quadrupoles: Any, out: Any) -> None:
    """:func:`~bnserve_surrogate.baseline.phase_coefficients` at a complex place, its quadrupoles given: of what changes
    with parameter p alone, or, with the mass ratio, all."""
    x_1 = q / (1.0 + q)
    x_2 = 1.0 / (1.0 + q)
    nu = x_1 * x_2
    for log_power in range(PHASE_LOG_POWERS):
        for power in range(PHASE_POWERS):
            out[log_power, power] = 0.0
    everything = p == Column.MASS_RATIO
    if everything:
        add_point_mass_phase(nu, out)
    if everything or p == Column.CHI_1:
        add_spin_orbit_phase(x_1, chi_1, out)
    if everything or p == Column.CHI_2:
        add_spin_orbit_phase(x_2, chi_2, out)
    if everything or p in (Column.CHI_1, Column.LAMBDA_1):
        add_self_spin_phase(x_1, chi_1, quadrupoles[0], out)
    if everything or p in (Column.CHI_2, Column.LAMBDA_2):
        add_self_spin_phase(x_2, chi_2, quadrupoles[1], out)
    if everything or p in (Column.CHI_1, Column.CHI_2):
        add_spin_spin_phase(x_1, chi_1, chi_2, out)
    if everything or p == Column.LAMBDA_1:
        add_tidal_phase(x_1, lambdas[0], out)
    if everything or p == Column.LAMBDA_2:
        add_tidal_phase(x_2, lambdas[1], out)
    leading = 3.0 / (128.0 * nu)
    for log_power in range(PHASE_LOG_POWERS):
        for power in range(PHASE_POWERS):
            out[log_power, power] *= leading


@njit(**JIT_OPTIONS)
def _quadrupole_slope(tidal_deformability: float) -> float:
    """d C_Q / d Lambda; zero for a black hole."""
    if tidal_deformability <= 1.0:
        return 0.0
    y = complex(np.log(tidal_deformability), STEP / tidal_deformability)
    return spin_induced_quadrupole(tidal_deformability) * (quadrupole_fit(y).imag / STEP)


@njit(**JIT_OPTIONS)
def fill_phase_tangents(row: Floats, room: Any, out: Floats) -> None:
    """The derivatives of a phase's coefficients, ``(5, 3, 16)``; ``room`` is complex, ``(3, 16)``."""
    lambda_1, lambda_2 = row[Column.LAMBDA_1], row[Column.LAMBDA_2]
    quadrupoles = (spin_induced_quadrupole(lambda_1), spin_induced_quadrupole(lambda_2))
    slopes = (_quadrupole_slope(lambda_1), _quadrupole_slope(lambda_2))
    for p in range(INTRINSIC):
        q = complex(row[Column.MASS_RATIO], STEP if p == Column.MASS_RATIO else 0.0)
        chi_1 = complex(row[Column.CHI_1], STEP if p == Column.CHI_1 else 0.0)
        chi_2 = complex(row[Column.CHI_2], STEP if p == Column.CHI_2 else 0.0)
        one = STEP if p == Column.LAMBDA_1 else 0.0
        other = STEP if p == Column.LAMBDA_2 else 0.0
        tides = (complex(lambda_1, one), complex(lambda_2, other))
        bulges = (complex(quadrupoles[0], one * slopes[0]), complex(quadrupoles[1], other * slopes[1]))
        _phase(p, q, chi_1, chi_2, tides, bulges, room)
        for log_power in range(PHASE_LOG_POWERS):
            for power in range(PHASE_POWERS):
                out[WORK * p + PHASE_POWERS * log_power + power] = room[log_power, power].imag / STEP


@njit(**JIT_OPTIONS)
def fill_amplitude_tangents(row: Floats, room: Any, out: Floats) -> None:
    """The derivatives of an amplitude's coefficients over the first one, ``(5, 8)``; ``room`` is complex, ``(8,)``.

    The first one goes as the square root of the symmetric mass ratio.
    """
    q = row[Column.MASS_RATIO]
    for p in range(INTRINSIC):
        ratio = complex(q, STEP if p == Column.MASS_RATIO else 0.0)
        chi_1 = complex(row[Column.CHI_1], STEP if p == Column.CHI_1 else 0.0)
        chi_2 = complex(row[Column.CHI_2], STEP if p == Column.CHI_2 else 0.0)
        amplitude_coefficients(ratio, chi_1, chi_2, room)
        along = 0.5 * log_nu_slope(q) if p == Column.MASS_RATIO else 0.0
        for k in range(AMPLITUDE_POWERS):
            out[AMPLITUDE_POWERS * p + k] = room[k].imag / STEP + along * room[k].real


@njit(inline="always")
def log_nu_slope(q: float) -> float:
    """d ln nu / d q: nothing at equal masses, to the last bit."""
    return (1.0 - q) / (q * (1.0 + q))


@njit(**JIT_OPTIONS)
def fill_tangent_series(
    p: int, row: Floats, unit: float, band: Floats, gauge: Floats, alignment: int, value: Floats, amplitude: Floats,
    phase: Floats, out: Floats,
) -> None:  # fmt: skip
    """The series of the derivative with respect to parameter p, as ``value`` is that of the waveform.

    ``amplitude`` and ``phase`` are what the functions above wrote; ``gauge`` the derivatives of what both alignments
    take off.
    """
    scale, power = (np.pi * unit) ** (1.0 / 3.0), value[0]
    for k in range(AMPLITUDE_POWERS):
        out[k] = power * amplitude[AMPLITUDE_POWERS * p + k]
        power *= scale
    work = floats_in(phase, WORK * p, (PHASE_LOG_POWERS, PHASE_POWERS))
    fill_phase_powers(unit, work, out[PLAIN:], out[LOGARITHMIC:])
    out[CONSTANT] = 0.0 - gauge[2 * alignment]
    if alignment == 1 and band[2] > 0.0:
        out[CONSTANT] += legendre(band[2], work)
    out[SLOPE] = 0.0 - gauge[2 * alignment + 1] * unit
    out[FROZEN] = value[FROZEN] * log_nu_slope(row[Column.MASS_RATIO]) if p == Column.MASS_RATIO else 0.0


@njit(**JIT_OPTIONS)
def fill_slope_series(series: Floats, slope: float, times: float, out: Floats) -> None:
    """The series of f d/df of a phase, times a factor; ``slope`` is that of its linear part."""
    for k in range(PHASE_POWERS):
        out[PLAIN + k] = times * series[PLAIN + k] * ((k - 5) / 3.0)
        if 5 <= k <= 11:
            own = series[LOGARITHMIC + k - 5]
            out[PLAIN + k] += times * own
            out[LOGARITHMIC + k - 5] = times * own * ((k - 5) / 3.0)
    out[LOGARITHMIC + 3] += times * 2.0 * series[LOGARITHMIC + 7]
    out[LOGARITHMIC + 7] = times * series[LOGARITHMIC + 7]
    out[CONSTANT], out[SLOPE] = 0.0, times * slope


@njit(**JIT_OPTIONS)
def fill_mass_series(row: Floats, unit: float, gauge: Floats, alignment: int, value: Floats, out: Floats) -> None:
    """The series of the derivative with respect to the total mass, on which the amplitude depends as M^2 times a
    function of M f, and the phase, but for the shift in time, as a function of M f."""
    over_mass = 1.0 / row[Column.TOTAL_MASS]
    for k in range(AMPLITUDE_POWERS):
        out[k] = value[k] * ((k / 3.0 + 5.0 / 6.0) * over_mass)
    fill_slope_series(value, 0.0 - gauge[2 * alignment + 1] * unit, over_mass, out)
    out[FROZEN] = 2.0 * over_mass * value[FROZEN]
