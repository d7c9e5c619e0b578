"""What holds for every waveform model: the remote ones equal the local one in bits, types and errors."""

import functools

import numpy as np
import pytest

from bnserve_protocol import (
    PARAMETER_NAMES,
    BnserveError,
    EvaluationOptions,
    InvalidFrequencies,
    InvalidParameters,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    ParametersWithExtrinsic,
    RowStatus,
    UniformGrid,
    WaveformModel,
)

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")

SHORT = np.geomspace(20.0, 1500.0, 277)
GRIDS = {
    "explicit": SHORT,
    "uniform": UniformGrid(20.0, 532.0, 0.5),
    "uploaded": np.geomspace(6.0, 2000.0, 2000),
    "one frequency": np.array([100.0]),
    "below and above the band": np.geomspace(1.0, 6000.0, 300),
    "integers in a list": list(range(20, 120)),
}
METHODS = ("predict_batch", "predict_factored", "predict_amplitude_phase", "predict_modes")
ONE = ParametersWithExtrinsic.gw170817()
TYPICAL = {name: getattr(ONE, name) for name in PARAMETER_NAMES}
FLAG = EvaluationOptions(out_of_domain="flag")


def binaries(rows, seed=1):
    """Binaries in the trained box, as a batch."""
    random = np.random.default_rng(seed)
    low = [1.0, 5.0, 5.0, -0.5, -0.5, 20.0, 0.0, 2.0, -3.0, -0.01]
    high = [3.0, 5000.0, 5000.0, 0.5, 0.5, 400.0, np.pi, 4.0, 3.0, 0.01]
    return ParameterBatch(random.uniform(low, high, (rows, len(PARAMETER_NAMES))))


def with_values(rows, **values):
    """Typical binaries with these values in row 1 (of three or more)."""
    columns = {name: np.full(rows, value) for name, value in TYPICAL.items()}
    for name, value in values.items():
        columns[name][1] = value
    return columns


def bits(result):
    """Types, shapes and bytes of everything in a result."""
    arrays = [np.asarray(getattr(result, name)) for name in type(result).__slots__]
    return type(result), [(array.dtype, array.shape, array.tobytes()) for array in arrays]


def failure(call):
    """Everything a user can see of an error."""
    with pytest.raises(BnserveError) as raised:
        call()
    error = raised.value
    return type(error), error.code, error.detail, error.errors


def test_it_is_a_waveform_model(model):
    assert isinstance(model, WaveformModel)


def test_it_describes_itself_alike(model, local):
    assert model.description == local.description


@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
@pytest.mark.parametrize("rows", [1, 7, 64])
@pytest.mark.parametrize("method", METHODS)
def test_batches_are_equal_in_bits(model, local, method, rows, grid):
    assert bits(getattr(model, method)(grid, binaries(rows))) == bits(getattr(local, method)(grid, binaries(rows)))


@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
@pytest.mark.parametrize("method", ["predict", *METHODS])
def test_one_binary_is_equal_in_bits(model, local, method, grid):
    assert bits(getattr(model, method)(grid, ONE)) == bits(getattr(local, method)(grid, ONE))


@pytest.mark.parametrize("method", METHODS)
def test_an_empty_batch_has_no_rows(model, local, method):
    assert bits(getattr(model, method)(SHORT, [])) == bits(getattr(local, method)(SHORT, []))


def test_a_row_has_the_same_bits_alone_and_in_a_batch(model):
    batch = binaries(7)
    together = model.predict_batch(SHORT, batch).plus
    assert [model.predict(SHORT, batch.row(row)).plus.tobytes() for row in range(7)] == [h.tobytes() for h in together]


@pytest.mark.parametrize("method", ["predict_batch", "predict_factored", "predict_modes"])
def test_single_precision_is_equal_in_bits(model, local, method):
    batch = binaries(7)
    there = getattr(model, method)(SHORT, batch, dtype="complex64")
    assert bits(there) == bits(getattr(local, method)(SHORT, batch, dtype="complex64"))
    assert there[0].dtype == np.complex64


