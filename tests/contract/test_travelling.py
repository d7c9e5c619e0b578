"""Models and likelihoods in other processes: pickled, copied, sent to pools; the bits are those of home."""

import copy
import io
import multiprocessing
import os
import pickle
import shutil
import subprocess
import sys

import joblib
import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_inference import LocalLikelihood, likelihood
from bnserve_protocol import DigestUnknown, InvalidRequest, ModelUnknown, ParametersWithExtrinsic
from bnserve_store import SHIPPED_MODELS, ModelStore
from bnserve_surrogate import Model as LocalModel
from tests.contract.conftest import ONE_MODE
from tests.service.injections import samples, small_analysis

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")

F = np.geomspace(20.0, 1500.0, 120)
ONE = ParametersWithExtrinsic.gw170817()
START_METHODS = ("fork", "spawn", "forkserver")


@pytest.fixture(params=["local", "local with threads", "remote"])
def here(request):
    """A model that is to travel."""
    if request.param == "remote":
        with RemoteModel.connect(request.getfixturevalue("address")) as model:
            yield model
    else:
        yield LocalModel.load("default", ONE_MODE, threads=2 if "threads" in request.param else 1)


@pytest.fixture
def bound(here, local):
    return likelihood(here, small_analysis(local, f_max=256.0), invalid_rows="error")


def strain_in(model):
    """The bits of a waveform and of a batch that is divided among threads, and where they were made."""
    wide = model.predict_factored(np.geomspace(20.0, 2000.0, 2000), [ONE] * 32).h
    return model.predict(F, ONE).plus.tobytes() + wide.tobytes(), os.getpid()


def values_in(bound):
    return bound.log_likelihood(samples(5)).tobytes(), os.getpid()


COPIES = {"pickled": lambda it: pickle.loads(pickle.dumps(it)), "copied": copy.copy, "deep-copied": copy.deepcopy}


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
def test_a_copy_gives_the_same_bits(here, bound, copied):
    assert strain_in(copied(here)) == strain_in(here)
    assert copied(here).description == here.description
    twin = copied(bound)
    assert values_in(twin) == values_in(bound)
    assert (twin.analysis.digest, twin.counts.rows) == (bound.analysis.digest, 5)


@pytest.mark.parametrize("method", START_METHODS)
def test_a_pool_gives_the_same_bits(here, bound, method):
    with multiprocessing.get_context(method).Pool(1) as pool:
        strain, process = pool.apply(strain_in, (here,))
        values, _ = pool.apply(values_in, (bound,))
        again = pool.apply(bound.log_likelihood, (samples(5),))
    assert process != os.getpid()
    assert strain == strain_in(here)[0]
    assert values == values_in(bound)[0] == again.tobytes()


def test_a_process_that_inherits_them_gives_the_same_bits(here, bound):
    """Not pickled: what a fork finds, threads of an evaluation included, which do not survive it."""
    before = strain_in(here)[0], values_in(bound)[0]
    receiver, sender = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.get_context("fork").Process(
        target=lambda: sender.send((strain_in(here)[0], values_in(bound)[0]))
    )
    child.start()
    assert receiver.recv() == before
    child.join()


def test_joblib_gives_the_same_bits(here, bound):
    found = joblib.Parallel(n_jobs=2)(joblib.delayed(values_in)(bound) for _ in range(2))
    assert {values for values, _ in found} == {values_in(bound)[0]}
    assert os.getpid() not in {process for _, process in found}
    [(strain, _), _] = joblib.Parallel(n_jobs=2)(joblib.delayed(strain_in)(here) for _ in range(2))
    assert strain == strain_in(here)[0]


def test_a_stranger_process_gives_the_same_bits(tmp_path, local):
    """Started by nobody we know, in another folder: what a checkpoint goes through."""
    (tmp_path / "checkpoint").write_bytes(pickle.dumps(LocalLikelihood(local, small_analysis(local, f_max=256.0))))
    code = (
        "import pickle, sys; bound = pickle.load(open('checkpoint', 'rb'))\n"
        "from tests.service.injections import samples\n"
        "sys.stdout.buffer.write(bound.log_likelihood(samples(5)).tobytes())"
    )
    path = os.pathsep.join(filter(None, sys.path))
    ran = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": path},
        capture_output=True,
        check=True,
    )
    assert ran.stdout == values_in(LocalLikelihood(local, small_analysis(local, f_max=256.0)))[0]


def test_weights_do_not_travel(local):
    weights = (SHIPPED_MODELS / "default").rglob("*.safetensors")
    assert len(pickle.dumps(local)) < 2**10 < min(file.stat().st_size for file in weights)


@pytest.fixture
def store(one_mode, tmp_path, monkeypatch):
    """A store of one's own, given by a path that is right in one folder alone."""
    shutil.copytree(one_mode / "default", tmp_path / "own" / "default")
    monkeypatch.chdir(tmp_path)
    return tmp_path / "own"


@pytest.mark.parametrize("given", ["own", ModelStore], ids=["a path", "a store"])
def test_a_model_of_ones_own_store_is_found_again(store, given, tmp_path, monkeypatch):
    model = LocalModel.load("default", store=given if isinstance(given, str) else ModelStore(["own"]))
    travelling, before = pickle.dumps(model), strain_in(model)
    monkeypatch.chdir("/")
    assert strain_in(pickle.loads(travelling)) == before


def test_it_is_the_same_artifact_or_an_error(store):
    travelling = pickle.dumps(LocalModel.load("default", store=store))
    [version] = ModelStore([store]).versions("default")
    manifest = store / "default" / version / "manifest.json"
    manifest.write_text(manifest.read_text().replace('"created"', '"created_"'))
    with pytest.raises(DigestUnknown, match="sha256:"):
        pickle.loads(travelling)
    shutil.rmtree(store / "default")
    with pytest.raises(ModelUnknown, match="default"):
        pickle.loads(travelling)


def test_a_model_made_in_memory_stays_where_it_is():
    model = LocalModel.from_artifact(ModelStore.default().load("default"))
    with pytest.raises(InvalidRequest, match=r"Publish it in a store and load it.*Model\.load\(name, store=\.\.\.\)"):
        pickle.dump(model, io.BytesIO())
    assert copy.deepcopy(model) is model
