"""The model's own estimate keeps its promise, in the middle and on the edges, for binaries nobody has measured."""

import numpy as np
import pytest

from bnserve_surrogate.training.validation.error_estimate import (
    PROMISED_FACTOR,
    fit_error_estimate,
    with_error_estimate,
)
from tests.surrogate.plain_reference import evaluate_exported

EDGE_SCATTER = 1.5


def binaries(seed, count=1024, edges=512):
    """Coordinates, mismatches and kinds: the edges are worse and scatter more, and a fifth of them are corners."""
    random = np.random.default_rng(seed)
    middle, faces = random.uniform(-1.0, 1.0, (count, 5)), random.uniform(-1.0, 1.0, (edges, 5))
    faces[:, 0] = np.sign(faces[:, 0])
    corners = random.random(edges) < 0.2
    faces[corners] = np.sign(faces[corners])
    points = np.vstack([middle, faces])
    kinds = np.repeat([0, 1], [count, edges])
    scatter = random.normal(size=len(points)) * np.where(kinds == 1, EDGE_SCATTER, 0.4)
    return points, np.exp(-20.0 + points[:, 3] - points[:, 1] ** 2 + 2.0 * kinds + scatter), kinds


def exceeding(estimate, seed, kind):
    points, mismatch, kinds = binaries(seed, 20_000, 20_000)
    return np.mean((mismatch > PROMISED_FACTOR * estimate(points))[kinds == kind])


@pytest.mark.parametrize("kind", [0, 1])
def test_at_most_one_fresh_binary_in_a_hundred_exceeds_three_times_the_estimate(kind):
    """With 95 % confidence: so many calibrations of twenty may miss it, and by little."""
    shares = np.array([exceeding(fit_error_estimate(*binaries(seed)), 1000 + seed, kind) for seed in range(20)])
    assert np.sum(shares > 0.01) <= 2
    assert shares.max() < 0.015


def test_calibrated_together_the_edges_would_break_the_promise():
    points, mismatch, kinds = binaries(3)
    together = fit_error_estimate(points, mismatch, np.zeros_like(kinds))
    assert exceeding(together, 1003, 1) > 0.01


def test_it_is_no_larger_than_the_promise_needs():
    """Of the kind that decides; else an estimate of one would do."""
    shares = [exceeding(fit_error_estimate(*binaries(seed)), 1000 + seed, 1) for seed in range(8)]
    assert np.mean(shares) > 0.001


def test_a_place_that_is_drawn_again_and_again_is_not_its_own_judge():
    """Sixteen copies of one corner, a thousand times worse: a fit that has seen fifteen would expect the last."""
    points, mismatch, kinds = binaries(5, 400, 0)
    corner = np.ones((16, 5))
    worse = np.full(16, 1e3 * mismatch.max())
    all_points, all_mismatch = np.vstack([points, corner]), np.concatenate([mismatch, worse])
    estimate = fit_error_estimate(all_points, all_mismatch, np.concatenate([kinds, np.ones(16, dtype=int)]))
    without = fit_error_estimate(points, mismatch, kinds)
    assert PROMISED_FACTOR * estimate(corner)[0] >= worse[0]
    assert np.median(estimate(points) / without(points)) > 100.0


def test_from_a_few_waveforms_there_is_none():
    points, mismatch, kinds = binaries(1, 60, 39)
    assert fit_error_estimate(points, mismatch, kinds) is None


@pytest.mark.parametrize("with_network", [False, True])
def test_it_becomes_the_last_output_of_the_regressor_and_changes_no_other(with_network):
    points, mismatch, kinds = binaries(2)
    estimate = fit_error_estimate(points, mismatch, kinds)
    random = np.random.default_rng(7)
    regressor = {
        "polynomial_exponents": np.array([[0, 0, 0, 0, 0], [0, 7, 0, 0, 0]], dtype=np.uint8),
        "polynomial_coefficients": random.normal(size=(2, 4)),
    }
    if with_network:
        regressor |= {"mlp_weights_0": random.normal(size=(5, 3)), "mlp_biases_0": random.normal(size=3),
                      "mlp_weights_1": random.normal(size=(3, 4)), "mlp_biases_1": random.normal(size=4)}  # fmt: skip
    tensors = {f"22/{name}": array for name, array in regressor.items()}
    tensors |= {"22/basis": random.normal(size=(4, 9)), "22/merger_alignment": np.zeros((5, 2))}
    widened = with_error_estimate(tensors, estimate)
    arrays = {name.removeprefix("22/"): array for name, array in widened.items()}
    outputs = evaluate_exported(arrays, points)
    np.testing.assert_allclose(outputs[:, :4], evaluate_exported(regressor, points), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(np.exp(outputs[:, 4]), estimate(points), rtol=1e-9)
    assert arrays["basis"].shape == (5, 9)
    assert not arrays["basis"][4].any()
