"""Posteriors and evidences of likelihoods whose integrals are known."""

import numpy as np
import pytest
from scipy.stats import f as f_distribution

from bnserve_posterior.sampling import Problem, Settings, plain, sample
from tests.posterior.densities import (
    FREEDOM,
    WIDTHS,
    HeavyTails,
    aligned_spins,
    effective_spin,
    effective_spin_by_quadrature,
    normal,
    two_detectors,
)

FEW = Settings(particles=400, effective=2000)


def within(found, expected):
    """The evidence, of the whole and of either half, is less than four errors off: of many one is beyond three."""
    assert found.log_evidence_error < 0.05
    assert abs(found.log_evidence - expected) < 4.0 * found.log_evidence_error
    for value, error in found.log_evidences:
        assert abs(value - expected) < 4.0 * error


@pytest.mark.parametrize("seed", [1, 2])
def test_the_evidence_is_known_within_its_error_and_the_moments_are_right(seed):
    found = sample(Problem(normal, 4), Settings(particles=400, effective=2000, seed=seed))
    within(found, 0.0)
    assert found.effective >= 2000
    assert found.k_hat < 0.5
    assert abs(found.weights.sum() - 1.0) < 1e-9
    mean = found.weights @ found.points
    np.testing.assert_allclose(mean, 0.4, atol=4.0 * WIDTHS.max() / np.sqrt(2000))
    np.testing.assert_allclose(np.sqrt(found.weights @ (found.points - mean) ** 2), WIDTHS, rtol=0.06)
    np.testing.assert_array_equal(found.log_likelihood, normal(found.points))


def test_eleven_dimensions_heavy_tails_and_two_modes():
    density = HeavyTails(11)
    found, twice = (sample(Problem(density, 11), Settings(particles=count, effective=2000)) for count in (500, 1000))
    within(found, 0.0)
    within(twice, 0.0)
    distances = np.stack([density.distances(found.points, mode) for mode in (0, 1)])
    nearest = np.argmin(distances, axis=0)
    assert abs(found.weights[nearest == 0].sum() - 0.7) < 0.03
    far = distances[0] > 11.0 * f_distribution.isf(0.02, 11, FREEDOM)
    first = nearest == 0
    assert 0.008 < found.weights[first & far].sum() / found.weights[first].sum() < 0.035


def test_the_tails_of_the_spins_are_there():
    evidence, tail = effective_spin_by_quadrature()
    found = sample(Problem(effective_spin, 3), Settings(particles=500, effective=4000))
    within(found, np.log(evidence))
    share = found.weights[np.abs(aligned_spins(found.points[:, 1])) > 0.2].sum()
    assert abs(share - tail) < 4.0 * np.sqrt(tail / found.effective)


def test_both_places_in_the_sky_are_found_also_across_the_ends_of_a_circle():
    found = sample(Problem(two_detectors, 3, plain((1,))), FEW)
    within(found, 0.0)
    azimuth = np.abs(found.points[:, 1] - 0.5)
    assert abs(found.weights[azimuth > 0.25].sum() - 0.5) < 0.05
    assert abs(found.weights[found.points[:, 1] > 0.9].sum() - 0.25) < 0.05


@pytest.mark.parametrize("dimensions", [1, 20])
def test_from_one_dimension_to_twenty(dimensions):
    def centred(u):
        return -0.5 * np.sum(((u - 0.5) / 0.05) ** 2, axis=1) - dimensions * np.log(0.05 * np.sqrt(2.0 * np.pi))

    within(sample(Problem(centred, dimensions), Settings(particles=500, effective=1000)), 0.0)


def test_a_likelihood_that_is_the_same_everywhere_leaves_the_prior():
    found = sample(Problem(lambda u: np.zeros(len(u)), 2), FEW)
    within(found, 0.0)
    np.testing.assert_allclose(found.weights @ found.points, 0.5, atol=0.03)


def test_a_plateau_with_nothing_around_it():
    def box(u):
        return np.where((np.abs(u - 0.3) < 0.1).all(axis=1), 5.0, -np.inf)

    found = sample(Problem(box, 2), FEW)
    within(found, 5.0 + np.log(0.04))
    assert (np.abs(found.points - 0.3) < 0.1).all()


def test_a_posterior_at_the_edge_of_the_prior():
    def falling(u):
        return -100.0 * u[:, 0]

    found = sample(Problem(falling, 2), FEW)
    within(found, np.log(0.01))
    assert abs(found.weights @ found.points[:, 0] - 0.01) < 0.001


def test_draws_are_as_the_weights_say():
    found = sample(Problem(normal, 4), FEW)
    chosen = found.draw(1000)
    assert len(chosen) == 1000
    np.testing.assert_array_equal(chosen, found.draw(1000))
    np.testing.assert_allclose(found.points[chosen].mean(axis=0), found.weights @ found.points, atol=0.005)
    assert np.max(np.bincount(chosen)) <= np.ceil(1000 * found.weights.max())
