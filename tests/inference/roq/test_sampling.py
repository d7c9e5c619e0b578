"""Draws that depend on their key alone."""

import numpy as np
import pytest

from bnserve_inference.roq._sampling import CHUNK_ROWS, Draws, Prior
from tests.inference.roq.tiny import tiny

RANGES = tiny().prior.ranges


def chirp_mass(binaries):
    q = binaries["mass_ratio"]
    return binaries["total_mass"] * q**0.6 / (1.0 + q) ** 1.2


def test_draws_are_inside_the_prior():
    drawn = Prior(RANGES, arcsine_fraction=0.5).draw(2000, 1)
    columns = {"chirp_mass": chirp_mass(drawn), **{name: drawn[name] for name in RANGES if name != "chirp_mass"}}
    for name, (low, high) in RANGES.items():
        assert low * (1 - 1e-12) <= columns[name].min() if low > 0 else low <= columns[name].min()
        assert columns[name].max() <= high * (1 + 1e-12)
        assert np.ptp(columns[name]) > 0.95 * (high - low)


def test_the_same_key_gives_the_same_draws_and_another_gives_others():
    prior = Prior(RANGES)
    np.testing.assert_array_equal(prior.draw(10, 1, 2).values, prior.draw(10, 1, 2).values)
    assert not np.array_equal(prior.draw(10, 1, 2).values, prior.draw(10, 1, 3).values)


@pytest.mark.parametrize(("fraction", "share"), [(0.0, 0.02), (1.0, 0.128)])
def test_arcsine_draws_crowd_at_both_ends(fraction, share):
    drawn = Prior(RANGES, fraction).draw(20_000, 5)["chi_1"]
    at_the_ends = np.mean(np.abs(drawn) > 0.98 * 0.05)
    assert at_the_ends == pytest.approx(share, rel=0.1)


def test_single_draws_are_found_again_by_their_number():
    draws = Draws(Prior(RANGES), 3 * CHUNK_ROWS + 5, (4,), corners=True)
    everything = np.concatenate([draws.chunk(number).values for number in range(draws.chunks)])
    wanted = [CHUNK_ROWS + 3, 0, len(everything) - 1]
    assert len(everything) == draws.count
    np.testing.assert_array_equal(draws.rows(wanted).values, everything[wanted])


def test_corners_come_first():
    prior = Prior(RANGES)
    draws = Draws(prior, 500, (4,), corners=True)
    np.testing.assert_array_equal(draws.chunk(0).values[:64], prior.corners().values)
    np.testing.assert_array_equal(draws.chunk(0).values[64:], Draws(prior, 500, (4,)).chunk(0).values[64:])


def test_a_parameter_that_does_not_vary_has_one_end():
    prior = Prior({**RANGES, "chi_1": (0.0, 0.0)})
    assert len(prior.corners()) == 32
