"""``bnserve roq``: build, show, validate, export; what is wrong is one sentence."""

import pytest

from bnserve_inference.roq import load_bajes, load_basis, load_bilby
from bnserve_service.cli import main
from tests.inference.roq.tiny import TINY, changed, toml


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("command")


@pytest.fixture(scope="module")
def run(folder):
    """A finished ``bnserve roq build``."""
    (folder / "tiny.toml").write_text(toml(TINY))
    arguments = ["roq", "build", str(folder / "tiny.toml"), "--work", str(folder / "work"), "--jobs", "1"]
    assert main([*arguments, "--no-progress"]) == 0
    return folder / "work"


def test_build_writes_the_basis_and_its_report(run, basis):
    assert load_basis(run / "tiny.h5").linear.coefficients.tobytes() == basis.linear.coefficients.tobytes()
    page = (run / "tiny.html").read_text()
    assert page.count("<img ") == 5
    for expected in ("The nodes", "Decay of the errors", "above tolerance in every sweep", "fresh binaries", "misses"):
        assert expected in page


def test_build_says_what_it_did(run, folder, capsys):
    output = folder / "elsewhere" / "basis.h5"
    arguments = ["roq", "build", str(folder / "tiny.toml"), "--work", str(run), "--output", str(output)]
    assert main([*arguments, "--no-report"]) == 0
    printed = capsys.readouterr().out
    for expected in ("linear: ", "quadratic: ", "0 of 1000 fresh binaries above 1e-05", f"Basis: {output}"):
        assert expected in printed
    assert output.read_bytes() == (run / "tiny.h5").read_bytes()
    assert not output.with_suffix(".html").exists()


def test_show_describes_a_basis(run, capsys):
    assert main(["roq", "show", str(run / "tiny.h5")]) == 0
    assert "condition number" in capsys.readouterr().out


def test_validate_measures_it(run, capsys):
    assert main(["roq", "validate", str(run / "tiny.h5"), "--count", "10"]) == 0
    assert capsys.readouterr().out.count("outliers 0 ") == 2


def test_export_writes_the_layouts_of_others(run, folder, capsys):
    basis = str(run / "tiny.h5")
    assert main(["roq", "export", basis, "bilby", str(folder / "tiny.hdf5")]) == 0
    assert main(["roq", "export", basis, "bajes", str(folder / "bajes")]) == 0
    assert "Wrote" in capsys.readouterr().out
    nodes = load_basis(run / "tiny.h5").linear_nodes
    for read in (load_bilby(folder / "tiny.hdf5"), load_bajes(folder / "bajes")):
        assert read.linear_nodes.tolist() == nodes.tolist()


@pytest.mark.parametrize(
    ("table", "message"),
    [
        (changed(model__name="defualt"), "did you mean|Did you mean"),
        (changed(band__f_maxx=3.0), "did you mean 'f_max'"),
        (changed(prior__chi_1=[-0.9, 0.9]), "chi_1"),
    ],
)
def test_a_wrong_configuration_is_one_sentence(table, message, tmp_path, capsys):
    (tmp_path / "wrong.toml").write_text(toml(table))
    assert main(["roq", "build", str(tmp_path / "wrong.toml"), "--work", str(tmp_path), "--no-report"]) == 2
    printed = capsys.readouterr().err
    assert any(part in printed for part in message.split("|"))
    assert "Traceback" not in printed


def test_a_file_that_is_no_basis_is_one_sentence(tmp_path, capsys):
    (tmp_path / "x.h5").touch()
    assert main(["roq", "show", str(tmp_path / "x.h5")]) == 2
    assert "x.h5" in capsys.readouterr().err
