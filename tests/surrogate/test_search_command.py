"""``bnserve search`` writes a study, text and a picture, and answers wrong input with a sentence."""

import pytest

from bnserve_service.cli import main
from bnserve_surrogate.training.search.hyperparameters import parse_collection

CONFIGURATION = """
name = "toy"
version = "1.0.0"
[generator]
name = "callable"
[generator.options]
path = "tests.surrogate.toy_waveforms:toy"
release = "1"
[ranges]
frequency_band = [20.0, 1000.0]
[nodes]
count = 40
[dataset]
count = 120
[reduction]
components = 8
[regressor]
kind = "polynomial"
"""


@pytest.fixture
def command(tmp_path):
    """Runs a search of a configuration in ``tmp_path``; returns the exit code."""

    def run(*arguments, text=CONFIGURATION):
        path = tmp_path / "toy.toml"
        path.write_text(text)
        options = ["--work", str(tmp_path / "runs"), "--jobs", "1", "--backend", "sequential", "--no-progress"]
        return main(["search", str(path), *options, *map(str, arguments)])

    return run


def test_a_search_leaves_a_study_a_collection_and_a_picture(command, tmp_path, capsys):
    assert command("--trials", 4) == 0
    printed = capsys.readouterr().out
    assert "Trial 3: " in printed
    assert "median mismatch" in printed
    runs = tmp_path / "runs"
    assert (runs / "search-toy.jsonl").exists()
    text = (runs / "search-toy.toml").read_text()
    assert text.startswith("# Hyper-parameters by number of training waveforms: 4 trials; 20")
    assert len(parse_collection(text, "x").entry) >= 1
    assert (runs / "search-toy.png").read_bytes().startswith(b"\x89PNG")


def test_a_study_can_be_reported_again_without_its_waveforms(command, tmp_path, capsys):
    study = tmp_path / "studies" / "mine.jsonl"
    assert command("--trials", 3, "--study", study) == 0
    first = study.with_suffix(".toml").read_text()
    before = study.read_bytes()
    assert command("--report", "--study", study, "--work", tmp_path / "elsewhere") == 0
    assert study.with_suffix(".toml").read_text() == first
    assert study.read_bytes() == before
    assert not (tmp_path / "elsewhere").exists()


def test_the_collection_beside_a_study_is_one_that_training_takes(command, tmp_path, capsys):
    command("--trials", 3)
    collection = tmp_path / "runs" / "search-toy.toml"
    asking = CONFIGURATION + f'hyperparameters = "best"\npareto = "{collection}"\n[validation]\ncount = 4\n'
    (tmp_path / "best.toml").write_text(asking + "edge_count = 0\n")
    work = ["--work", str(tmp_path / "runs"), "--jobs", "1", "--backend", "sequential", "--no-progress"]
    assert main(["train", str(tmp_path / "best.toml"), "--store", str(tmp_path / "store"), *work]) == 0
    assert "Hyper-parameters: trial " in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments",
    [("--trials", "0"), ("--trials", "-3"), ("--trials", "many"), ("--timeout", "nan"), ("--waveform-seconds", "-1"),
     ("--waveforms", "3")],
    ids="=".join,
)  # fmt: skip
def test_numbers_that_make_no_sense_are_refused(command, capsys, arguments):
    with pytest.raises(SystemExit) as ended:
        command(*arguments)
    assert ended.value.code == 2
    assert f"Argument {arguments[0]}: '{arguments[1]}' is not a number from" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("components = 8", "component = 8", "did you mean 'components'"),
        ('"polynomial"', '"polynom"', "polynom"),
        ("toy_waveforms:toy", "toy_waveforms:tyo", "cannot be imported"),
    ],
)
def test_a_configuration_with_a_mistake_is_a_sentence(command, capsys, old, new, message):
    assert command("--trials", 1, text=CONFIGURATION.replace(old, new)) == 2
    assert message in capsys.readouterr().err


def test_an_unknown_study_and_one_of_another_configuration(command, tmp_path, capsys):
    assert command("--report", "--study", tmp_path / "nowhere.jsonl") == 2
    assert "There is no study" in capsys.readouterr().err
    assert command("--trials", 1) == 0
    capsys.readouterr()
    assert command("--trials", 1, "--waveforms", 64) == 2
    assert "waveforms: 120 there, 64 here" in capsys.readouterr().err


def test_a_study_where_nothing_can_be_written(command, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert command("--trials", 1, "--study", tmp_path / "file" / "study.jsonl") == 2
    assert "cannot be written" in capsys.readouterr().err
