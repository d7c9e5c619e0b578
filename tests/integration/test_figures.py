"""Every figure of the documentation comes from one command, with its numbers beside it."""

import json
import re
import tomllib
from pathlib import Path

import pytest

from benchmarks.accuracy import main as accuracy
from benchmarks.figures.__main__ import FIGURES
from benchmarks.figures.__main__ import main as figures
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.pipeline import train
from bnserve_surrogate.training.publication import publish

OF_MODES = ("modes", "higher_modes")
"""Figures of models with several."""
FUNCTION = "tests.integration.figure_waveforms:waveform"
GENERATOR = """
[generator]
name = "callable"
options = { path = "tests.integration.figure_waveforms:waveform", release = "1" }
"""
OURS = """
name = "ours"
version = "1.0.0"
[nodes]
count = 60
[dataset]
count = 256
[reduction]
components = 8
[regressor.polynomial]
degree = 3
[validation]
count = 32
edge_count = 32
"""
PAPER = """
name = "paper"
version = "1.0.0"
[ranges]
frequency_band = [20.0, 1024.0]
[nodes]
kind = "greedy"
waveforms = 8
[dataset]
count = 256
sampling = "uniform"
[reduction]
kind = "paper"
components = 6
[regressor]
kind = "network"
coordinates = "raw"
network = { hidden_layer_sizes = [8], batch_size = 16, max_iter = 20 }
"""
PARETO = """
[setup]
regressor = "polynomial"
reduction = "metric"
coordinates = "physical"
generator = "callable"
sampling = "mixture"
waveforms = 64
waveform_seconds = 0.1
trials = 4
mass_ratio = [1.0, 3.0]
chi = [-0.5, 0.5]
tidal_deformability = [5.0, 5000.0]
""" + "".join(
    f"""
[[entry]]
trial = {number}
waveforms = {waveforms}
reconstruction_error = {error}
median_mismatch = {error}
training_seconds = 1.0
cost_seconds = {waveforms / 10}
hyperparameters = {{}}
"""
    for number, (waveforms, error) in enumerate([(64, 1e-4), (128, 1e-6)])
)


@pytest.fixture(scope="module")
def place(tmp_path_factory) -> Path:
    """A folder with recipes, a store with a model, a Pareto collection and a page to fill."""
    folder = tmp_path_factory.mktemp("figures")
    for name, text in {"ours.toml": OURS, "paper.toml": PAPER}.items():
        (folder / name).write_text(text + GENERATOR)
    (folder / "pareto_polynomial.toml").write_text(PARETO)
    (folder / "page.md").write_text("".join(f"<!-- begin: figure {n} -->\n<!-- end: figure {n} -->\n" for n in FIGURES))
    recipe = parse_configuration(tomllib.loads(OURS + GENERATOR))
    publish(recipe, train(recipe, folder / "runs", n_jobs=1, progress=False, say=lambda line: None), folder / "store")
    return folder


def common(place: Path) -> list[str]:
    return ["--short", "--jobs", "1", "--work", str(place / "runs"), "--store", str(place / "store")]


def arguments(place: Path) -> list[str]:
    paths = {"recipe": "ours.toml", "paper": "paper.toml", "pareto": ".", "output": "images"}
    options = [part for name, path in paths.items() for part in (f"--{name}", str(place / path))]
    return [*common(place), "--model", "ours", *options]


@pytest.mark.slow
def test_one_command_draws_all_figures_and_writes_their_numbers(place, capsys):
    names = [name for name in FIGURES if name not in OF_MODES]
    assert figures([*names, *arguments(place), "--page", str(place / "page.md")]) == 0
    printed = capsys.readouterr().out
    for name in names:
        assert (place / "images" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        record = json.loads((place / "images" / f"{name}.json").read_text())
        assert record["setup"]["command"] == f"python -m benchmarks.figures {name} --short"
        assert record["numbers"]
        summary = "\n".join(record["summary"])
        assert summary in printed
        assert (
            f"$ python -m benchmarks.figures {name} --short\n{summary}\n```\n<!-- end: figure {name} -->"
            in (place / "page.md").read_text()
        )

    numbers = {name: json.loads((place / "images" / f"{name}.json").read_text())["numbers"] for name in names}
    before, after = (numbers["residuals"][when]["phase_radians"]["all"] for when in ("before", "after"))
    assert after < before / 10
    by_size = numbers["mismatch_by_size"]["mismatch"]
    assert set(by_size) == {"paper", "ours", "baseline alone"}
    assert by_size["ours"]["256"]["median"] < by_size["baseline alone"]["0"]["median"] / 10
    points = numbers["sampling"]["points"]
    assert points["uniform"]["phase"] > points["multibanded"]["phase"] > points["greedy on residuals"]["phase"]


@pytest.mark.parametrize("name", OF_MODES)
def test_a_figure_of_modes_says_which_models_have_some(place, capsys, name):
    assert figures([name, *arguments(place)]) == 1
    assert "has the (2, 2) mode alone; take one with more" in capsys.readouterr().err


def test_the_modes_of_the_shipped_model_are_drawn(place, tmp_path, capsys):
    assert figures(["modes", *common(place), "--model", "default@2.0.0", "--output", str(tmp_path)]) == 0
    printed = capsys.readouterr().out
    assert all(str(mode) in printed for mode in [(2, 2), (2, 1), (3, 3), (4, 4), (3, 2), (3, 1), (4, 3)])
    assert (tmp_path / "modes.png").exists()


def test_drawing_again_generates_nothing(place, capsys):
    figures(["mismatch_by_size", *arguments(place)])
    capsys.readouterr()
    assert figures(["mismatch_by_size", *arguments(place)]) == 0
    assert "training" not in capsys.readouterr().err


def test_without_a_search_the_pareto_figure_says_how_to_make_one(place, tmp_path, capsys):
    assert figures(["pareto", *arguments(place), "--pareto", str(tmp_path)]) == 1
    assert "bnserve search" in capsys.readouterr().err


def test_an_unknown_model_is_one_sentence(place, capsys):
    assert figures(["residuals", *arguments(place), "--model", "our"]) == 1
    assert "ours" in capsys.readouterr().err


def test_the_accuracy_table_names_models_detectors_and_the_predecessor(place, capsys):
    assert accuracy(["ours", *common(place), "--generator", FUNCTION]) == 0
    table = capsys.readouterr().out
    for expected in ("`ours` 1.0.0", "M = 2, ET-D", "M = 4, ET-D", "Advanced LIGO from 20 Hz", "mlgw_bns 0.12.1"):
        assert expected in table
    assert re.search(r"\| 32 on faces, edges, corners \| M = 2.8, ET-D \| \d\.\de-\d\d", table)


def test_the_accuracy_table_as_json(place, capsys):
    assert accuracy(["ours", *common(place), "--generator", FUNCTION, "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert len(rows) == 5
    assert all(0.0 < row["mismatch"]["median"] < row["mismatch"]["max"] < 1e-3 for row in rows)
