"""Runs that are stopped, and what is refused."""

import signal
import subprocess
import sys
import threading

import numpy as np
import pytest

from bnserve_posterior.sampling import (
    PLAIN,
    CheckpointMismatch,
    Coordinates,
    LikelihoodEmpty,
    LikelihoodNotFinite,
    PosteriorUnreliable,
    Problem,
    Settings,
    _checkpoint,
    plain,
    sample,
)
from tests.architecture.rooms import ROOT, room_environment
from tests.posterior.densities import normal

SETTINGS = Settings(particles=300, effective=2000, batch=1000)

KILLED = """
import os, signal, sys
from pathlib import Path
from bnserve_posterior.sampling import Problem, Settings, sample
from tests.posterior.densities import normal

calls = 0

def killed(u):
    global calls
    calls += 1
    if calls == int(sys.argv[2]):
        os.kill(os.getpid(), signal.SIGKILL)
    return normal(u)

sample(Problem(killed, 4), Settings(particles=300, effective=2000, batch=1000), checkpoint=Path(sys.argv[1]))
"""


@pytest.fixture(scope="module")
def undisturbed():
    return sample(Problem(normal, 4), SETTINGS)


def same(one, other):
    assert one.points.tobytes() == other.points.tobytes()
    assert one.weights.tobytes() == other.weights.tobytes()
    assert one.log_evidence == other.log_evidence
    assert one.log_evidences == other.log_evidences


def test_a_run_that_was_killed_again_and_again_ends_with_the_same_bits(tmp_path, undisturbed):
    checkpoint = tmp_path / "checkpoint.npz"
    for calls in (60, 90):
        command = [sys.executable, "-c", KILLED, str(checkpoint), str(calls)]
        done = subprocess.run(command, cwd=ROOT, env=room_environment() | {"PYTHONSAFEPATH": ""}, check=False)
        assert done.returncode == -signal.SIGKILL
        assert checkpoint.exists()
    same(sample(Problem(normal, 4), SETTINGS, checkpoint=checkpoint), undisturbed)


def test_searches_side_by_side_find_the_same_and_are_asked_in_the_thread_of_the_caller(tmp_path, undisturbed):
    threads = set()

    def watched(u):
        threads.add(threading.get_ident())
        return normal(u)

    same(sample(Problem(watched, 4), SETTINGS, checkpoint=tmp_path / "checkpoint.npz", threads=2), undisturbed)
    assert threads == {threading.get_ident()}


class Refused(Exception):
    pass


@pytest.mark.parametrize("threads", [1, 2])
def test_a_call_that_fails_at_any_place_leaves_a_good_checkpoint(tmp_path, undisturbed, threads):
    """As one of a remote likelihood may: every run gets a few calls farther."""
    checkpoint, left = tmp_path / "checkpoint.npz", 0

    def fails(u):
        nonlocal left
        left -= 1
        if left < 0:
            raise Refused
        return normal(u)

    for _ in range(100):
        left = 150 * threads
        try:
            found = sample(Problem(fails, 4), SETTINGS, checkpoint=checkpoint, threads=threads)
            break
        except Refused:
            assert not [each for each in threading.enumerate() if each.name.startswith("search")]
    same(found, undisturbed)
    same(sample(Problem(normal, 4), SETTINGS, checkpoint=checkpoint), undisturbed)


def test_no_call_has_more_points_than_a_batch_and_progress_is_told(undisturbed):
    sizes, told = [], []

    def counted(u):
        sizes.append(len(u))
        return normal(u)

    same(sample(Problem(counted, 4), SETTINGS, progress=told.append), undisturbed)
    assert max(sizes) <= 1000
    assert sum(sizes) == undisturbed.likelihoods == told[-1].likelihoods
    assert told[0].power < told[1].power <= told[-1].power == 1.0
    assert told[-1].effective >= 2000
    assert abs(told[-1].log_evidence - undisturbed.log_evidence) < 1e-12


