"""Files of a basis: ours, bilby's and bajes'; what is read is what was written, and damage is refused."""

import h5py
import numpy as np
import pytest

from bnserve_inference.roq import (
    BasisFileInvalid,
    BasisMismatch,
    BasisUnwritable,
    load_bajes,
    load_basis,
    load_bilby,
    save_bajes,
    save_basis,
    save_bilby,
    validate_basis,
)
from bnserve_surrogate import Model
from tests.inference.bases import linear_basis, quadratic_basis


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("formats")


@pytest.fixture(scope="module")
def compact(basis, folder):
    basis.save(folder / "basis.h5")
    return folder / "basis.h5"


@pytest.fixture(scope="module")
def bilby_file(basis, model, folder):
    save_bilby(folder / "basis.hdf5", basis, model)
    return folder / "basis.hdf5"


@pytest.fixture(scope="module")
def bajes_folder(basis, model, folder):
    save_bajes(folder / "bajes", basis, model)
    return folder / "bajes"


def test_the_compact_file_gives_the_basis_back(compact, basis, model):
    read = load_basis(compact)
    np.testing.assert_array_equal(linear_basis(read, model), linear_basis(basis, model))
    np.testing.assert_array_equal(quadratic_basis(read, model), quadratic_basis(basis, model))
    for name in ("f_min", "f_max", "duration", "alignment", "prior", "model_name", "model_digest", "diagnostics"):
        assert getattr(read, name) == getattr(basis, name)


def test_the_compact_file_is_small_and_the_same_every_time(compact, basis, tmp_path):
    assert compact.stat().st_size < 64_000
    save_basis(tmp_path / "again.h5", basis)
    assert (tmp_path / "again.h5").read_bytes() == compact.read_bytes()


def damage(path, change):
    with h5py.File(path, "r+") as file:
        change(file)


def without(name):
    return lambda file: file.__delitem__(name)


def replaced(name, array):
    def change(file):
        attributes = dict(file[name].attrs)
        del file[name]
        file[name] = array
        file[name].attrs.update(attributes)

    return change


@pytest.mark.parametrize(
    "change",
    [
        without("linear"),
        without("quadratic/nodes"),
        without("diagnostics"),
        lambda file: file.attrs.__delitem__("f_min"),
        lambda file: file.attrs.__setitem__("schema", "bnserve-roq-99"),
        lambda file: file.attrs.__setitem__("alignment", "peak"),
        lambda file: file.attrs.__setitem__("prior", "[1"),
        lambda file: file.attrs.__setitem__("prior", file.attrs["prior"][:-1] + ", " + file.attrs["prior"][1:]),
        lambda file: file["linear/nodes"].__setitem__(0, np.nan),
        lambda file: file["linear/nodes"].__setitem__(0, 1e9),
        lambda file: file["linear/coefficients"].__setitem__((0, 0), np.inf),
        lambda file: file["linear/binaries"].attrs.__setitem__("columns", ["a"] * 10),
        replaced("linear/coefficients", np.ones((2, 2), dtype=complex)),
        replaced("quadratic/coefficients", np.array([["x"]], dtype="S1")),
        replaced("linear/nodes", np.arange(3)),
    ],
)
def test_a_damaged_compact_file_is_refused(compact, tmp_path, change):
    path = tmp_path / "damaged.h5"
    path.write_bytes(compact.read_bytes())
    damage(path, change)
    with pytest.raises(BasisFileInvalid, match=r"damaged\.h5"):
        load_basis(path)


@pytest.mark.parametrize("content", [b"", b"not hdf5 at all"])
def test_what_is_no_hdf5_file_is_refused(tmp_path, content):
    (tmp_path / "x.h5").write_bytes(content)
    for load in (load_basis, load_bilby):
        with pytest.raises(BasisFileInvalid, match=r"x\.h5"):
            load(tmp_path / "x.h5")


def test_a_truncated_compact_file_is_refused(compact, tmp_path):
    (tmp_path / "x.h5").write_bytes(compact.read_bytes()[:-2000])
    with pytest.raises(BasisFileInvalid):
        load_basis(tmp_path / "x.h5")


def test_a_missing_file_is_named(tmp_path):
    for load in (load_basis, load_bilby, load_bajes):
        with pytest.raises(BasisFileInvalid, match="nowhere"):
            load(tmp_path / "nowhere.hdf5")


