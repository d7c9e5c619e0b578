"""Post-Newtonian equations of precessing spins on quasi-circular orbits, averaged over an orbit.

    Omega_1 = (a_5 v^5 + a_7 v^7 + a_9 v^9) L + v^6 / 2 (S_2 - 3 (S_2 . L) L) - 3 / 2 v^6 kappa_1 X_2 / X_1 (S_1 . L) L

where L is the direction of the orbital angular momentum, v^3 = M omega, spins are in units of M^2 and kappa is the
quadrupole that a spin induces, 1 for black holes. Spin-orbit terms: Bohe, Marsat, Faye, Blanchet 2013
(arXiv:1212.5520); spin-spin: Racine 2008 (arXiv:0803.1820). L follows from the conservation of J on this
time scale, with 1PN, 2PN and the spins' share of it: Akcay, Gamba, Bernuzzi 2021 (arXiv:2005.05338), eqs. (4) and (7).
d omega / dt is TaylorT4's to 3.5PN with the leading tides: Chatziioannou, Klein, Yunes, Cornish 2013 (arXiv:1307.4418),
appendix A, and Damour, Nagar, Villain 2012 (arXiv:1203.4352). These are TEOBResumS's equations; there, kappa is 1.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import spin_induced_quadrupole
from bnserve_surrogate.kernel._layout import Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.precession._layout import BEND, LANES, RADIANS, Constant, State

Floats = NDArray[np.float64]

_PI = np.pi
_GAMMA = 0.5772156649015329
LOG_TERM = -1712.0 / 315.0
"""Of log omega in d omega / dt at 3PN; all others are constants of a binary."""


@njit(**JIT_OPTIONS)
def fill_constants(row: Floats, in_plane: Floats, reference: float, c: Floats, state: Floats) -> None:
    """One binary's lane of the constants and of the initial state; both views begin at the lane."""
    q = row[Column.MASS_RATIO]
    x1 = q / (1.0 + q)
    x2 = 1.0 - x1
    _fill_rates(x1, x2, row, c)
    _fill_angular_momentum(x1, x2, c)
    s1, s2 = x1 * x1, x2 * x2
    # x points to the observer's meridian, which is pi / 2 - phi_ref from the line between the stars.
    turn = 0.5 * row[Column.REFERENCE_PHASE]
    sine, cosine = np.sin(turn), np.cos(turn)
    state[State.X1 * LANES] = s1 * (in_plane[1] * cosine + in_plane[0] * sine)
    state[State.Y1 * LANES] = s1 * (in_plane[1] * sine - in_plane[0] * cosine)
    state[State.Z1 * LANES] = s1 * row[Column.CHI_1]
    state[State.X2 * LANES] = s2 * (in_plane[3] * cosine + in_plane[2] * sine)
    state[State.Y2 * LANES] = s2 * (in_plane[3] * sine - in_plane[2] * cosine)
    state[State.Z2 * LANES] = s2 * row[Column.CHI_2]
    half = 0.5 * row[Column.INCLINATION]
    state[State.A_RE * LANES], state[State.A_IM * LANES] = np.cos(half), 0.0
    state[State.B_RE * LANES], state[State.B_IM * LANES] = np.sin(half), 0.0
    _fill_flux(x1, x2, c)
    _fill_spin_flux(x1, x2, row, state, c)
    origin = 1.0 / (_PI * row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS * reference)
    scale = step_scale(q)
    c[Constant.SCALE * LANES], c[Constant.ORIGIN * LANES] = scale, origin
    c[Constant.FIRST * LANES] = place_of(origin, scale)


@njit(**JIT_OPTIONS)
def step_scale(q: float) -> float:
    """1 / omega in a step far from the merger: RADIANS of the precession of the lighter star, which is faster."""
    return RADIANS / (5.0 / 96.0 * (2.0 + 1.5 * q))


@njit(inline="always")
def place_of(y: float, scale: float) -> float:
    """The step at which 1 / omega is ``y``: the inverse of y = scale s^2 / (s + BEND)."""
    return (y + np.sqrt(y * (y + (4.0 * BEND) * scale))) / (2.0 * scale)


@njit(**JIT_OPTIONS)
def _fill_rates(x1: float, x2: float, row: Floats, c: Floats) -> None:
    """Spin precession and its time scale."""
    nu, delta = x1 * x2, x1 - x2
    common_7, odd_7 = 0.5625 + nu * (1.25 - nu / 24.0), -0.5625 + 0.625 * nu
    common_9 = 0.84375 + nu * (0.1875 - nu * (3.28125 + nu / 48.0))
    odd_9 = -0.84375 + nu * (4.875 - 0.15625 * nu)
    c[Constant.RATE_1 * LANES], c[Constant.RATE_2 * LANES] = 2.0 * nu + 1.5 * x2 * x2, 2.0 * nu + 1.5 * x1 * x1
    c[Constant.RATE_1_NLO * LANES] = common_7 + delta * odd_7
    c[Constant.RATE_2_NLO * LANES] = common_7 - delta * odd_7
    c[Constant.RATE_1_NNLO * LANES] = common_9 + delta * odd_9
    c[Constant.RATE_2_NNLO * LANES] = common_9 - delta * odd_9
    c[Constant.SELF_1 * LANES] = spin_induced_quadrupole(row[Column.LAMBDA_1]) * x2 / x1
    c[Constant.SELF_2 * LANES] = spin_induced_quadrupole(row[Column.LAMBDA_2]) * x1 / x2
    c[Constant.TIME * LANES] = 5.0 / (96.0 * nu)