@pytest.mark.parametrize("other", ["likelihood", "settings", "circles", "format"])
def test_the_checkpoint_of_another_run_is_refused(tmp_path, monkeypatch, other):
    checkpoint = tmp_path / "checkpoint.npz"
    sample(Problem(normal, 4), SETTINGS, checkpoint=checkpoint)
    problem = Problem((lambda u: normal(u) + 1.0) if other == "likelihood" else normal, 4)
    if other == "circles":
        problem = Problem(normal, 4, plain((0,)))
    if other == "format":
        monkeypatch.setattr(_checkpoint, "_FORMAT", 0)
    settings = Settings(particles=301, effective=2000, batch=1000) if other == "settings" else SETTINGS
    with pytest.raises(CheckpointMismatch, match=r"'checkpoint.npz' is the checkpoint of another .* delete it"):
        sample(problem, settings, checkpoint=checkpoint)


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04 cut off", b"text", b"\x80\x04K\x01."])
def test_what_is_no_checkpoint_is_refused(tmp_path, content):
    checkpoint = tmp_path / "checkpoint.npz"
    checkpoint.write_bytes(content)
    with pytest.raises(CheckpointMismatch, match=r"'checkpoint.npz' is no checkpoint .* delete it"):
        sample(Problem(normal, 4), SETTINGS, checkpoint=checkpoint)


def test_a_checkpoint_without_an_array_is_refused(tmp_path):
    checkpoint = tmp_path / "checkpoint.npz"
    sample(Problem(normal, 4), SETTINGS, checkpoint=checkpoint)
    with np.load(checkpoint, allow_pickle=False) as file:
        arrays = dict(file)
    del arrays["mixture.0.0.means"]
    np.savez(checkpoint, **arrays)
    with pytest.raises(CheckpointMismatch, match="no checkpoint"):
        sample(Problem(normal, 4), SETTINGS, checkpoint=checkpoint)


def test_a_folder_that_is_not_there_is_said_before_anything_is_evaluated(tmp_path):
    with pytest.raises(CheckpointMismatch, match="no folder"):
        sample(Problem(normal, 4), SETTINGS, checkpoint=tmp_path / "missing" / "checkpoint.npz")


@pytest.mark.parametrize(("value", "text"), [(np.nan, "nan"), (np.inf, "inf")])
def test_a_likelihood_that_is_no_number_is_refused_with_its_place(value, text):
    def wrong(u):
        return np.where(u[:, 0] > 0.9, value, normal(u))

    with pytest.raises(LikelihoodNotFinite, match=rf"is {text} at the point \[0\.9\d*, .*return -inf"):
        sample(Problem(wrong, 4), SETTINGS)


def test_a_likelihood_of_another_length_is_refused():
    with pytest.raises(LikelihoodNotFinite, match=r"of 1000 points is an array \(1,\): return one number for each"):
        sample(Problem(lambda u: np.zeros(1), 4), SETTINGS)


def test_a_likelihood_that_is_zero_everywhere_is_refused():
    with pytest.raises(LikelihoodEmpty, match="0 have a likelihood above zero: look at"):
        sample(Problem(lambda u: np.full(len(u), -np.inf), 2), SETTINGS)


def test_a_posterior_that_no_mixture_follows_is_refused():
    """A thousand peaks in six dimensions, of which draws find some; what they weigh is not believed."""

    def peaks(u):
        return 40.0 * np.sum(np.cos(40.0 * np.pi * u), axis=1)

    with pytest.raises(PosteriorUnreliable, match="More particles may find what is missing"):
        sample(Problem(peaks, 6), Settings(particles=100, effective=2000))


@pytest.mark.parametrize(
    ("problem", "settings", "text"),
    [
        (Problem(normal, 0), SETTINGS, "dimensions"),
        (Problem(normal, 4, PLAIN._replace(circles=(4,))), SETTINGS, "circles"),
        (Problem(normal, 4), Settings(particles=10), "particles"),
        (Problem(normal, 4), Settings(effective=0), "effective"),
        (Problem(normal, 4), Settings(batch=0), "batch"),
        (Problem(normal, 4), Settings(seed=-1), "seed"),
    ],
)
def test_settings_that_mean_nothing_are_refused(problem, settings, text):
    with pytest.raises(ValueError, match=text):
        sample(problem, settings)


def half(y):
    points, volumes = PLAIN.to_cube(y)
    return 0.5 * points, volumes


def other_volumes(y):
    points, volumes = PLAIN.to_cube(y)
    return points, volumes + np.log(2.0)


@pytest.mark.parametrize("to_cube", [half, other_volumes])
def test_coordinates_that_are_not_undone_are_refused(to_cube):
    with pytest.raises(ValueError, match="must be undone by to_cube, with the same volumes"):
        sample(Problem(normal, 4, Coordinates(PLAIN.from_cube, to_cube)), SETTINGS)
