"""Training data and bases on a Ray cluster: the same bits as here, whatever happens to the workers."""

import os
import signal
import sys

import numpy as np
import pytest

from bnserve_inference.roq import build_basis
from bnserve_store import ModelStore
from bnserve_surrogate import Model
from bnserve_surrogate.training.data.dataset import build_dataset
from bnserve_surrogate.training.data.sampling import UniformSampling, draw
from tests.inference.bases import linear_basis
from tests.inference.roq.tiny import tiny
from tests.surrogate.test_training_data_dataset import RANGES, chunk_bytes, sequential, specification, toy_generator
from tests.surrogate.training_runs import QUICK, digests, train_here, written

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore")]  # Ray warns about its own modules

COUNT = 24


def first_samples():
    return draw(UniformSampling(), RANGES, 1, "training", COUNT)


def test_a_killed_worker_is_replaced_and_the_data_have_the_same_bytes(ray_cluster, tmp_path):
    marker, unlucky = tmp_path / "killed", float(first_samples()[9, 0])

    def special(theta):
        if theta[0] == unlucky and not marker.exists():
            marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)

    build_dataset(specification(toy_generator(special)), COUNT, tmp_path / "cluster", n_jobs=2, backend="ray")
    assert marker.exists()
    sequential(specification(), COUNT, tmp_path / "here")
    assert chunk_bytes(tmp_path / "cluster") == chunk_bytes(tmp_path / "here")


def test_a_sample_that_ends_every_worker_is_lost_and_nothing_else(ray_cluster, tmp_path):
    doomed = float(first_samples()[5, 0])

    def special(theta):
        if theta[0] == doomed:
            os.kill(os.getpid(), signal.SIGSEGV)

    generator = toy_generator(special)
    made = build_dataset(
        specification(generator), 8, tmp_path / "cluster", n_jobs=2, backend="ray", max_failed_fraction=0.5
    )
    assert [failure.index for failure in made.failures] == [5]
    healthy = sequential(specification(), 8, tmp_path / "here")
    np.testing.assert_array_equal(made.psi_residual, healthy.psi_residual[made.index])


def test_one_flag_trains_on_the_cluster(ray_cluster, tmp_path):
    trained = []
    for name, flags in [("cluster", ["--backend", f"ray:{ray_cluster.address}", "--jobs", "2"]), ("here", [])]:
        (tmp_path / name).mkdir()
        assert train_here(tmp_path / name, written(tmp_path / name, QUICK), *flags) == 0
        trained.append(digests(ModelStore([tmp_path / name / "store"]).load("smooth").manifest))
    assert trained[0] == trained[1]


def test_a_basis_from_the_cluster_is_the_same(ray_cluster, tmp_path):
    model, quiet = Model.default(), {"progress": False, "say": lambda line: None}
    smaller = tiny(cycles=[{"size": 600}], validation={"count": 300, "edge_count": 100})
    here = build_basis(smaller, model, tmp_path / "here", n_jobs=1, **quiet).quadrature
    cluster = build_basis(
        smaller, model, tmp_path / "cluster", n_jobs=2, backend="ray", opener=Model.default, **quiet
    ).quadrature
    for name in ("linear_nodes", "quadratic_nodes"):
        np.testing.assert_array_equal(getattr(cluster, name), getattr(here, name))
    np.testing.assert_array_equal(linear_basis(cluster, model), linear_basis(here, model))


def test_without_ray_the_error_says_what_to_install(tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "ray", None)
    assert train_here(tmp_path, written(tmp_path, QUICK), "--backend", "ray") == 2
    complaint = capsys.readouterr().err
    assert "needs the package 'ray'" in complaint
    assert "pip install '.[ray]'" in complaint
