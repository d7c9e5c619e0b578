"""What must hold of the baseline whatever the numbers in it."""

import numba
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_surrogate import baseline
from bnserve_surrogate.baseline import (
    AMPLITUDE_POWERS,
    FREEZING_END,
    FREEZING_START,
    FROZEN_AMPLITUDE,
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    amplitude_coefficients,
    amplitude_prefactor,
    freezing_weight,
    mass_scale,
    phase_coefficients,
    spin_induced_quadrupole,
    taylorf2_amplitude,
    taylorf2_phase,
)

mass_ratios = st.floats(1.0, 3.0)
chis = st.floats(-0.5, 0.5)
lambdas = st.floats(0.0, 5000.0)

compiled_phase = numba.njit(phase_coefficients)
compiled_amplitude = numba.njit(amplitude_coefficients)


def phase(function, *parameters):
    out = np.full((PHASE_LOG_POWERS, PHASE_POWERS, *np.shape(parameters[0])), np.nan)
    function(*parameters, out)
    return out


def amplitude(function, *parameters):
    out = np.full((AMPLITUDE_POWERS, *np.shape(parameters[0])), np.nan)
    function(*parameters, out)
    return out


def test_public_names_exist():
    assert all(hasattr(baseline, name) for name in baseline.__all__)


@given(mass_ratios, chis, chis, lambdas, lambdas)
def test_compiled_coefficients_are_the_interpreted_ones(q, chi_1, chi_2, lambda_1, lambda_2):
    parameters = (q, chi_1, chi_2, lambda_1, lambda_2)
    np.testing.assert_allclose(phase(compiled_phase, *parameters), phase(phase_coefficients, *parameters), rtol=1e-14)
    np.testing.assert_allclose(
        amplitude(compiled_amplitude, *parameters[:3]), amplitude(amplitude_coefficients, *parameters[:3]), rtol=1e-14
    )


@given(st.lists(st.tuples(mass_ratios, chis, chis, lambdas, lambdas), min_size=1, max_size=5))
def test_coefficients_of_many_are_those_of_each(rows):
    columns = np.array(rows).T
    together = phase(phase_coefficients, *columns)
    one_by_one = np.stack([phase(phase_coefficients, *row) for row in rows], axis=-1)
    np.testing.assert_allclose(together, one_by_one, rtol=1e-14)
    together = amplitude(amplitude_coefficients, *columns[:3])
    one_by_one = np.stack([amplitude(amplitude_coefficients, *row[:3]) for row in rows], axis=-1)
    np.testing.assert_allclose(together, one_by_one, rtol=1e-14)


@given(mass_ratios, chis, chis, lambdas, lambdas)
def test_the_labels_of_the_stars_are_conventional(q, chi_1, chi_2, lambda_1, lambda_2):
    one, other = (q, chi_1, chi_2, lambda_1, lambda_2), (1.0 / q, chi_2, chi_1, lambda_2, lambda_1)
    np.testing.assert_allclose(phase(phase_coefficients, *one), phase(phase_coefficients, *other), rtol=1e-11)
    first, second = (amplitude(amplitude_coefficients, *parameters[:3]) for parameters in (one, other))
    np.testing.assert_allclose(first, second, rtol=1e-11, atol=1e-12)
    assert amplitude_prefactor(q) == pytest.approx(amplitude_prefactor(1.0 / q), rel=1e-14)


@given(mass_ratios, lambdas, lambdas)
def test_without_spin_the_quadrupoles_do_not_matter_and_tides_start_at_5pn(q, lambda_1, lambda_2):
    tidal = phase(phase_coefficients, q, 0.0, 0.0, lambda_1, lambda_2)
    point = phase(phase_coefficients, q, 0.0, 0.0, 0.0, 0.0)
    assert np.array_equal(tidal[:, :10], point[:, :10])
    assert np.array_equal(tidal[1:], point[1:])
    assert not point[:, 12:].any()
    assert np.all(tidal[0, [10, 12, 14]] <= point[0, [10, 12, 14]])


