"""A study survives what stops it, may be worked on by several processes, and is not mixed up with another."""

import json
import subprocess
import sys
import time

import pytest

from bnserve_surrogate.training.search.results import SearchEmpty, search_results
from bnserve_surrogate.training.search.study import StudyMismatch, StudyUnreadable, failures, finished, read_study
from tests.architecture.rooms import ROOT, room_environment
from tests.surrogate.searching import NETWORK, SUM, run, toy_search


@pytest.fixture(scope="module")
def work(tmp_path_factory):
    """Where the waveforms of this module are."""
    return tmp_path_factory.mktemp("runs")


@pytest.fixture
def study(tmp_path):
    return tmp_path / "studies" / "study.jsonl"


def trial_numbers(lines):
    return [int(line.split()[1].rstrip(":")) for line in lines]


def costs(search):
    """Number, waveforms and error of every trial: what does not depend on the clock."""
    return [(t.trial, t.waveforms, t.reconstruction_error, t.hyperparameters) for t in search_results(search).trials]


@pytest.mark.parametrize("regressor", [None, NETWORK, SUM], ids=["polynomial", "network", "sum"])
def test_a_search_finds_better_hyperparameters_with_more_waveforms(work, study, regressor):
    search = toy_search(study, regressor)
    assert trial_numbers(run(search, work, trials=8)) == list(range(8))
    results = search_results(search)
    assert len(results.trials) == results.pareto.setup.trials == 8
    front = results.pareto.entry
    assert 1 < len(front) <= 8
    by_cost = sorted(front, key=lambda entry: entry.cost_seconds)
    errors = [entry.reconstruction_error for entry in by_cost]
    assert errors == sorted(errors, reverse=True)
    for entry in results.trials:
        assert 50 <= entry.waveforms <= 300
        assert any(
            best.cost_seconds <= entry.cost_seconds and best.reconstruction_error <= entry.reconstruction_error
            for best in front
        )


def test_the_first_trials_are_what_the_configuration_gives(work, study):
    given = {"degree": 3, "weights": [2.0, 2.0, 2.0, 3.0, 2.0], "terms": 45}
    search = toy_search(study, {"kind": "polynomial", "coordinates": "physical", "polynomial": given})
    run(search, work, trials=3)
    whole, quarter, drawn = search_results(search).trials
    assert (whole.waveforms, quarter.waveforms) == (300, 75)
    expected = {"degree": 1.5, "weights": [1.0, 1.0, 1.0, 1.5, 1.0], "terms": 50}  # the same; terms from 50 on
    assert whole.hyperparameters.reduction == {"components": 10}
    assert whole.hyperparameters.regressor == {"polynomial": expected}
    assert drawn.hyperparameters != whole.hyperparameters == quarter.hyperparameters


def test_the_same_seed_gives_the_same_first_trials_and_each_draws_its_own_waveforms(work, study):
    searches = [toy_search(study.with_name(name)) for name in ("a", "b", "c")]
    for search, seed in zip(searches, (3, 3, 4), strict=True):
        run(search, work, trials=4, seed=seed)
    first, second, other = map(costs, searches)
    assert first == second != other
    assert len({waveforms for _, waveforms, *_ in first}) == 4


def test_a_study_goes_on_where_it_was(work, study):
    search = toy_search(study)
    assert trial_numbers(run(search, work, trials=2)) == [0, 1]
    before = costs(search)
    assert trial_numbers(run(search, work, trials=5)) == [2, 3, 4]
    assert costs(search)[:2] == before
    assert run(search, work, trials=5) == []


def test_a_timeout_begins_no_further_trial(work, study):
    assert run(toy_search(study), work, trials=1000, timeout=0.0) == []
    with pytest.raises(SearchEmpty, match="more trials or time"):
        search_results(toy_search(study))


WORKER = """
import json, sys, time
from pathlib import Path
from tests.surrogate.searching import run, toy_search
from bnserve_surrogate.training.search import trials as search

evaluate = search.evaluate
def slow(*arguments):
    time.sleep(float(sys.argv[4]))
    return evaluate(*arguments)
search.evaluate = slow
run(toy_search(Path(sys.argv[1])), Path(sys.argv[2]), trials=int(sys.argv[3]))
"""


def worker(study, work, trials, pause):
    """Another process that works on a study, and takes its time over every trial."""
    command = [sys.executable, "-c", WORKER, str(study), str(work), str(trials), str(pause)]
    return subprocess.Popen(command, cwd=ROOT, env=room_environment(), stderr=subprocess.PIPE, text=True)


def wait_for(condition, process):
    while not condition():
        assert process.poll() is None, process.communicate()[1]
        time.sleep(0.02)


