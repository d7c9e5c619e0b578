"""The coordinates of the regressor: one definition for numpy and numba, and exact bounds."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

from bnserve_protocol import InvalidParameters
from bnserve_surrogate._coordinates import (
    ANTISYMMETRIC_AXES,
    PHYSICAL_COORDINATES,
    SYMMETRIC_COORDINATES,
    CoordinateMap,
    physical_bounds,
    physical_coordinates,
    symmetric_bounds,
    symmetric_coordinates,
    transform_physical,
    transform_symmetric,
)

LOWER, UPPER = np.array([1.0, -0.5, -0.5, 5.0, 5.0]), np.array([3.0, 0.5, 0.5, 5000.0, 5000.0])


@njit
def compiled_physical(theta, out):
    transform_physical(theta[0], theta[1], theta[2], theta[3], theta[4], out)


@njit
def compiled_symmetric(theta, out):
    transform_symmetric(theta[0], theta[1], theta[2], theta[3], theta[4], out)


def draw(count, lower=LOWER, upper=UPPER):
    return np.random.default_rng(0).uniform(lower, upper, size=(count, 5))


def test_the_definition():
    coordinates = dict(
        zip(PHYSICAL_COORDINATES, physical_coordinates([[2.0, 0.3, -0.1, 400.0, 800.0]])[0], strict=True)
    )
    assert coordinates["log_mass_ratio"] == pytest.approx(np.log(2))
    assert coordinates["tide_1"] == pytest.approx(2 / 3 * 400**0.4)
    assert coordinates["tide_2"] == pytest.approx(1 / 3 * 800**0.4)
    assert coordinates["chi_hat"] == pytest.approx(0.2 - 0.1 / 3 - 38 / 113 * 2 / 9 * 0.2)
    assert coordinates["chi_antisymmetric"] == pytest.approx(0.2)


def test_symmetric_coordinates_are_the_physical_ones_with_sum_and_difference_of_the_tides():
    theta = draw(50)
    physical, symmetric = physical_coordinates(theta), symmetric_coordinates(theta)
    assert SYMMETRIC_COORDINATES[1:3] == ("tide_difference", "tide_sum")
    np.testing.assert_array_equal(symmetric[:, 1], physical[:, 1] - physical[:, 2])
    np.testing.assert_array_equal(symmetric[:, 2], physical[:, 1] + physical[:, 2])
    np.testing.assert_array_equal(symmetric[:, [0, 3, 4]], physical[:, [0, 3, 4]])


def test_swapped_labels_change_the_signs_of_three_coordinates_and_nothing_else():
    theta = draw(200)
    theta[:, 0] = 1.0
    coordinates = CoordinateMap.symmetric(LOWER, UPPER)
    signs = np.ones(5)
    signs[list(ANTISYMMETRIC_AXES)] = -1.0
    np.testing.assert_array_equal(coordinates(theta[:, [0, 2, 1, 4, 3]]), signs * coordinates(theta))


KINDS = [
    (compiled_physical, physical_coordinates, physical_bounds),
    (compiled_symmetric, symmetric_coordinates, symmetric_bounds),
]


@pytest.mark.parametrize(("compiled", "in_numpy", "bounds"), KINDS)
def test_numba_and_numpy_agree_to_rounding(compiled, in_numpy, bounds):
    theta = draw(200)
    out = np.empty(5)
    for row, expected in zip(theta, in_numpy(theta), strict=True):
        compiled(row, out)
        np.testing.assert_allclose(out, expected, rtol=1e-14, atol=1e-14)


ratios = st.tuples(st.floats(1, 6), st.floats(1, 6)).map(sorted)
spins = st.tuples(st.floats(-0.9, 0.9), st.floats(-0.9, 0.9)).map(sorted)
tides = st.tuples(st.floats(0, 5000), st.floats(0, 5000)).map(sorted)


@pytest.mark.parametrize(("compiled", "in_numpy", "bounds"), KINDS)
@given(intervals=st.tuples(ratios, spins, spins, tides, tides))
@settings(deadline=None)
def test_bounds_hold_everywhere_in_the_box_and_are_attained(compiled, in_numpy, bounds, intervals):
    lower, upper = np.array(intervals).T
    low, high = bounds(lower, upper)
    units = np.stack(np.meshgrid(np.linspace(0, 1, 41), *[[0.0, 1.0]] * 4, indexing="ij"), axis=-1).reshape(-1, 5)
    values = in_numpy(lower + (upper - lower) * units)
    slack = 1e-12 * (1 + np.abs(high) + np.abs(low))
    assert (values >= low - slack).all()
    assert (values <= high + slack).all()
    # Attained: between neighbours on this grid of mass ratios nothing changes by more than this.
    np.testing.assert_allclose(values.min(axis=0), low, atol=2e-3)
    np.testing.assert_allclose(values.max(axis=0), high, atol=2e-3)


@pytest.mark.parametrize("make", [CoordinateMap.physical, CoordinateMap.raw])
def test_the_box_is_mapped_into_the_unit_cube_and_fills_it(make):
    mapped = make(LOWER, UPPER)(np.vstack([draw(2000), LOWER, UPPER, np.where([0, 1, 0, 0, 1], UPPER, LOWER)]))
    assert np.abs(mapped).max() <= 1 + 1e-12
    assert (mapped.max(axis=0) - mapped.min(axis=0) > 1.7).all()


def test_the_symmetric_map_has_no_offset_where_the_labels_decide_the_sign():
    coordinates = CoordinateMap.symmetric(LOWER, UPPER)
    assert coordinates.offset[list(ANTISYMMETRIC_AXES)].tolist() == [0.0, 0.0, 0.0]
    mapped = coordinates(np.vstack([draw(2000), LOWER, UPPER]))
    assert np.abs(mapped).max() <= 1 + 1e-12
    assert (mapped.max(axis=0) - mapped.min(axis=0) > 0.9).all()


def test_a_parameter_that_does_not_vary_is_mapped_to_zero():
    lower, upper = LOWER.copy(), UPPER.copy()
    lower[[1, 2]] = upper[[1, 2]] = 0.0
    mapped = CoordinateMap.physical(lower, upper)(draw(50, lower, upper))
    assert (mapped[:, 3:] == 0).all()
    assert np.isfinite(mapped).all()


def test_standardised_parameters_have_mean_zero_and_deviation_one():
    theta = draw(500)
    mapped = CoordinateMap.standardised(theta)(theta)
    np.testing.assert_allclose(mapped.mean(axis=0), 0, atol=1e-12)
    np.testing.assert_allclose(mapped.std(axis=0), 1, rtol=1e-12)


def test_a_map_is_its_arrays():
    original = CoordinateMap.physical(LOWER, UPPER)
    copy = CoordinateMap(original.kind, original.offset.copy(), original.scale.copy())
    np.testing.assert_array_equal(copy(draw(10)), original(draw(10)))
    with pytest.raises(ValueError, match="read-only"):
        original.offset[0] = 1.0


def test_impossible_boxes_and_shapes_are_refused():
    with pytest.raises(InvalidParameters, match="lower <= upper"):
        CoordinateMap.physical(UPPER, LOWER)
    with pytest.raises(InvalidParameters, match="negative"):
        CoordinateMap.physical([1, 0, 0, -5, 0], UPPER)
    with pytest.raises(ValueError, match="shape"):
        physical_coordinates([1.0, 0.0, 0.0, 400.0, 400.0])
    with pytest.raises(ValueError, match="kind"):
        CoordinateMap("polar", np.zeros(5), np.ones(5))
    with pytest.raises(ValueError, match="scale"):
        CoordinateMap("raw", np.zeros(5), np.full(5, np.nan))
