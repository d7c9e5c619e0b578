"""Noise curves, quadrature, the metric in which distance is mismatch, and principal components in it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from bnserve_protocol import InvalidFrequencies, InvalidParameters
from bnserve_surrogate.training.data.noise import (
    NOISE_CURVES,
    _einstein_telescope_table,
    advanced_ligo_design,
    einstein_telescope_d,
    noise_curve,
    noise_weights,
    trapezoid_weights,
)
from bnserve_surrogate.training.reduction.metric import MismatchMetric, node_weights, spline_matrix
from bnserve_surrogate.training.reduction.reductions import MetricReduction, PaperReduction, PrincipalComponents
from bnserve_surrogate.training.validation.mismatch import NodeMismatch

DENSE = np.geomspace(10.0, 2048.0, 3000)
WEIGHTS = noise_weights(DENSE, DENSE ** (-7 / 6), einstein_telescope_d)
AMPLITUDE_NODES, PHASE_NODES = np.geomspace(10.0, 2048.0, 40), np.geomspace(10.0, 2048.0, 60)
METRIC = MismatchMetric.from_dense(AMPLITUDE_NODES, PHASE_NODES, DENSE, WEIGHTS)


def smooth(coefficients, nodes):
    """Smooth functions of log f: Chebyshev series, coefficients (N, m) -> values (N, n)."""
    return np.polynomial.chebyshev.chebval(
        np.log(nodes / nodes[0]) / np.log(nodes[-1] / nodes[0]) * 2 - 1, coefficients.T
    )


def population(count, seed=0):
    rng = np.random.default_rng(seed)
    decay = 0.5 ** np.arange(10)
    return (
        smooth(0.01 * rng.normal(size=(count, 10)) * decay, AMPLITUDE_NODES),
        smooth(0.01 * rng.normal(size=(count, 10)) * decay, PHASE_NODES),
    )


# --- noise


def test_the_einstein_telescope_curve_is_its_table_and_a_power_law_between_rows():
    assert einstein_telescope_d(np.array([1.0, 1e4])) == pytest.approx([1.2221678e-33, 2.9411763e-47], rel=1e-6)
    rows, density = _einstein_telescope_table()
    between = einstein_telescope_d(np.sqrt(rows[1:] * rows[:-1]))
    np.testing.assert_allclose(between, np.sqrt(density[1:] * density[:-1]), rtol=1e-12)


def test_the_einstein_telescope_curve_agrees_with_lalsimulation():
    lal, lalsimulation = pytest.importorskip("lal"), pytest.importorskip("lalsimulation")
    theirs = lal.CreateREAL8FrequencySeries("", 0, 0.0, 1.0, lal.DimensionlessUnit, 2900)
    lalsimulation.SimNoisePSDEinsteinTelescopeP1600143(theirs, 3.0)
    bins = np.arange(4, 2900)
    assert einstein_telescope_d(1.0 * bins) == pytest.approx(theirs.data.data[bins], rel=0.02)


def test_the_fit_of_advanced_ligo_is_within_its_stated_error_of_lalsimulation():
    lalsimulation = pytest.importorskip("lalsimulation")
    grid = np.geomspace(25.0, 4000.0, 200)
    theirs = np.array([lalsimulation.SimNoisePSDaLIGOZeroDetHighPower(f) for f in grid])
    assert np.abs(advanced_ligo_design(grid) / theirs - 1).max() < 0.13


@pytest.mark.parametrize("name", NOISE_CURVES)
def test_every_named_curve_is_positive_over_the_bands_it_accepts(name):
    assert (noise_curve(name)(np.geomspace(10.0, 4000.0, 100)) > 0).all()


def test_frequencies_outside_a_curve_and_unknown_names_are_refused():
    with pytest.raises(InvalidFrequencies, match="1 to 10000 Hz"):
        einstein_telescope_d(np.array([0.5, 20.0]))
    with pytest.raises(InvalidFrequencies, match="10 Hz"):
        advanced_ligo_design(np.array([5.0]))
    with pytest.raises(InvalidParameters, match="ET-D"):
        noise_curve("ET-B")


# --- quadrature


@given(arrays(float, 5, elements=st.floats(0.1, 3.0)), st.floats(-2, 2), st.floats(-2, 2))
def test_the_trapezoid_rule_is_exact_for_straight_lines(steps, slope, constant):
    grid = np.cumsum(steps)
    exact = slope * (grid[-1] ** 2 - grid[0] ** 2) / 2 + constant * (grid[-1] - grid[0])
    assert trapezoid_weights(grid) @ (slope * grid + constant) == pytest.approx(exact, abs=1e-12)


def test_noise_weights_are_normalised_per_waveform():
    weights = noise_weights(DENSE, np.stack([DENSE**-1, 5 * DENSE**-1]), einstein_telescope_d)
    assert weights.sum(axis=1) == pytest.approx([1, 1], rel=1e-13)
    np.testing.assert_allclose(weights[0], weights[1], rtol=1e-12)


def test_splines_reproduce_cubics_in_log_frequency_and_refuse_to_extrapolate():
    cubic = np.poly1d([0.3, -1.0, 2.0, 5.0])
    spline = spline_matrix(AMPLITUDE_NODES, DENSE)
    np.testing.assert_allclose(spline @ cubic(np.log(AMPLITUDE_NODES)), cubic(np.log(DENSE)), rtol=1e-10)
    with pytest.raises(ValueError, match="extrapolated"):
        spline_matrix(AMPLITUDE_NODES, DENSE * 1.1)


def test_node_weights_integrate_smooth_functions_like_the_dense_grid():
    weights = node_weights(PHASE_NODES, DENSE, WEIGHTS)
    assert (weights > 0).all()
    assert weights.sum() == pytest.approx(1, rel=1e-13)
    at_nodes, dense = (smooth(np.array([[0.2, 1.0, -0.5, 0.3]]), grid)[0] for grid in (PHASE_NODES, DENSE))
    assert weights @ at_nodes**2 == pytest.approx(WEIGHTS @ dense**2, rel=1e-5)


def test_node_weights_are_positive_even_on_nodes_too_coarse_for_splines():
    assert (node_weights(np.array([10.0, 12.0, 900.0, 1000.0, 2048.0]), DENSE, WEIGHTS) > 0).all()


# --- metric


@given(st.integers(0, 10_000), st.floats(1e-5, 1e-3))
@settings(max_examples=30, deadline=None)
def test_squared_distance_is_the_mismatch_to_second_order(seed, size):
    amplitude, phase = (size / 0.01 * part for part in population(2, seed))
    first, second = METRIC.transform(amplitude, phase).vectors
    measured = NodeMismatch(AMPLITUDE_NODES, PHASE_NODES, DENSE, WEIGHTS)(
        amplitude[:1] - amplitude[1:], phase[:1] - phase[1:]
    ).mismatch[0]
    # Third order is a relative error of the size of the differences; quadrature at the nodes costs the rest.
    assert np.sum((first - second) ** 2) == pytest.approx(measured, rel=20 * size + 1e-4)


@given(st.integers(0, 10_000), st.floats(-300, 300), st.floats(-0.1, 0.1), st.floats(-3, 3))
@settings(max_examples=50, deadline=None)
def test_amplitude_phase_and_time_are_projected_out_and_returned(seed, angle, time, level):
    amplitude, phase = population(1, seed)
    slope = 2 * np.pi * time
    before = METRIC.transform(amplitude, phase)
    after = METRIC.transform(amplitude + level, phase + angle + slope * (PHASE_NODES - METRIC.reference_frequency))
    np.testing.assert_allclose(after.vectors, before.vectors, atol=1e-12)
    assert after.log_amplitude - before.log_amplitude == pytest.approx(level, abs=1e-12)
    assert after.phase - before.phase == pytest.approx(angle, abs=1e-10)
    assert after.phase_slope - before.phase_slope == pytest.approx(slope, abs=1e-12)


def test_the_projection_is_idempotent_and_everything_together_is_invertible():
    amplitude, phase = population(20)
    phase += 40.0 + 3.0 * PHASE_NODES
    coordinates = METRIC.transform(amplitude, phase)
    again = METRIC.transform(*METRIC.residuals(coordinates.vectors))
    np.testing.assert_allclose(again.vectors, coordinates.vectors, atol=1e-15)
    for scalar in (again.log_amplitude, again.phase):
        np.testing.assert_allclose(scalar, 0, atol=1e-15)
    restored = METRIC.inverse_transform(coordinates)
    np.testing.assert_allclose(restored[0], amplitude, atol=1e-13)
    np.testing.assert_allclose(restored[1], phase, rtol=1e-13)


def test_a_metric_needs_positive_weights_and_three_phase_nodes():
    with pytest.raises(ValueError, match="positive"):
        MismatchMetric([1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 2.0, 3.0])
    with pytest.raises(ValueError, match="three"):
        MismatchMetric([1.0, 1.0], [1.0, 1.0], [1.0, 2.0])
    with pytest.raises(ValueError, match=r"\(N, 40\)"):
        METRIC.transform(np.zeros((2, 3)), np.zeros((2, 60)))


# --- principal components


@given(st.integers(0, 10_000), st.integers(1, 8))
@settings(max_examples=30, deadline=None)
def test_components_are_orthonormal_ordered_and_leave_the_rest_of_the_variance(seed, count):
    samples = np.random.default_rng(seed).normal(size=(60, 8)) * np.geomspace(1, 1e-3, 8) + 5.0
    original = samples.copy()
    analysis = PrincipalComponents(count).fit(samples)
    np.testing.assert_allclose(analysis.components_ @ analysis.components_.T, np.eye(count), atol=1e-12)
    assert (np.diff(analysis.eigenvalues_) <= 0).all()
    restored = analysis.inverse_transform(analysis.transform(samples))
    rest = samples.var(axis=0).sum() - analysis.eigenvalues_.sum()
    assert np.mean(np.sum((restored - samples) ** 2, axis=1)) == pytest.approx(rest, abs=1e-12)
    np.testing.assert_array_equal(samples, original)


def test_the_sign_does_not_depend_on_the_samples_order_or_sign():
    samples = np.random.default_rng(0).normal(size=(100, 5)) * [5, 4, 3, 2, 1]
    reference = PrincipalComponents(5).fit(samples).components_
    np.testing.assert_allclose(PrincipalComponents(5).fit(-samples[::-1]).components_, reference, atol=1e-12)


def test_principal_components_refuse_too_few_samples_and_failed_waveforms():
    with pytest.raises(ValueError, match="30 components of 10"):
        PrincipalComponents(30).fit(np.zeros((10, 50)))
    with pytest.raises(ValueError, match="finite"):
        PrincipalComponents(1).fit(np.full((10, 5), np.nan))


# --- reductions


@pytest.mark.parametrize(
    "reduction",
    [MetricReduction(METRIC, 20), PaperReduction(20)],
    ids=["metric", "paper"],
)
def test_reductions_are_affine_maps_given_by_their_basis_at_the_nodes(reduction):
    amplitude, phase = population(200)
    phase += np.linspace(-3, 3, 200)[:, None] * (1 + PHASE_NODES / 100)
    reduced = reduction.fit(amplitude, phase).transform(amplitude, phase)
    restored = reduction.inverse_transform(reduced)
    # Covariances of phases of 100 rad are rounded at 1e-12: square roots of that show.
    np.testing.assert_allclose(restored[0], amplitude, atol=1e-7)
    np.testing.assert_allclose(restored[1], phase, atol=1e-7)
    no_scalars = reduced._replace(log_amplitude=np.zeros(200), phase=np.zeros(200), phase_slope=np.zeros(200))
    mean, basis = reduction.node_basis()
    plain = np.hstack(reduction.inverse_transform(no_scalars))
    np.testing.assert_allclose(mean + reduced.components @ basis, plain, atol=1e-10)


def test_half_as_many_components_in_the_metric_lose_less_mismatch_than_the_papers():
    train, test = population(400, 1), population(100, 2)
    measure = NodeMismatch(AMPLITUDE_NODES, PHASE_NODES, DENSE, WEIGHTS)

    def loss(reduction):
        restored = reduction.fit(*train).inverse_transform(reduction.transform(*test))
        return measure(restored[0] - test[0], restored[1] - test[1]).mismatch.mean()

    assert loss(MetricReduction(METRIC, 6)) < 0.5 * loss(PaperReduction(6))


def test_squared_distances_of_components_are_mismatches():
    train = population(400, 1)
    reduction = MetricReduction(METRIC, 18).fit(*train)
    components = reduction.transform(*train).components
    measured = NodeMismatch(AMPLITUDE_NODES, PHASE_NODES, DENSE, WEIGHTS)(
        train[0][1:50] - train[0][0], train[1][1:50] - train[1][0]
    ).mismatch
    np.testing.assert_allclose(np.sum((components[1:50] - components[0]) ** 2, axis=1), measured, rtol=0.02)
