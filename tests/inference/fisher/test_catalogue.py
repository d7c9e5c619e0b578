"""Forecasts of catalogues: files of other programs, interruptions, and what the command says."""

import io
import json

import h5py
import numpy as np
import pytest

from bnserve_inference.fisher import as_samples, draw_population, luminosity_distance, read_population
from bnserve_protocol import AnalysisInvalid, InvalidParameters, InvalidRequest
from bnserve_service import BackgroundServer, Settings
from bnserve_service.cli import main

COLUMNS = {
    "mass_1": [1.5, 1.7, 1.6], "mass_2": [1.3, 1.4, 1.5], "luminosity_distance": [100.0, 300.0, 40.0],
    "theta_jn": [0.4, 1.2, 2.0], "ra": [1.0, 2.0, 3.0], "dec": [0.1, -0.4, 0.9], "psi": [0.3, 0.5, 0.7],
    "phase": [1.0, 2.0, 3.0], "geocent_time": [1.7e9, 1.7e9 + 5e6, 1.7e9 + 1e7], "redshift": [0.02, 0.07, 0.01],
    "lambda_1": [300.0, 200.0, 250.0], "lambda_2": [500.0, 600.0, 300.0],
}  # fmt: skip


@pytest.fixture
def text(tmp_path):
    file = tmp_path / "population.csv"
    rows = zip(*COLUMNS.values(), strict=True)
    file.write_text("\n".join([",".join(COLUMNS), *(",".join(map(repr, row)) for row in rows)]))
    return file


def hdf5(tmp_path, columns=COLUMNS):
    file = tmp_path / "population.h5"
    with h5py.File(file, "w") as stored:
        for name, column in columns.items():
            stored.create_dataset(f"injections/{name}", data=column)
    return file


def test_files_say_the_same(text, tmp_path):
    ours, other = (as_samples(read_population(file)) for file in (text, hdf5(tmp_path)))
    assert ours[1] == other[1] == 1.7e9
    assert ours[0].values.tobytes() == other[0].values.tobytes()
    assert ours[0]["coalescence_time"].tolist() == [0.0, 5e6, 1e7]
    assert ours[0]["total_mass"] == pytest.approx([2.8, 3.1, 3.1])
    assert ours[0]["chi_1"].tolist() == [0.0, 0.0, 0.0]


def test_a_table_of_pandas_is_read(tmp_path):
    """The fixed format, as GWFish's catalogues have it; pandas needs PyTables to write it, so its layout is written."""
    file = tmp_path / "table.hdf5"
    with h5py.File(file, "w") as stored:
        group = stored.create_group("root")
        group["block0_items"] = np.array([name.encode() for name in COLUMNS])
        group["block0_values"] = np.array(list(COLUMNS.values())).T
    assert {name: column.tolist() for name, column in read_population(file).items()} == COLUMNS


def test_masses_of_the_source_are_redshifted():
    columns = {name: np.array(column) for name, column in COLUMNS.items()}
    source = columns | {"mass_1_source": columns["mass_1"], "mass_2_source": columns["mass_2"]}
    del source["mass_1"], source["mass_2"]
    assert as_samples(source)[0]["total_mass"] == pytest.approx([2.8 * 1.02, 3.1 * 1.07, 3.1 * 1.01])
    del source["redshift"]
    with pytest.raises(AnalysisInvalid, match="give 'redshift' too"):
        as_samples(source)


def test_what_is_no_catalogue_is_refused(tmp_path):
    file = tmp_path / "notes.txt"
    file.write_text("some words\nand more")
    with pytest.raises(AnalysisInvalid, match="is no catalogue"):
        read_population(file)
    with pytest.raises(AnalysisInvalid, match=r"There is no file .*missing\.h5"):
        read_population(tmp_path / "missing.h5")
    file.write_text("mass_1,mass_2\n1,2,3\n")
    with pytest.raises(AnalysisInvalid, match="names 2 columns, and there are 3"):
        read_population(file)
    file.write_text("mass_1,mass_1\n1,2\n")
    with pytest.raises(AnalysisInvalid, match="'mass_1' twice"):
        read_population(file)
    columns = {name: np.array(column) for name, column in COLUMNS.items()}
    with pytest.raises(AnalysisInvalid, match="Binary 1 of the catalogue has no time"):
        as_samples(columns | {"geocent_time": np.array([1.7e9, np.nan, 1.7e9])})
    with pytest.raises(AnalysisInvalid, match="'geocent_time' in GPS seconds"):
        as_samples({name: column for name, column in columns.items() if name != "geocent_time"})
    with pytest.raises(InvalidParameters, match="mass_l"):
        as_samples(columns | {"mass_l": columns["mass_1"]})