def test_a_killed_search_keeps_its_finished_trials(work, study):
    run(toy_search(study), work, trials=2)
    kept, size = costs(toy_search(study)), study.stat().st_size
    killed = worker(study, work, 100, 60.0)
    wait_for(lambda: study.stat().st_size > size and '"values"' in study.read_text()[size:], killed)
    killed.kill()
    killed.communicate(timeout=60)
    with study.open("ab") as file:
        file.write(b'{"op_code":6,"worker_id"')  # killed while it wrote
    search = toy_search(study)
    assert trial_numbers(run(search, work, trials=4)) == [3, 4]  # the interrupted trial 2 does not count
    assert costs(search)[:2] == kept
    assert [number for number, *_ in costs(search)] == [0, 1, 3, 4]
    assert failures(read_study(study, search.setup)) == []


def test_two_processes_share_one_study(work, study):
    run(toy_search(study), work, trials=1)  # the waveforms are there
    both = [worker(study, work, 9, 0.2) for _ in range(2)]
    for process in both:
        assert process.wait(timeout=120) == 0, process.communicate()[1]
        process.communicate()
    search = toy_search(study)
    assert 9 <= finished(read_study(study, search.setup)) <= 10
    numbers = [number for number, *_ in costs(search)]
    assert numbers == list(range(len(numbers)))
    workers = {json.loads(line)["worker_id"] for line in study.read_text().splitlines()}
    assert len(workers) >= 3


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"dataset": {"count": 401}}, "waveforms"),
        ({"reduction": {"kind": "metric", "noise": "flat"}}, "reduction.noise"),
        ({"regressor": {"kind": "polynomial", "coordinates": "raw"}}, "regressor.coordinates"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_study_of_another_configuration_is_refused(work, study, changes, named):
    run(toy_search(study), work, trials=1)
    before = study.read_bytes()
    other = toy_search(study, **changes)
    with pytest.raises(StudyMismatch, match=named):
        run(other, work, trials=2)
    with pytest.raises(StudyMismatch, match="--study"):
        search_results(other)
    assert study.read_bytes() == before


def test_what_is_searched_may_be_given_differently(work, study):
    run(toy_search(study), work, trials=1)
    given = {"kind": "polynomial", "coordinates": "physical", "polynomial": {"degree": 3}}
    assert len(run(toy_search(study, given, version="2.0.0"), work, trials=2)) == 1


@pytest.mark.parametrize("content", ["name = 'toml'\n", "[1, 2]\n", '{"op_code": 77}\n', "3\n", "\x00\x01\n"])
def test_a_file_that_is_not_a_study_is_refused_and_left_alone(work, study, content):
    study.parent.mkdir()
    study.write_text(content)
    with pytest.raises(StudyUnreadable, match="--study"):
        run(toy_search(study), work, trials=1)
    assert study.read_text() == content


def test_a_damaged_study_is_refused(work, study):
    run(toy_search(study), work, trials=2)
    lines = study.read_bytes().splitlines(keepends=True)
    study.write_bytes(b"".join([*lines[:3], b"{broken\n", *lines[3:]]))
    with pytest.raises(StudyUnreadable, match="damaged"):
        run(toy_search(study), work, trials=3)


def test_there_is_nothing_to_report_of_an_unknown_study(study):
    with pytest.raises(StudyUnreadable, match=r"There is no study .*study\.jsonl"):
        search_results(toy_search(study))
    assert not study.exists()


def test_failed_trials_say_why_and_count(work, study, monkeypatch):
    from bnserve_surrogate.training.regressors import ChebyshevPolynomial

    def impossible(self, X, Y):
        raise ValueError("cannot be fitted")

    monkeypatch.setattr(ChebyshevPolynomial, "fit", impossible)
    said = run(toy_search(study), work, trials=2)
    assert all("failed: ValueError: cannot be fitted" in line for line in said)
    assert len(said) == 2
    with pytest.raises(SearchEmpty, match="cannot be fitted"):
        search_results(toy_search(study))


def test_a_study_is_text_and_unpickles_nothing(work, study):
    run(toy_search(study), work, trials=2)
    assert all(isinstance(json.loads(line), dict) for line in study.read_text().splitlines())
    code = (
        "import sys\n"
        "sys.addaudithook(lambda event, a: print(event, *a) if event == 'pickle.find_class' else None)\n"
        "from pathlib import Path\n"
        "from tests.surrogate.searching import toy_search\n"
        "from bnserve_surrogate.training.search.results import search_results\n"
        "import pickle, pathlib; pickle.loads(pickle.dumps(pathlib.PurePosixPath('x')))\n"
        "print('---')\n"
        "print(len(search_results(toy_search(Path(sys.argv[1]))).trials))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(study)],
        cwd=ROOT, env=room_environment(), capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    control, _, after = done.stdout.partition("---\n")
    assert "PurePosixPath" in control
    assert after == "2\n"
