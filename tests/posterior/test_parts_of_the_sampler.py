"""What importance sampling is made of: the shape of tails, mixtures, bent coordinates."""

import numpy as np
import pytest

from bnserve_posterior.sampling import PLAIN, Problem, plain
from bnserve_posterior.sampling._bending import Bending
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._islands import islands
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._pareto import pareto_k
from bnserve_posterior.sampling._population import Population, advance
from bnserve_posterior.sampling._proposals import Proposal, inside


@pytest.mark.parametrize(("shape", "by_arviz"), [(0.1, 0.12666), (0.5, 0.49866), (0.9, 0.87061)])
def test_the_shape_of_a_tail_is_that_of_arviz(shape, by_arviz):
    """arviz-stats 0.8 of the same weights, of which its tail has one less."""
    quantiles = (np.arange(4000) + 0.5) / 4000
    weights = ((1.0 - quantiles) ** -shape - 1.0) / shape
    assert abs(pareto_k(weights) - shape) < 0.06
    assert abs(pareto_k(weights) - by_arviz) < 1e-3


def test_weights_that_are_alike_are_believed_and_a_single_one_is_not():
    assert pareto_k(np.ones(1000)) == -np.inf
    assert pareto_k(np.concatenate([np.zeros(999), [1.0]])) == np.inf


def two_clouds(random):
    return np.concatenate([random.normal(-2.0, 0.3, (400, 2)), random.normal(1.0, [0.2, 1.0], (600, 2))])


def test_a_mixture_integrates_to_one_and_draws_as_its_density_says():
    random = np.random.default_rng(4)
    points = two_clouds(random)
    mixture = Mixture.fit(points, np.full(1000, 1e-3), 6, 20, random)
    draws = mixture.draw(50_000, random)
    inside = (np.abs(draws) < 8.0).all(axis=1)
    box = random.uniform(-8.0, 8.0, (200_000, 2))
    assert abs(256.0 * np.exp(mixture.log_density(box)).mean() - inside.mean()) < 0.02
    assert abs(np.mean(draws[:, 0] < -0.5) - 0.4) < 0.03


def test_a_mixture_follows_the_weights():
    random = np.random.default_rng(5)
    points, weights = two_clouds(random), np.concatenate([np.full(400, 9.0), np.ones(600)])
    mixture = Mixture.fit(points, weights / weights.sum(), 6, 20, random)
    assert abs(np.mean(mixture.draw(50_000, random)[:, 0] < -0.5) - 3600.0 / 4200.0) < 0.03


def banana(random, count):
    y = random.standard_normal((count, 3))
    y[:, 0] = 0.05 * y[:, 0] + 0.4 * y[:, 1] ** 2 - 0.2 * y[:, 1] * y[:, 2]
    return y


def test_bananas_are_straight_in_learnt_coordinates_and_volumes_are_constant():
    random = np.random.default_rng(6)
    points = banana(random, 3000)
    bending = Bending.fit(points, np.full(3000, 1.0 / 3000))
    straight = bending.straight(banana(random, 1000))
    np.testing.assert_allclose(bending.bent(straight)[:, 1:], bending.bent(straight)[:, 1:])
    assert straight[:, -1].std() < 0.2
    far = 5.0 * random.standard_normal((100, 3))
    np.testing.assert_allclose(bending.bent(bending.straight(far)), far, atol=1e-9)
    step = 1e-6 * np.eye(3)
    for point in far[:5]:
        slopes = (bending.straight(point + step) - bending.straight(point - step)) / 2e-6
        assert abs(np.linalg.slogdet(slopes)[1] - bending.log_volume) < 1e-5


def test_few_points_do_not_bend():
    random = np.random.default_rng(7)
    assert Bending.fit(banana(random, 50), np.full(50, 0.02)).degree == 1


def test_plain_coordinates_can_be_undone_and_know_their_volume():
    u = np.random.default_rng(8).random((100, 3))
    y, volumes = PLAIN.from_cube(u)
    back, again = PLAIN.to_cube(y)
    np.testing.assert_allclose(back, u, rtol=1e-9)
    np.testing.assert_array_equal(again, volumes)
    np.testing.assert_allclose(volumes, -0.5 * np.sum(y**2 + np.log(2.0 * np.pi), axis=1))
    deep = PLAIN.to_cube(np.array([[-20.0, -30.0, 3.0]]))[0]
    np.testing.assert_allclose(PLAIN.from_cube(deep)[0], [[-20.0, -30.0, 3.0]], rtol=1e-9)


