"""A batch of binaries: every accepted form, and what is said about the others."""

import dataclasses
import pickle

import numpy as np
import pytest

from bnserve_protocol import (
    IN_PLANE_NAMES,
    INTRINSIC_NAMES,
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    InvalidParameters,
    LikelihoodParameters,
    ParameterBatch,
    ParametersWithExtrinsic,
    UniformGrid,
)

ONE = ParametersWithExtrinsic.gw170817()
TYPICAL = {name: value for name, value in dataclasses.asdict(ONE).items() if name in PARAMETER_NAMES}


def refused(batch):
    with pytest.raises(InvalidParameters) as raised:
        ParameterBatch.coerce(batch)
    return raised.value


def test_names_and_defaults():
    assert set(INTRINSIC_NAMES) < set(PARAMETER_NAMES)
    assert not set(IN_PLANE_NAMES) & set(PARAMETER_NAMES)
    assert dict.fromkeys(("reference_phase", "time_shift", *IN_PLANE_NAMES), 0.0) == PARAMETER_DEFAULTS


def test_a_binary_is_immutable():
    with pytest.raises(dataclasses.FrozenInstanceError):
        ONE.mass_ratio = 2.0


def test_one_binary_is_a_batch_of_one_and_comes_back():
    batch = ParameterBatch.coerce(ONE)
    assert len(batch) == 1
    assert batch.row(0) == ONE


def test_a_list_a_mapping_and_a_batch_are_the_same():
    other = dataclasses.replace(ONE, chi_1=0.3)
    listed = ParameterBatch.coerce([ONE, other])
    mapped = ParameterBatch.coerce(TYPICAL | {"chi_1": [ONE.chi_1, 0.3]})
    np.testing.assert_array_equal(listed.values, mapped.values)
    assert ParameterBatch.coerce(listed) is listed
    assert listed.row(1) == other


def test_a_scalar_counts_for_all_rows_and_defaults_fill_in():
    required = {name: value for name, value in TYPICAL.items() if name not in PARAMETER_DEFAULTS}
    batch = ParameterBatch.coerce(required | {"chi_1": np.array([0.1, 0.2, 0.3]), "chi_2": (0, 0, 0)})
    assert batch.values.shape == (3, len(PARAMETER_NAMES))
    np.testing.assert_array_equal(batch["mass_ratio"], [1.2] * 3)
    np.testing.assert_array_equal(batch["chi_1"], [0.1, 0.2, 0.3])
    np.testing.assert_array_equal(batch["time_shift"], 0.0)


IN_PLANE = {"chi_1x": 0.1, "chi_1y": -0.2, "chi_2x": 0.3, "chi_2y": 0.0}


def test_spins_in_the_orbital_plane_stand_beside_the_ten_columns():
    precessing = dataclasses.replace(ONE, **IN_PLANE)
    table = ParameterBatch(ParameterBatch.one(ONE).values, [list(IN_PLANE.values())])
    for form in (precessing, [precessing], TYPICAL | IN_PLANE, table):
        batch = ParameterBatch.coerce(form)
        assert batch.values.shape == (1, 10)
        np.testing.assert_array_equal(batch.in_plane, [list(IN_PLANE.values())])
        np.testing.assert_array_equal(batch["chi_1y"], [-0.2])
        assert batch.row(0) == precessing


@pytest.mark.parametrize("form", [ONE, [ONE], TYPICAL, TYPICAL | dict.fromkeys(IN_PLANE, 0.0)])
def test_where_no_spin_is_in_the_orbital_plane_there_are_no_columns_for_them(form):
    batch = ParameterBatch.coerce(form)
    assert batch.in_plane is None
    np.testing.assert_array_equal(batch["chi_2x"], [0.0])


def test_one_that_precesses_among_others_is_a_row_of_its_own():
    batch = ParameterBatch.coerce([ONE, dataclasses.replace(ONE, chi_2x=0.1), ONE])
    first, second = batch.split(2)
    assert first.in_plane.tolist() == [[0.0] * 4, [0.0, 0.0, 0.1, 0.0]]
    assert second.in_plane is None
    again = ParameterBatch.joined([first, second])
    np.testing.assert_array_equal(again.in_plane, batch.in_plane)
    np.testing.assert_array_equal(again.values, batch.values)
    assert ParameterBatch.joined([second, second]).in_plane is None


def test_a_spin_that_is_no_number_counts_as_one_in_the_plane():
    assert ParameterBatch.coerce(TYPICAL | {"chi_1x": np.nan}).in_plane is not None


def test_as_many_rows_of_spins_as_of_binaries():
    with pytest.raises(InvalidParameters, match="as many rows"):
        ParameterBatch(np.zeros((2, 10)), np.ones((3, 4)))


def test_scalars_alone_are_one_row():
    assert len(ParameterBatch.coerce(TYPICAL)) == 1


@pytest.mark.parametrize("empty", [[], TYPICAL | {"chi_1": []}], ids=["a list", "a vector"])
def test_an_empty_batch_has_no_rows(empty):
    assert ParameterBatch.coerce(empty).values.shape == (0, 10)


