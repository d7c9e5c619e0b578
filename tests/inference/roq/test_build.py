"""Bases that meet their tolerance on binaries they never saw, whoever builds them."""

import dataclasses

import numpy as np
import pytest

from bnserve_inference.roq import (
    BasisMismatch,
    BasisUnwritable,
    ConstructionFailed,
    PriorNotCovered,
    build_basis,
    describe,
    validate_basis,
)
from bnserve_inference.roq._interpolant import evaluate_term
from bnserve_inference.roq._sampling import Prior
from bnserve_inference.roq._validation import full_grid_errors
from bnserve_protocol import OutOfDomain
from bnserve_surrogate import Model
from tests.inference.bases import linear_basis
from tests.inference.roq.tiny import tiny

TERMS = ("linear", "quadratic")


def build(configuration, model, directory, **options):
    quiet = {"progress": False, "say": lambda line: None, "n_jobs": 1}
    return build_basis(configuration, model, directory, **{**quiet, **options})


def arrays(basis):
    return [
        array
        for term in (basis.linear, basis.quadratic)
        for array in (term.nodes, term.binaries.values, term.coefficients)
    ]


def assert_same(first, second):
    for one, other in zip(arrays(first), arrays(second), strict=True):
        np.testing.assert_array_equal(one, other)
    assert first.diagnostics == second.diagnostics


@pytest.mark.parametrize("term", TERMS)
def test_fresh_binaries_meet_the_tolerance_on_the_full_grid(basis, model, term):
    tolerance = basis.diagnostics[term]["tolerance"]
    errors = full_grid_errors(basis, model, Prior(basis.prior).draw(100, 77), term)
    assert 0.0 < errors.max() < tolerance


@pytest.mark.parametrize("term", TERMS)
def test_errors_on_the_thinned_grid_are_those_on_the_full_grid(basis, term):
    assert basis.diagnostics["full_grid"][term] < 1e-3  # of the tolerance


@pytest.mark.parametrize("term", TERMS)
def test_the_corners_of_the_prior_meet_the_tolerance(basis, model, term):
    errors = full_grid_errors(basis, model, Prior(basis.prior).corners(), term)
    assert errors.max() < basis.diagnostics[term]["tolerance"]


@pytest.mark.parametrize("term", TERMS)
def test_the_nodes_are_unique_points_of_the_full_grid(basis, term):
    nodes = getattr(basis, f"{term}_nodes")
    assert set(nodes) <= set(basis.grid.frequencies())
    assert (np.diff(nodes) > 0.0).all()


def test_the_rows_are_one_at_their_node_and_zero_at_the_others(basis, model):
    at_nodes = np.searchsorted(basis.grid.frequencies(), basis.linear_nodes)
    np.testing.assert_allclose(linear_basis(basis, model)[:, at_nodes], np.eye(len(at_nodes)), atol=1e-8)


def test_chunks_cover_the_grid_once_and_in_order(basis, model, monkeypatch):
    monkeypatch.setattr("bnserve_inference.roq._interpolant.CHUNK", 100)
    pieces = list(basis.linear_chunks(model))
    assert len(pieces) == 14
    assert [place.start for place, _ in pieces] == list(range(0, len(basis.grid), 100))
    assert all(rows.shape == (len(basis.linear_nodes), place.stop - place.start) for place, rows in pieces)
    assert pieces[-1][0].stop == len(basis.grid)
    assert {rows.dtype for _, rows in pieces} == {np.dtype(np.complex128)}
    assert {rows.dtype for _, rows in basis.quadratic_chunks(model)} == {np.dtype(np.float64)}


def test_the_last_sweep_of_every_cycle_is_clean(built):
    for term, relative in ((term, relative) for term in TERMS for relative in (0, 1)):
        sweeps = built.growth[term].sweeps
        assert sweeps[sweeps[:, 0] == relative][-1, 2] == 0.0


def test_the_first_cycle_is_stricter_where_the_configuration_says_so(built):
    first = built.growth["linear"].sweeps[built.growth["linear"].sweeps[:, 0] == 0]
    assert first[-1, 3] <= 1e-6


def test_the_corner_basis_comes_first(built):
    ends = Prior(tiny().prior.ranges).ends().values
    np.testing.assert_array_equal(np.sort(built.growth["linear"].binaries[:2], axis=0), np.sort(ends, axis=0))


def test_the_pre_selection_stops_at_its_number_of_elements_or_its_tolerance(built):
    linear, quadratic = (built.growth[term].preselection_errors for term in TERMS)
    assert len(linear) == 8 - 2
    assert quadratic[-1] <= 1e-9 or len(quadratic) == 4 - 2
    assert (linear[0], linear[-1]) == (linear.max(), linear.min())


