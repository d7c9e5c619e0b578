"""The commands of the inference pages, from end to end with few samples: they run, resume and report what they say."""

import json
import sys
from pathlib import Path

import pytest

from benchmarks.gw170817.__main__ import main as gw170817
from benchmarks.inference.__main__ import main as inference
from benchmarks.pp.__main__ import main as pp

RESULTS = Path(__file__).parents[2] / "benchmarks" / "pp" / "results"


@pytest.fixture
def run(monkeypatch, capsys):
    """Run a command with these arguments; the object on the last line of its output."""

    def call(command, *arguments):
        monkeypatch.setattr(sys, "argv", ["command", *(str(argument) for argument in arguments)])
        assert command() in (None, 0)
        return json.loads(capsys.readouterr().out.splitlines()[-1])

    return call


@pytest.mark.slow
def test_the_event_is_sampled_and_its_likelihoods_compared(bnserve_server, tmp_path, monkeypatch, capsys):
    arguments = ["--url", bnserve_server.address, "--work", tmp_path, "--particles", 400, "--effective", 500]
    arguments += ["--checks", 20, "--generator-checks", 2, "--figure", tmp_path / "corner.png"]

    def call(*more):
        monkeypatch.setattr(sys, "argv", ["gw170817", *map(str, [*arguments, *more])])
        return gw170817()

    assert call() == 0
    printed = capsys.readouterr().out
    found = json.loads((tmp_path / "result.json").read_text())
    assert list(found["runs"]) == ["quadrature", "binning", "calibration"]
    for one in found["runs"].values():
        assert one["likelihoods"] > 500
        assert abs(one["log_evidence"] - 490.2) < 0.6
        assert one["check"]["largest"] < 0.2
    assert found["runs"]["calibration"]["calibration"]["draws"] == 20
    assert 0.0 < found["generator"]["largest"] < 0.5
    assert all(0.0 <= value < 0.1 for _, value in found["divergences"].values())
    assert (tmp_path / "corner.png").stat().st_size > 10_000
    assert call() == 0
    assert capsys.readouterr().out == printed  # nothing was sampled again
    assert call("--seed", 9) == 1
    assert "throw it away with --force, or name another folder" in capsys.readouterr().err


@pytest.mark.slow
def test_the_percentile_percentile_test_goes_on_where_it_was_stopped(run, bnserve_server, tmp_path):
    arguments = ["--url", bnserve_server.address, "--work", tmp_path, "--particles", 400, "--effective", 300]
    first = run(pp, *arguments, "--injections", 1)
    assert first["injections"] == first["wanted"] == 1
    with (tmp_path / "injections.jsonl").open("a") as file:
        file.write('{"seed": 1, "ranks": {"chirp_m')  # killed while it wrote
    second = run(pp, *arguments, "--injections", 2, "--figure", tmp_path / "pp.png")
    assert second["injections"] == 2
    assert second["likelihood_calls"] > first["likelihood_calls"]
    assert set(second["p_values"]) >= {"chirp_mass", "lambda_1", "coalescence_time"}
    assert (tmp_path / "pp.png").stat().st_size > 10_000


@pytest.mark.parametrize(("network", "count"), [("ligo", 100), ("et", 50)])
def test_the_percentiles_that_were_found_are_judged_as_the_page_says(run, network, count):
    found = run(pp, "--network", network, "--work", RESULTS, "--injections", count, "--seconds", 0)
    assert found["injections"] == count
    assert found["combined_p"] >= 0.01
    assert found["smallest_p"] >= found["smallest_p_wanted"]
    assert found["largest_k_hat"] <= 0.7
    judged = json.loads((RESULTS / "result.json").read_text())[network]
    assert judged == found


@pytest.mark.slow
def test_speed_and_accuracy_of_the_likelihoods(run):
    found = run(inference, "--short", "--json", "--rounds", 1, "--points", 10)
    for name in ("roq_us", "relative_binning_us", "peer_bilby_relative_binning_us"):
        assert 0.0 < found[name] < 1e5
    assert found["roq_max_abs_delta_lnl"] < 0.2
    assert found["basis_linear"] > found["basis_quadratic"] > 0