def test_no_room_is_an_error_that_says_so(basis, tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(BasisUnwritable, match="Make room"):
        basis.save(tmp_path / "file" / "basis.h5")


def test_bilbys_layout(bilby_file, basis, model):
    """The names that bilby 2.8 looks up."""
    with h5py.File(bilby_file) as file:
        assert [file[name][()] for name in ("minimum_frequency_hz", "maximum_frequency_hz", "duration_s")] == [
            60,
            400,
            4,
        ]
        np.testing.assert_array_equal(file["basis_linear/0/basis"][()], linear_basis(basis, model))
        np.testing.assert_array_equal(file["basis_quadratic/0/basis"][()], quadratic_basis(basis, model))
        np.testing.assert_array_equal(file["basis_linear/0/frequency_nodes"][()], basis.linear_nodes)
        np.testing.assert_array_equal(file["basis_quadratic/0/frequency_nodes"][()], basis.quadratic_nodes)
        for term in ("linear", "quadratic"):
            np.testing.assert_array_equal(file[f"prior_range_{term}/chirp_mass"][()], [[1.18, 1.2]])
            np.testing.assert_array_equal(file[f"prior_range_{term}/mass_ratio"][()], [[1 / 1.3, 1.0]])


def test_bajes_layout(bajes_folder, basis, model):
    """As ``Initialise_pyROQ_Jena_for_inference`` of bajes 1.3 reads it."""
    data = bajes_folder / "ROQ_data"
    metadata = np.genfromtxt(data / "ROQ_metadata.txt", names=True)
    assert (metadata["fmin"], metadata["fmax"], metadata["seglen"]) == (60.0, 400.0, 4.0)
    np.testing.assert_array_equal(np.load(data / "full_frequencies.npy"), basis.grid.frequencies())
    for term, rows in (("linear", linear_basis), ("quadratic", quadratic_basis)):
        nodes = np.load(data / term / f"empirical_frequencies_{term}.npy")
        interpolant = np.load(data / term / f"basis_interpolant_{term}.npy")
        places = np.load(data / term / f"empirical_nodes_{term}.npy")
        np.testing.assert_array_equal(nodes, getattr(basis, f"{term}_nodes"))
        np.testing.assert_array_equal(basis.grid.frequencies()[places], nodes)
        np.testing.assert_array_equal(interpolant, rows(basis, model).T)


@pytest.mark.parametrize("layout", ["bilby", "bajes"])
def test_tabulated_bases_give_the_same_rows_without_a_model(layout, bilby_file, bajes_folder, basis, model):
    read = load_bilby(bilby_file) if layout == "bilby" else load_bajes(bajes_folder)
    np.testing.assert_array_equal(linear_basis(read), linear_basis(basis, model))
    np.testing.assert_array_equal(quadratic_basis(read), quadratic_basis(basis, model))
    assert (read.f_min, read.f_max, read.duration) == (basis.f_min, basis.f_max, basis.duration)


def test_bilbys_layout_gives_the_prior_and_the_model_back(bilby_file, basis):
    read = load_bilby(bilby_file)
    assert set(read.prior) == set(basis.prior)
    for name, pair in read.prior.items():
        assert pair == pytest.approx(basis.prior[name])
    assert (read.model_name, read.model_digest, read.alignment) == (basis.model_name, basis.model_digest, "merger")
    with pytest.raises(BasisMismatch):
        next(read.linear_chunks(Model.load("fast")))


def test_nodes_in_any_order_are_put_in_order(bilby_file, basis, model, tmp_path):
    path = tmp_path / "shuffled.hdf5"
    path.write_bytes(bilby_file.read_bytes())
    order = np.random.default_rng(1).permutation(len(basis.linear_nodes))
    with h5py.File(path, "r+") as file:
        for name in ("basis", "frequency_nodes"):
            dataset = file[f"basis_linear/0/{name}"]
            dataset[...] = dataset[()][order]
    read = load_bilby(path)
    np.testing.assert_array_equal(read.linear_nodes, basis.linear_nodes)
    np.testing.assert_array_equal(linear_basis(read), linear_basis(basis, model))


@pytest.mark.parametrize(
    "change",
    [
        without("basis_quadratic"),
        without("duration_s"),
        without("basis_linear/0/frequency_nodes"),
        replaced("basis_linear/0/basis", np.ones((3, 3), dtype=complex)),
        replaced("basis_linear/0/frequency_nodes", np.ones(3)),
        lambda file: file["basis_linear/0/frequency_nodes"].__setitem__(0, 7.0),
        lambda file: file.copy("basis_linear/0", "basis_linear/1"),
    ],
)
def test_a_damaged_file_in_bilbys_layout_is_refused(bilby_file, tmp_path, change):
    path = tmp_path / "damaged.hdf5"
    path.write_bytes(bilby_file.read_bytes())
    damage(path, change)
    with pytest.raises(BasisFileInvalid):
        load_bilby(path)


def test_a_name_that_bilby_would_refuse_is_refused(basis, model, tmp_path):
    with pytest.raises(BasisFileInvalid, match=r"\*\.hdf5"):
        save_bilby(tmp_path / "basis.h5", basis, model)


def test_a_damaged_folder_in_bajes_layout_is_refused(bajes_folder, tmp_path):
    data = tmp_path / "ROQ_data"
    data.mkdir()
    (data / "ROQ_metadata.txt").write_text("fmin fmax seglen\n60 400 4\n")
    with pytest.raises(BasisFileInvalid, match="empirical_frequencies"):
        load_bajes(tmp_path)


def test_a_tabulated_basis_has_no_compact_form(bilby_file, tmp_path):
    with pytest.raises(BasisFileInvalid, match="keep that file"):
        save_basis(tmp_path / "x.h5", load_bilby(bilby_file))


def test_a_tabulated_basis_can_be_converted(bilby_file, basis, model, tmp_path):
    save_bajes(tmp_path, load_bilby(bilby_file))
    np.testing.assert_array_equal(linear_basis(load_bajes(tmp_path)), linear_basis(basis, model))


def test_only_a_basis_that_knows_its_prior_can_be_validated(bajes_folder, model):
    with pytest.raises(BasisFileInvalid, match="what prior"):
        validate_basis(load_bajes(bajes_folder), model, 1)


def test_nothing_half_written_is_left(basis, model, tmp_path, monkeypatch):
    def broken(self, *arguments):
        yield slice(0, 10), np.ones((len(self.nodes), 10), dtype=complex)
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(type(basis.linear), "chunks", broken)
    with pytest.raises(BasisUnwritable, match="No space left"):
        save_bilby(tmp_path / "basis.hdf5", basis, model)
    assert list(tmp_path.iterdir()) == []
