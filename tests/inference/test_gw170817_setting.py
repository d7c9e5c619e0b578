"""The priors of the GW170817 analysis, and the setting of the percentile-percentile test."""

import numpy as np

from benchmarks.gw170817 import coordinates, priors
from benchmarks.gw170817.setting import TRIGGER
from benchmarks.pp import trial, turning
from bnserve_inference import Detector, sidereal_time, time_delay


def test_the_time_is_that_of_the_arrival_at_hanford():
    u = np.random.default_rng(1).random((20, len(priors.NAMES)))
    batch = priors.UnitCube()(u)
    site, (now, _) = Detector.named("H1"), sidereal_time(TRIGGER)
    for row in range(len(batch)):
        delay = time_delay(site, batch["right_ascension"][row], batch["declination"][row], now)
        arrival = priors.ARRIVALS[0] + u[row, -1] * (priors.ARRIVALS[1] - priors.ARRIVALS[0])
        assert abs(batch["coalescence_time"][row] + delay - arrival) < 1e-9


def test_places_are_uniform_in_the_sky():
    u = np.random.default_rng(2).random((20_000, len(priors.NAMES)))
    batch = priors.UnitCube()(u)
    assert abs(np.mean(np.sin(batch["declination"]))) < 0.02
    assert abs(np.mean(np.sin(batch["declination"]) ** 2) - 1.0 / 3.0) < 0.01
    assert abs(np.mean(np.cos(batch["right_ascension"]))) < 0.02


def test_spins_follow_the_aligned_part_of_an_isotropic_prior():
    spins = priors.aligned_spins(np.random.default_rng(3).random(50_000))
    for fraction in (0.1, 0.3, 0.7):
        expected = fraction * (1.0 - np.log(fraction))
        assert abs(np.mean(np.abs(spins) < fraction * priors.LARGEST_SPIN) - expected) < 0.01
    assert abs(np.mean(spins > 0.0) - 0.5) < 0.01


def test_masses_are_flat_in_the_components():
    u = np.random.default_rng(4).random((2, 50_000))
    q, chirp_mass = priors.mass_ratios(u[0]), priors.chirp_masses(u[1])
    lighter = chirp_mass * (1.0 + q) ** 0.2 * q**-0.6
    weights = 1.0 / (chirp_mass * (1.0 + q) ** 0.4 * q**-1.2)
    # Undoing the density leaves a uniform distribution in (Mc, q): their weighted mean is the middle of the box.
    assert abs(np.average(q, weights=weights) - np.mean(priors.MASS_RATIOS)) < 0.02
    assert (lighter > 0.0).all()


def test_a_seed_is_a_binary():
    first, again, other = trial.draw(1), trial.draw(1), trial.draw(2)
    assert first[1] == again[1] != other[1]
    np.testing.assert_array_equal(first[0], again[0])
    assert trial.DISTANCES[0] <= first[1].distance_mpc <= trial.DISTANCES[1]


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
