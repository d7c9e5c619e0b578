"""The TaylorF2 phase of the (2, 2) mode as a polynomial in v and log v: its coefficients, and their sum in numpy.

The non-spinning, non-tidal part is made of the tables in :mod:`._phase_terms`, which name their sources.

Every term linear or quadratic in one star's spin is a function of that star's mass fraction X = m / M and spin chi, so
the spins' phase is a sum over the two stars, plus what involves both spins; terms cubic in the spins (3.5PN) and all
those from 4PN on are left to the surrogate. What a neutron star adds to a black hole are the tidal phase and the
spin-induced quadrupole. All terms are in units of the leading one, 3 / (128 nu) v**-5.
"""

from math import pi

import numpy as np
from numba.extending import register_jitable

from bnserve_surrogate.baseline import _phase_terms as terms
from bnserve_surrogate.baseline._amplitude import velocity
from bnserve_surrogate.baseline._types import Coefficients, FloatArray, Scalars

PHASE_LOG_POWERS = 3
"""Powers of log v in the phase: 0, 1, 2."""
PHASE_POWERS = 16
"""Powers of v in v**5 times the phase: 0 to 15, that is 7.5PN order."""


@register_jitable(error_model="numpy")
def phase_coefficients(
    mass_ratio: Scalars, chi_1: Scalars, chi_2: Scalars, lambda_1: Scalars, lambda_2: Scalars, out: Coefficients,
) -> None:  # fmt: skip
    r"""Fill ``out`` with the coefficients of the TaylorF2 phase.

    .. math:: \Psi(v) = v^{-5} \sum_{l, k} \mathrm{out}[l, k] \, (\log v)^l \, v^k, \qquad v = (\pi M f)^{1/3}

    The sign is LALSimulation's, h(f) = A exp(-i Psi): the leading term is +3 / (128 nu), tides are negative. A constant
    and a term linear in f are a choice of reference phase and time: the -pi/4 is absent, and ``out[0, 5]`` and
    ``out[0, 8]`` are zero.

    Pass floats and ``out`` of shape (3, 16), in Python or under ``numba.njit``; or, in Python, arrays of shape (N,) and
    ``out`` of shape (3, 16, N). Nothing is validated.

    Parameters
    ----------
    mass_ratio
        m_1 / m_2, of either sense.
    chi_1, chi_2
        Dimensionless spins along the orbital angular momentum.
    lambda_1, lambda_2
        Dimensionless quadrupolar tidal deformabilities; the spin-induced quadrupoles follow from them.
    out
        Overwritten.
    """
    x_1 = mass_ratio / (1.0 + mass_ratio)
    x_2 = 1.0 / (1.0 + mass_ratio)
    nu = x_1 * x_2
    out[:] = 0.0
    add_point_mass_phase(nu, out)
    add_spin_orbit_phase(x_1, chi_1, out)
    add_spin_orbit_phase(x_2, chi_2, out)
    add_self_spin_phase(x_1, chi_1, spin_induced_quadrupole(lambda_1), out)
    add_self_spin_phase(x_2, chi_2, spin_induced_quadrupole(lambda_2), out)
    add_spin_spin_phase(x_1, chi_1, chi_2, out)
    add_tidal_phase(x_1, lambda_1, out)
    add_tidal_phase(x_2, lambda_2, out)
    leading = 3.0 / (128.0 * nu)
    for log_power in range(PHASE_LOG_POWERS):
        for power in range(PHASE_POWERS):
            out[log_power, power] *= leading


@register_jitable(error_model="numpy")
def add_spin_orbit_phase(mass_fraction: Scalars, chi: Scalars, out: Coefficients) -> None:
    """Add one star's spin-orbit terms, 1.5PN to 3.5PN, to ``out[l, k]``.

    Bohe, Marsat, Blanchet 2013 (arXiv:1303.7412), eqs. (3.15)-(3.16); the 3PN tail: Marsat, Bohe, Blanchet, Buonanno
    2013 (arXiv:1307.6793), eq. (4.9).
    """
    x = mass_fraction
    nu = x * (1.0 - x)
    spin = x * chi
    out[0, 3] += spin * (25.0 + 38.0 / 3.0 * x)
    out[1, 5] += -3.0 * spin * (13915.0 / 84.0 - 10.0 / 3.0 * nu + x * (12760.0 / 81.0 + 170.0 / 9.0 * nu))
    out[0, 6] += pi * spin * (1490.0 / 3.0 + 260.0 * x)
    along_total = -8980424995.0 / 762048.0 + nu * (6586595.0 / 756.0 - 305.0 / 36.0 * nu)
    along_difference = 170978035.0 / 48384.0 - nu * (2876425.0 / 672.0 + 4735.0 / 144.0 * nu)
    out[0, 7] += spin * (along_total * x + along_difference * (2.0 * x - 1.0))


