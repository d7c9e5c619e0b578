r"""The TaylorF2 amplitude of the (2, 2) mode, 3.5PN, and its freezing at high frequency.

Normalisation: A is the plus polarisation of a face-on source in units of nu M**2 / D_L (G = c = 1),

.. math:: A = \frac{D_L}{\nu M^2} |\tilde h_+(f; \iota = 0)|, \qquad
          |\tilde h_{22}| = \sqrt{4 \pi / 5} \, \nu M^2 A \quad \mathrm{where} \quad
          h_+ = \frac{1}{D_L} \sqrt{\frac{5}{4 \pi}} h_{22} \frac{1 + \cos^2 \iota}{2} .

It is what TEOBResumS returns in geometric units, and the one in which the paper's constant C = 20 is what it is said to
be: at M f = 0.02, for equal masses without spin, TEOBResumS has A = 21 for Lambda = 400, 32 for 5 and 4.6 for 5000.
"""

from math import pi

import numpy as np
from numba.extending import register_jitable

from bnserve_surrogate._freezing import FREEZING_END, FREEZING_START
from bnserve_surrogate.baseline._types import Coefficients, FloatArray, Scalars

AMPLITUDE_POWERS = 8
"""Powers of v in the amplitude relative to the leading order: 0 to 7, that is 3.5PN."""
FROZEN_AMPLITUDE = 20.0
"""That constant, the paper's C."""


def velocity(mf: FloatArray) -> FloatArray:
    """The PN parameter v = (pi M f)**(1/3), for M f in units of c**3 / G."""
    return np.asarray(np.cbrt(np.pi * mf))


@register_jitable(error_model="numpy")
def mass_scale(mass_ratio: Scalars) -> Scalars:
    """The symmetric mass ratio nu: |h_+| of a face-on source is nu M**2 / D_L times A."""
    return mass_ratio / (1.0 + mass_ratio) ** 2


@register_jitable(error_model="numpy")
def amplitude_prefactor(mass_ratio: Scalars) -> Scalars:
    """Coefficient of v**(-7/2) in the leading-order A, sqrt(5 pi / (24 nu)), from the quadrupole formula."""
    return np.sqrt(5.0 * pi / 24.0 / mass_scale(mass_ratio))


