"""The coordinates of the regressor: one definition for numpy and numba, and exact bounds."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

from bnserve_protocol import InvalidParameters
from bnserve_surrogate._coordinates import (
    PHYSICAL_COORDINATES,
    CoordinateMap,
    physical_bounds,
    physical_coordinates,
    transform_physical,
)

LOWER, UPPER = np.array([1.0, -0.5, -0.5, 5.0, 5.0]), np.array([3.0, 0.5, 0.5, 5000.0, 5000.0])


@njit
def compiled(theta, out):
    transform_physical(theta[0], theta[1], theta[2], theta[3], theta[4], out)


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


def test_numba_and_numpy_agree_to_rounding():
    theta = draw(200)
    out = np.empty(5)
    for row, expected in zip(theta, physical_coordinates(theta), strict=True):
        compiled(row, out)
        np.testing.assert_allclose(out, expected, rtol=1e-14, atol=1e-16)


ratios = st.tuples(st.floats(1, 6), st.floats(1, 6)).map(sorted)
spins = st.tuples(st.floats(-0.9, 0.9), st.floats(-0.9, 0.9)).map(sorted)
tides = st.tuples(st.floats(0, 5000), st.floats(0, 5000)).map(sorted)


@given(st.tuples(ratios, spins, spins, tides, tides))
@settings(deadline=None)
def test_bounds_hold_everywhere_in_the_box_and_are_attained(intervals):
    lower, upper = np.array(intervals).T
    low, high = physical_bounds(lower, upper)
    units = np.stack(np.meshgrid(np.linspace(0, 1, 41), *[[0.0, 1.0]] * 4, indexing="ij"), axis=-1).reshape(-1, 5)
    values = physical_coordinates(lower + (upper - lower) * units)
    slack = 1e-12 * (1 + np.abs(high))
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
