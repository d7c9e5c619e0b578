"""``bnserve waveform``: the bits of the model in a file, by our names or those of others, from here or a server."""

import csv
import json

import h5py
import numpy as np
import pytest

from bnserve_protocol import PARAMETER_NAMES, EvaluationOptions, ParametersWithExtrinsic, UniformGrid
from bnserve_protocol._conversion import _CONVERTED
from bnserve_protocol._foreign import FORMULAS, SAME
from bnserve_service import BackgroundServer, Settings
from bnserve_service.cli import build_parser, main
from bnserve_service.cli.waveform import CONVERTED, EXPLAINED, OURS
from bnserve_surrogate import Model

USUAL = ParametersWithExtrinsic.gw170817()
SHORT = ["--f-min", "30", "--f-max", "40", "--delta-f", "0.5"]
GRID = UniformGrid(f_min=30.0, f_max=40.0, delta_f=0.5)


@pytest.fixture
def waveform(capsys):
    """Runs it: what it says of the binary."""

    def evaluate(*options):
        assert main(["waveform", *map(str, options), "--json"]) == 0
        return json.loads(capsys.readouterr().out)

    return evaluate


@pytest.fixture
def refused(capsys):
    def evaluate(*options):
        assert main(["waveform", *map(str, options)]) == 2
        told = capsys.readouterr()
        assert told.out == ""
        assert told.err.count("\n") == 1
        return told.err

    return evaluate


def test_its_names_are_those_of_the_protocol():
    assert set(OURS) == set(PARAMETER_NAMES)
    assert all(f"({getattr(USUAL, name):g})" in text for name, text in OURS.items())
    assert set(CONVERTED) == {*_CONVERTED, *(theirs for theirs, ours in SAME.items() if ours in PARAMETER_NAMES)}
    assert set(EXPLAINED) == set(FORMULAS) - set(CONVERTED)


def test_without_options_it_is_like_gw170817(waveform):
    said = waveform()
    assert ParametersWithExtrinsic(**said["parameters"]) == USUAL
    assert (said["model"], said["version"], said["server"], said["output"]) == (
        "default",
        Model.default().description.version,
        None,
        None,
    )
    assert said["seconds_until_merger"] == Model.default().time_until_merger(20.0, USUAL)


def test_modes_may_be_chosen(waveform, refused, tmp_path):
    """As (l, m) of two digits each; without, all count."""
    known = [list(mode) for mode in Model.default().description.modes]
    assert waveform()["modes"] == known
    assert waveform("--modes", "33, 22", *SHORT, "--output", tmp_path / "h.npz")["modes"] == [[3, 3], [2, 2]]
    expected = Model.default().predict(GRID, USUAL, options=EvaluationOptions(modes=[(3, 3), (2, 2)]))
    assert read(tmp_path / "h.npz")[1].tobytes() == expected.plus.tobytes()
    for modes in ("2,2", "222", "", "22,", "2x"):
        assert "such as 22,33" in refused("--modes", modes)
    assert "no mode (5, 5); it has (2, 2)" in refused("--modes", "22,55")


def read(path):
    """Frequencies, h_plus and h_cross of a file, and its summary where there is one."""
    if path.suffix == ".csv":
        with path.open() as file:
            rows = list(csv.DictReader(file))
        column = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
        plus, cross = (column[f"h_{name}_re"] + 1j * column[f"h_{name}_im"] for name in ("plus", "cross"))
        return column["frequency_hz"], plus, cross, None
    if path.suffix == ".npz":
        with np.load(path) as file:  # nothing in it can run
            return file["frequencies"], file["h_plus"], file["h_cross"], json.loads(str(file["summary"]))
    with h5py.File(path) as file:
        return *(file[name][()] for name in ("frequencies", "h_plus", "h_cross")), json.loads(file.attrs["summary"])


@pytest.mark.parametrize("ending", [".npz", ".csv", ".h5", ".hdf5"])
def test_a_file_has_the_bits_of_the_model(waveform, tmp_path, ending):
    path = tmp_path / f"gw{ending}"
    said = waveform("--output", path, *SHORT, "--mass-ratio", 1.5)
    frequencies, plus, cross, summary = read(path)
    expected = Model.default().predict(GRID, ParametersWithExtrinsic(**said["parameters"]))
    assert said["parameters"]["mass_ratio"] == 1.5
    assert np.array_equal(frequencies, GRID.frequencies())
    assert np.array_equal(plus, expected.plus)
    assert np.array_equal(cross, expected.cross)
    assert summary in (None, said)


@pytest.mark.parametrize("ending", [".png", ".svg"])
def test_a_picture(waveform, tmp_path, ending):
    pytest.importorskip("matplotlib")
    waveform("--output", tmp_path / f"gw{ending}", "--distance-mpc", 400)
    assert (tmp_path / f"gw{ending}").read_bytes()[:5] in (b"\x89PNG\r", b"<?xml")


def test_a_server_gives_the_same_bits(waveform, tmp_path):
    with BackgroundServer(Settings(port=0)) as server:
        said = waveform("--url", server.address.removeprefix("http://"), "--output", tmp_path / "there.npz", *SHORT)
    waveform("--output", tmp_path / "here.npz", *SHORT)
    assert said["server"]
    there, here = read(tmp_path / "there.npz"), read(tmp_path / "here.npz")
    assert np.array_equal(there[1], here[1])


@pytest.mark.parametrize(
    ("given", "becomes"),
    [
        (["--mass-1", 1.4, "--mass-2", 1.4], {"mass_ratio": 1.0, "total_mass": 2.8}),
        (["--mass_1", 1.4, "--mass_2", 1.4], {"mass_ratio": 1.0, "total_mass": 2.8}),
        (["--chirp-mass", 1.188], {"mass_ratio": 1.2, "total_mass": 1.188 * (2.2**2 / 1.2) ** 0.6}),
        (["--luminosity-distance", 100, "--theta-jn", 0.3], {"distance_mpc": 100.0, "inclination": 0.3}),
        (["--chi-1", -0.2], {"chi_1": -0.2}),
    ],
)
def test_names_of_other_programs(waveform, given, becomes):
    said = waveform(*given)["parameters"]
    assert {name: said[name] for name in becomes} == pytest.approx(becomes)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (["--phase", 1], "reference_phase is twice that of the orbit"),
        (["--geocent_time", 1], "time_shift moves a waveform"),
        (["--mass-1", 1.4], "total_mass = mass_1 + mass_2"),
        (["--mass-ratio", 5], "The model was not trained on this binary. mass_ratio = 5.0: outside [1, 3]."),
        (["--f-max", 0], "'f_max' of a uniform grid"),
        (["--output", "gw.txt"], "end its name in one of .npz, .csv, .h5, .hdf5, .png, .pdf, .svg."),
        (["--output", "/dev/null/gw.npz"], "Cannot write /dev/null/gw.npz"),
        (["--url", "localhost:1", "--store", "."], "Leave out one of the two"),
        (["--model", "defualt"], "Did you mean 'default'?"),
    ],
)
def test_what_cannot_be_is_one_sentence(refused, given, says):
    assert says in refused(*given)


def test_a_misspelt_parameter_has_a_near_one(capsys):
    with pytest.raises(SystemExit, match="2"):
        build_parser().parse_args(["waveform", "--mass-raito", "1.2"])
    assert "Did you mean '--mass-ratio'?" in capsys.readouterr().err