@register_jitable(error_model="numpy")
def add_self_spin_phase(mass_fraction: Scalars, chi: Scalars, quadrupole: Scalars, out: Coefficients) -> None:
    """Add one star's terms quadratic in its own spin, 2PN, 3PN and 3.5PN, to ``out[l, k]``.

    ``quadrupole`` is the star's spin-induced quadrupole C_Q (1 for a black hole). The terms in C_Q are the
    monopole-quadrupole phase of Nagar et al. 2018 (arXiv:1812.07923), eqs. (50)-(52), the last of them the 3.5PN tail.
    The others: 2PN, Mikoczi, Vasuth, Gergely 2005 (arXiv:astro-ph/0504538), eq. (9); 3PN, Bohe, Faye, Marsat, Porter
    2015 (arXiv:1501.01529), from eqs. (3.30) and (4.12).
    """
    x = mass_fraction
    square = (x * chi) ** 2
    out[0, 4] += -square * (50.0 * quadrupole + 5.0 / 8.0)
    out[0, 6] += square * (
        quadrupole * (47035.0 / 84.0 + x * (2935.0 / 6.0 - 120.0 * x))
        - (410825.0 / 672.0 + x * (1085.0 / 12.0 - 1255.0 / 36.0 * x))
    )
    out[0, 7] += -400.0 * pi * square * quadrupole


@register_jitable(error_model="numpy")
def add_spin_spin_phase(mass_fraction_1: Scalars, chi_1: Scalars, chi_2: Scalars, out: Coefficients) -> None:
    """Add the rest of what is quadratic in the spins and belongs to the pair: 2PN, 3PN and the 3.5PN tail.

    Same sources as :func:`add_self_spin_phase`. The tail, which LALSimulation's TaylorF2 lacks, follows from the energy
    and flux at 2PN and the tail factors of the (2, 2) and (2, 1) modes, 1 + 2 pi m v**3: with a = X chi, it is
    -800 pi a_1 a_2 - (15/2) pi (a_1 - a_2)**2.
    """
    nu = mass_fraction_1 * (1.0 - mass_fraction_1)
    product = nu * chi_1 * chi_2
    out[0, 4] += -395.0 / 4.0 * product
    out[0, 6] += product * (32675.0 / 112.0 + 5575.0 / 18.0 * nu)
    difference = mass_fraction_1 * chi_1 - (1.0 - mass_fraction_1) * chi_2
    out[0, 7] += -pi * (800.0 * product + 7.5 * difference**2)


@register_jitable(error_model="numpy")
def add_tidal_phase(mass_fraction: Scalars, tidal_deformability: Scalars, out: Coefficients) -> None:
    """Add one star's quadrupolar, gravitoelectric tidal terms, 5PN to 7.5PN, to ``out[l, k]`` in units of 3 / (128 nu).

    5PN to 6.5PN: Damour, Nagar, Villain 2012 (arXiv:1203.4352), appendix B. 7PN and 7.5PN: the complete coefficients of
    Henry, Faye, Blanchet 2020 (arXiv:2005.13367) as first published, written for one star as in Narikawa, Uchikata,
    Tanaka 2021 (arXiv:2106.09193), eq. (4), and LALSimulation: the expression is the same for both stars.
    """
    x = mass_fraction
    square = x * x
    scale = -24.0 * (square * square) * tidal_deformability
    out[0, 10] += scale * (12.0 - 11.0 * x)
    out[0, 12] += scale * 5.0 / 672.0 * (3179.0 - x * (919.0 + x * (2286.0 - 260.0 * x)))
    out[0, 13] += -pi * scale * (12.0 - 11.0 * x)
    high_7pn = 158378220.0 - x * (20427120.0 - 4572288.0 * x)
    out[0, 14] += scale * 5.0 / 27433728.0 * (387973870.0 - x * (43246839.0 + x * (174965616.0 + x * high_7pn)))
    out[0, 15] += -pi * scale / 672.0 * (27719.0 - x * (22415.0 - x * (7598.0 - 10520.0 * x)))


@register_jitable(error_model="numpy")
def spin_induced_quadrupole(tidal_deformability: Scalars) -> Scalars:
    """Quadrupole coefficient C_Q of a spinning star, from its quadrupolar tidal deformability Lambda.

    The universal relation of Yagi and Yunes 2013 (arXiv:1303.1528), which TEOBResumS uses (Nagar et al. 2018,
    arXiv:1806.01772, eq. (41)); LALSimulation has the fit of 2017, 2e-3 away. As in TEOBResumS, a body with Lambda <= 1
    is a black hole, C_Q = 1.
    """
    fit = quadrupole_fit(np.log(np.maximum(tidal_deformability, 1.0)))
    return np.exp(fit * (tidal_deformability > 1.0))


