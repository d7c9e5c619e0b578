"""What the server promises, in the short form: counts, statuses and memory. How fast it was is for the long form.

``benchmarks/reliability`` says what each measurement does; with its fault injected, each has to fail.
"""

import json
import math

import pytest

from benchmarks.reliability.__main__ import main
from benchmarks.reliability.outcome import NAMES, find, in_present_names, names, present_name, promise_of
from benchmarks.reliability.page import FIRST
from benchmarks.reliability.soak import theil_sen

MIB = 2**20
FORKS = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")
"""Callers are processes."""


def measured(name, injected=None):
    """The figures of a short run, and whether it said that the promise is kept."""
    outcome = find(name, injected).run(True, print, injected)
    assert all(not isinstance(value, float) or math.isfinite(value) or "refusals" in key
               for key, value in outcome.figures.items())  # fmt: skip
    assert outcome.summary
    return outcome.figures, outcome.passed


def test_every_promise_has_a_measurement_a_mechanism_a_bar_and_faults():
    assert names() == list(NAMES)
    for name in names():
        promise = find(name)
        assert promise_of(promise)
        assert len(promise.MECHANISM) > 50
        assert promise.BAR
        assert promise.INJECTED_FAULTS, f"{name} cannot be seen to fail"


def test_overload_sheds_with_a_reason_and_health_is_never_shed():
    figures, _ = measured("overload")
    assert figures["refused"] > 0
    assert figures["refusals without Retry-After"] == 0
    assert figures["health not answered"] == 0
    assert figures["good answers/s at 10x"] > 0


def test_clients_that_vanish_leave_no_work_behind():
    figures, _ = measured("vanishing")
    assert figures["left while they waited"] > 10
    assert figures["wasted share"] <= 0.05
    assert figures["errors of those who stayed"] == 0


def test_a_rolling_restart_loses_nothing():
    figures, _ = measured("drain")
    assert figures["requests"] > 100
    assert figures["failed"] == 0
    assert figures["exits with another status than 0"] == 0


def test_reloads_mix_no_versions():
    figures, _ = measured("reload")
    assert figures["reloads"] > 0
    assert figures["versions seen in answers"] > 1
    assert figures["errors"] == figures["answers of no version"] == 0


def test_damaged_artifacts_are_refused():
    figures, kept = measured("artifacts")
    assert kept
    assert figures["refused"] > 40


def test_killed_and_stopped_workers_are_replaced():
    figures, _ = measured("hung")
    assert figures["faults"] == 1
    assert figures["requests"] > 500
    assert figures["failed, of callers without retries"] < 100


def test_no_body_outgrows_the_cap():
    figures, kept = measured("body_cap")
    assert kept
    assert figures["memory, MiB, chunked"] < 32


def test_slow_clients_are_cut_off():
    figures, _ = measured("slow_clients")
    assert figures["slow connections at a time"] == 200
    assert figures["errors of others"] == 0


def test_floods_of_what_is_not_body_are_cut_off():
    figures, _ = measured("trailers")
    assert figures["floods"] == figures["floods refused"] > 10
    assert figures["memory at most, MiB more"] < 32
    assert figures["workers replaced"] == figures["errors of others"] == 0


@FORKS
def test_requests_are_told_apart_also_behind_haproxy():
    figures, kept = measured("framing")
    assert kept
    assert figures["requests"] > 500


def test_slow_readers_are_cut_off_and_others_are_answered():
    figures, _ = measured("slow_readers")
    assert figures["answers that they began to take"] > 2
    assert figures["answers that they got"] == 0
    assert figures["answers of others"] > 0
    assert figures["of these wrong"] == 0


def test_a_shared_folder_that_is_removed_is_made_again():
    figures, _ = measured("shared_folder")
    assert figures["folders removed"] == figures["uploads kept when all was whole"] == 1
    assert figures["lost"] == figures["wrong"] == figures["uploads answered with 500"] == 0


def test_no_code_comes_from_data():
    figures, kept = measured("no_code")
    assert kept
    assert figures["hostile requests"] > 100
    assert figures["hostile answers"] > 100


def test_wrong_tokens_stay_outside_and_all_tokens_inside():
    figures, kept = measured("tokens")
    assert kept
    assert figures["wrong headers"] > 40


def test_the_soak_reads_memory_and_files_and_sees_no_error():
    figures, _ = measured("soak")
    assert figures["5xx"] == figures["failed"] == figures["exit status"] == 0
    assert figures["growth of open files"] <= 2
    assert figures["reloads"] > 0


@FORKS
@pytest.mark.parametrize(
    ("name", "injected"),
    [
        ("no_code", "unpickle-bodies"),
        ("tokens", "prefix-compare"),
        ("vanishing", "no-watch"),
        ("trailers", "endless-frames"),
        ("framing", "trailers-as-headers"),
        ("shared_folder", "no-look"),
        ("slow_readers", "timeout-restarts"),
    ],
)
def test_without_its_mechanism_a_promise_is_not_kept(name, injected):
    _, kept = measured(name, injected)
    assert not kept


def test_a_trend_is_told_from_a_step():
    hours = [0.1 * number for number in range(20)]
    assert theil_sen(hours, [5.0 * hour for hour in hours]) == pytest.approx(5.0)
    assert theil_sen(hours, [0.0] * 3 + [7.0] * 17) == 0.0


def test_figures_are_kept_and_fill_the_page(tmp_path, capsys):
    results, page, readme = tmp_path / "results", tmp_path / "page.md", tmp_path / "readme.md"
    results.mkdir()
    page.write_text("<!-- begin: promises -->\n<!-- end: promises -->\n")
    readme.write_text("<!-- begin: reliability -->\n<!-- end: reliability -->\n")
    assert main(["tokens", "--short", "--json", "--output", str(results / "tokens.json")]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed["command"] == "python -m benchmarks.reliability tokens --short"
    paths = ["--results", str(results), "--page-file", str(page), "--readme", str(readme)]
    assert main(["--page", *paths]) == 0
    assert printed["summary"] in page.read_text()
    shown = readme.read_text()  # those that come first, measured or not
    assert [name for name in FIRST if f"`python -m benchmarks.reliability {name}`" in shown] == list(FIRST)
    assert shown.count("not measured yet") == len(FIRST)


@pytest.mark.parametrize("arguments", [["nothing"], ["tokens", "--inject", "nothing"], []])
def test_mistakes_are_explained(arguments, capsys):
    assert main(arguments) == 2
    assert capsys.readouterr().err


def test_former_names_are_understood_for_one_version():
    with pytest.warns(DeprecationWarning, match="called"):
        words = [present_name(word) for word in ("slow_readers", "--plant", "patience-restarts")]
    assert words == ["slow_readers", "--inject", "timeout-restarts"]


def test_commands_of_kept_results_are_shown_in_the_names_of_today():
    kept = "python -m benchmarks.reliability shares --short --plant one-owner"
    assert in_present_names(kept) == "python -m benchmarks.reliability quotas --short --inject one-owner"


def test_the_promises_are_listed(capsys):
    assert main(["--list"]) == 0
    assert "overload" in capsys.readouterr().out
