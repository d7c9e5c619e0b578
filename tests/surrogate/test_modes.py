"""Seven modes in one kernel against their definition, and against each other."""

import numpy as np
import pytest
from scipy.special import factorial

from bnserve_protocol import (
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    InvalidParameters,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    RowStatus,
)
from bnserve_surrogate import Model
from bnserve_surrogate._artifact import MODES
from bnserve_surrogate.kernel._layout import DENSE, STREAMED
from tests.surrogate.conftest import random_batch
from tests.surrogate.mode_reference import Reference
from tests.surrogate.seven_modes import chosen, seven_mode_metadata, seven_mode_model, seven_mode_tensors

ALL = tuple(MODES.values())
FLAG = EvaluationOptions(out_of_domain="flag")
BAND = np.geomspace(15.0, 2048.0, 300)


@pytest.fixture(scope="module")
def metadata():
    return seven_mode_metadata()


@pytest.fixture(scope="module")
def tensors():
    return seven_mode_tensors()


@pytest.fixture(scope="module")
def model(metadata, tensors):
    return seven_mode_model(metadata, tensors)


@pytest.fixture(scope="module")
def reference(metadata, tensors):
    return Reference(metadata, tensors)


def test_a_model_has_all_its_modes_unless_some_are_chosen(model):
    assert model.predict_modes(BAND, ParameterBatch(random_batch(2))).modes == ALL
    some = model.predict_modes(BAND, ParameterBatch(random_batch(2)), options=chosen((3, 3), (2, 2)))
    assert some.modes == ((3, 3), (2, 2))
    assert some.h.shape == (2, 2, 300)


GRIDS = {
    "one frequency": np.array([100.0]),
    "few frequencies": np.geomspace(15.0, 2048.0, 300),
    "a dense grid": np.linspace(15.0, 2048.0, 6001),
}
ACCURACY = {"one frequency": 1e-11, "few frequencies": 1e-9, "a dense grid": 1e-6}
"""Of the largest value. Phases of 1e5 radians are rounded; on a dense grid they come from polynomials, to 5e-7 rad."""


@pytest.mark.parametrize("alignment", ["post_newtonian", "merger"])
@pytest.mark.parametrize("grid", GRIDS)
def test_every_mode_is_its_definition(model, reference, grid, alignment):
    values, f = random_batch(5, seed=1), GRIDS[grid]
    modes = model.predict_modes(f, ParameterBatch(values), options=EvaluationOptions(alignment=alignment))
    # The (2, 2) at 2 f is there for (2, 1) up to half of the band's end.
    for k, mode in enumerate(modes.modes):
        for i, row in enumerate(values):
            expected = reference.mode(mode, row, f, alignment)
            inside = 2.0 * f * row[7] * SOLAR_MASS_SECONDS <= mode[1] * reference.metadata.mf_band[1]
            error = np.abs(modes.h[i, k] - expected)[inside].max()
            assert error <= ACCURACY[grid] * np.abs(expected).max(), mode


@pytest.mark.parametrize("mode", ALL)
def test_below_the_band_every_mode_goes_on_as_its_definition(model, reference, mode):
    values = random_batch(4, seed=2)
    f = np.geomspace(0.5, 30.0, 200)
    h = model.predict_modes(f, ParameterBatch(values), options=chosen(mode)).h
    for i, row in enumerate(values):
        expected = reference.mode(mode, row, f)
        assert np.abs(h[i, 0] / expected - 1.0).max() < 1e-7  # of 1e7 radians at 0.5 Hz


