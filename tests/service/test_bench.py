"""``bnserve bench``: what it computes from times, and that every part of it runs and says what it found."""

import json
import re
import sys
from collections import Counter

import numpy as np
import pytest

from bnserve_protocol import BnserveError, require
from bnserve_service.bench.binaries import Questions
from bnserve_service.bench.breakdown import local_breakdown
from bnserve_service.bench.costs import batch_costs, single_costs
from bnserve_service.bench.load import LoadFailed, Target, answers_per_second, round_trips
from bnserve_service.bench.over_http import measure_remote
from bnserve_service.bench.processes import first_waveform
from bnserve_service.bench.report import duration, print_report
from bnserve_service.bench.sizes import Sizes
from bnserve_service.bench.timing import fit_cost, grid_sizes, shuffled, timed
from bnserve_service.cli import main
from bnserve_surrogate import Model

TINY = Sizes(
    grids=(10, 100, 1000), batches=(1, 4), batch_grids=(50,), clients=(1, 3), epochs=1, load_seconds=0.05, points=50
)
SETUP = {"bnserve": "0", "model": "m", "where": "here", "python": "3", "machine": "2"}


@pytest.fixture(scope="module")
def model():
    return Model.default()


def test_the_fit_finds_overhead_and_cost_per_point():
    points = grid_sizes(50)
    fit = fit_cost(points, [1e-3 + 5e-8 * count for count in points])
    assert fit.overhead == pytest.approx(1e-3)
    assert fit.per_point == pytest.approx(5e-8)
    assert fit.at(1000) == pytest.approx(1.05e-3)


def test_the_fit_counts_relative_errors():
    points = [10, 100, 1_000, 10_000, 100_000, 1_000_000]
    noise = 1.0 + 0.01 * np.array([1, -1, 1, -1, 1, -1])
    fit = fit_cost(points, ((1e-6 + 1e-9 * np.array(points)) * noise).tolist())
    assert fit.overhead == pytest.approx(1e-6, rel=0.03)
    assert fit.per_point == pytest.approx(1e-9, rel=0.03)


@pytest.mark.parametrize("seconds", [[3.0, 2.0, 1.0], [1e-9, 1e-3, 1e-1]])
def test_neither_part_of_the_fit_is_negative(seconds):
    fit = fit_cost([10, 1_000, 100_000], seconds)
    assert fit.overhead >= 0.0
    assert fit.per_point >= 0.0


def test_grid_sizes_are_different_whole_numbers_up_to_the_largest():
    sizes = grid_sizes(50, 2, 5_000)
    assert sizes == sorted(set(sizes))
    assert sizes[0] == 2
    assert sizes[-1] == 5_000


def test_every_case_is_timed_in_every_epoch_and_the_order_changes():
    order = []
    cases = {name: lambda name=name: [order.append(name) or float(name)] for name in range(20)}
    found = shuffled(cases, epochs=3)
    assert found == {name: [float(name)] * 3 for name in range(20)}
    epochs = [order[at : at + 20] for at in (0, 20, 40)]
    assert all(sorted(epoch) == list(range(20)) for epoch in epochs)
    assert epochs[0] != epochs[1] != epochs[2]


def test_the_first_call_does_not_count():
    calls = []
    assert len(timed(lambda: calls.append(1), calls=5)()) == 5
    assert len(calls) == 6


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(2.5, "2.50 s"), (0.0125, "12.5 ms"), (3.2e-4, "320 us"), (4e-9, "4.00 ns"), (0.0, "0.00 ns")],
)
def test_durations_are_short(seconds, text):
    assert duration(seconds) == text


def test_binaries_lie_in_the_box_and_differ(model):
    questions = Questions(model.description)
    batch = questions.batch(50)
    assert len(np.unique(batch["mass_ratio"])) == 50
    model.predict_batch(questions.grid(10), batch)  # raises for a row outside


