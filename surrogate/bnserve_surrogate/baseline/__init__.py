"""The post-Newtonian baseline of the (2, 2) mode: TaylorF2 phase, pseudo-5.5PN with 7.5PN tides, and 3.5PN amplitude.

The surrogate learns what TEOBResumS adds to it. Frequencies are dimensionless, M f in units of c**3 / G.
"""

from bnserve_surrogate._freezing import FREEZING_END, FREEZING_START
from bnserve_surrogate.baseline._amplitude import (
    AMPLITUDE_POWERS,
    FROZEN_AMPLITUDE,
    amplitude_coefficients,
    amplitude_prefactor,
    freezing_weight,
    mass_scale,
    taylorf2_amplitude,
)
from bnserve_surrogate.baseline._phase import (
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    add_point_mass_phase,
    add_self_spin_phase,
    add_spin_orbit_phase,
    add_spin_spin_phase,
    add_tidal_phase,
    evaluate_phase,
    phase_coefficients,
    quadrupole_fit,
    spin_induced_quadrupole,
    taylorf2_phase,
)

__all__ = [
    "AMPLITUDE_POWERS",
    "FREEZING_END",
    "FREEZING_START",
    "FROZEN_AMPLITUDE",
    "PHASE_LOG_POWERS",
    "PHASE_POWERS",
    "add_point_mass_phase",
    "add_self_spin_phase",
    "add_spin_orbit_phase",
    "add_spin_spin_phase",
    "add_tidal_phase",
    "amplitude_coefficients",
    "amplitude_prefactor",
    "evaluate_phase",
    "freezing_weight",
    "mass_scale",
    "phase_coefficients",
    "quadrupole_fit",
    "spin_induced_quadrupole",
    "taylorf2_amplitude",
    "taylorf2_phase",
]