@register_jitable(error_model="numpy")
def quadrupole_fit(y: Scalars) -> Scalars:
    """The logarithm of C_Q as a function of that of Lambda."""
    return 0.194 + y * (0.0936 + y * (0.0474 + y * (-4.21e-3 + y * 1.23e-4)))


def evaluate_phase(mf: FloatArray, coefficients: FloatArray) -> FloatArray:
    """Phase in radians, shape (N, M), of coefficients of shape (3, 16, N) at M f of shape (M,)."""
    v = velocity(mf)
    powers = v ** (np.arange(PHASE_POWERS)[:, np.newaxis] - 5.0)
    logs = np.log(v)
    polynomials = np.einsum("lkn,km->lnm", coefficients, powers)
    return np.asarray(polynomials[0] + logs * (polynomials[1] + logs * polynomials[2]))


def taylorf2_phase(
    mf: FloatArray, mass_ratio: FloatArray, chi_1: FloatArray, chi_2: FloatArray, lambda_1: FloatArray,
    lambda_2: FloatArray,
) -> FloatArray:  # fmt: skip
    """Psi in radians, shape (N, M), where h = A exp(-i Psi): see :func:`phase_coefficients`.

    Parameters
    ----------
    mf
        M f in units of c**3 / G, shape (M,).
    mass_ratio, chi_1, chi_2, lambda_1, lambda_2
        Shape (N,).
    """
    coefficients = np.empty((PHASE_LOG_POWERS, PHASE_POWERS, np.size(mass_ratio)))
    phase_coefficients(mass_ratio, chi_1, chi_2, lambda_1, lambda_2, coefficients)
    return evaluate_phase(mf, coefficients)


@register_jitable(error_model="numpy")
def add_point_mass_phase(symmetric_mass_ratio: Scalars, out: Coefficients) -> None:
    """Add the point-mass terms, in units of 3 / (128 nu), to ``out[l, k]`` (power l of log v, power k of v).

    ``out[0, 5]`` (a constant of the phase) and ``out[0, 8]`` (linear in the frequency) are conventional and left alone.
    """
    nu = symmetric_mass_ratio
    out[0, 0] += 1.0
    out[0, 2] += terms.PHASE_1PN[0] + nu * terms.PHASE_1PN[1]
    out[0, 3] += terms.PHASE_1_5PN
    out[0, 4] += terms.PHASE_2PN[0] + nu * (terms.PHASE_2PN[1] + nu * terms.PHASE_2PN[2])
    out[1, 5] += terms.PHASE_2_5PN_LOG[0] + nu * terms.PHASE_2_5PN_LOG[1]
    out[0, 6] += terms.PHASE_3PN[0] + nu * (terms.PHASE_3PN[1] + nu * (terms.PHASE_3PN[2] + nu * terms.PHASE_3PN[3]))
    out[1, 6] += terms.PHASE_3PN_LOG
    out[0, 7] += terms.PHASE_3_5PN[0] + nu * (terms.PHASE_3_5PN[1] + nu * terms.PHASE_3_5PN[2])
    out[1, 8] += terms.PHASE_4PN_LOG[0] + nu * (
        terms.PHASE_4PN_LOG[1]
        + nu * (terms.PHASE_4PN_LOG[2] + nu * (terms.PHASE_4PN_LOG[3] + nu * terms.PHASE_4PN_LOG[4]))
    )
    out[2, 8] += terms.PHASE_4PN_LOG_SQUARED[0] + nu * terms.PHASE_4PN_LOG_SQUARED[1]
    out[0, 9] += terms.PHASE_4_5PN[0] + nu * (
        terms.PHASE_4_5PN[1] + nu * (terms.PHASE_4_5PN[2] + nu * terms.PHASE_4_5PN[3])
    )
    out[1, 9] += terms.PHASE_4_5PN_LOG
    high_5pn = terms.PHASE_5PN[3] + nu * (terms.PHASE_5PN[4] + nu * (terms.PHASE_5PN[5] + nu * terms.PHASE_5PN[6]))
    out[0, 10] += (terms.PHASE_5PN[0] + nu * (terms.PHASE_5PN[1] + nu * (terms.PHASE_5PN[2] + nu * high_5pn))) / (
        1.0 - 3.0 * nu
    )
    low_5pn_log = terms.PHASE_5PN_LOG[0] + nu * (
        terms.PHASE_5PN_LOG[1] + nu * (terms.PHASE_5PN_LOG[2] + nu * terms.PHASE_5PN_LOG[3])
    )
    out[1, 10] += low_5pn_log / (1.0 - 3.0 * nu)
    out[0, 11] += terms.PHASE_5_5PN[0] + nu * (
        terms.PHASE_5_5PN[1] + nu * (terms.PHASE_5_5PN[2] + nu * (terms.PHASE_5_5PN[3] + nu * terms.PHASE_5_5PN[4]))
    )
    out[1, 11] += terms.PHASE_5_5PN_LOG[0] + nu * terms.PHASE_5_5PN_LOG[1]