BATCHES = {
    "a list": [ONE, ParametersWithExtrinsic(**TYPICAL | {"mass_ratio": 2.0})],
    "vectors and numbers": TYPICAL | {"mass_ratio": [1.0, 1.5, 2.0]},
    "defaults left out": {
        name: value for name, value in TYPICAL.items() if name not in ("time_shift", "reference_phase")
    },
}


@pytest.mark.parametrize("batch", BATCHES.values(), ids=BATCHES)
def test_every_form_of_a_batch_is_accepted(model, local, batch):
    assert bits(model.predict_batch(SHORT, batch)) == bits(local.predict_batch(SHORT, batch))


@pytest.mark.parametrize("method", METHODS)
def test_alignment_at_the_merger_is_equal_in_bits(model, local, method):
    batch, options = binaries(3), EvaluationOptions(alignment="merger")
    there = bits(getattr(model, method)(SHORT, batch, options=options))
    assert there == bits(getattr(local, method)(SHORT, batch, options=options))
    assert there != bits(getattr(local, method)(SHORT, batch))


def test_the_one_mode_may_be_chosen(model, local):
    batch, chosen = binaries(3), EvaluationOptions(modes=[(2, 2)])
    assert bits(model.predict_batch(SHORT, batch, options=chosen)) == bits(local.predict_batch(SHORT, batch))
    there = model.predict_modes(SHORT, batch, options=chosen)
    assert there.modes == ((2, 2),)
    assert there.h.shape == (3, 1, len(SHORT))
    assert bits(there) == bits(local.predict_modes(SHORT, batch))


@pytest.mark.parametrize("method", ["predict", *METHODS])
def test_a_mode_that_is_not_there_is_the_same_error(model, local, method):
    options = EvaluationOptions(modes=[(2, 2), (5, 5)])
    there = failure(lambda: getattr(model, method)(SHORT, ONE, options=options))
    assert there == failure(lambda: getattr(local, method)(SHORT, ONE, options=options))
    assert there[2] == "This model has no mode (5, 5); it has (2, 2)."


@pytest.mark.parametrize("method", METHODS)
def test_flagged_rows_are_nan_with_a_reason(model, local, method):
    batch = with_values(64, mass_ratio=0.5)
    batch["chi_1"][40], batch["lambda_1"][50] = np.nan, 1e9
    there = getattr(model, method)(SHORT, batch, options=FLAG)
    assert bits(there) == bits(getattr(local, method)(SHORT, batch, options=FLAG))
    flagged = {1: RowStatus.OUT_OF_DOMAIN, 40: RowStatus.NOT_FINITE, 50: RowStatus.OUT_OF_DOMAIN}
    assert {row: RowStatus(status) for row, status in enumerate(there.status) if status} == flagged
    assert all(np.isnan(there[0][row]).all() for row in flagged)


PARTS = {
    "predict": ("plus", "cross"),
    "predict_batch": ("plus", "cross"),
    "predict_factored": ("h", "plus", "cross"),
    "predict_modes": ("h", "plus", "cross"),
    "predict_amplitude_phase": ("amplitude", "phase"),
}


@pytest.mark.parametrize("method", PARTS)
def test_results_are_used_like_tuples(model, method):
    """As those of mlgw_bns are: unpacked, indexed, sliced, counted."""
    answer = getattr(model, method)(SHORT, ONE)
    parts = [getattr(answer, name) for name in PARTS[method]]
    count = len(parts)
    assert len(answer) == count
    assert all(one is other for one, other in zip(answer, parts, strict=True))
    assert all(answer[place] is answer[place - count] is parts[place] for place in range(count))
    assert answer[1:] == tuple(parts[1:])
    assert [part is other for part, other in zip(reversed(answer), parts[::-1], strict=True)] == [True] * count
    with pytest.raises(IndexError):
        answer[count]
    with pytest.raises(TypeError):
        answer["plus"]


def test_results_can_be_written_to(model):
    answer = model.predict_factored(SHORT, binaries(2))
    answer.h[...] = 0.0
    assert not answer.h.any()


