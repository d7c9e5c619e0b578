"""LALSimulation and TEOBResumS, called directly: what a model is judged by knows nothing of it."""

import numpy as np
import pytest

from bnserve_protocol import SOLAR_MASS_SECONDS


def strain_of_lal(frequencies, one, approximant, orbital_phase=0.0):
    """h_plus and h_cross of LALSimulation in 1/Hz."""
    lal, simulation = pytest.importorskip("lal"), pytest.importorskip("lalsimulation")
    options = lal.CreateDict()
    simulation.SimInspiralWaveformParamsInsertTidalLambda1(options, one.lambda_1)
    simulation.SimInspiralWaveformParamsInsertTidalLambda2(options, one.lambda_2)
    simulation.SimInspiralSetQuadMonParamsFromLambdas(options)
    masses = one.total_mass * lal.MSUN_SI * np.array([one.mass_ratio, 1.0]) / (1.0 + one.mass_ratio)
    vector = lal.CreateREAL8Vector(len(frequencies))
    vector.data = frequencies
    plus, cross = simulation.SimInspiralChooseFDWaveformSequence(
        orbital_phase, *masses, 0.0, 0.0, one.chi_1, 0.0, 0.0, one.chi_2, frequencies[0],
        one.distance_mpc * 1e6 * lal.PC_SI, one.inclination, options, getattr(simulation, approximant), vector,
    )  # fmt: skip
    return np.array(plus.data.data), np.array(cross.data.data)


def strain_of_teobresums(frequencies, one):
    """h_plus and h_cross of TEOBResumSPA, conjugated, in 1/Hz."""
    teobresums = pytest.importorskip("EOBRun_module")
    from bnserve_surrogate.training.data.generators import TEOBResumSPA

    mass = one.total_mass * SOLAR_MASS_SECONDS
    request = {
        "M": one.total_mass, "q": one.mass_ratio, "distance": one.distance_mpc, "inclination": one.inclination,
        "chi1": one.chi_1, "chi2": one.chi_2, "chi1z": one.chi_1, "chi2z": one.chi_2,
        "LambdaAl2": one.lambda_1, "LambdaBl2": one.lambda_2, "use_geometric_units": "no", "domain": 1,
        "initial_frequency": TEOBResumSPA(first_mf=frequencies[0] * mass).phase_start / mass, "use_mode_lm": [1],
        "interp_uniform_grid": "no", "interp_freqs": "yes", "freqs": frequencies.tolist(), "srate_interp": 0.25 / mass,
        "time_shift_FD": "yes", "output_hpc": "no", "ode_tmax": 1e12, "postadiabatic_dynamics_dr": 0.2,
    }  # fmt: skip
    _, *parts = teobresums.EOBRunPy(request)[:5]
    return parts[0] - 1j * parts[1], parts[2] - 1j * parts[3]