def three_islands(random, count):
    centres = np.array([[0.0, 0.0], [0.0, 8.0], [5.0, 8.0]])
    number = random.choice(3, count, p=[0.7, 0.25, 0.05])
    return centres[number] + random.standard_normal((count, 2)) * [0.5, 0.8], number


def test_islands_are_told_apart_and_one_cloud_is_one():
    random = np.random.default_rng(11)
    y, number = three_islands(random, 3000)
    found = islands(y, np.full(3000, 1.0 / 3000.0))
    assert [set(number[rows]) for rows in found] == [{0}, {1}, {2}]
    assert sum(map(len, found)) == 3000
    assert len(islands(random.standard_t(5, (3000, 8)), np.full(3000, 1.0 / 3000.0))) == 1
    assert len(islands(y[:7], np.full(7, 1.0 / 7.0))) == 1


def proposal_of_islands(random):
    coordinates = plain((1,))
    y, _ = three_islands(random, 3000)
    u = np.mod(np.stack([0.5 + 0.05 * y[:, 0], 0.05 * y[:, 1]], axis=1), 1.0)
    return Proposal.fit(Problem(two_peaks, 2, coordinates), u, np.full(3000, 1.0 / 3000.0), 6, 10, random)


def test_a_proposal_of_islands_draws_as_its_density_says():
    random = np.random.default_rng(12)
    proposal = proposal_of_islands(random)
    assert len(proposal.parts) == 3
    edges = np.linspace(0.0, 1.0, 101)
    middle = np.stack(np.meshgrid(*2 * [edges[:-1] + 0.005]), axis=-1).reshape(-1, 2)
    density = np.exp(proposal.log_density(middle)).reshape(100, 100)
    held, _, _ = np.histogram2d(*proposal.draw(200_000, random).T[::-1], bins=edges)
    assert abs(density.mean() - 1.0) < 0.02
    assert np.abs(density / 1e4 - held / 2e5).sum() < 0.1


def test_the_first_draws_are_as_the_last():
    random = np.random.default_rng(14)
    proposal = proposal_of_islands(random)
    first, last = np.split(proposal.draw(20_000, random), 2)
    for column in range(2):
        one, other = (np.histogram(each[:, column], 10, (0.0, 1.0))[0] for each in (first, last))
        assert np.abs(one - other).max() < 250  # five standard deviations


def test_steps_leave_what_is_drawn_as_it_is():
    random = np.random.default_rng(13)
    proposal = proposal_of_islands(random)

    def target(u):
        return 0.7 * proposal.log_density(u) - 3.0 * u[:, 0]

    random_points = proposal.draw(40_000, random)
    random_points = random_points[inside(random_points)]
    weights = np.exp(target(random_points) - proposal.log_density(random_points))
    before = random_points[random.choice(len(random_points), 20_000, p=weights / weights.sum())]
    now, taken = before.copy(), 0.0
    for _ in range(10):
        there, factor = proposal.step(now, random)
        some = inside(there)
        some = some[np.log(random.random(len(some))) < (target(there[some]) - target(now[some]) + factor[some])]
        now[some] = there[some]
        taken += len(some) / len(now) / 10
    assert 0.2 < taken < 0.95
    for column in range(2):
        one, other = (np.histogram(each[:, column], 20, (0.0, 1.0))[0] for each in (before, now))
        assert np.abs(one - other).max() < 300  # five standard deviations of what was drawn again


def two_peaks(points):
    """One at 0.2, and one at 0.8 that holds twenty times as much."""
    far = [np.sum((points - centre) ** 2, axis=1) / (2.0 * 0.01**2) for centre in (0.2, 0.8)]
    return np.logaddexp(-far[0], np.log(20.0) - far[1])


@pytest.mark.parametrize("twins", [None, lambda points, random: 1.0 - points], ids=["alone", "with twins"])
def test_a_population_finds_a_peak_that_it_has_lost_by_way_of_twins(twins):
    random = np.random.default_rng(9)
    points = 0.2 + 0.01 * random.standard_normal((400, 4))
    lost = Population(points, two_peaks(points), 0.9, 7)
    found = advance(Evaluator(Problem(two_peaks, 4, twins=twins), 4000), lost, 400, random)
    part = np.mean(found.points[:, 0] > 0.5)
    assert part == 0.0 if twins is None else abs(part - 20.0 / 21.0) < 0.06
