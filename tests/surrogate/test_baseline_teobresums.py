"""The baseline against TEOBResumS at low frequency, where both are right."""

import numpy as np
import pytest

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import mass_scale, spin_induced_quadrupole, taylorf2_amplitude, taylorf2_phase

teobresums = pytest.importorskip("EOBRun_module")

TOTAL_MASS = 2.8
BINARIES = {
    "equal": (1.0, 0.0, 0.0, 400.0, 400.0),
    "unequal": (3.0, 0.0, 0.0, 5.0, 5.0),
    "aligned": (1.0, 0.5, 0.5, 5.0, 5.0),
    "opposite": (1.0, 0.5, -0.5, 5.0, 5.0),
    "generic": (2.0, 0.3, -0.2, 800.0, 3000.0),
    "deformable": (3.0, 0.5, 0.5, 5000.0, 5000.0),
}


def frequencies(low, high):
    return np.geomspace(low, high, 200)


def teobresums_mode(f, parameters):
    """A and psi of the face-on plus polarisation at f in Hz."""
    q, chi_1, chi_2, lambda_1, lambda_2 = parameters
    mf = f * TOTAL_MASS * SOLAR_MASS_SECONDS
    *_, real, imaginary, _, _, modes, _, _ = teobresums.EOBRunPy(
        {
            "q": q, "chi1": chi_1, "chi2": chi_2, "chi1z": chi_1, "chi2z": chi_2,
            "LambdaAl2": lambda_1, "LambdaBl2": lambda_2, "M": 1.0, "distance": 1.0, "inclination": 0.0,
            "use_geometric_units": "yes", "initial_frequency": 0.95 * mf[0], "domain": 1, "interp_uniform_grid": "no",
            "interp_freqs": "yes", "freqs": list(mf), "srate_interp": 1.0, "time_shift_FD": "yes", "output_hpc": "no",
            "ode_tmax": 1e12, "use_mode_lm": [1], "arg_out": "yes",
        }
    )  # fmt: skip
    return np.hypot(real, imaginary), modes["1"][1]


def residual(f, parameters):
    """Phase residual in radians, once a constant and a time are taken out."""
    mf = f * TOTAL_MASS * SOLAR_MASS_SECONDS
    columns = [np.array([value]) for value in parameters]
    difference = teobresums_mode(f, parameters)[1] - taylorf2_phase(mf, *columns)[0]
    return difference - np.polynomial.Polynomial.fit(mf, difference, 1)(mf)


@pytest.mark.parametrize("name", BINARIES)
def test_phase_agrees_at_low_frequency_and_better_the_lower(name):
    octave = [np.abs(residual(frequencies(low, 2.0 * low), BINARIES[name])).max() for low in (3.57, 7.14, 14.28)]
    spinning = any(BINARIES[name][1:3])
    assert octave[0] < (6e-3 if spinning else 1e-4)  # out of a phase of 1e5 rad; 4PN terms in the spins are missing
    assert octave[0] < octave[1] < octave[2]


@pytest.mark.parametrize("tidal_deformability", [5.0, 400.0, 5000.0])
def test_the_universal_relation_is_that_of_teobresums(tidal_deformability):
    """Its 2PN term is read off the phase far below any band, with the next orders that the baseline lacks left free."""
    f = frequencies(0.5, 30.0)
    mf = f * TOTAL_MASS * SOLAR_MASS_SECONDS
    v = np.cbrt(np.pi * mf)
    parameters = (1.0, 0.5, -0.5, tidal_deformability, tidal_deformability)
    difference = teobresums_mode(f, parameters)[1] - taylorf2_phase(mf, *np.array(parameters)[:, np.newaxis])[0]
    terms = np.stack([1 / v, v**0, v**3, v**3 * np.log(v), v**3 * np.log(v) ** 2, v**4, v**5], axis=1)
    scale = np.abs(terms).max(axis=0)
    leading = (np.linalg.lstsq(terms / scale, difference, rcond=None)[0] / scale)[0]
    per_quadrupole = 3.0 / (128.0 * mass_scale(1.0)) * -50.0 * 2.0 * 0.25**2
    assert leading / per_quadrupole == pytest.approx(0.0, abs=1e-5 * spin_induced_quadrupole(tidal_deformability))


@pytest.mark.parametrize("name", BINARIES)
def test_amplitude_agrees_at_low_frequency_and_better_the_lower(name):
    f = frequencies(3.57, 100.0)
    mf = f * TOTAL_MASS * SOLAR_MASS_SECONDS
    amplitude = taylorf2_amplitude(mf, *(np.array([value]) for value in BINARIES[name][:3]))[0]
    error = np.abs(teobresums_mode(f, BINARIES[name])[0] / amplitude - 1.0)
    assert error.max() < 5e-3
    assert error[0] < 3e-5
    assert error[0] < error[-1]


@pytest.mark.parametrize(("tidal_deformability", "amplitude"), [(5.0, 32.0), (400.0, 21.0), (5000.0, 4.6)])
def test_the_frozen_amplitude_is_among_those_of_teobresums_where_it_sets_in(tidal_deformability, amplitude):
    f = np.linspace(0.018, 0.022, 41) / (TOTAL_MASS * SOLAR_MASS_SECONDS)
    values, _ = teobresums_mode(f, (1.0, 0.0, 0.0, tidal_deformability, tidal_deformability))
    assert values[20] == pytest.approx(amplitude, rel=0.02)
