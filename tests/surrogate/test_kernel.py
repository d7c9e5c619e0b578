"""The fused kernel against a slow reference made of numpy, scipy's splines and the baseline's reference functions."""

import threading

import numpy as np
import pytest
from numpy.polynomial import chebyshev
from scipy.interpolate import CubicSpline

from bnserve_protocol import (
    MEGAPARSEC_SECONDS,
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    ParameterBatch,
    UniformGrid,
)
from bnserve_surrogate._coordinates import physical_coordinates
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from tests.surrogate.conftest import random_batch

BAND = np.geomspace(5.0, 2048.0, 1500)


def outputs(tensors, theta):
    """The regressor, from its definition."""
    x = (physical_coordinates(theta) - tensors["22/coordinate_offset"]) * tensors["22/coordinate_scale"]
    exponents = tensors["22/polynomial_exponents"].astype(int)
    units = np.eye(exponents.max() + 1)
    terms = np.array(
        [[np.prod([chebyshev.chebval(p[a], units[e[a]]) for a in range(5)]) for e in exponents] for p in x]
    )
    hidden = np.tanh(x @ tensors["22/mlp_weights_0"] + tensors["22/mlp_biases_0"])
    return (
        terms @ tensors["22/polynomial_coefficients"]
        + hidden @ tensors["22/mlp_weights_1"]
        + tensors["22/mlp_biases_1"]
    )


def reference(tensors, values, f, alignment):
    """Amplitude and phase inside the band."""
    p = ParameterBatch(values)
    names = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")
    theta = np.column_stack([p[name] for name in names])
    y = outputs(tensors, theta)
    residual = tensors["22/mean"] + y @ tensors["22/basis"]
    amplitude, phase = np.empty((len(p), len(f))), np.empty((len(p), len(f)))
    for i in range(len(p)):
        mass = p["total_mass"][i] * SOLAR_MASS_SECONDS
        mf = f * mass
        one = [theta[i : i + 1, k] for k in range(5)]
        spline_a = CubicSpline(np.log(tensors["22/amplitude_nodes"]), residual[i, :31])
        spline_p = CubicSpline(np.log(tensors["22/phase_nodes"]), residual[i, 31:])
        nu = p["mass_ratio"][i] / (1 + p["mass_ratio"][i]) ** 2
        scale = nu * mass**2 / (p["distance_mpc"][i] * MEGAPARSEC_SECONDS)
        amplitude[i] = scale * taylorf2_amplitude(mf, *one[:3])[0] * np.exp(spline_a(np.log(mf)))
        psi = taylorf2_phase(mf, *one)[0] + spline_p(np.log(mf))
        if alignment == "post_newtonian":
            first = tensors["22/phase_nodes"][0]
            slope = spline_p(np.log(first), 1) / first
            psi -= spline_p(np.log(first)) + slope * (mf - first)
        else:
            linear = tensors["22/merger_alignment"][0] + y[i] @ tensors["22/merger_alignment"][1:]
            psi += linear[0] + linear[1] * mf
        phase[i] = -psi + p["reference_phase"][i] + 2 * np.pi * f * p["time_shift"][i]
    return amplitude, phase


@pytest.mark.parametrize("alignment", ["post_newtonian", "merger"])
def test_amplitude_and_phase_equal_the_reference(model, tensors, alignment):
    values = random_batch(20)
    ours = model.predict_amplitude_phase(BAND, ParameterBatch(values), options=EvaluationOptions(alignment=alignment))
    amplitude, phase = reference(tensors, values, BAND, alignment)
    np.testing.assert_allclose(ours.amplitude, amplitude, rtol=1e-12)
    np.testing.assert_allclose(ours.phase, phase, rtol=1e-14, atol=2e-9)


def test_strain_is_amplitude_times_exp_i_phase_with_lal_polarizations(model):
    batch = ParameterBatch(random_batch(5))
    amplitude, phase = model.predict_amplitude_phase(BAND, batch)
    plus, cross = model.predict_batch(BAND, batch)
    h = amplitude * np.exp(1j * phase)
    cosine = np.cos(batch["inclination"])[:, None]
    np.testing.assert_allclose(plus, h * (1 + cosine**2) / 2, rtol=1e-13)
    np.testing.assert_allclose(cross, h * (-1j * cosine), rtol=1e-13)


def test_single_precision_is_the_rounded_double_precision(model):
    batch = ParameterBatch(random_batch(5))
    double = model.predict_factored(BAND, batch).h
    single = model.predict_factored(BAND, batch, dtype="complex64").h
    assert single.dtype == np.complex64
    np.testing.assert_array_equal(single, double.astype(np.complex64))


