"""The phase against LALSimulation's TaylorF2, order by order and as a phase, where the two hold the same terms.

LALSimulation has nothing beyond 3.5PN but tides, and at 3.5PN not the terms quadratic in the spins.
"""

import numpy as np
import pytest

from bnserve_surrogate.baseline import (
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    evaluate_phase,
    phase_coefficients,
    spin_induced_quadrupole,
)

lal = pytest.importorskip("lal")
lalsimulation = pytest.importorskip("lalsimulation")

SHARED = ([0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0], [0, 2, 3, 4, 5, 6, 6, 7, 10, 12, 13, 14, 15])
"""Powers of log v and of v of the terms that LALSimulation has."""
TOTAL_MASS = 2.8


def draw(count, seed):
    rng = np.random.default_rng(seed)
    low, high = np.array([[1.0, -0.5, -0.5, 5.0, 5.0], [3.0, 0.5, 0.5, 5000.0, 5000.0]])
    return rng.uniform(low, high, (count, 5))


def options(parameters):
    _, _, _, lambda_1, lambda_2 = parameters
    chosen = lal.CreateDict()
    lalsimulation.SimInspiralWaveformParamsInsertTidalLambda1(chosen, lambda_1)
    lalsimulation.SimInspiralWaveformParamsInsertTidalLambda2(chosen, lambda_2)
    lalsimulation.SimInspiralWaveformParamsInsertdQuadMon1(chosen, spin_induced_quadrupole(lambda_1) - 1.0)
    lalsimulation.SimInspiralWaveformParamsInsertdQuadMon2(chosen, spin_induced_quadrupole(lambda_2) - 1.0)
    lalsimulation.SimInspiralWaveformParamsInsertPNTidalOrder(chosen, 15)
    lalsimulation.SimInspiralWaveformParamsInsertPNSpinOrder(chosen, 7)
    lalsimulation.SimInspiralWaveformParamsInsertPNPhaseOrder(chosen, 7)
    return chosen


def coefficients(parameters):
    out = np.empty((PHASE_LOG_POWERS, PHASE_POWERS))
    phase_coefficients(*parameters, out)
    return out


def shared_coefficients(parameters):
    """Ours, less what LALSimulation lacks: point-mass terms from 4PN, and those quadratic in the spins at 3.5PN."""
    q, chi_1, chi_2, lambda_1, lambda_2 = parameters
    ours = coefficients(parameters)
    flipped = coefficients((q, -chi_1, -chi_2, lambda_1, lambda_2))
    spinless = coefficients((q, 0.0, 0.0, lambda_1, lambda_2))
    point_mass = coefficients((q, 0.0, 0.0, 0.0, 0.0))
    shared = np.zeros_like(ours)
    shared[SHARED] = ours[SHARED]
    shared[0, 7] -= 0.5 * (ours + flipped)[0, 7] - spinless[0, 7]
    shared[0, 10] -= point_mass[0, 10]
    return shared


@pytest.mark.parametrize("parameters", draw(20, seed=1))
def test_coefficients_are_those_of_lalsimulation(parameters):
    q, chi_1, chi_2, *_ = parameters
    theirs = lalsimulation.SimInspiralTaylorF2AlignedPhasing(q, 1.0, chi_1, chi_2, options(parameters))
    expected = np.stack([theirs.v, theirs.vlogv])[SHARED]
    np.testing.assert_allclose(shared_coefficients(parameters)[SHARED], expected, rtol=1e-12)


@pytest.mark.parametrize("parameters", draw(8, seed=2))
def test_phase_is_that_of_lalsimulation_up_to_a_constant_and_a_time(parameters):
    q, chi_1, chi_2, *_ = parameters
    masses = TOTAL_MASS * lal.MSUN_SI * np.array([q, 1.0]) / (1.0 + q)
    f = lal.CreateREAL8Vector(1000)
    f.data = np.geomspace(5.0, 1500.0, f.length)
    strain, _ = lalsimulation.SimInspiralChooseFDWaveformSequence(
        0.0, *masses, 0.0, 0.0, chi_1, 0.0, 0.0, chi_2, 0.0, 1e24, 0.0, options(parameters), lalsimulation.TaylorF2, f
    )
    mf = f.data * TOTAL_MASS * lal.MTSUN_SI  # the constant of the release that runs
    ours = evaluate_phase(mf, shared_coefficients(parameters)[..., np.newaxis])[0]
    difference = np.unwrap(np.angle(strain.data.data * np.exp(1j * ours)))
    assert np.abs(difference - np.polynomial.Polynomial.fit(mf, difference, 1)(mf)).max() < 1e-8