@pytest.mark.parametrize("points", [60, 5000])
@pytest.mark.parametrize("mode", [(2, 1), (3, 1)])
def test_above_the_carriers_end_amplitude_falls_and_phase_goes_on_without_a_step(model, metadata, mode, points):
    """m = 1 reaches the frequencies of the others, although the (2, 2) at 2 f does not."""
    row = random_batch(1, seed=3)
    end = metadata.mf_band[1] / (row[0, 7] * SOLAR_MASS_SECONDS)
    middle = 0.5 * end
    f = np.sort(np.concatenate([np.linspace(0.9 * middle, end, points), middle * np.array([1 - 1e-9, 1 + 2e-9])]))
    h = model.predict_modes(f, ParameterBatch(row), options=chosen(mode)).h[0, 0]
    place = np.searchsorted(f, middle)
    assert abs(h[place] / h[place - 1] - 1.0) < 1e-5  # 3e-9 of the frequency turns it by 2e-6 rad
    above = f >= middle * (1 + 1e-9)
    falling = np.abs(h[above][0]) * (f[above][0] / f[above]) ** (10.0 / 3.0)  # as TEOBResumS's own
    np.testing.assert_allclose(np.abs(h[above]), falling, rtol=1e-12)
    phase = np.unwrap(np.angle(h))
    slope = np.gradient(phase, f)
    np.testing.assert_allclose(slope[above][3:-1], slope[above][-2], rtol=1e-6)
    assert abs(slope[place + 3] / slope[place - 3] - 1.0) < 0.02


@pytest.mark.parametrize("mode", ALL)
def test_above_the_band_every_mode_is_zero(model, metadata, mode):
    row = random_batch(1, seed=3)
    end = metadata.mf_band[1] / (row[0, 7] * SOLAR_MASS_SECONDS)
    h = model.predict_modes([0.5 * end, end, 1.0001 * end, 2.0 * end], ParameterBatch(row), options=chosen(mode)).h[
        0, 0
    ]
    assert (np.abs(h[:2]) > 0.0).all()
    assert (h[2:] == 0.0).all()


def wigner(degree, order, theta):
    """-2Y_lm(theta, 0) by LALSimulation's and Wikipedia's sum for the spin-weighted harmonics."""
    s, total = -2, 0.0
    norm = factorial(degree + order) * factorial(degree - order) * (2 * degree + 1)
    norm /= 4 * np.pi * factorial(degree + s) * factorial(degree - s)
    for r in range(degree - s + 1):
        up, down = r, r + s - order
        if 0 <= up <= degree - s and 0 <= down <= degree + s:
            ways = binomial(degree - s, up) * binomial(degree + s, down)
            power = 2 * r + s - order
            total += (
                ways * (-1) ** (degree - r - s) * np.cos(theta / 2) ** power * np.sin(theta / 2) ** (2 * degree - power)
            )
    return (-1) ** order * np.sqrt(norm) * total


def binomial(n, k):
    return factorial(n) / factorial(k) / factorial(n - k)


@pytest.mark.parametrize("mode", ALL)
def test_factors_are_those_of_the_spin_weighted_harmonics(model, mode):
    values = random_batch(20, seed=4)
    values[:3, 6] = 0.0, np.pi, np.pi / 2
    answer = model.predict_modes([100.0], ParameterBatch(values), options=chosen(*dict.fromkeys([mode, (2, 2)])))
    degree, order = mode
    theta, norm = values[:, 6], np.sqrt(5 / (4 * np.pi))
    here, mirrored = wigner(degree, order, theta), (-1) ** degree * wigner(degree, -order, theta)
    np.testing.assert_allclose(answer.plus[:, 0], (here + mirrored) / norm, atol=1e-14)
    np.testing.assert_allclose(answer.cross[:, 0], -1j * (here - mirrored) / norm, atol=1e-14)
    cosine = np.cos(theta)
    np.testing.assert_allclose(answer.plus[:, -1], (1 + cosine**2) / 2, atol=1e-15)
    np.testing.assert_allclose(answer.cross[:, -1], -1j * cosine, atol=1e-15)


@pytest.mark.parametrize("points", [1, 7, 300, 1025, 3001])
@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
def test_polarisations_are_the_sums_over_modes(model, points, dtype):
    f = np.linspace(3.0, 2700.0, points) if points > 1 else np.array([100.0])
    values = random_batch(11, seed=5)
    modes = model.predict_modes(f, ParameterBatch(values))
    summed = model.predict_batch(f, ParameterBatch(values), dtype=dtype)
    tolerance = 1e-15 if dtype == "complex128" else 1e-7
    for ours, factor in ((summed.plus, modes.plus), (summed.cross, modes.cross)):
        expected = (factor[:, :, None] * modes.h).sum(axis=1)
        np.testing.assert_allclose(ours, expected, atol=tolerance * np.abs(modes.h).max(), rtol=tolerance)
        assert ours.dtype == dtype


