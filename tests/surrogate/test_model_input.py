"""What the local model says to input that it cannot use: which row, which parameter, and what to do."""

import dataclasses
import math

import numpy as np
import pytest

from bnserve_protocol import (
    PARAMETER_NAMES,
    InvalidFrequencies,
    InvalidParameters,
    InvalidRequest,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    ParametersWithExtrinsic,
    RowStatus,
    UniformGrid,
)
from bnserve_surrogate import EvaluationOptions
from tests.surrogate.conftest import random_batch

GRID = np.geomspace(10.0, 1500.0, 40)
ONE = ParametersWithExtrinsic.gw170817()
TYPICAL = dataclasses.asdict(ONE)
FLAG = EvaluationOptions(out_of_domain="flag")
METHODS = ("predict_batch", "predict_factored", "predict_amplitude_phase")


def batch_with(row, **values):
    """Four good binaries, one of them changed."""
    columns = {name: np.full(4, value) for name, value in TYPICAL.items()}
    for name, value in values.items():
        columns[name][row] = value
    return columns


def refused(kind, call):
    with pytest.raises(InvalidRequest) as raised:
        call()
    assert type(raised.value) is kind
    return raised.value


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", PARAMETER_NAMES)
@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_value_that_is_not_finite_is_named(model, method, name, value):
    error = refused(InvalidParameters, lambda: getattr(model, method)(GRID, batch_with(2, **{name: value})))
    assert error.detail == f"Row 2: {name} = {value} is not finite."
    assert [(problem.row, problem.parameter, problem.value) for problem in error.errors] == [(2, name, str(value))]


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("mass_ratio", 0.5, "[1, 3]"),
        ("mass_ratio", 3.01, "[1, 3]"),
        ("chi_1", 0.51, "[-0.5, 0.5]"),
        ("chi_2", -0.9, "[-0.5, 0.5]"),
        ("lambda_1", 0.0, "[5, 5000]"),
        ("lambda_2", 5001.0, "[5, 5000]"),
        ("total_mass", 0.19, "[0.2, 100]"),
        ("total_mass", 101.0, "[0.2, 100]"),
    ],
)
def test_a_value_outside_its_range_is_named_with_the_range(model, name, value, allowed):
    error = refused(OutOfDomain, lambda: model.predict_batch(GRID, batch_with(1, **{name: value})))
    assert f"Row 1: {name} = {value} is outside the trained range; it is outside {allowed}" in error.detail
    assert 'out_of_domain="flag"' in error.detail
    assert [(p.row, p.parameter, p.value) for p in error.errors] == [(1, name, value)]


def test_the_ends_of_the_ranges_are_inside(model):
    for name in ("mass_ratio", "chi_1", "lambda_2", "total_mass"):
        entry = next(entry for entry in model.description.parameters if entry.name == name)
        for value in (entry.minimum, entry.maximum):
            assert np.isfinite(model.predict_batch(GRID, batch_with(0, **{name: value})).plus).all()


@pytest.mark.parametrize("value", [0.0, -40.0])
def test_a_distance_is_positive(model, value):
    error = refused(InvalidParameters, lambda: model.predict_batch(GRID, batch_with(3, distance_mpc=value)))
    assert f"Row 3: distance_mpc = {value} Mpc must be positive" in error.detail
    assert error.errors[0].parameter == "distance_mpc"


@pytest.mark.parametrize("shift", [{"time_shift": 1e12}, {"reference_phase": -1e300}, {"time_shift": 1e306}], ids=str)
def test_shifts_that_leave_no_digit_of_the_phase_are_refused(model, shift):
    error = refused(InvalidParameters, lambda: model.predict_batch(GRID, batch_with(1, **shift)))
    assert "Row 1" in error.detail
    assert "use smaller ones" in error.detail
    assert {problem.parameter for problem in error.errors} == {"reference_phase", "time_shift"}
    assert model.predict_batch(GRID, batch_with(1, **shift), options=FLAG).status.tolist() == [0, 2, 0, 0]


