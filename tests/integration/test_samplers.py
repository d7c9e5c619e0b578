"""Samplers through a real server: the examples in their short form, and a run that outlives an outage."""

import functools
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from bnserve_client import Model, Together
from tests.integration.conftest import COMMAND
from tests.running_server import free_port, is_ready, running

SAMPLERS = Path(__file__).parents[2] / "examples" / "samplers"
RUNS = {
    "emcee": ("with_emcee.py",),
    "nautilus": ("with_nautilus.py",),
    "dynesty in processes": ("with_dynesty.py",),
    "dynesty in batches": ("with_dynesty.py", "--batches"),
    "bilby": ("with_bilby.py",),
    "NUTS": ("with_nuts.py",),
    "NumPyro": ("with_numpyro.py",),
}
IN_BATCHES = [name for name in RUNS if name != "dynesty in processes"]
OUTAGE_SECONDS = 3.0


class Summary(NamedTuple):
    """What an example printed."""

    mean: dict[str, float]
    std: dict[str, float]
    evidence: tuple[float, float] | None
    text: str


@pytest.fixture(scope="module")
def summary(bnserve_server):
    """Each example is run once, by its name."""

    @functools.cache
    def run(name: str) -> Summary:
        script, *options = RUNS[name]
        command = [sys.executable, SAMPLERS / script, bnserve_server.address, "--short", *options]
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=900)
        assert done.returncode == 0, done.stdout + done.stderr
        rows = re.findall(r"^(\w+) +(\S+) +(\S+) +(\S+)$", done.stdout, re.MULTILINE)[1:]
        evidence = re.search(r"^log evidence: (\S+) \+- (\S+)$", done.stdout, re.MULTILINE)
        return Summary(
            {name: float(mean) for name, _, mean, _ in rows},
            {name: float(std) for name, _, _, std in rows},
            (float(evidence[1]), float(evidence[2])) if evidence else None,
            done.stdout,
        )

    return run


@pytest.fixture
def examples(monkeypatch) -> Iterator[None]:
    """The folder of the examples can be imported from, as when one of them is run."""
    before = set(sys.modules)
    monkeypatch.syspath_prepend(SAMPLERS)
    yield
    for name in set(sys.modules) - before:
        if str(SAMPLERS) in str(getattr(sys.modules[name], "__file__", "")):
            del sys.modules[name]


@pytest.mark.slow
@pytest.mark.parametrize("name", RUNS)
def test_the_posterior_holds_what_was_injected(summary, name):
    found = summary(name)
    assert "The posterior holds what was injected." in found.text
    assert set(found.mean) == {"chirp_mass", "mass_ratio", "distance_mpc", "coalescence_time"}


@pytest.mark.slow
@pytest.mark.parametrize("name", IN_BATCHES)
def test_likelihoods_travel_in_batches(summary, name):
    likelihoods, requests = map(int, re.search(r"(\d+) likelihoods in (\d+) requests", summary(name).text).groups())
    assert likelihoods > 3 * requests


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in RUNS if name != "nautilus"])
def test_samplers_agree(summary, name):
    """Runs this short know a mean to a good part of its standard deviation, and the evidence to about one."""
    found, reference = summary(name), summary("nautilus")
    for parameter, std in reference.std.items():
        assert abs(found.mean[parameter] - reference.mean[parameter]) < std
        assert 0.5 < found.std[parameter] / std < 2.0
    if found.evidence is not None:
        error = np.hypot(found.evidence[1], reference.evidence[1])
        assert abs(found.evidence[0] - reference.evidence[0]) < 4.0 * error


@pytest.mark.slow
def test_bilbys_own_likelihood_says_the_same(summary):
    service, theirs = re.search(
        r"ln L of the injection: (\S+) from the service, (\S+) from bilby", summary("bilby").text
    ).groups()
    assert float(service) == pytest.approx(float(theirs), abs=0.01)


def test_the_detectors_noise_may_come_from_files(bnserve_server, tmp_path, examples):
    import problem

    frequencies = np.geomspace(10.0, 2048.0, 300)
    np.savetxt(tmp_path / "asd.txt", np.column_stack([frequencies, problem.advanced_ligo_asd(frequencies)]))
    with Model.connect(bnserve_server.address) as model:
        given = problem.simulate(model, [str(tmp_path / "asd.txt")] * 3)
        analytic = problem.simulate(model, [])
    band = slice(int(problem.F_MIN * problem.DURATION), int(problem.F_MAX * problem.DURATION))
    for ours, theirs in zip(given, analytic, strict=True):
        np.testing.assert_allclose(ours.asd[band], theirs.asd[band], rtol=1e-2)


def test_questions_of_threads_travel_together():
    asked = []

    def evaluate(questions):
        asked.append(sorted(questions))
        return [10.0 * question for question in questions]

    pool = Together(evaluate, size=4)

    def walk(start):
        return [pool.log_likelihood(start + step) for step in range(0, 100 * (1 + start % 2), 100)]

    found = pool.map(walk, range(6))
    pool.close()
    pool.join()
    assert found == [[0.0], [10.0, 1010.0], [20.0], [30.0, 1030.0], [40.0], [50.0, 1050.0]]
    assert asked == [[0, 1, 2, 3], [101, 103], [4, 5], [105]]


def test_a_failure_reaches_every_thread_that_asked():
    def evaluate(questions):
        raise ConnectionError("nobody answers")

    pool = Together(evaluate, size=3)
    with pytest.raises(ConnectionError, match="nobody answers"):
        pool.map(pool.log_likelihood, range(3))
    pool.close()


def test_emcee_outlives_an_outage(tmp_path, examples):
    """The server is killed in the middle of a seeded run, and away for seconds: no exception, the same bits."""
    from problem import Problem
    from with_emcee import sample

    port = free_port()
    address = f"http://127.0.0.1:{port}"
    command = [*COMMAND, "serve", "--port", str(port), "--model", "default"]

    class WithOutage(Problem):
        """Whose server vanishes before the twentieth request."""

        def log_likelihood(self, points):
            if self.requests == 20:
                first.send_signal(signal.SIGKILL)
                first.wait()
                assert not is_ready(address)
                revival.start()
            return super().log_likelihood(points)

    def revive():
        time.sleep(OUTAGE_SECONDS)
        stack.enter_context(running(command, tmp_path / "second.log", lambda: is_ready(address)))

    with ExitStack() as stack:
        first = stack.enter_context(running(command, tmp_path / "first.log", lambda: is_ready(address)))
        model = stack.enter_context(Model.connect(address, timeout=300.0))
        undisturbed = Problem.pose(model, [])
        expected = sample(undisturbed, walkers=16, steps=30)
        revival = threading.Thread(target=revive)
        found = sample(WithOutage(undisturbed.likelihood), walkers=16, steps=30)
        revival.join()
    assert not revival.is_alive()
    assert found.get_chain().tobytes() == expected.get_chain().tobytes()
    assert found.get_log_prob().tobytes() == expected.get_log_prob().tobytes()


def test_every_example_is_run_here():
    helpers = {"problem.py"}
    assert {path.name for path in SAMPLERS.glob("*.py")} == helpers | {script for script, *_ in RUNS.values()}