def test_the_order_in_which_modes_are_asked_for_does_not_change_a_bit_of_their_sum(model):
    values = random_batch(3)
    one = model.predict_batch(BAND, ParameterBatch(values), options=chosen((3, 3), (2, 2), (2, 1)))
    other = model.predict_batch(BAND, ParameterBatch(values), options=chosen((2, 1), (2, 2), (3, 3)))
    np.testing.assert_array_equal(one.plus, other.plus)
    np.testing.assert_array_equal(one.cross, other.cross)


@pytest.mark.parametrize("points", [100, 1000, DENSE, 5003])
@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
def test_the_2_2_alone_has_the_bits_of_a_model_that_has_no_other(model, reference, points, dtype):
    values, f, options = random_batch(5), np.linspace(3.0, 2700.0, points), chosen((2, 2))
    ours = model.predict_batch(f, ParameterBatch(values), options=options, dtype=dtype)
    theirs = reference.carrier.predict_batch(f, ParameterBatch(values), dtype=dtype)
    np.testing.assert_array_equal(ours.plus, theirs.plus)
    np.testing.assert_array_equal(ours.cross, theirs.cross)
    np.testing.assert_array_equal(ours.estimated_mismatch, theirs.estimated_mismatch)


def test_single_precision_is_the_rounded_double_precision(model):
    values = random_batch(5)
    double, single = (
        model.predict_modes(BAND, ParameterBatch(values)).h,
        model.predict_modes(BAND, ParameterBatch(values), dtype="complex64").h,
    )
    assert single.dtype == np.complex64
    np.testing.assert_array_equal(single, double.astype(np.complex64))


@pytest.mark.parametrize("size", [1, 2, 7, 16])
@pytest.mark.parametrize("points", [277, 1500])
def test_a_row_has_the_same_bits_in_every_batch(model, size, points):
    values, f = random_batch(32), np.geomspace(5.0, 2600.0, points)
    alone, modes = model.predict_batch(f, ParameterBatch(values)), model.predict_modes(f, ParameterBatch(values))
    for start in range(0, 32, size):
        part = ParameterBatch(values[start : start + size])
        np.testing.assert_array_equal(model.predict_batch(f, part).cross, alone.cross[start : start + size])
        np.testing.assert_array_equal(model.predict_modes(f, part).h, modes.h[start : start + size])


def test_threads_share_a_batch_without_changing_a_bit(model, metadata, tensors):
    values, f = random_batch(75), np.linspace(5.0, 2048.0, 700)
    shared = seven_mode_model(metadata, tensors, threads=3)
    np.testing.assert_array_equal(
        shared.predict_batch(f, ParameterBatch(values)).plus, model.predict_batch(f, ParameterBatch(values)).plus
    )
    np.testing.assert_array_equal(
        shared.predict_modes(f, ParameterBatch(values)).h, model.predict_modes(f, ParameterBatch(values)).h
    )
    np.testing.assert_array_equal(
        shared.predict_modes(f, ParameterBatch(values)).cross, model.predict_modes(f, ParameterBatch(values)).cross
    )


@pytest.mark.parametrize("points", [1, 300, 4097])
@pytest.mark.parametrize("options", [EvaluationOptions(), chosen((3, 3)), chosen((2, 2), (4, 4)), chosen((2, 2))])
def test_one_waveform_has_the_bits_of_a_batch_of_one(model, points, options):
    f = np.geomspace(5.0, 2048.0, points)
    batch = ParameterBatch(random_batch(1))
    first = model.predict(f, batch.row(0), options=options)
    again = model.predict(f, batch.row(0), options=options)  # the grid is prepared now: the short way
    expected = model.predict_batch(f, batch, options=options)
    for answer in (first, again):
        np.testing.assert_array_equal(answer.plus, expected.plus[0])
        np.testing.assert_array_equal(answer.cross, expected.cross[0])
        np.testing.assert_array_equal(answer.status, expected.status)
        np.testing.assert_array_equal(answer.estimated_mismatch, expected.estimated_mismatch)


def test_the_short_way_takes_a_choice_of_modes(model, monkeypatch):
    f, one = np.linspace(20.0, 2000.0, 50), ParameterBatch(random_batch(1)).row(0)
    model.predict(f, one, options=chosen((3, 3), (2, 2)))
    monkeypatch.setattr(Model, "predict_batch", None)
    model.predict(f, one, options=chosen((3, 3), (2, 2)))