def test_a_gps_time_as_a_time_shift_is_fine(model):
    shifted = dataclasses.replace(ONE, time_shift=1.187e9)
    np.testing.assert_allclose(np.abs(model.predict(GRID, shifted).plus), np.abs(model.predict(GRID, ONE).plus))


def test_many_problems_are_counted_and_the_first_listed(model):
    columns = {name: np.full(50, value) for name, value in TYPICAL.items()} | {"chi_1": np.full(50, 0.9)}
    error = refused(OutOfDomain, lambda: model.predict_batch(GRID, columns))
    assert "(50 values in all)" in error.detail
    assert [problem.row for problem in error.errors] == list(range(20))


def test_misspelt_missing_and_unequal_parameters(model):
    assert "Did you mean 'lambda_1'" in refused(
        InvalidParameters, lambda: model.predict_batch(GRID, TYPICAL | {"lamda_1": 1.0})
    ).detail  # fmt: skip
    assert "Missing" in refused(InvalidParameters, lambda: model.predict_batch(GRID, {"chi_1": 0.0})).detail
    unequal = TYPICAL | {"chi_1": [0.0] * 2, "chi_2": [0.0] * 3}
    assert "same length" in refused(InvalidParameters, lambda: model.predict_batch(GRID, unequal)).detail


@pytest.mark.parametrize("method", METHODS)
def test_flagged_rows_are_nan_with_their_status_and_the_others_untouched(model, method):
    columns = {name: np.full(6, value) for name, value in TYPICAL.items()}
    columns["chi_1"][1], columns["mass_ratio"][3], columns["distance_mpc"][4] = math.nan, 0.5, -1.0
    answer = getattr(model, method)(GRID, columns, options=FLAG)
    expected = [RowStatus.OK, RowStatus.NOT_FINITE, RowStatus.OK, *[RowStatus.OUT_OF_DOMAIN] * 2, RowStatus.OK]
    assert answer.status.tolist() == expected
    assert answer.status.dtype == np.uint8
    good = answer.status == RowStatus.OK
    alone = getattr(model, method)(GRID, ONE)
    for name in set(type(answer).__slots__) - {"status", "estimated_mismatch"}:
        array = getattr(answer, name)
        assert np.isnan(array[~good]).all()
        np.testing.assert_array_equal(array[good], np.broadcast_to(getattr(alone, name), array[good].shape))


def test_a_row_that_is_not_finite_and_out_of_band_is_not_finite(model):
    columns = batch_with(0, total_mass=math.nan)
    options = EvaluationOptions(out_of_domain="flag", above_band="error")
    answer = model.predict_batch([7000.0], columns, options=options)
    assert answer.status.tolist() == [RowStatus.NOT_FINITE, *[RowStatus.OUT_OF_BAND] * 3]


@pytest.mark.parametrize(
    ("grid", "says"),
    [
        ([], "empty"),
        ([30.0, 20.0], "number 1 (20.0 Hz) is out of order; sort"),
        ([20.0, 20.0], "repeated"),
        ([-1.0, 20.0], "not positive"),
        ([0.0, 20.0], "leave out the zero-frequency bin"),
        ([20.0, math.nan], "number 1 (nan Hz) is not finite"),
        ([[20.0]], "shape (1, 1)"),
        ("20 Hz", "vector of numbers"),
    ],
    ids=str,
)
@pytest.mark.parametrize("method", ["predict", *METHODS])
def test_bad_frequencies_are_named(model, method, grid, says):
    assert says in refused(InvalidFrequencies, lambda: getattr(model, method)(grid, ONE)).detail


BANDS = {
    "all above": ([7000.0, 8000.0], EvaluationOptions(above_band="error")),
    "some above": ([100.0, 7000.0], EvaluationOptions(above_band="error")),
    "some below": ([1.0, 100.0], EvaluationOptions(below_band="error")),
    "nothing of the phase left": ([1e-9, 100.0], EvaluationOptions()),
}


