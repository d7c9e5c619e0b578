"""The TaylorF2 phase of the (2, 2) mode as a polynomial in v and log v: its coefficients for given parameters."""

from numba.extending import register_jitable

from bnserve_surrogate.baseline._point_mass import add_point_mass_phase
from bnserve_surrogate.baseline._spins import add_self_spin_phase, add_spin_orbit_phase, add_spin_spin_phase
from bnserve_surrogate.baseline._tides import add_tidal_phase, spin_induced_quadrupole
from bnserve_surrogate.baseline._types import Coefficients, Scalars

PHASE_LOG_POWERS = 3
"""Powers of log v in the phase: 0, 1, 2."""
PHASE_POWERS = 16
"""Powers of v in v**5 times the phase: 0 to 15, that is 7.5PN order."""


@register_jitable(error_model="numpy")
def phase_coefficients(
    mass_ratio: Scalars,
    chi_1: Scalars,
    chi_2: Scalars,
    lambda_1: Scalars,
    lambda_2: Scalars,
    out: Coefficients,
) -> None:
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