@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
@pytest.mark.parametrize("points", [9_001, 40_003])
def test_a_result_written_past_the_caches_has_the_bits_of_its_rows_alone(model, points, dtype):
    f = np.linspace(5.0, 2500.0, points)
    batch = ParameterBatch(random_batch(40 if points < 10_000 else 9))
    together, modes = model.predict_batch(f, batch, dtype=dtype), model.predict_modes(f, batch, dtype=dtype)
    assert together.plus.nbytes + together.cross.nbytes > STREAMED
    for i in (0, 3, 8):
        alone = model.predict_batch(f, batch.row(i), dtype=dtype)
        assert together.plus[i].tobytes() == alone.plus[0].tobytes()
        assert together.cross[i].tobytes() == alone.cross[0].tobytes()
        assert modes.h[i].tobytes() == model.predict_modes(f, batch.row(i), dtype=dtype).h[0].tobytes()


def test_reference_phase_turns_mode_m_by_half_of_m_times_it(model):
    values = random_batch(4)
    turned = values.copy()
    turned[:, 8] += 0.7
    before, after = model.predict_modes(BAND, ParameterBatch(values)), model.predict_modes(BAND, ParameterBatch(turned))
    for k, (_, order) in enumerate(before.modes):
        np.testing.assert_allclose(after.h[:, k] / before.h[:, k], np.exp(0.35j * order), atol=1e-9)


def test_a_time_shift_delays_every_mode_by_the_same_time(model):
    values = random_batch(4)
    late = values.copy()
    late[:, 9] += 0.003
    before, after = model.predict_modes(BAND, ParameterBatch(values)), model.predict_modes(BAND, ParameterBatch(late))
    delay = np.exp(2j * np.pi * BAND * 0.003)
    np.testing.assert_allclose(after.h / before.h, np.broadcast_to(delay, after.h.shape), atol=1e-9)


def swapped(values):
    columns = [0, 2, 1, 4, 3, *range(5, 10)]  # mass ratio, Lambda_1, Lambda_2, chi_1, chi_2, the rest
    return values[:, columns]


def test_swapped_labels_at_equal_masses_change_the_signs_of_odd_m_and_nothing_else(model):
    values = random_batch(20, seed=6)
    values[:, 0] = 1.0
    here, there = (
        model.predict_modes(BAND, ParameterBatch(values)),
        model.predict_modes(BAND, ParameterBatch(swapped(values))),
    )
    for k, (_, order) in enumerate(here.modes):
        scale = np.abs(here.h[:, k]).max(axis=1, keepdims=True)
        assert np.abs(there.h[:, k] - (-1) ** order * here.h[:, k]).max() <= 1e-9 * scale.max()
        assert (np.abs(there.h[:, k] - (-1) ** order * here.h[:, k]) <= 1e-9 * scale).all()


def test_the_symmetry_is_approached_continuously(model):
    values = random_batch(20, seed=6)
    values[:, 0] = 1.0 + 1e-9
    here, there = (
        model.predict_modes(BAND, ParameterBatch(values)),
        model.predict_modes(BAND, ParameterBatch(swapped(values))),
    )
    largest = np.abs(here.h).max(axis=(0, 2))
    for k, (_, order) in enumerate(here.modes):
        # A change of 1e-9 in q turns phases of 1e5 rad by no more than 1e-4.
        assert np.abs(there.h[:, k] - (-1) ** order * here.h[:, k]).max() <= 1e-3 * largest[k]


def test_an_odd_mode_of_equal_stars_vanishes(model):
    values = random_batch(5, seed=7)
    values[:, 0], values[:, 2], values[:, 4] = 1.0, values[:, 1], values[:, 3]
    modes = model.predict_modes(BAND, ParameterBatch(values))
    for k, (_, order) in enumerate(modes.modes):
        assert (np.abs(modes.h[:, k]).max() == 0.0) == (order % 2 == 1)


