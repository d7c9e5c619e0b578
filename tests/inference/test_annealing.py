"""The annealed population: evidence and posterior of likelihoods whose integrals are known."""

import numpy as np
import pytest

from benchmarks.gw170817 import coordinates
from benchmarks.gw170817.annealing import Annealing, anneal
from benchmarks.gw170817.bridge import bridge
from benchmarks.gw170817.mixture import Mixture
from benchmarks.gw170817.moving import PLAIN

WIDTHS = np.array([0.02, 0.01, 0.05, 0.03])
SETTINGS = Annealing(pool=2000, particles=500, components=4, draws=2000)


def normal(u):
    """A normalised density in the unit cube, whose evidence is one."""
    return -0.5 * np.sum(((u - 0.4) / WIDTHS) ** 2, axis=1) - np.sum(np.log(WIDTHS * np.sqrt(2.0 * np.pi)))


@pytest.mark.parametrize("seed", [1, 2])
def test_the_evidence_is_known_within_its_error_and_the_moments_are_right(seed):
    found = anneal(normal, 4, Annealing(**{**vars(SETTINGS), "seed": seed}), PLAIN, None)
    assert found.log_evidence_error < 0.05
    assert abs(found.log_evidence) < 4.0 * found.log_evidence_error
    assert 500 < found.effective <= len(found.points) == 2000
    np.testing.assert_allclose(found.points.mean(axis=0), 0.4, atol=0.15 * WIDTHS.max())
    np.testing.assert_allclose(found.points.std(axis=0), WIDTHS, rtol=0.15)


def test_both_modes_are_found():
    def two_modes(u):
        return np.logaddexp(normal(u), normal(1.0 - u))

    found = anneal(two_modes, 4, SETTINGS, PLAIN, None)
    assert 0.4 < np.mean(found.points[:, 0] < 0.5) < 0.6
    assert abs(found.log_evidence - np.log(2.0)) < 0.2


class Stopped(Exception):
    pass


def test_a_run_that_was_stopped_ends_with_the_same_bits(tmp_path):
    calls = 0

    def fails_once(u):
        nonlocal calls
        calls += 1
        if calls == 60:
            raise Stopped
        return normal(u)

    checkpoint = tmp_path / "annealing.npz"
    with pytest.raises(Stopped):
        anneal(fails_once, 4, SETTINGS, PLAIN, checkpoint)
    assert checkpoint.exists()
    resumed, direct = anneal(normal, 4, SETTINGS, PLAIN, checkpoint), anneal(normal, 4, SETTINGS, PLAIN, None)
    assert resumed.points.tobytes() == direct.points.tobytes()
    assert resumed.log_evidence == direct.log_evidence


def test_bridge_sampling_gives_the_volume_and_its_scatter():
    random = np.random.default_rng(3)
    found = []
    for _ in range(200):
        samples, draws = random.standard_normal(400), 1.5 * random.standard_normal(600)
        ratios = [-0.5 * x**2 + 0.5 * (x / 1.5) ** 2 + np.log(1.5 * np.sqrt(2.0 * np.pi)) for x in (samples, draws)]
        found.append(bridge(*ratios, 400))
    values, errors = np.array(found).T
    assert abs(values.mean() - 0.5 * np.log(2.0 * np.pi)) < 0.01
    assert 0.8 < values.std() / errors.mean() < 1.25


def test_a_mixture_integrates_to_one_and_draws_as_its_density_says():
    random = np.random.default_rng(4)
    points = np.concatenate([random.normal(-2.0, 0.3, (400, 2)), random.normal(1.0, [0.2, 1.0], (600, 2))])
    mixture = Mixture.fit(points, 6, random)
    draws = mixture.draw(50_000, random)
    inside = (np.abs(draws) < 8.0).all(axis=1)
    box = random.uniform(-8.0, 8.0, (200_000, 2))
    assert abs(256.0 * np.exp(mixture.log_density(box)).mean() - inside.mean()) < 0.02
    assert abs(np.mean(draws[:, 0] < -0.5) - 0.4) < 0.03


def test_coordinates_of_a_binary_can_be_undone_and_know_their_volume():
    u = np.random.default_rng(5).uniform(0.05, 0.95, (300, 9))
    y, volumes = coordinates.from_cube(u)
    back, again = coordinates.to_cube(y)
    np.testing.assert_allclose(back, u, atol=1e-5)
    np.testing.assert_allclose(again, volumes, rtol=0.0, atol=1e-6)
    step = 1e-5
    for row in range(5):
        moved = np.repeat(u[row][None], 18, axis=0)
        moved[np.arange(9), np.arange(9)] += step
        moved[np.arange(9, 18), np.arange(9)] -= step
        there = coordinates.from_cube(moved)[0]
        _, size = np.linalg.slogdet((there[:9] - there[9:]) / (2.0 * step))
        assert abs(size + volumes[row]) < 0.05  # aligned_spins interpolates a table, which has steps in its slope
