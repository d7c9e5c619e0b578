"""``kill -9`` at any time: the same command goes on, with the result that it would have had."""

import time

import pytest

from bnserve_protocol import ModelUnknown
from bnserve_store import ModelStore
from bnserve_surrogate import Model
from tests.surrogate import smooth_waveforms
from tests.surrogate.training_runs import arguments, digests, in_a_process, train_here, written


@pytest.fixture(scope="module")
def whole(published):
    """Digests of the tensors of a run that nothing interrupted."""
    return digests(ModelStore([published / "store"]).manifest("smooth", "1.0.0"))


def test_killed_among_the_waveforms(tmp_path, monkeypatch, whole):
    configuration, marks = written(tmp_path), tmp_path / "marks"
    command = arguments(tmp_path, configuration, "--jobs", "2")
    variables = {smooth_waveforms.PAUSE: "0.02", smooth_waveforms.MARK: str(marks)}
    process = in_a_process(command, **variables)
    while not list(tmp_path.glob("work/train-*/chunk-*.npz")):
        assert process.poll() is None, process.communicate()[1]
        time.sleep(0.01)
    process.kill()
    process.communicate(timeout=60)
    kept = list(tmp_path.glob("work/train-*/chunk-*.npz"))
    assert 0 < len(kept) < 7
    assert not (tmp_path / "store").exists()

    marks.unlink()
    monkeypatch.setenv(smooth_waveforms.MARK, str(marks))
    assert train_here(tmp_path, configuration) == 0
    assert marks.stat().st_size <= 200 - 8 * len(kept) + 18  # the smallest chunk has 8 waveforms; 18 validate
    assert digests(ModelStore([tmp_path / "store"]).manifest("smooth")) == whole


KILLED_WHILE_PUBLISHING = """
import os, signal
from bnserve_store import _publishing

def die(*arguments, **keywords):
    os.kill(os.getpid(), signal.SIGKILL)

_publishing.{function} = die
"""


@pytest.mark.parametrize("function", ["write_durably", "_rename"])
def test_killed_while_publishing(published, tmp_path, whole, function):
    """At the first write, and when all is written and read back, at the last moment before it appears."""
    configuration, store = written(tmp_path), tmp_path / "store"
    work = ["--work", str(published / "work"), "--no-report"]  # the waveforms are there
    command = arguments(tmp_path, configuration, "--jobs", "1", *work)
    process = in_a_process(command, script=KILLED_WHILE_PUBLISHING.format(function=function))
    _, error = process.communicate(timeout=300)
    assert process.returncode == -9, error
    assert ModelStore([store]).names() == []
    with pytest.raises(ModelUnknown):
        Model.load("smooth", store=store)

    assert train_here(tmp_path, configuration, *work) == 0
    assert digests(ModelStore([store]).manifest("smooth")) == whole
    assert {path.name for path in (store / "smooth").iterdir()} == {"1.0.0", "labels.json"}