def test_the_estimate_counts_every_mode_as_it_is_seen(model):
    values = random_batch(6, seed=8)
    options = [chosen(mode) for mode in ALL]
    each = np.array(
        [model.predict_modes([100.0], ParameterBatch(values), options=one).estimated_mismatch for one in options]
    )
    np.testing.assert_allclose(
        model.predict_batch([100.0], ParameterBatch(values)).estimated_mismatch, each.sum(axis=0), rtol=1e-13
    )
    face_on = values.copy()
    face_on[:, 6] = 0.0
    at_pole = model.predict_batch([100.0], ParameterBatch(face_on), options=chosen((2, 2), (3, 3), (4, 4)))
    np.testing.assert_allclose(at_pole.estimated_mismatch, each[0], rtol=1e-13)  # which only m = 2 reaches


BAD = {
    "mass_ratio": (0, 0.9, RowStatus.OUT_OF_DOMAIN, OutOfDomain),
    "lambda_1": (1, -1.0, RowStatus.OUT_OF_DOMAIN, OutOfDomain),
    "distance_mpc": (5, 0.0, RowStatus.OUT_OF_DOMAIN, InvalidParameters),
    "inclination": (6, np.nan, RowStatus.NOT_FINITE, InvalidParameters),
    "reference_phase": (8, -2e14, RowStatus.OUT_OF_DOMAIN, InvalidParameters),
}


@pytest.mark.parametrize("name", BAD)
@pytest.mark.parametrize("modes", [ALL, ((3, 3),)])
def test_what_is_flagged_is_what_is_refused(model, name, modes):
    column, value, status, error = BAD[name]
    values = random_batch(12)
    options = chosen(*modes, out_of_domain="flag")
    good, summed = (
        model.predict_modes(BAND, ParameterBatch(values), options=options),
        model.predict_batch(BAND, ParameterBatch(values), options=options),
    )
    values[11, column] = value
    flagged = model.predict_modes(BAND, ParameterBatch(values), options=options)
    assert flagged.status.tolist() == [0] * 11 + [status]
    for part in (flagged.h, flagged.plus, flagged.cross, flagged.estimated_mismatch):
        assert np.isnan(part[11]).all()
    np.testing.assert_array_equal(flagged.h[:11], good.h[:11])
    again = model.predict_batch(BAND, ParameterBatch(values), options=options)
    assert np.isnan(again.plus[11]).all()
    np.testing.assert_array_equal(again.plus[:11], summed.plus[:11])
    with pytest.raises(error, match=name):
        model.predict_modes(BAND, ParameterBatch(values), options=chosen(*modes))
    with pytest.raises(error, match=name):
        model.predict(BAND, ParameterBatch(values).row(11))


def test_a_frequency_so_low_that_a_mode_has_no_phase_is_refused_for_this_mode(model):
    f = np.array([1.5e-9 / (2.8 * SOLAR_MASS_SECONDS)])
    values = random_batch(2)
    values[:, 7] = 2.8
    assert (model.predict_modes(f, ParameterBatch(values), options=chosen((2, 2), (2, 1))).status == 0).all()
    with pytest.raises(OutOfBand, match="exceeds double precision"):
        model.predict_modes(f, ParameterBatch(values), options=chosen((4, 4)))


def test_the_band_of_the_policies_is_the_models(model):
    low, high = model.description.mf_band
    row = random_batch(1)
    mass = row[0, 7] * SOLAR_MASS_SECONDS
    options = EvaluationOptions(below_band="error", above_band="error")
    assert (
        model.predict_batch([low / mass, high / mass], ParameterBatch(row), options=options).status[0] == RowStatus.OK
    )
    for f in ([0.99 * low / mass, 100.0], [100.0, 1.01 * high / mass]):
        with pytest.raises(OutOfBand):
            model.predict_batch(f, ParameterBatch(row), options=options)


def test_a_strain_larger_than_its_numbers_is_refused(model):
    values = random_batch(3)
    values[1, 5] = 1e-60
    with pytest.raises(InvalidParameters, match="distance_mpc"):
        model.predict_modes(BAND, ParameterBatch(values), dtype="complex64")
    flagged = model.predict_modes(BAND, ParameterBatch(values), options=FLAG, dtype="complex64")
    assert flagged.status.tolist() == [0, RowStatus.NOT_FINITE, 0]
    assert np.isnan(flagged.h[1]).all()
    assert np.isnan(flagged.plus[1]).all()
