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
def test_the_event_is_sampled_and_its_likelihoods_compared(run, bnserve_server, tmp_path, monkeypatch, capsys):
    few = ["--particles", 400, "--effective", 500, "--checks", 20, "--generator-checks", 1]
    few += ["--calibration-checks", 2, "--calibration-draws", 5]
    arguments = ["--url", bnserve_server.address, "--work", tmp_path / "work", *few]
    found = run(gw170817, *arguments, "--figure", tmp_path / "corner.png")
    assert found["likelihood_calls"] > 500
    assert 0.0 < found["log_evidence_error"] < 0.1
    assert abs(found["log_evidence"] - 490.2) < 0.5
    assert found["roq_and_full_max_abs_delta_lnl"] < 0.2
    assert 0.0 < found["roq_and_relative_binning_reweighting_efficiency"] <= 1.0
    assert 0.0 <= found["roq_and_full_largest_divergence"] < 0.7
    assert (tmp_path / "corner.png").stat().st_size > 10_000
    again = run(gw170817, *arguments, "--sample-only")
    assert again["log_evidence"] == found["log_evidence"]
    assert again["likelihood_calls"] == found["likelihood_calls"]  # nothing was asked again
    monkeypatch.setattr(sys, "argv", ["gw170817", *map(str, arguments), "--seed", "9"])
    assert gw170817() == 1
    assert "name another file, or delete it" in capsys.readouterr().err


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
