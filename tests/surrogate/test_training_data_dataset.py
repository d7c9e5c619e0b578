"""A data set survives whatever stops it, and tells what it could not make."""

import json
import os
import resource
import signal
import subprocess
import sys
import textwrap
import time
from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import PackageMissing
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from bnserve_surrogate.training.data import dataset as dataset_module
from bnserve_surrogate.training.data.dataset import DatasetSpecification, build_dataset
from bnserve_surrogate.training.data.generators import CallableGenerator, TEOBResumSPA
from bnserve_surrogate.training.data.residuals import log_amplitude_ratio, phase_difference
from bnserve_surrogate.training.data.sampling import ParameterRanges, UniformSampling, draw
from bnserve_surrogate.training.errors import (
    DatasetInUse,
    DatasetUnwritable,
    TooManyFailures,
    WorkersUnusable,
)
from bnserve_surrogate.training.reduction.nodes import smooth_nodes

RANGES = ParameterRanges()


def toy_generator(special=None):
    """The baseline and a little more, as nested functions: they travel to workers by value."""

    def toy(theta, mf):
        if special is not None:
            special(theta)
        change = theta[0] * mf
        amplitude = taylorf2_amplitude(mf, *theta[:3, None])[0] * np.exp(change)
        return amplitude, taylorf2_phase(mf, *theta[:, None])[0] + 100.0 * change

    return CallableGenerator(toy, label="toy", release="1")


def specification(generator=None, **changes):
    defaults = DatasetSpecification(
        generator or toy_generator(),
        RANGES,
        UniformSampling(),
        seed=1,
        purpose="training",
        mf_amplitude=smooth_nodes(5.0, 2000.0, 12),
        mf_phase=smooth_nodes(5.0, 2000.0, 17),
        chunk_size=4,
    )
    return replace(defaults, **changes)


def sequential(spec, count, directory, **options):
    return build_dataset(spec, count, directory, n_jobs=1, backend="sequential", **options)


def chunk_bytes(directory):
    return {path.relative_to(directory): path.read_bytes() for path in directory.rglob("chunk-*.npz")}


def fails_above(limit):
    """Something for a generator to do with parameters it does not like."""

    def special(theta):
        if theta[0] > limit:
            raise RuntimeError("did not converge")

    return special


def test_a_data_set_holds_the_raw_residuals_of_its_draw(tmp_path):
    spec = specification()
    made = sequential(spec, 10, tmp_path)
    np.testing.assert_array_equal(made.theta, draw(UniformSampling(), RANGES, 1, "training", 10))
    assert made.log_amplitude_ratio.shape == (10, 12)
    assert made.psi_residual.shape == (10, 17)
    for row in (0, 9):
        theta = made.theta[row]
        np.testing.assert_allclose(made.log_amplitude_ratio[row], theta[0] * spec.mf_amplitude, atol=1e-12)
        np.testing.assert_allclose(made.psi_residual[row], 100 * theta[0] * spec.mf_phase, atol=1e-8)
    assert made.failures == ()
    described = json.loads((spec.directory(tmp_path) / "dataset.json").read_text())
    assert described["generator"]["name"] == "toy"


def test_processes_give_the_same_bytes_as_this_process_in_any_number(tmp_path):
    alone = sequential(specification(), 22, tmp_path / "sequential")
    for jobs in (1, 2):
        together = build_dataset(specification(), 22, tmp_path / str(jobs), n_jobs=jobs)
        np.testing.assert_array_equal(together.psi_residual, alone.psi_residual)
        assert chunk_bytes(tmp_path / str(jobs)) == chunk_bytes(tmp_path / "sequential")


def test_what_is_there_is_not_computed_again_and_a_data_set_can_grow(tmp_path):
    calls = []
    spec = specification(toy_generator(special=calls.append))
    small = sequential(spec, 8, tmp_path)
    assert len(calls) == 8
    sequential(spec, 8, tmp_path)
    assert len(calls) == 8
    grown = sequential(spec, 12, tmp_path)
    assert len(calls) == 12
    np.testing.assert_array_equal(grown.psi_residual[:8], small.psi_residual)
    assert len(sequential(spec, 6, tmp_path)) == 6