def run(text, tmp_path, *more):
    return main([*options(text, tmp_path), *more])


def test_folders_are_made_and_a_picture_that_is_none_is_refused_before_the_work(text, tmp_path, capsys):
    picture = tmp_path / "made" / "too" / "out.pdf"
    assert main([*options(text, tmp_path / "made"), "--plot", str(tmp_path / "out.txt")]) == 2
    assert "A picture cannot be named 'out.txt': its name ends in" in capsys.readouterr().err
    assert not (tmp_path / "made").exists()
    assert main([*options(text, tmp_path / "made"), "--plot", str(picture)]) == 0
    assert (tmp_path / "made" / "out.h5").exists()
    assert picture.read_bytes()[:4] == b"%PDF"


def options(text, folder):
    command = ["fisher", str(text), "--output", str(folder / "out.h5"), "--work", str(folder / "runs")]
    return [*command, "--quadrupole", "--f-min", "20", "--no-progress", "--jobs", "1"]


def test_the_command_writes_says_and_goes_on(text, tmp_path, capsys):
    assert run(text, tmp_path, "--network", "ET,CE1", "--json", "--plot", str(tmp_path / "out.png")) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["binaries"] == said["snr above 12"] == 3
    with h5py.File(tmp_path / "out.h5") as stored:
        snr, covariance = stored["snr"][()], stored["covariance"][()]
        assert stored["detector_snr"].shape == (3, 4)
        assert stored.attrs["model"].startswith("default 2.0.0 sha256:")
        assert "error/lambda_tilde" in stored
    assert snr[2] > snr[0] > snr[1]
    assert (tmp_path / "out.png").read_bytes()[:4] == b"\x89PNG"
    # What is finished is not done again: a piece that says something else is taken as it is.
    [piece] = (tmp_path / "runs").glob("fisher-*/*.npz")
    with np.load(piece) as kept:
        changed = {name: kept[name] for name in kept.files}
    np.savez(piece, **changed | {"snr": changed["snr"] + 1.0})
    assert run(text, tmp_path, "--network", "ET,CE1") == 0
    with h5py.File(tmp_path / "out.h5") as stored:
        assert stored["snr"][()].tolist() == (snr + 1.0).tolist()
        assert stored["covariance"][()].tobytes() == covariance.tobytes()
    assert "Forecasts: " in capsys.readouterr().out
    assert run(text, tmp_path, "--network", "ET") == 0  # another question
    assert len(list((tmp_path / "runs").glob("fisher-*"))) == 2


