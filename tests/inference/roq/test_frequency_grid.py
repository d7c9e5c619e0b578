"""The thinned grid: points of the full grid, sums of the full grid."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_inference.roq._frequency_grid import FrequencyGrid, summation_weights, thinned_grid
from bnserve_inference.roq._interpolant import evaluate_term
from bnserve_inference.roq._sampling import Prior
from bnserve_protocol import OutOfBand, OutOfDomain, UniformGrid
from tests.inference.roq.tiny import tiny

PRIOR = Prior(tiny().prior.ranges)
FULL = UniformGrid(f_min=60.0, f_max=400.0, delta_f=0.25)


@pytest.fixture(scope="module")
def grid(model):
    return thinned_grid(model, PRIOR, FULL, "merger", 1)


@given(
    gaps=st.lists(st.integers(1, 9), min_size=8, max_size=30),
    powers=st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=6),
)
def test_sums_of_polynomials_are_exact(gaps, powers):
    indices = np.concatenate([[0], np.cumsum(gaps)])
    weights = summation_weights(indices)
    everywhere = np.arange(indices[-1] + 1)
    values = np.polynomial.Polynomial(powers)(everywhere / indices[-1])
    assert weights @ values[indices] == pytest.approx(values.sum(), abs=1e-9 * len(everywhere))


def test_a_grid_of_all_points_has_weights_one():
    np.testing.assert_allclose(summation_weights(np.arange(20)), 1.0, atol=1e-12)


def test_the_points_are_points_of_the_full_grid(grid):
    assert set(grid.frequencies) <= set(FULL.frequencies())
    assert (grid.indices[0], grid.indices[-1]) == (0, len(FULL) - 1)
    assert len(grid) < len(FULL) / 4


@pytest.mark.parametrize("term", ["linear", "quadratic"])
def test_inner_products_are_those_of_the_full_grid(grid, model, term):
    values = evaluate_term(model, FULL.frequencies(), PRIOR.draw(20, 99), term, "merger")
    values /= np.linalg.norm(values, axis=1)[:, None]
    thinned = values[:, grid.indices]
    np.testing.assert_allclose((thinned.conj() * grid.weights) @ thinned.T, values.conj() @ values.T, atol=3e-7)


def test_a_grid_half_as_fine_would_not_do(grid, model):
    coarse = np.unique(np.append(grid.indices[::8], len(FULL) - 1))
    worse = FrequencyGrid(FULL, coarse, summation_weights(coarse), 0.0)
    values = evaluate_term(model, FULL.frequencies(), PRIOR.draw(20, 99), "linear", "merger")
    values /= np.linalg.norm(values, axis=1)[:, None]
    thinned = values[:, worse.indices]
    assert np.abs((thinned.conj() * worse.weights) @ thinned.T - values.conj() @ values.T).max() > 1e-4


def test_a_short_band_is_not_thinned(model):
    full = UniformGrid(f_min=60.0, f_max=70.0, delta_f=1.0)
    grid = thinned_grid(model, PRIOR, full, "merger", 1)
    np.testing.assert_array_equal(grid.frequencies, full.frequencies())
    np.testing.assert_array_equal(grid.weights, 1.0)


def test_a_prior_beyond_the_model_is_refused(model):
    prior = Prior({**PRIOR.ranges, "mass_ratio": (1.0, 8.0)})
    with pytest.raises(OutOfDomain, match="mass_ratio"):
        thinned_grid(model, prior, FULL, "merger", 1)


def test_a_band_beyond_the_model_is_refused(model):
    with pytest.raises(OutOfBand):
        thinned_grid(model, PRIOR, UniformGrid(f_min=60.0, f_max=5000.0, delta_f=1.0), "merger", 1)
