"""Spin part of the TaylorF2 phase for aligned spins, in units of the leading term 3 / (128 nu) v**-5.

Every term linear or quadratic in one star's spin is a function of that star's mass fraction X = m / M and spin chi, so
the phase is a sum over the two stars, plus what involves both spins. Terms cubic in the spins (3.5PN) and all those
from 4PN on are left to the surrogate.
"""

from math import pi

from numba.extending import register_jitable

from bnserve_surrogate.baseline._types import Coefficients, Scalars


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