def test_costs_of_a_model(model):
    questions = Questions(model.description)
    single = single_costs(model, questions, TINY)
    assert single["points"] == list(TINY.grids)
    assert single["overhead_seconds"] > 0.0
    assert {(each["rows"], each["points"]) for each in batch_costs(model, questions, TINY)} == {(1, 50), (4, 50)}


def test_the_parts_of_a_waveform_add_up(model):
    found = local_breakdown(model, Questions(model.description), points=200, epochs=2)
    assert all(seconds >= 0.0 for seconds in found["parts"].values())
    assert found["total"] <= sum(found["parts"].values()) * (1.0 + 1e-9)
    assert found["new_grid"] >= 0.0


def test_a_fresh_process_is_timed_in_order():
    found = first_waveform("default", "stable", None, repetitions=1)
    assert 0.0 < found["imported"] < found["loaded"] < found["first_waveform"]


def test_a_fresh_process_that_fails_is_one_sentence():
    with pytest.raises(BnserveError, match="no-such-model"):
        first_waveform("no-such-model", "stable", None, repetitions=1)


def test_a_server_is_measured(server, tmp_path):
    said = []
    found = measure_remote(server.address, "chirp", "stable", None, TINY, said.append)
    assert said
    assert found["single"]["points"] == list(TINY.grids)
    assert [each["clients"] for each in found["concurrency"]] == [1, 3]
    assert all(each["rows_per_second"] > 0.0 for each in found["concurrency"])
    assert "evaluation" in found["breakdown"]["parts"]
    lines = []
    found.pop("model")
    print_report({"setup": SETUP} | found, lines.append)
    text = "\n".join(lines)
    for expected in ("overhead", "per point", "the server's HTTP", "3 clients", "rows"):
        assert expected in text
    pictures = require("bnserve_service.bench.plots", "This measurement").save_plots(found, tmp_path)
    assert Counter(picture.read_bytes()[:4] for picture in pictures) == {b"\x89PNG": 4}


def test_targets_are_read_from_addresses():
    assert Target.parse("http://host:8000/prefix/").address == ("host", 8000)
    assert Target.parse("http://host:8000/prefix/").prefix == "/prefix"
    assert Target.parse("https://host").address == ("host", 443)
    assert Target.parse("https://host").tls
    assert Target.parse("unix:/run/b.sock").address == "/run/b.sock"
    assert b"\r\nAuthorization: Bearer secret\r\n" in Target.parse("http://h", "secret").request("/", b"", {})


def test_an_error_of_the_server_ends_the_load(server):
    target = Target.parse(server.address)
    with pytest.raises(LoadFailed, match="404"):
        answers_per_second(target, [target.request("/nowhere", b"", {})] * 3, 0.1)
    with pytest.raises(LoadFailed, match="404"):
        round_trips(target, target.request("/nowhere", b"", {}), 1)


@pytest.mark.slow
def test_the_command_measures_this_installation(tmp_path, capsys):
    assert main(["bench", "--short", "--epochs", "1", "--json", "--plot", str(tmp_path)]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["single"]["per_point_seconds"] > 0.0
    assert found["server_memory"]["bytes"] > 2**20
    assert found["fresh_process"]["first_waveform"] > 0.0
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "bench-batches.png", "bench-breakdown.png", "bench-single.png"
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--url", "http://127.0.0.1:9", "--store", "x"], "Leave out one"),
        (["--points", "1"], "--points"),
        (["--epochs", "0"], "--epochs"),
        (["--model", "no-such-model"], "no-such-model"),
        (["--url", "ftp://host"], "ftp://host"),
    ],
)
def test_what_cannot_be_measured_is_one_sentence(arguments, sentence, capsys):
    assert main(["bench", *arguments]) == 2
    printed = capsys.readouterr().err
    assert sentence in printed
    assert re.fullmatch(r"bnserve: [^\n]+\n", printed)


def test_a_missing_package_is_one_sentence(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.delitem(sys.modules, "bnserve_service.bench.plots", raising=False)
    with pytest.raises(BnserveError, match="needs the package 'matplotlib', which is not installed"):
        require("bnserve_service.bench.plots", "This measurement")