def test_a_population_is_drawn_forecast_and_plotted(tmp_path, capsys):
    command = ["fisher", "--draw", "6", "--seed", "3", "--redshift", "0.5", "--quadrupole", "--f-min", "20"]
    where = [
        "--output",
        str(tmp_path / "out.h5"),
        "--work",
        str(tmp_path / "runs"),
        "--plot",
        str(tmp_path / "out.png"),
    ]
    assert main([*command, *where, "--prior", "chi_1=0.05", "--prior", "chi_2=0.05", "--no-progress", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["binaries"] == 6
    assert (tmp_path / "out.png").read_bytes()[:4] == b"\x89PNG"
    drawn = draw_population(6, 3, most_redshift=0.5)
    with h5py.File(tmp_path / "out.h5") as stored:
        kept = {name: stored[f"population/{name}"][()] for name in stored["population"]}
        assert np.isfinite(stored["error/lambda_tilde"][()]).all()
    assert kept.keys() == drawn.keys()
    assert all(np.array_equal(kept[name], drawn[name]) for name in drawn)
    assert main([*command, *where, str(tmp_path / "population.csv")]) == 2
    assert "give one of the two" in capsys.readouterr().err


def test_populations_are_what_they_are_said_to_be():
    drawn = draw_population(20_000, 1)
    assert (drawn["mass_1_source"] >= drawn["mass_2_source"]).all()
    both = np.concatenate([drawn["mass_1_source"], drawn["mass_2_source"]])
    assert both.mean() == pytest.approx(1.33, abs=3e-3)
    assert both.std() == pytest.approx(0.0886, abs=2e-3)
    assert drawn["lambda_1"] == pytest.approx(400.0 * (drawn["mass_1_source"] / 1.4) ** -6.0)
    assert np.abs(drawn["chi_1"]).max() < 0.05
    # The part of all mergers nearer than a redshift of one, by a sum on another grid.
    z = np.linspace(1e-6, 10.0, 100_001)
    comoving = np.cumsum(1.0 / np.sqrt(0.30966 * (1.0 + z) ** 3 + 0.69034))
    rate = (1.0 + z) ** 1.7 / (1.0 + ((1.0 + z) / 2.9) ** 5.6) * comoving**2 / np.sqrt(0.30966 * (1 + z) ** 3 + 0.69034)
    assert (drawn["redshift"] < 1.0).mean() == pytest.approx(rate[z < 1.0].sum() / rate.sum(), abs=0.006)
    assert drawn["luminosity_distance"].tolist() == luminosity_distance(drawn["redshift"]).tolist()
    for most in (0.01, 1.0):
        z = np.linspace(0.0, most, 100_001)
        comoving = 299792.458 / 67.66 * np.trapezoid(1.0 / np.sqrt(0.30966 * (1.0 + z) ** 3 + 0.69034), z)
        assert luminosity_distance(np.array([most])) == pytest.approx((1.0 + most) * comoving, rel=1e-9)
    assert (draw_population(5, 1)["redshift"] == draw_population(5, 1)["redshift"]).all()
    assert (draw_population(5, 1)["redshift"] != draw_population(5, 2)["redshift"]).all()
    for count, most in ((0, 1.0), (5, 0.0), (5, float("nan")), (5, 100.0)):
        with pytest.raises(InvalidRequest, match="A population has binaries"):
            draw_population(count, 1, most_redshift=most)


def test_a_server_makes_them(text, tmp_path, capsys):
    assert run(text, tmp_path, "--network", "ET,CE1") == 0
    here = (tmp_path / "out.h5").read_bytes()
    with BackgroundServer(Settings(port=0)) as server:
        assert (
            run(text, tmp_path, "--network", "ET,CE1", "--url", server.address, "--work", str(tmp_path / "more")) == 0
        )
        capsys.readouterr()
        assert run(text, tmp_path, "--url", server.address, "--model", "defualt") == 2
        assert "defualt" in capsys.readouterr().err
    with h5py.File(io.BytesIO(here)) as ours, h5py.File(tmp_path / "out.h5") as theirs:
        for name in ("snr", "covariance", "sky_area_90", "error/lambda_tilde"):
            assert ours[name][()].tobytes() == theirs[name][()].tobytes()
        assert ours.attrs["model"] == theirs.attrs["model"]


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (("--network", "H1"), "--noise H1=FILE"),
        (("--network", "ET,X7"), "--noise X7=FILE"),
        (("--network", "ET,CE1,E2"), "got 'E2' 2 times"),
        (("--network", ",ET"), "names with a comma between each two; got ',ET'"),
        (("--noise", "E1"), "NAME=VALUE"),
        (("--noise", "e1=curve.txt"), "a file of e1, which is not in the network: E1, E2, E3"),
        (("--noise", "E1=one.txt", "--noise", "E1=other.txt"), "twice for E1"),
        (("--prior", "chi_1=0.1", "--prior", "chi_1=0.2"), "twice for chi_1"),
        (("--prior", "lambda_tilde=wide"), "has no number"),
        (("--prior", "mass=1"), "positive width"),
        (("--model", "defualt"), "defualt"),
    ],
)
def test_mistakes_are_one_sentence(text, tmp_path, capsys, more, words):
    assert run(text, tmp_path, *more) == 2
    said = capsys.readouterr().err
    assert words in said
    assert "Traceback" not in said
    assert not (tmp_path / "out.h5").exists()