@pytest.mark.parametrize("options", [{"n_jobs": 1}, {"n_jobs": 3}], ids=["one worker", "three threads"])
def test_the_number_of_workers_does_not_matter(basis, model, tmp_path, options):
    assert_same(build(tiny(), model, tmp_path, **options).quadrature, basis)


@pytest.mark.slow
def test_processes_give_the_same(basis, model, tmp_path):
    built = build(tiny(), model, tmp_path, n_jobs=2, backend="loky", opener=Model.default)
    assert_same(built.quadrature, basis)


def test_another_seed_gives_another_basis_that_is_as_good(basis, model, tmp_path):
    other = build(tiny(seed=2), model, tmp_path).quadrature
    assert not np.array_equal(other.linear.binaries.values, basis.linear.binaries.values)
    assert validate_basis(other, model, 50)["linear"]["outliers"] == 0


def test_waveforms_as_elements_give_the_same_interpolant_with_a_worse_condition(basis, model, tmp_path):
    papers = build(tiny(elements="waveforms"), model, tmp_path).quadrature
    np.testing.assert_array_equal(papers.linear_nodes, basis.linear_nodes)
    np.testing.assert_allclose(linear_basis(papers, model), linear_basis(basis, model), atol=1e-6)
    assert papers.diagnostics["linear"]["condition_number"] > 30 * basis.diagnostics["linear"]["condition_number"]


def test_a_post_newtonian_alignment_is_kept_in_the_basis(model, tmp_path):
    other = build(tiny(band__alignment="post_newtonian"), model, tmp_path).quadrature
    assert other.alignment == "post_newtonian"
    assert validate_basis(other, model, 20)["linear"]["outliers"] == 0
    merger = dataclasses.replace(other, alignment="merger")
    assert full_grid_errors(merger, model, Prior(other.prior).draw(20, 1), "linear").max() > 1e-4


def test_outliers_may_be_allowed(model, tmp_path):
    strict_cycle = {"size": 600, "relative_tolerance": 0.01}
    allowing = build(tiny(cycles=[{**strict_cycle, "outliers": 50}]), model, tmp_path / "a")
    strict = build(tiny(cycles=[strict_cycle]), model, tmp_path / "b")
    assert 0 < allowing.growth["linear"].sweeps[-1, 2] <= 50
    assert len(allowing.growth["linear"]) < len(strict.growth["linear"])


def test_too_few_elements_are_an_error_that_says_so(model, tmp_path):
    with pytest.raises(ConstructionFailed, match=r"Raise \[linear\] most_elements"):
        build(tiny(linear__most_elements=9), model, tmp_path)


def test_a_tolerance_below_rounding_is_an_error_that_says_so(model, tmp_path):
    impossible = tiny(linear__tolerance=1e-32, linear__preselection__tolerance=1e-32)
    with pytest.raises(ConstructionFailed, match="larger"):
        build(impossible, model, tmp_path)


def test_a_prior_beyond_the_model_is_refused(model, tmp_path):
    with pytest.raises(OutOfDomain, match="lambda_1"):
        build(tiny(prior__lambda_1=[0.0, 9000.0]), model, tmp_path)


def test_a_directory_that_cannot_be_written_is_refused(model, tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(BasisUnwritable, match="choose another directory"):
        build(tiny(), model, tmp_path / "file")


def test_a_basis_serves_its_own_model_alone(basis):
    with pytest.raises(BasisMismatch, match="built for default"):
        next(basis.linear_chunks(Model.load("fast")))


def test_a_prior_beyond_the_basis_is_refused_by_name(basis):
    basis.check_prior({"chirp_mass": (1.185, 1.195), "distance": (1.0, 75.0)})
    with pytest.raises(PriorNotCovered, match=r"'chi_1' needs -0\.2 to 0\.1, the basis has -0\.05 to 0\.05"):
        basis.check_prior({"chi_1": (-0.2, 0.1), "chi_2": (0.0, 0.0)})


def test_validation_finds_a_basis_that_is_not_good_enough(basis, model):
    term = basis.linear
    fewer = slice(None, -6)
    elements = evaluate_term(model, term.nodes[fewer], term.binaries, "linear", "merger")[fewer]
    worse = dataclasses.replace(
        term,
        nodes=term.nodes[fewer],
        binaries=type(term.binaries)(term.binaries.values[fewer]),
        coefficients=np.linalg.inv(elements.T),
    )
    assert validate_basis(dataclasses.replace(basis, linear=worse), model, 20)["linear"]["outliers"] == 20


def test_a_description_names_what_matters(basis, model):
    text = describe(basis)
    version = f"default {model.description.version}"
    for expected in (
        version,
        "modes       (2, 2)",
        "60 to 400 Hz",
        f"{len(basis.linear_nodes)} elements",
        "chirp_mass 1.18 to 1.2",
    ):
        assert expected in text
    assert "0 of 1000 fresh binaries above 1e-05" in text