@pytest.mark.parametrize("size", [1, 2, 7, 16, 64])
def test_a_row_has_the_same_bits_in_every_batch(model, size):
    values = random_batch(64)
    alone = model.predict_batch(BAND, ParameterBatch(values)).plus
    for start in range(0, 64, size):
        part = model.predict_batch(BAND, ParameterBatch(values[start : start + size])).plus
        np.testing.assert_array_equal(part, alone[start : start + size])


def test_threads_give_the_same_bits(model):
    batch = ParameterBatch(random_batch(32))
    expected = model.predict_batch(BAND, batch).plus
    wrong = []

    def check():
        for _ in range(5):
            if not np.array_equal(model.predict_batch(BAND, batch).plus, expected):
                wrong.append(1)

    threads = [threading.Thread(target=check) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


@pytest.mark.parametrize("points", [1, 2, 3, 277, 1023, 1024, 1025, 5000])
def test_every_grid_size_equals_the_reference(model, tensors, points):
    f = np.geomspace(5.0, 2000.0, points) if points > 1 else np.array([100.0])
    values = random_batch(3, seed=points)
    amplitude, phase = model.predict_amplitude_phase(f, ParameterBatch(values))
    expected = reference(tensors, values, f, "post_newtonian")
    np.testing.assert_allclose(amplitude, expected[0], rtol=1e-12)
    np.testing.assert_allclose(phase, expected[1], rtol=1e-14, atol=2e-9)


def test_a_uniform_grid_is_its_frequencies(model):
    grid = UniformGrid(5.0, 2048.0, 0.25)
    batch = ParameterBatch(random_batch(2))
    np.testing.assert_array_equal(
        model.predict_batch(grid, batch).plus, model.predict_batch(grid.frequencies(), batch).plus
    )


def test_below_the_band_the_phase_is_the_baseline_and_the_amplitude_joins_smoothly(model):
    values = random_batch(4)
    values[:, 8:] = 0.0
    p = ParameterBatch(values)
    mass = p["total_mass"] * SOLAR_MASS_SECONDS
    edge = 5.0 * 2.0 / p["total_mass"]
    for i in range(4):
        f = edge[i] * np.geomspace(1e-3, 0.999999, 400)
        one = [p[name][i : i + 1] for name in ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")]
        amplitude, phase = model.predict_amplitude_phase(f, p.row(i))
        np.testing.assert_allclose(phase, -taylorf2_phase(f * mass[i], *one)[0], rtol=1e-13, atol=1e-9)
        scale = one[0] / (1 + one[0]) ** 2 * mass[i] ** 2 / (p["distance_mpc"][i] * MEGAPARSEC_SECONDS)
        bare = scale * taylorf2_amplitude(f * mass[i], *one[:3])[0]
        far = f < 0.5 * edge[i]
        np.testing.assert_allclose(amplitude[far], bare[far], rtol=1e-12)
        across = edge[i] * (1.0 + np.array([-4e-9, 4e-9]))
        joined = model.predict_amplitude_phase(across, p.row(i))
        assert joined.amplitude[0] == pytest.approx(joined.amplitude[1], rel=1e-7)
        baseline = -taylorf2_phase(across * mass[i], *one)[0]
        np.testing.assert_allclose(np.diff(joined.phase), np.diff(baseline), atol=1e-8)


def test_above_the_band_the_strain_is_zero(model):
    p = ParameterBatch(random_batch(4))
    f = np.array([1000.0, 4096.0 / p["total_mass"].max() * 2.0 * 1.01, 20000.0])
    plus = model.predict_batch(f, p).plus
    assert (plus[:, 0] != 0).all()
    assert (plus[:, 2] == 0).all()


def test_the_last_frequency_of_the_guaranteed_band_is_inside(model):
    values = random_batch(1)
    values[:, 7] = 4.0
    assert (model.predict_batch(np.array([5.0, 2048.0]), ParameterBatch(values)).plus != 0).all()


def test_inputs_stay_untouched_and_writable(model):
    f = np.geomspace(5.0, 100.0, 50)
    values = random_batch(3)
    before = f.copy(), values.copy()
    model.predict_batch(f, ParameterBatch(values))
    np.testing.assert_array_equal(f, before[0])
    np.testing.assert_array_equal(values, before[1])
    f[10] += 1e-9
    assert not np.array_equal(
        model.predict_batch(f, ParameterBatch(values)).plus, model.predict_batch(before[0], ParameterBatch(values)).plus
    )