OUTSIDE = {
    "mass_ratio": 0.9,
    "lambda_1": -1.0,
    "lambda_2": 1e6,
    "chi_1": 2.0,
    "chi_2": -2.0,
    "total_mass": 101.0,
}
BAD_PARAMETERS = {
    "unknown": (TYPICAL | {"eccentricity": 0.1}, InvalidParameters, "Unknown parameter 'eccentricity'"),
    "misspelt": (TYPICAL | {"lamda_1": 1.0}, InvalidParameters, "Did you mean 'lambda_1'"),
    "missing": ({"mass_ratio": 1.0}, InvalidParameters, "Missing parameters"),
    "no number": (TYPICAL | {"chi_1": "fast"}, InvalidParameters, "chi_1"),
    "unequal lengths": (TYPICAL | {"chi_1": [0.0, 0.1], "chi_2": [0.0] * 3}, InvalidParameters, "same length"),
    "no batch": (3, InvalidParameters, "A batch is"),
    "a shift beyond double precision": (with_values(3, time_shift=1e15), InvalidParameters, "use smaller ones"),
    "no distance": (with_values(3, distance_mpc=0.0), InvalidParameters, "Row 1: distance_mpc"),
    "two kinds": (with_values(3, mass_ratio=0.5, chi_1=np.nan), InvalidParameters, "chi_1"),
    "many rows": (with_values(64, mass_ratio=0.5) | {"chi_1": np.full(64, 3.0)}, OutOfDomain, "65 values in all"),
    **{
        f"{value} as {name}": (with_values(3, **{name: value}), InvalidParameters, f"Row 1: {name} = {value} is not")
        for name in PARAMETER_NAMES
        for value in (np.nan, np.inf)
    },
    **{
        f"{name} outside": (with_values(3, **{name: value}), OutOfDomain, f"Row 1: {name} = {value} is outside")
        for name, value in OUTSIDE.items()
    },
}


@pytest.mark.parametrize(("batch", "kind", "says"), BAD_PARAMETERS.values(), ids=BAD_PARAMETERS)
def test_bad_parameters_are_the_same_error(model, local, batch, kind, says):
    there = failure(lambda: model.predict_batch(SHORT, batch))
    assert there == failure(lambda: local.predict_batch(SHORT, batch))
    assert there[0] is kind
    assert says in there[2]


def test_a_bad_row_far_down_is_the_same_error(model, local):
    batch = with_values(64, mass_ratio=1.0)
    batch["mass_ratio"][61] = 0.5
    there = failure(lambda: model.predict_batch(SHORT, batch))
    assert there == failure(lambda: local.predict_batch(SHORT, batch))
    assert there[3][0].row == 61


BAD_GRIDS = {
    "empty": [],
    "unsorted": [20.0, 40.0, 30.0],
    "repeated": [20.0, 30.0, 30.0],
    "negative": [-20.0, 30.0],
    "zero": [0.0, 30.0],
    "NaN": [20.0, np.nan],
    "infinite": [20.0, np.inf],
    "two-dimensional": [[20.0, 30.0]],
    "a number": 20.0,
    "no numbers": ["a", "b"],
}


@pytest.mark.parametrize("method", ["predict", *METHODS])
@pytest.mark.parametrize("grid", BAD_GRIDS.values(), ids=BAD_GRIDS)
def test_bad_frequencies_are_the_same_error(model, local, method, grid):
    there = failure(lambda: getattr(model, method)(grid, ONE))
    assert there == failure(lambda: getattr(local, method)(grid, ONE))
    assert there[0] is InvalidFrequencies


OUT_OF_BAND = {
    "all above the band, forbidden": ([9000.0, 9001.0], EvaluationOptions(above_band="error")),
    "some above, forbidden": ([100.0, 9000.0], EvaluationOptions(above_band="error")),
    "too low for a phase": ([1e-9, 100.0], EvaluationOptions()),
    "all below, forbidden": ([0.5, 0.6], EvaluationOptions(below_band="error")),
    "some below, forbidden": ([0.5, 100.0], EvaluationOptions(below_band="error")),
}


@pytest.mark.parametrize(("grid", "options"), OUT_OF_BAND.values(), ids=OUT_OF_BAND)
def test_frequencies_outside_the_band_are_the_same_error(model, local, grid, options):
    there = failure(lambda: model.predict_batch(grid, binaries(3), options=options))
    assert there == failure(lambda: local.predict_batch(grid, binaries(3), options=options))
    assert there[0] is OutOfBand