def test_pieces_cover_the_batch_in_order():
    batch = ParameterBatch(np.arange(70.0).reshape(7, 10))
    pieces = batch.split(3)
    assert [len(piece) for piece in pieces] == [3, 3, 1]
    np.testing.assert_array_equal(np.vstack([piece.values for piece in pieces]), batch.values)


@pytest.mark.parametrize(
    ("misspelt", "meant"),
    [("lamda_1", "lambda_1"), ("mass-ratio", "mass_ratio"), ("distance", "distance_mpc"), ("chi1", "chi_1")],
)
def test_a_misspelt_name_suggests_the_nearest(misspelt, meant):
    error = refused(TYPICAL | {misspelt: 1.0})
    assert f"Unknown parameter '{misspelt}'. Did you mean '{meant}'?" in error.detail
    assert [(problem.parameter, problem.row) for problem in error.errors] == [(misspelt, None)]


@pytest.mark.parametrize(
    ("made", "given", "meant"),
    [
        (ParametersWithExtrinsic, TYPICAL | {"lamda_1": 1.0}, "lambda_1"),
        (LikelihoodParameters, {"mass_ration": 1.0}, "mass_ratio"),
        (UniformGrid, {"f_min": 20.0, "f_max": 21.0, "deltaf": 1.0}, "delta_f"),
    ],
)
def test_a_misspelt_keyword_suggests_the_nearest(made, given, meant):
    with pytest.raises(InvalidParameters, match=f"{made.__name__} takes no '.*'. Did you mean '{meant}'?") as caught:
        made(**given)
    assert isinstance(caught.value, TypeError)
    assert type(pickle.loads(pickle.dumps(caught.value))) is type(caught.value)


def test_a_missing_keyword_is_pythons_own_error():
    with pytest.raises(TypeError, match=r"missing 7 required positional arguments: 'lambda_1'") as caught:
        ParametersWithExtrinsic(1.0)
    assert not isinstance(caught.value, InvalidParameters)


def test_a_name_like_no_other_lists_those_that_exist():
    assert all(name in refused(TYPICAL | {"xyz": 1.0}).detail for name in PARAMETER_NAMES)


def test_a_name_that_is_no_text_or_endless_is_refused_and_shortened():
    assert "'7'" in refused(TYPICAL | {7: 1.0}).detail
    assert len(refused(TYPICAL | {"x" * 10_000: 1.0}).detail) < 500


def test_missing_names_are_all_listed():
    error = refused({"mass_ratio": 1.0, "lambda_1": 1.0, "lambda_2": 2.0, "chi_1": 0.0, "chi_2": 0.0})
    assert error.detail == "Missing parameters: distance_mpc, inclination, total_mass."
    assert [problem.parameter for problem in error.errors] == ["distance_mpc", "inclination", "total_mass"]


def test_unequal_lengths_are_refused_with_the_lengths():
    detail = refused(TYPICAL | {"chi_1": [0.0, 0.1], "chi_2": [0.0] * 3}).detail
    assert "chi_1: 2" in detail
    assert "chi_2: 3" in detail


@pytest.mark.parametrize("value", ["fast", [0.1, "fast"], [[0.1], [0.2, 0.3]], {}, 1j], ids=str)
def test_what_is_no_number_is_named(value):
    error = refused(TYPICAL | {"chi_1": value})
    assert "'chi_1' must be a number or a vector" in error.detail
    assert error.errors[0].parameter == "chi_1"


def test_a_matrix_is_no_vector():
    assert "shape (2, 1)" in refused(TYPICAL | {"chi_1": [[0.1], [0.2]]}).detail


@pytest.mark.parametrize(
    "batch", [3, None, "binaries", [1, 2], np.zeros((2, 10)), [ONE, TYPICAL]], ids=lambda b: str(type(b))
)
def test_anything_else_is_no_batch(batch):
    assert "A batch is" in refused(batch).detail


@pytest.mark.parametrize("values", [np.zeros(10), np.zeros((2, 9)), np.zeros((1, 2, 10)), 0.0])
def test_an_array_of_another_shape_is_refused(values):
    with pytest.raises(InvalidParameters, match=r"shape \(N, 10\)"):
        ParameterBatch(values)


@pytest.mark.parametrize("values", [[["a"] * 10], [[0.0] * 10, [0.0]]])
def test_an_array_that_is_no_array_of_numbers_is_refused(values):
    with pytest.raises(InvalidParameters, match="must be a number or a vector of numbers"):
        ParameterBatch(values)


def test_one_binary_is_one_row_in_any_form():
    for form in (ONE, [ONE], TYPICAL, ParameterBatch.coerce(ONE)):
        assert ParameterBatch.one(form).row(0) == ONE
    for form in ([], [ONE, ONE], TYPICAL | {"chi_1": [0.0, 0.1]}):
        with pytest.raises(InvalidParameters, match=r"predict takes one binary; got [02]\. Use predict_batch"):
            ParameterBatch.one(form)
