"""Posteriors and evidences of likelihoods whose integrals are known."""

import numpy as np

from bnserve_posterior.sampling import Problem, Settings, sample

WIDTHS = np.array([0.02, 0.01, 0.05, 0.03])


def normal(u):
    """A normalised density in the unit cube, whose evidence is one."""
    return -0.5 * np.sum(((u - 0.4) / WIDTHS) ** 2, axis=1) - np.sum(np.log(WIDTHS * np.sqrt(2.0 * np.pi)))


def test_the_evidence_is_known_within_its_error_and_the_moments_are_right():
    found = sample(Problem(normal, 4), Settings(particles=1000, effective=3000))
    assert found.log_evidence_error < 0.05
    assert abs(found.log_evidence) < 3.0 * found.log_evidence_error
    assert found.effective >= 3000
    assert found.k_hat < 0.7
    mean = found.weights @ found.points
    np.testing.assert_allclose(mean, 0.4, atol=0.05 * WIDTHS.max())
    np.testing.assert_allclose(np.sqrt(found.weights @ (found.points - mean) ** 2), WIDTHS, rtol=0.05)