WIDE = np.array([0.5, 1.0, 3.0, 100.0, 2000.0, 2047.9, 2048.1, 2100.0, 9000.0])
HEAVY = TYPICAL | {"total_mass": [4.0, 3.9, 2.76]}
"""Their bands end at 2048, 2100.5 and 2968.1 Hz, and begin at 2.5, 2.56 and 3.6 Hz."""


def parts_of(answer):
    return [np.atleast_2d(part) for part in answer if part.ndim > 1]


@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
@pytest.mark.parametrize("method", ["predict_batch", "predict_factored"])
def test_what_stands_at_a_frequency_does_not_depend_on_the_others(model, method, dtype):
    """Zeros above the band, the continuation below it, however the grid is split."""
    call = functools.partial(getattr(model, method), batch=HEAVY, dtype=dtype)
    together, alone = parts_of(call(WIDE)), [parts_of(call([f])) for f in WIDE]
    for part, whole in enumerate(together):
        pieces = np.hstack([answer[part] for answer in alone])
        np.testing.assert_array_equal(pieces == 0.0, whole == 0.0)
        np.testing.assert_allclose(pieces, whole, rtol=1e-7)  # complex64 rounds
        assert (whole[0] == 0.0).tolist() == [f > 2048.0 for f in WIDE]
        assert (whole[1] == 0.0).tolist() == [f > 2100.0 + 0.5 for f in WIDE]
    answer = call([9000.0])
    assert answer.status.tolist() == [RowStatus.OK] * 3
    assert np.isfinite(answer.estimated_mismatch).all()
    assert not any(np.signbit(part.real).any() for part in parts_of(answer))


def test_amplitudes_above_the_band_are_zero_however_the_grid_is_split(model):
    together = model.predict_amplitude_phase(WIDE, HEAVY)
    for place, f in enumerate(WIDE):
        alone = model.predict_amplitude_phase([f], HEAVY)
        np.testing.assert_array_equal(alone.amplitude[:, 0], together.amplitude[:, place])
        np.testing.assert_allclose(alone.phase[:, 0], together.phase[:, place], rtol=1e-12)
    assert not model.predict_amplitude_phase([8000.0, 9000.0], ONE).amplitude.any()


@pytest.mark.parametrize(("option", "outside"), [("above_band", WIDE > 2048.0), ("below_band", WIDE < 2.5)])
def test_what_is_forbidden_of_a_grid_is_forbidden_of_its_parts(model, option, outside):
    heavy, options = TYPICAL | {"total_mass": 4.0}, EvaluationOptions(**{option: "error"})
    for f in WIDE[outside]:
        for grid in ([f], sorted([100.0, f])):
            with pytest.raises(OutOfBand):
                model.predict_batch(grid, heavy, options=options)
    assert model.predict_batch(WIDE[~outside], heavy, options=options).plus.shape == (1, (~outside).sum())


def test_squares_underflow_in_single_precision_as_the_pages_say(model):
    h = model.predict(np.arange(20.0, 2049.0), ONE, dtype="complex64").plus
    right = (np.abs(model.predict(np.arange(20.0, 2049.0), ONE).plus) ** 2).sum()
    assert right == pytest.approx(4.77e-44, rel=1e-3)
    assert (np.abs(h) ** 2).sum() < 0.7 * right
    assert (np.abs(h.astype(complex)) ** 2).sum() == pytest.approx(right, rel=1e-7)
    assert (np.abs(h * np.float32(1e22)) ** 2).sum(dtype=float) / 1e44 == pytest.approx(right, rel=1e-6)


def test_an_unknown_precision_is_the_same_error(model, local):
    there = failure(lambda: model.predict(SHORT, ONE, dtype="complex32"))
    assert there == failure(lambda: local.predict(SHORT, ONE, dtype="complex32"))


@pytest.mark.parametrize(
    "parameters", [[ONE, ONE], [], TYPICAL | {"chi_1": [0.0, 0.1]}], ids=["two", "none", "columns"]
)
def test_predict_of_other_than_one_binary_is_the_same_error(model, local, parameters):
    there = failure(lambda: model.predict(SHORT, parameters))
    assert there == failure(lambda: local.predict(SHORT, parameters))
    assert there[0] is InvalidParameters
    assert "predict_batch" in there[2]