@pytest.mark.parametrize(
    "changes",
    [
        {"seed": 2},
        {"purpose": "test"},
        {"chunk_size": 5},
        {"ranges": ParameterRanges(chi=(-0.4, 0.4))},
        {"mf_phase": smooth_nodes(5.0, 2000.0, 18)},
        {"generator": CallableGenerator(lambda theta, mf: (mf, mf), label="toy", release="2")},
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_whatever_defines_the_data_separates_them(tmp_path, changes):
    assert specification(**changes).digest != specification().digest
    assert specification(**changes).directory(tmp_path) != specification().directory(tmp_path)
    assert specification().digest == specification().digest


def test_residuals_to_another_baseline_are_another_data_set(monkeypatch):
    before = specification().digest
    monkeypatch.setattr(
        "bnserve_surrogate.training.data.residuals.taylorf2_phase", lambda *a: taylorf2_phase(*a) * (1 + 1e-7)
    )
    assert specification().digest != before


def test_failed_waveforms_are_recorded_and_left_out(tmp_path):
    spec = specification(toy_generator(special=fails_above(2.6)))
    made = sequential(spec, 20, tmp_path, max_failed_fraction=0.5)
    theta = draw(UniformSampling(), RANGES, 1, "training", 20)
    expected = np.flatnonzero(theta[:, 0] > 2.6)
    assert 0 < expected.size < 10
    assert [failure.index for failure in made.failures] == expected.tolist()
    assert made.failures[0].theta == tuple(theta[expected[0]])
    assert "did not converge" in made.failures[0].reason
    np.testing.assert_array_equal(made.index, np.setdiff1d(np.arange(20), expected))
    np.testing.assert_array_equal(made.theta, theta[made.index])
    assert made.psi_residual.shape == (20 - expected.size, 17)


def test_failures_are_remembered(tmp_path):
    sequential(specification(toy_generator(special=fails_above(2.6))), 20, tmp_path, max_failed_fraction=0.5)
    mended = specification(toy_generator())
    assert sequential(mended, 20, tmp_path, max_failed_fraction=0.5).failures


def test_too_many_failures_stop_the_run_early_with_the_reasons(tmp_path):
    calls = []

    def special(theta):
        calls.append(theta)
        raise RuntimeError("licence expired")

    with pytest.raises(TooManyFailures, match="licence expired"):
        sequential(specification(toy_generator(special=special)), 400, tmp_path)
    assert len(calls) <= 12


def test_a_missing_package_stops_the_run_at_once(tmp_path):
    def special(theta):
        raise PackageMissing("install it")

    with pytest.raises(PackageMissing):
        sequential(specification(toy_generator(special=special)), 8, tmp_path, max_failed_fraction=1.0)


@pytest.mark.parametrize(("jobs", "how"), [(1, "exit"), (2, "segfault")])
def test_a_worker_that_dies_loses_its_waveform_and_nothing_else(tmp_path, jobs, how):
    def special(theta):
        if 2.55 < theta[0] < 2.75:
            if how == "exit":
                os._exit(3)
            os.kill(os.getpid(), signal.SIGSEGV)

    theta = draw(UniformSampling(), RANGES, 1, "training", 12)
    doomed = np.flatnonzero((theta[:, 0] > 2.55) & (theta[:, 0] < 2.75))
    assert doomed.size == 1
    made = build_dataset(
        specification(toy_generator(special=special)), 12, tmp_path, n_jobs=jobs, max_failed_fraction=0.5
    )
    assert [failure.index for failure in made.failures] == doomed.tolist()
    assert "ended its process" in made.failures[0].reason
    healthy = sequential(specification(), 12, tmp_path / "healthy")
    np.testing.assert_array_equal(made.psi_residual, healthy.psi_residual[made.index])


class OnlyHere:
    """A generator that a new process cannot unpickle."""

    name, version, settings = "only here", "1", {}

    def __reduce__(self):
        return __import__, ("a_module_of_this_process_alone",)

    def __call__(self, theta, mf):
        return 1.0 + mf, mf


@pytest.mark.parametrize("jobs", [1, 2])
def test_workers_that_cannot_load_the_generator_are_not_blamed_on_it(tmp_path, jobs):
    with pytest.raises(WorkersUnusable, match="cannot load the generator"):
        build_dataset(specification(OnlyHere()), 24, tmp_path, n_jobs=jobs)
    assert not chunk_bytes(tmp_path)


KILLED_RUN = textwrap.dedent(
    """
    import sys, time
    from bnserve_surrogate.training.data.dataset import DatasetSpecification, build_dataset
    from bnserve_surrogate.training.data.generators import CallableGenerator
    from bnserve_surrogate.training.reduction.nodes import smooth_nodes
    from bnserve_surrogate.training.data.sampling import ParameterRanges
    from bnserve_surrogate.training.data.sampling import UniformSampling

    def slow(theta, mf):
        time.sleep(0.1)
        return 20.0 + theta[0] * mf, theta[3] / mf

    nodes = smooth_nodes(20.0, 1000.0, 9)
    specification = DatasetSpecification(
        CallableGenerator(slow, label="slow", release="1"), ParameterRanges(), UniformSampling(),
        seed=4, purpose="test", mf_amplitude=nodes, mf_phase=nodes, chunk_size=3,
    )
    build_dataset(specification, 300, sys.argv[1], n_jobs=2)
    """
)


def test_a_killed_run_is_resumed_with_identical_bytes(tmp_path):
    """And its worker processes, which hold the other ends of its pipes, go away with it."""

    def fast(theta, mf):
        return 20.0 + theta[0] * mf, theta[3] / mf

    nodes = smooth_nodes(20.0, 1000.0, 9)
    generator = CallableGenerator(fast, label="slow", release="1")
    spec = specification(generator, seed=4, purpose="test", mf_amplitude=nodes, mf_phase=nodes, chunk_size=3)
    arguments = [sys.executable, "-c", KILLED_RUN, str(tmp_path / "killed")]
    killed = subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not chunk_bytes(tmp_path / "killed"):
        assert killed.poll() is None, killed.communicate()[1]
        time.sleep(0.02)
    killed.kill()
    killed.communicate(timeout=60)
    kept = chunk_bytes(tmp_path / "killed")
    assert 0 < len(kept) < 100
    sequential(spec, 300, tmp_path / "killed")
    sequential(spec, 300, tmp_path / "whole")
    assert chunk_bytes(tmp_path / "killed") == chunk_bytes(tmp_path / "whole")
    assert not list(tmp_path.rglob("*.tmp"))


SLOW_START = """
import os, sys, time
if any("popen_loky_posix" in word for word in sys.orig_argv):
    open(os.environ["STARTED"], "w").close()
    time.sleep(1.0)
"""
"""Site customisation of a worker process that takes its time to start."""


def test_a_worker_whose_parent_is_killed_before_its_first_task_goes_away(tmp_path):
    (tmp_path / "sitecustomize.py").write_text(SLOW_START)
    started, path = tmp_path / "started", os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
    killed = subprocess.Popen(
        [sys.executable, "-c", KILLED_RUN, str(tmp_path / "killed")],
        env={**os.environ, "PYTHONPATH": path, "STARTED": str(started)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    while not started.exists():
        assert killed.poll() is None, killed.communicate()[1]
        time.sleep(0.02)
    time.sleep(0.2)  # what it is to do has been written into its pipe
    killed.kill()
    killed.communicate(timeout=60)  # as long as a worker lives, its end of these pipes is open
    assert not chunk_bytes(tmp_path / "killed")


def test_two_runs_cannot_make_the_same_data_set_at_once(tmp_path):
    spec = specification()
    with dataset_module._exclusive(spec.directory(tmp_path)), pytest.raises(DatasetInUse, match="Another process"):
        sequential(spec, 4, tmp_path)
    assert len(sequential(spec, 4, tmp_path)) == 4


def test_a_damaged_chunk_is_computed_again(tmp_path):
    before = sequential(specification(), 12, tmp_path)
    first, second, third = sorted(tmp_path.rglob("chunk-*.npz"))
    intact = chunk_bytes(tmp_path)
    first.write_bytes(first.read_bytes()[:100])
    second.write_bytes(b"")
    third.write_bytes(bytes(reversed(third.read_bytes())))
    after = sequential(specification(), 12, tmp_path)
    np.testing.assert_array_equal(before.psi_residual, after.psi_residual)
    assert chunk_bytes(tmp_path) == intact


def test_a_full_disk_is_a_clear_error_and_finished_chunks_are_kept(tmp_path):
    """A limit on the size of files stands for the disk; later chunks are larger because they record long reasons."""
    calls = []

    def special(theta):
        calls.append(theta)
        if len(calls) > 8:
            raise RuntimeError("x" * 20_000)

    spec = specification(toy_generator(special=special))
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, hard))
    try:
        with pytest.raises(DatasetUnwritable, match="free some space and start the same command again"):
            sequential(spec, 20, tmp_path, max_failed_fraction=1.0)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert len(chunk_bytes(tmp_path)) == 2
    assert not list(tmp_path.rglob("*.tmp"))
    calls.clear()
    assert len(sequential(specification(), 20, tmp_path)) == 20


def test_a_directory_that_cannot_be_written_is_a_clear_error(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(DatasetUnwritable, match="Choose a directory"):
        sequential(specification(), 4, tmp_path / "file")


def test_the_progress_bar_is_silent_where_nobody_looks(tmp_path, capsys):
    sequential(specification(), 4, tmp_path)
    assert capsys.readouterr().err == ""
    sequential(specification(), 8, tmp_path, progress=True)
    assert "training" in capsys.readouterr().err


def test_nonsense_is_refused(tmp_path):
    with pytest.raises(ValueError, match="Nodes"):
        specification(mf_phase=np.array([0.02, 0.01]))
    with pytest.raises(ValueError, match="chunk_size"):
        specification(chunk_size=0)
    with pytest.raises(ValueError, match="count"):
        sequential(specification(), 0, tmp_path)


def test_teobresums_waveforms_become_a_data_set(tmp_path):
    pytest.importorskip("EOBRun_module")
    spec = specification(
        TEOBResumSPA(), mf_amplitude=smooth_nodes(20.0, 2000.0, 40), mf_phase=smooth_nodes(20.0, 2500.0, 60)
    )
    made = build_dataset(spec, 6, tmp_path, n_jobs=2)
    assert made.failures == ()
    union = np.union1d(spec.mf_amplitude, spec.mf_phase)
    amplitude, psi = spec.generator(made.theta[4], union)
    ratio = log_amplitude_ratio(made.theta[4], union, amplitude)[np.searchsorted(union, spec.mf_amplitude)]
    difference = phase_difference(made.theta[4], union, psi)[np.searchsorted(union, spec.mf_phase)]
    np.testing.assert_allclose(made.log_amplitude_ratio[4], ratio, atol=1e-12)
    np.testing.assert_allclose(made.psi_residual[4], difference, atol=1e-6)
