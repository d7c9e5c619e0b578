"""The annealed population: evidence and posterior of likelihoods whose integrals are known."""

import numpy as np
import pytest

from benchmarks.gw170817.annealing import Annealing, anneal

WIDTHS = np.array([0.02, 0.01, 0.05, 0.03])
SETTINGS = Annealing(particles=500, sweeps=10, final_sweeps=60, keep_every=20)


def normal(u):
    """A normalised density in the unit cube, whose evidence is one."""
    return -0.5 * np.sum(((u - 0.4) / WIDTHS) ** 2, axis=1) - np.sum(np.log(WIDTHS * np.sqrt(2.0 * np.pi)))


def test_the_evidence_and_the_moments_of_a_normal_density():
    found = anneal(normal, 4, SETTINGS, None)
    assert abs(found.log_evidence) < 0.5
    np.testing.assert_allclose(found.points.mean(axis=0), 0.4, atol=0.15 * WIDTHS.max())
    np.testing.assert_allclose(found.points.std(axis=0), WIDTHS, rtol=0.15)


def test_both_modes_are_found():
    def two_modes(u):
        return np.logaddexp(normal(u), normal(1.0 - u))

    found = anneal(two_modes, 4, SETTINGS, None)
    assert 0.3 < np.mean(found.points[:, 0] < 0.5) < 0.7


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
        anneal(fails_once, 4, SETTINGS, checkpoint)
    assert checkpoint.exists()
    resumed, direct = anneal(normal, 4, SETTINGS, checkpoint), anneal(normal, 4, SETTINGS, None)
    assert resumed.points.tobytes() == direct.points.tobytes()
    assert resumed.log_evidence == direct.log_evidence