@pytest.mark.parametrize(("grid", "options"), BANDS.values(), ids=list(BANDS))
def test_frequencies_outside_the_band_are_refused_where_that_was_asked_for(model, grid, options):
    error = refused(OutOfBand, lambda: model.predict_batch(grid, batch_with(0), options=options))
    assert "Row 0" in error.detail
    assert "do not fit the model's band at total mass 2.76 Msun, 3.62319 to 2968.12 Hz" in error.detail
    assert (error.errors[0].row, error.errors[0].parameter) == (0, "frequencies")
    flagged = EvaluationOptions(out_of_domain="flag", below_band=options.below_band, above_band=options.above_band)
    assert model.predict_batch(grid, batch_with(0), options=flagged).status.tolist() == [RowStatus.OUT_OF_BAND] * 4


def test_the_band_of_every_row_is_its_own(model):
    """At 2 solar masses the band ends at 4096 Hz, at 4 at 2048 Hz, at 100 at 82 Hz: M f decides."""
    options = EvaluationOptions(out_of_domain="flag", above_band="error")
    status = model.predict_batch(
        [100.0, 3000.0], TYPICAL | {"total_mass": [2.0, 2.7, 3.0, 4.0, 0.2, 100.0]}, options=options
    ).status
    assert status.tolist() == [0, 0, RowStatus.OUT_OF_BAND, RowStatus.OUT_OF_BAND, 0, RowStatus.OUT_OF_BAND]
    options = EvaluationOptions(out_of_domain="flag", below_band="error")
    status = model.predict_batch([4.0, 80.0], TYPICAL | {"total_mass": [2.0, 2.6, 0.2, 100.0]}, options=options).status
    assert status.tolist() == [RowStatus.OUT_OF_BAND, 0, RowStatus.OUT_OF_BAND, 0]


def test_by_default_a_grid_may_leave_the_band_on_both_sides(model):
    plus = model.predict([0.5, 100.0, 7000.0], ONE).plus
    assert (plus != 0.0).tolist() == [True, True, False]


@pytest.mark.parametrize(
    "dtype", ["complex32", "float64", float, np.float32, None, "", 7, ["complex64"], np.dtype("V16")]
)
def test_an_unknown_precision_is_refused(model, dtype):
    error = refused(InvalidRequest, lambda: model.predict_batch(GRID, ONE, dtype=dtype))
    assert "dtype must be one of complex128, complex64" in error.detail


@pytest.mark.parametrize("name", ["out_of_domain", "below_band", "above_band", "alignment"])
def test_an_unknown_option_is_refused(name):
    error = refused(InvalidRequest, lambda: EvaluationOptions(**{name: "maybe"}))
    assert error.detail.startswith(f"{name} must be one of ")


def test_one_binary_means_one(model):
    assert "predict_batch" in refused(InvalidParameters, lambda: model.predict(GRID, [ONE, ONE])).detail
    assert "got 0" in refused(InvalidParameters, lambda: model.predict(GRID, [])).detail
    refused(InvalidParameters, lambda: model.predict(GRID, "GW170817"))


@pytest.mark.parametrize("frequency", [0.0, -5.0, math.nan, math.inf])
def test_the_time_until_merger_needs_a_frequency(model, frequency):
    refused(InvalidFrequencies, lambda: model.time_until_merger(frequency, ONE))


def test_shapes_of_one_and_of_many(model):
    one, many = model.predict(GRID, ONE), model.predict_batch(GRID, [ONE])
    assert one.plus.shape == one.cross.shape == (40,)
    assert many.plus.shape == many.cross.shape == (1, 40)
    assert one.status.shape == many.status.shape == (1,)
    np.testing.assert_array_equal(one.plus, many.plus[0])
    assert model.predict_amplitude_phase(GRID, ONE).phase.shape == (40,)
    assert model.predict_amplitude_phase(GRID, [ONE]).phase.shape == (1, 40)
    factored = model.predict_factored(GRID, ParameterBatch(random_batch(3)))
    assert (factored.h.shape, factored.plus.shape, factored.cross.shape) == ((3, 40), (3,), (3,))
    assert model.predict_batch(GRID, []).plus.shape == (0, 40)
    assert model.predict(UniformGrid(20.0, 21.0, 0.5), ONE).plus.shape == (3,)
    hp, hc = one
    assert hp is one.plus
    assert hc is one.cross
