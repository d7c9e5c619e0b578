"""What a neutron star adds to a black hole: the tidal phase and the spin-induced quadrupole."""

from math import pi

import numpy as np
from numba.extending import register_jitable

from bnserve_surrogate.baseline._types import Coefficients, Scalars


@register_jitable(error_model="numpy")
def add_tidal_phase(mass_fraction: Scalars, tidal_deformability: Scalars, out: Coefficients) -> None:
    """Add one star's quadrupolar, gravitoelectric tidal terms, 5PN to 7.5PN, to ``out[l, k]`` in units of 3 / (128 nu).

    5PN to 6.5PN: Damour, Nagar, Villain 2012 (arXiv:1203.4352), appendix B. 7PN and 7.5PN: the complete coefficients of
    Henry, Faye, Blanchet 2020 (arXiv:2005.13367) as first published, written for one star as in Narikawa, Uchikata,
    Tanaka 2021 (arXiv:2106.09193), eq. (4), and LALSimulation: the expression is the same for both stars.
    """
    x = mass_fraction
    scale = -24.0 * x**4 * tidal_deformability
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
    y = np.log(np.maximum(tidal_deformability, 1.0))
    fit = 0.194 + y * (0.0936 + y * (0.0474 + y * (-4.21e-3 + y * 1.23e-4)))
    return np.exp(fit * (tidal_deformability > 1.0))