@njit(**JIT_OPTIONS)
def _fill_angular_momentum(x1: float, x2: float, c: Floats) -> None:
    """L = nu / v (L (1 + L_2 v^2 + L_4 v^4) + v^3 (spin terms)), of a unit vector L."""
    nu = x1 * x2
    c[Constant.NU * LANES] = nu
    c[Constant.L_2 * LANES] = 1.5 + nu / 6.0
    c[Constant.L_4 * LANES] = 3.375 + nu * (nu / 24.0 - 2.375)
    c[Constant.L_SPIN_1 * LANES], c[Constant.L_SPIN_2 * LANES] = -0.25 * (3.0 + 1.0 / x1), -0.25 * (3.0 + 1.0 / x2)
    c[Constant.L_ALONG_1 * LANES] = -(1.0 + 27.0 / x1) / 12.0
    c[Constant.L_ALONG_2 * LANES] = -(1.0 + 27.0 / x2) / 12.0


@njit(**JIT_OPTIONS)
def _fill_flux(x1: float, x2: float, c: Floats) -> None:
    """(M^2 d omega / dt) / (96 / 5 nu v^11) without spins and tides."""
    nu = x1 * x2
    c[Constant.FLUX_2 * LANES] = -743.0 / 336.0 - 2.75 * nu
    c[Constant.FLUX_3 * LANES] = 4.0 * _PI
    c[Constant.FLUX_4 * LANES] = 34103.0 / 18144.0 + nu * (13661.0 / 2016.0 + 59.0 / 18.0 * nu)
    c[Constant.FLUX_5 * LANES] = -_PI * (4159.0 / 672.0 + 189.0 / 8.0 * nu)
    constant = 16447322263.0 / 139708800.0 + 16.0 / 3.0 * _PI * _PI - 1712.0 / 105.0 * (_GAMMA + np.log(4.0))
    linear = 451.0 / 48.0 * _PI * _PI - 56198689.0 / 217728.0
    c[Constant.FLUX_6 * LANES] = constant + nu * (linear + nu * (541.0 / 896.0 - 5605.0 / 2592.0 * nu))
    c[Constant.FLUX_7 * LANES] = _PI * (-4415.0 / 4032.0 + nu * (358675.0 / 6048.0 + 91495.0 / 1512.0 * nu))


@njit(**JIT_OPTIONS)
def _fill_spin_flux(x1: float, x2: float, row: Floats, state: Floats, c: Floats) -> None:
    """What spins and tides add: spin-orbit to 3.5PN, spin-spin at 2PN with the induced quadrupoles."""
    nu = x1 * x2
    kappa_1, kappa_2 = c[Constant.SELF_1 * LANES] * x1 / x2, c[Constant.SELF_2 * LANES] * x2 / x1
    nlo, nlo_other = 31319.0 / 1008.0 - 1159.0 / 24.0 * nu, 809.0 / 84.0 - 281.0 / 8.0 * nu
    nnlo = 130325.0 / 756.0 + nu * (100019.0 / 864.0 * nu - 796069.0 / 2016.0)
    nnlo_other = 1195759.0 / 18144.0 + nu * (2903.0 / 32.0 * nu - 257023.0 / 1008.0)
    for star in range(2):
        other = x2 / x1 if star == 0 else x1 / x2
        c[(Constant.FLUX_3_1 + 4 * star) * LANES] = -(113.0 / 12.0 + 25.0 / 4.0 * other)
        c[(Constant.FLUX_5_1 + 4 * star) * LANES] = -(nlo + nlo_other * other)
        c[(Constant.FLUX_6_1 + 4 * star) * LANES] = -_PI * (37.5 + 151.0 / 6.0 * other)
        c[(Constant.FLUX_7_1 + 4 * star) * LANES] = -(nnlo + nnlo_other * other)
    c[Constant.SPIN_SPIN * LANES], c[Constant.SPIN_SPIN_ALONG * LANES] = -247.0 / (48.0 * nu), 721.0 / (48.0 * nu)
    c[Constant.SQUARE_ALONG_1 * LANES] = (7.5 * kappa_1 - 1.0 / 96.0) / (x1 * x1)
    c[Constant.SQUARE_ALONG_2 * LANES] = (7.5 * kappa_2 - 1.0 / 96.0) / (x2 * x2)
    square_1 = state[State.X1 * LANES] ** 2 + state[State.Y1 * LANES] ** 2 + state[State.Z1 * LANES] ** 2
    square_2 = state[State.X2 * LANES] ** 2 + state[State.Y2 * LANES] ** 2 + state[State.Z2 * LANES] ** 2
    c[Constant.FLUX_4 * LANES] -= (2.5 * kappa_1 - 7.0 / 96.0) * square_1 / (x1 * x1)
    c[Constant.FLUX_4 * LANES] -= (2.5 * kappa_2 - 7.0 / 96.0) * square_2 / (x2 * x2)
    tides = x1**4 * (12.0 - 11.0 * x1) * row[Column.LAMBDA_1] + x2**4 * (12.0 - 11.0 * x2) * row[Column.LAMBDA_2]
    c[Constant.FLUX_10 * LANES] = 6.0 * tides