@given(mass_ratios, chis, chis, lambdas)
def test_the_constant_and_the_linear_term_are_dropped(q, chi_1, chi_2, tidal_deformability):
    out = phase(phase_coefficients, q, chi_1, chi_2, tidal_deformability, tidal_deformability)
    assert out[0, 0] == pytest.approx(3.0 / (128.0 * mass_scale(q)), rel=1e-15)
    assert out[0, 1] == out[0, 5] == out[0, 8] == 0.0


def test_a_black_hole_has_its_own_quadrupole():
    assert np.array_equal(spin_induced_quadrupole(np.array([0.0, 0.5, 1.0])), [1.0, 1.0, 1.0])


@given(mass_ratios, chis, chis)
def test_freezing_is_continuous_and_exact_above(q, chi_1, chi_2):
    parameters = [np.array([value]) for value in (q, chi_1, chi_2)]
    step = 1e-9
    mf = np.array([0.002, FREEZING_START - step, FREEZING_START, FREEZING_START + step])
    np.testing.assert_allclose(
        taylorf2_amplitude(mf, *parameters), taylorf2_amplitude(mf, *parameters, frozen=False), rtol=1e-12
    )
    assert taylorf2_amplitude(np.array([FREEZING_END - step]), *parameters)[0, 0] == pytest.approx(20.0, abs=1e-10)
    assert np.all(taylorf2_amplitude(np.array([FREEZING_END, 0.03, 0.05]), *parameters) == FROZEN_AMPLITUDE)


def test_freezing_weight_rises_from_zero_to_one():
    weight = freezing_weight(np.linspace(0.0, 0.03, 301))
    assert np.all(np.diff(weight) >= 0.0)
    assert (weight[0], weight[150], weight[300]) == pytest.approx((0.0, 0.5, 1.0), abs=1e-12)


@given(mass_ratios, chis, chis)
def test_the_frozen_amplitude_is_positive(q, chi_1, chi_2):
    mf = np.linspace(1e-5, 0.04, 2000)
    assert np.all(taylorf2_amplitude(mf, *(np.array([value]) for value in (q, chi_1, chi_2))) > 0.0)


@given(mass_ratios)
def test_amplitude_and_phase_share_one_chirp(q):
    """A**2 is |H_22|**2 times the second derivative of the phase: SPA, and |H_22| of arXiv:1409.3546, eq. (4.17)."""
    nu = mass_scale(q)
    psi = phase(phase_coefficients, q, 0.0, 0.0, 0.0, 0.0) * (128.0 * nu / 3.0)
    k = np.arange(8)
    chirp = psi[0, :8] * (k - 5) * (k - 8) / 40 + psi[1, :8] * (2 * k - 13) / 40
    mode = np.zeros(8)
    mode[[0, 2, 3]] = 1.0, (-107 + 55 * nu) / 42, 2 * np.pi
    mode[4] = -2173 / 1512 - 1069 / 216 * nu + 2047 / 1512 * nu**2
    mode[5] = (-107 + 34 * nu) / 21 * np.pi
    mode[6] = 27027409 / 646800 - 856 / 105 * (np.euler_gamma + 2 * np.log(2)) + 2 / 3 * np.pi**2
    mode[6] += (-278185 / 33264 + 41 / 96 * np.pi**2) * nu - 20261 / 2772 * nu**2 + 114635 / 99792 * nu**3
    mode[7] = (-2173 / 756 - 2495 / 378 * nu + 40 / 27 * nu**2) * np.pi
    series = amplitude(amplitude_coefficients, q, 0.0, 0.0)
    expected = np.convolve(np.convolve(mode, mode)[:8], chirp)[:8]
    np.testing.assert_allclose(np.convolve(series, series)[:8], expected, rtol=1e-10, atol=1e-10)


def test_phase_is_evaluated_from_its_coefficients():
    parameters = (1.7, 0.2, -0.4, 300.0, 900.0)
    mf = np.array([1e-4, 3e-3, 0.03])
    v = np.cbrt(np.pi * mf)
    out = phase(phase_coefficients, *parameters)
    terms = [out[i, k] * np.log(v) ** i * v ** (k - 5.0) for i in range(PHASE_LOG_POWERS) for k in range(PHASE_POWERS)]
    columns = [np.array([value]) for value in parameters]
    np.testing.assert_allclose(taylorf2_phase(mf, *columns), [np.sum(terms, axis=0)], rtol=1e-13)
