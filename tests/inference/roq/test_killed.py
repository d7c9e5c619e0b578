"""``kill -9`` at any time: the same call goes on, and the file has the same bytes."""

import subprocess
import sys

import numpy as np
import pytest

from bnserve_inference.roq import BasisUnwritable, build_basis
from bnserve_inference.roq._storage import working_in
from tests.architecture.rooms import ROOT, room_environment
from tests.inference.roq.tiny import tiny

BUILD_AND_DIE = """
import os, signal, sys
from bnserve_inference.roq import build_basis, _storage
from bnserve_surrogate import Model
from tests.inference.roq.tiny import tiny

_storage.Checkpoints.__init__.__defaults__ = (0.0,)  # keep everything
keep, left = _storage.Checkpoints.keep, {survived}

def keep_or_die(self, name, arrays, force=False):
    global left
    if name == {name!r} and left == 0:
        if {half}:
            (self.directory / f"{{name}}.npz").write_bytes(b"PK half of a file")
        os.kill(os.getpid(), signal.SIGKILL)
    left -= name == {name!r}
    keep(self, name, arrays, force)

_storage.Checkpoints.keep = keep_or_die
build_basis(tiny(), Model.default(), sys.argv[1], n_jobs=1, progress=False)
"""


class Counting:
    """A model that counts the waveforms it is asked for."""

    def __init__(self, model):
        self._model, self.waveforms = model, 0

    def __getattr__(self, name):
        return getattr(self._model, name)

    def predict_factored(self, frequencies, batch, **options):
        self.waveforms += len(batch)
        return self._model.predict_factored(frequencies, batch, **options)


def build(model, directory):
    return build_basis(tiny(), model, directory, n_jobs=1, progress=False, say=lambda line: None).quadrature


@pytest.fixture(scope="module")
def whole(model, tmp_path_factory):
    """The bytes of a basis that nothing interrupted, and how many waveforms it took."""
    folder, counting = tmp_path_factory.mktemp("whole"), Counting(model)
    build(counting, folder).save(folder / "basis.h5")
    return (folder / "basis.h5").read_bytes(), counting.waveforms


@pytest.mark.parametrize(
    ("name", "survived", "half"),
    [
        pytest.param("linear", 3, False, id="in the pre-selection"),
        pytest.param("linear", 8, False, id="in a sweep"),
        pytest.param("linear", 14, True, id="in a write of the linear basis"),
        pytest.param("quadratic", 4, False, id="in the quadratic basis"),
        pytest.param("validation", 2, False, id="in the validation"),
    ],
)
def test_killed_and_started_again(tmp_path, model, whole, name, survived, half):
    script = BUILD_AND_DIE.format(name=name, survived=survived, half=half)
    environment = room_environment() | {"PYTHONPATH": f"{room_environment()['PYTHONPATH']}:{ROOT}"}
    done = subprocess.run(
        [sys.executable, "-c", script, str(tmp_path / "work")], env=environment, capture_output=True, check=False
    )
    assert done.returncode == -9, done.stderr.decode()

    counting = Counting(model)
    build(counting, tmp_path / "work").save(tmp_path / "basis.h5")
    assert (tmp_path / "basis.h5").read_bytes() == whole[0]
    if not half:  # else all of the linear basis is made again
        assert counting.waveforms < whole[1]


def test_a_finished_construction_is_not_repeated(tmp_path, model, whole):
    build(model, tmp_path)
    counting = Counting(model)
    build(counting, tmp_path).save(tmp_path / "basis.h5")
    assert (tmp_path / "basis.h5").read_bytes() == whole[0]
    assert counting.waveforms < whole[1] / 5


def test_another_configuration_begins_anew(tmp_path, model):
    build(model, tmp_path)
    build_basis(tiny(seed=2), model, tmp_path, n_jobs=1, progress=False, say=lambda line: None)
    assert len(list(tmp_path.glob("roq-tiny-*"))) == 2


def test_two_at_once_do_not_write_into_each_other(tmp_path):
    with working_in(tmp_path), pytest.raises(BasisUnwritable, match="Another process"), working_in(tmp_path):
        pass


def test_what_cannot_be_read_is_made_again(tmp_path):
    with working_in(tmp_path) as checkpoints:
        checkpoints.keep("good", {"x": np.arange(3)}, force=True)
        (tmp_path / "bad.npz").write_bytes(b"not an archive")
        np.testing.assert_array_equal(checkpoints.find("good")["x"], [0, 1, 2])
        assert checkpoints.find("bad") is None
        assert checkpoints.find("none") is None
