"""LALSimulation and TEOBResumS, called directly: what a model is judged by knows nothing of it."""

import numpy as np
import pytest

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS


def strain_of_lal(frequencies, one, approximant, orbital_phase=0.0, reference=None):
    """h_plus and h_cross of LALSimulation in 1/Hz, its orbital phase at a reference frequency (the lowest)."""
    lal, simulation = pytest.importorskip("lal"), pytest.importorskip("lalsimulation")
    options = lal.CreateDict()
    if "Tidal" in approximant or "Taylor" in approximant:
        simulation.SimInspiralWaveformParamsInsertTidalLambda1(options, one.lambda_1)
        simulation.SimInspiralWaveformParamsInsertTidalLambda2(options, one.lambda_2)
        simulation.SimInspiralSetQuadMonParamsFromLambdas(options)
    masses = one.total_mass * lal.MSUN_SI * np.array([one.mass_ratio, 1.0]) / (1.0 + one.mass_ratio)
    vector = lal.CreateREAL8Vector(len(frequencies))
    vector.data = frequencies
    plus, cross = simulation.SimInspiralChooseFDWaveformSequence(
        orbital_phase, *masses, 0.0, 0.0, one.chi_1, 0.0, 0.0, one.chi_2, reference or frequencies[0],
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


def signal_of_teobresums(one, f_start, rate, modes=((2, 2),)):
    """Times in s, of which 0 is the end of its dynamics, and h_plus and h_cross of TEOBResumS in the time domain, which
    are minus LALSimulation's at azimuth zero but for the orbital phase at its start."""
    teobresums = pytest.importorskip("EOBRun_module")
    from bnserve_surrogate.training.data.generators._teobresums import MODE_NUMBERS

    request = {
        "M": one.total_mass, "q": one.mass_ratio, "distance": one.distance_mpc, "inclination": one.inclination,
        "chi1": one.chi_1, "chi2": one.chi_2, "chi1z": one.chi_1, "chi2z": one.chi_2,
        "LambdaAl2": one.lambda_1, "LambdaBl2": one.lambda_2, "coalescence_angle": np.pi / 2.0,
        "use_geometric_units": "no", "domain": 0, "srate_interp": rate, "output_hpc": "no", "ode_tmax": 1e12,
        "initial_frequency": f_start, "use_mode_lm": sorted(MODE_NUMBERS[mode] for mode in modes), "arg_out": "no",
    }  # fmt: skip
    end = teobresums.EOBRunPy(request | {"interp_uniform_grid": "no"})[0][-1]
    times, plus, cross = teobresums.EOBRunPy(request | {"interp_uniform_grid": "yes"})
    return times - end, plus, cross


MODES = ((2, 2), (2, 1), (3, 3), (4, 4), (3, 2), (3, 1), (4, 3))
"""Those of TEOBResumS that count."""


def harmonics(inclination, azimuth=0.0):
    """What each of :data:`MODES` counts in plus and cross by LAL's harmonics, {mode: (plus, cross)}.

    A mode h(f) at positive frequencies is sqrt(5 / 4 pi) / 2 times the conjugate of h_lm's Fourier transform at -f.
    """
    lal, found = pytest.importorskip("lal"), {}
    for degree, order in MODES:
        up, down = (
            lal.SpinWeightedSphericalHarmonic(inclination, azimuth, -2, degree, m) * np.sqrt(4.0 * np.pi / 5.0)
            for m in (order, -order)
        )
        mirrored = (-1) ** degree * down
        found[degree, order] = up.conjugate() + mirrored, -1j * (up.conjugate() - mirrored)
    return found


def modes_of_teobresums(frequencies, one, modes=MODES):
    """The modes of TEOBResumSPA as the training sees them, {mode: (signed amplitude in 1/Hz, continuous phase)}.

    Frequencies are in Hz, or {mode: frequencies}.
    """
    pytest.importorskip("EOBRun_module")
    from bnserve_surrogate.training.data.generators import TEOBResumSPA

    mass, q = one.total_mass * SOLAR_MASS_SECONDS, one.mass_ratio
    if not isinstance(frequencies, dict):
        frequencies = dict.fromkeys(modes, frequencies)
    asked = {mode: f * mass for mode, f in frequencies.items()}
    generator = TEOBResumSPA(first_mf=min(2.0 * mf[0] / order for (_, order), mf in asked.items()))
    theta = np.array([q, one.chi_1, one.chi_2, one.lambda_1, one.lambda_2])
    unit = q / (1.0 + q) ** 2 * mass**2 / (one.distance_mpc * MEGAPARSEC_SECONDS)
    return {mode: (unit * amplitude, -psi) for mode, (amplitude, psi) in generator.modes(theta, asked).items()}


def polarisations(modes, inclination, azimuth=0.0):
    """h_plus and h_cross of modes ``{mode: h}`` on common frequencies."""
    counts = harmonics(inclination, azimuth)
    return tuple(sum(counts[mode][part] * h for mode, h in modes.items()) for part in (0, 1))
