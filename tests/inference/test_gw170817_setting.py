"""The paper's analysis of GW170817, and the setting of the percentile-percentile test."""

import numpy as np
import pytest

from benchmarks.gw170817 import comparing, setting
from benchmarks.pp import trial, turning
from bnserve_posterior.data import load_data
from bnserve_posterior.likelihoods import analysis_ranges
from bnserve_surrogate import Model


@pytest.fixture(scope="module")
def model():
    return Model.default()


def test_the_papers_prior_is_that_of_the_example(model):
    cube = setting.prior_cube()
    assert len(cube) == 11
    found = analysis_ranges(cube, model.description)
    assert found.keys() == setting.RANGES.keys()
    for name, ends in setting.RANGES.items():
        assert found[name] == pytest.approx(ends, rel=1e-6), name
    distance = cube.priors["luminosity_distance"]
    assert (distance.minimum, distance.maximum) == setting.DISTANCES


def test_the_example_and_the_other_benchmarks_have_the_same_data(model):
    """Segment, noise curves, signal, distance and noise; the example's own are in detectors that turn."""
    ours = load_data(setting.paper_event(), model, setting.MODES)
    theirs = setting.inject(setting.read_asds(), model)
    assert ours.injection["luminosity_distance"] == pytest.approx(theirs.truth.distance_mpc, rel=1e-6)
    for one, other in zip(ours.detectors, theirs.data, strict=True):
        assert (one.name, one.start_time, one.duration) == (other.name, other.start_time, other.duration)
        band = one.band(setting.F_MIN, setting.F_MAX)
        np.testing.assert_allclose(one.asd[band], other.asd[band], rtol=1e-6)
        np.testing.assert_allclose(one.strain[band] / one.asd[band], other.strain[band] / one.asd[band], atol=1e-4)


def test_divergences_tell_posteriors_apart():
    random = np.random.default_rng(1)
    one, same, other = ({"x": random.normal(shift, 1.0, 5000)} for shift in (0.0, 0.0, 0.5))
    assert comparing.divergences(one, one)["x"] == 0.0
    assert comparing.divergences(one, same)["x"] < 0.003
    assert comparing.divergences(one, other)["x"] == pytest.approx(0.031, abs=0.008)  # 0.25 / 8 to first order


def test_a_seed_is_a_binary():
    cube = trial.prior_cube()
    first, again, other = (trial.draw(cube, seed) for seed in (1, 1, 2))
    assert first == again != other
    assert trial.DISTANCES[0] <= first.distance_mpc <= trial.DISTANCES[1]
    assert (first.right_ascension, first.declination) == tuple(trial.PLACE.values())


def test_what_is_ranked_rises_with_the_place_in_the_prior():
    cube = trial.prior_cube()
    u = np.random.default_rng(3).random((200, len(trial.NAMES)))
    batch = cube.batch(cube(trial.places(cube, u)))
    found = trial.ranked(batch)
    assert tuple(sorted(found)) == tuple(sorted(trial.NAMES))
    for column, name in enumerate(trial.NAMES):
        np.testing.assert_array_equal(np.argsort(found[name]), np.argsort(u[:, column]))


def test_a_seed_is_a_binary_anywhere_in_the_sky_of_the_einstein_telescope():
    first, again, other = turning.draw(1), turning.draw(1), turning.draw(2)
    assert first.truth == again.truth != other.truth
    values = first.cube(first.u[None])
    assert values["theta_jn"][0] == first.truth.inclination
    assert values["psi"][0] == first.truth.polarization_angle
    heights = [np.sin(turning.draw(seed).truth.declination) for seed in range(40)]
    assert min(heights) < -0.7
    assert max(heights) > 0.7
    assert turning.DISTANCES[0] <= first.truth.distance_mpc <= turning.DISTANCES[1]