@register_jitable(error_model="numpy")
def amplitude_coefficients(mass_ratio: Scalars, chi_1: Scalars, chi_2: Scalars, out: Coefficients) -> None:
    r"""Fill ``out`` with the coefficients of the PN amplitude, relative to the leading order.

    .. math:: A(v) = A_0 v^{-7/2} \sum_k \mathrm{out}[k] \, v^k, \qquad v = (\pi M f)^{1/3}

    with A_0 from :func:`amplitude_prefactor`. Through 3PN: Khan et al. 2016 (arXiv:1508.07253), eqs. (B14)-(B20), but
    for the spin-spin terms, which there lack part of the mode's own; those are of Garcia-Quiros et al. 2020
    (arXiv:2001.10914), for spin-induced quadrupoles of black holes (C_Q = 1). 3.5PN, without spins: the modulus of the
    mode (Faye, Blanchet, Iyer 2015, arXiv:1409.3546) times the square root of the second derivative of the phase, which
    also gives back the lower orders.

    Pass floats and ``out`` of shape (8,), in Python or under ``numba.njit``; or, in Python, arrays of shape (N,) and
    ``out`` of shape (8, N). Nothing is validated.

    Parameters
    ----------
    mass_ratio
        m_1 / m_2, of either sense.
    chi_1, chi_2
        Dimensionless spins along the orbital angular momentum.
    out
        Overwritten.
    """
    nu = mass_scale(mass_ratio)
    delta = (mass_ratio - 1.0) / (mass_ratio + 1.0)
    symmetric = 0.5 * (chi_1 + chi_2)
    antisymmetric = 0.5 * delta * (chi_1 - chi_2)  # delta chi_a: chi_a comes with delta, or squared
    square = 0.25 * (chi_1 - chi_2) ** 2
    out[0] = 1.0
    out[1] = 0.0
    out[2] = -323.0 / 224.0 + 451.0 / 168.0 * nu
    out[3] = 27.0 / 8.0 * antisymmetric + (27.0 / 8.0 - 11.0 / 6.0 * nu) * symmetric
    out[4] = -27312085.0 / 8128512.0 + nu * (-1975055.0 / 338688.0 + 105271.0 / 24192.0 * nu)
    out[4] += (-49.0 / 32.0 + 6.0 * nu) * square - 49.0 / 16.0 * antisymmetric * symmetric
    out[4] += (-49.0 / 32.0 + nu / 8.0) * symmetric**2
    out[5] = -85.0 / 64.0 * pi * (1.0 - 4.0 * nu) + (285197.0 / 16128.0 - 1579.0 / 4032.0 * nu) * antisymmetric
    out[5] += (285197.0 / 16128.0 - nu * (15317.0 / 672.0 + 2227.0 / 1008.0 * nu)) * symmetric
    out[6] = -177520268561.0 / 8583708672.0 + nu * (545384828789.0 / 5007163392.0 - 205.0 / 48.0 * pi**2)
    out[6] += nu**2 * (-3248849057.0 / 178827264.0 + 34473079.0 / 6386688.0 * nu)
    out[6] += pi * (31.0 / 12.0 * antisymmetric + (31.0 / 12.0 - 7.0 / 3.0 * nu) * symmetric)
    out[6] += (-875047.0 / 64512.0 + nu * (129367.0 / 2304.0 + 491.0 / 84.0 * nu)) * square
    out[6] += (-875047.0 / 32256.0 + 107291.0 / 2688.0 * nu) * antisymmetric * symmetric
    out[6] += (-875047.0 / 64512.0 + nu * (8517.0 / 224.0 - 51329.0 / 4032.0 * nu)) * symmetric**2
    out[7] = pi * (3814429.0 / 1161216.0 - nu * (393581.0 / 24192.0 - 193621.0 / 24192.0 * nu))


def freezing_weight(mf: FloatArray) -> FloatArray:
    """Share of the constant: (1 - cos(pi x)) / 2, x from 0 at M f = 0.01 to 1 at 0.02; 0 below and exactly 1 above."""
    x = np.clip((mf - FREEZING_START) / (FREEZING_END - FREEZING_START), 0.0, 1.0)
    return np.asarray(0.5 * (1.0 - np.cos(pi * x)))


def freeze_amplitude(mf: FloatArray, amplitude: FloatArray) -> FloatArray:
    """Replace a PN amplitude, shape (..., M) at M f of shape (M,), by the constant 20 at high frequency, smoothly."""
    weight = freezing_weight(mf)
    return (1.0 - weight) * amplitude + weight * FROZEN_AMPLITUDE


def taylorf2_amplitude(
    mf: FloatArray, mass_ratio: FloatArray, chi_1: FloatArray, chi_2: FloatArray, *, frozen: bool = True
) -> FloatArray:
    """A = |h_+(face-on)| D_L / (nu M**2), shape (N, M), from M f of shape (M,) and parameters of shape (N,).

    Constant above M f = 0.02, as the baseline needs; without ``frozen`` the bare PN series, which may change sign.
    """
    v = velocity(mf)
    coefficients = np.empty((AMPLITUDE_POWERS, np.size(mass_ratio)))
    amplitude_coefficients(mass_ratio, chi_1, chi_2, coefficients)
    series = coefficients.T @ v ** (np.arange(AMPLITUDE_POWERS)[:, np.newaxis] - 3.5)
    amplitude = np.atleast_1d(amplitude_prefactor(mass_ratio))[:, np.newaxis] * series
    return freeze_amplitude(mf, amplitude) if frozen else np.asarray(amplitude)
