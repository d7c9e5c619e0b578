"""h(t): against TEOBResumS's own time domain, and what a signal on a time axis has to be."""

from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import (
    EvaluationOptions,
    InvalidParameters,
    InvalidRequest,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    ParametersWithExtrinsic,
    RowStatus,
    TooLarge,
    predict_time_domain,
)
from bnserve_surrogate import Model
from tests.surrogate.other_codes import MODES, signal_of_teobresums

ONE = replace(ParametersWithExtrinsic.gw170817(), inclination=0.6)
HEAVY = replace(ONE, mass_ratio=1.9, total_mass=3.6, chi_1=0.3, chi_2=-0.1, lambda_1=30.0)
FAST = {"sampling_rate": 8192.0, "f_min": 60.0}


@pytest.fixture(scope="module")
def model():
    return Model.default()


@pytest.fixture(scope="module")
def series(model):
    return model.predict_time_domain(ONE, **FAST)


def analytic(signal):
    """The signal at positive frequencies: its modulus is the amplitude, its argument the phase."""
    spectrum = np.fft.fft(signal)
    spectrum[1 : len(signal) // 2] *= 2.0
    spectrum[len(signal) // 2 + 1 :] = 0.0
    return np.fft.ifft(spectrum)


def middle(times, begin, end=-0.02):
    return (times > begin) & (times < end)


@pytest.mark.parametrize("one", [ONE, HEAVY], ids=["like GW170817", "unequal, spinning"])
def test_it_is_the_signal_of_teobresums(model, one):
    """From its own start on, amplitude and phase of h_plus and h_cross, but for one phase: that of its start."""
    found = model.predict_time_domain(one, options=EvaluationOptions(modes=[(2, 2)]), **FAST)
    times, plus, cross = signal_of_teobresums(one, 50.0, 8192.0)
    inside = middle(found.times, -model.time_until_merger(62.0, one))
    turned = []
    for ours, theirs in ((found.plus, plus), (found.cross, cross)):
        ours, at = analytic(ours)[inside], found.times[inside]
        theirs = analytic(-theirs)
        amplitude = np.interp(at, times, np.abs(theirs))
        phase = np.interp(at, times, np.unwrap(np.angle(theirs)))
        np.testing.assert_allclose(np.abs(ours), amplitude, rtol=0.015)
        turned.append(np.unwrap(np.angle(ours)) - phase)
    early = found.times[inside] < -0.5  # what the stationary-phase approximation leaves out grows towards the merger
    assert np.ptp(turned[0][early]) < 5e-3
    assert np.ptp(turned[0]) < 0.03
    np.testing.assert_allclose(turned[0], turned[1], atol=0.02)


@pytest.mark.parametrize("one", [ONE, HEAVY], ids=["like GW170817", "unequal, spinning"])
def test_all_modes_are_the_signal_of_teobresums(model, one):
    """Turned by one phase, that of (2, 2) at one moment, modulo 4 pi: what the other modes add is theirs."""
    times, *theirs = signal_of_teobresums(one, 50.0, 8192.0, MODES)
    _, *quadrupole = signal_of_teobresums(one, 50.0, 8192.0)
    alone = model.predict_time_domain(one, options=EvaluationOptions(modes=[(2, 2)]), **FAST)
    at = int(np.searchsorted(alone.times, -1.0))
    phase = np.interp(alone.times[at], times, np.unwrap(np.angle(analytic(-quadrupole[0]))))
    turn = phase - np.angle(analytic(alone.plus)[at])
    left = []
    for half_turns in (0.0, 2.0 * np.pi):
        turned = replace(one, reference_phase=one.reference_phase + turn + half_turns)
        all_modes = model.predict_time_domain(turned, **FAST)
        own = model.predict_time_domain(turned, options=EvaluationOptions(modes=[(2, 2)]), **FAST)
        inside = middle(own.times, -2.0, -0.3)
        ours = np.array([all_modes.plus - own.plus, all_modes.cross - own.cross])[:, inside]
        added = [np.interp(own.times[inside], times, two - one) for one, two in zip(quadrupole, theirs, strict=True)]
        left.append(np.linalg.norm(ours + np.array(added)) / np.linalg.norm(added))
    assert min(left) < 0.01
    assert max(left) > 1.0  # half a turn of the orbit is seen in the modes of odd m


def test_the_merger_is_at_zero_which_is_a_sample(series):
    amplitude = np.hypot(series.plus, series.cross)
    assert 0.0 in series.times
    np.testing.assert_allclose(np.diff(series.times), 1.0 / 8192.0, rtol=1e-9)
    assert abs(series.times[np.argmax(amplitude)]) < 1e-3
    assert series.times[-1] == pytest.approx(0.05, abs=0.01)
    assert amplitude[series.times > 0.03].max() < 1e-3 * amplitude.max()


def test_it_begins_with_nothing_a_tenth_and_three_cycles_before_f_min(model, series):
    complete = model.time_until_merger(60.0, ONE)
    assert series.times[0] == pytest.approx(-(1.1 * complete + 3.0 / 60.0), abs=2.0 / 8192.0)
    amplitude = np.abs(analytic(series.plus))
    assert abs(series.plus[0]) < 1e-6 * amplitude[np.searchsorted(series.times, -complete)]
    assert series.f_min.tolist() == [60.0]


def test_from_f_min_on_it_does_not_depend_on_where_it_begins(model, series):
    """Nothing rings, nothing wraps around: one that begins much lower is the same from there on."""
    lower = model.predict_time_domain(ONE, sampling_rate=8192.0, f_min=35.0)
    after = series.times >= -model.time_until_merger(60.0, ONE)
    same = lower.times >= series.times[after][0] - 1e-9
    for ours, theirs in zip(series, lower, strict=True):
        largest = np.abs(theirs[same]).max()
        np.testing.assert_allclose(ours[after], theirs[same], atol=3e-6 * largest)


def test_another_rate_gives_the_same_numbers_at_common_times(model, series):
    faster = model.predict_time_domain(ONE, sampling_rate=16384.0, f_min=60.0)
    common = np.searchsorted(faster.times, series.times[1:-1] - 1e-9)
    np.testing.assert_allclose(series.plus[1:-1], faster.plus[common], atol=2e-4 * np.abs(faster.plus).max())


def test_it_is_the_inverse_transform_of_the_strain(model, series):
    """h(f) = integral of h(t) exp(-2 pi i f t) dt, where it is complete: its signs are those of the strain."""
    f = np.linspace(150.0, 1000.0, 50)  # modes of m = 4 are whole from twice as high as (2, 2) on
    kernel = np.exp(-2j * np.pi * f[:, None] * series.times) / 8192.0
    expected = model.predict(f, ONE, options=EvaluationOptions(alignment="merger"))
    for signal, strain in zip(series, expected, strict=True):
        np.testing.assert_allclose(kernel @ signal, strain, rtol=2e-3)


def test_a_duration_is_that_of_the_axis_before_the_merger(model):
    found = model.predict_time_domain([ONE, HEAVY], sampling_rate=4096.0, duration=4.0)
    assert found.times[0] == -4.0
    complete = [model.time_until_merger(f, one) for f, one in zip(found.f_min, (ONE, HEAVY), strict=True)]
    np.testing.assert_allclose(1.1 * np.array(complete) + 3.0 / found.f_min, 4.0, rtol=1e-4)
    assert (np.abs(found.plus[:, 0]) < 1e-6 * np.abs(found.plus).max()).all()


def test_rows_of_a_batch_are_those_alone_on_the_longest_axis(model):
    rows = [ONE, HEAVY, replace(ONE, reference_phase=1.0)]
    together = model.predict_time_domain(rows, **FAST)
    assert together.plus.shape == together.cross.shape == (3, len(together.times))
    for row, one in enumerate(rows):
        alone = model.predict_time_domain(one, **FAST)
        assert alone.plus.shape == alone.times.shape
        same = np.searchsorted(together.times, alone.times[0] - 1e-9)
        largest = np.abs(alone.plus).max()
        here = together.plus[row, same : same + len(alone.times)]
        np.testing.assert_allclose(here, alone.plus, atol=3e-6 * largest)
        assert not together.plus[row, : max(0, same - 1)].any()


def test_a_time_shift_is_earlier_and_fits_the_axis(model, series):
    for shift in (0.25, -0.25):
        moved = model.predict_time_domain(replace(ONE, time_shift=shift), **FAST)
        np.testing.assert_allclose(moved.times[0] + shift, series.times[0], atol=1e-9)
        assert moved.times[-1] == max(series.times[-1] - shift, 0.0)
        there = moved.plus[: len(series.times)]
        np.testing.assert_allclose(there, series.plus[: len(there)], atol=3e-6 * np.abs(series.plus).max())


def test_the_alignment_of_the_options_does_not_matter(model, series):
    for alignment in ("merger", "post_newtonian"):
        found = model.predict_time_domain(ONE, options=EvaluationOptions(alignment=alignment), **FAST)
        assert found.plus.tobytes() == series.plus.tobytes()


def test_flagged_rows_are_nan(model):
    batch = ParameterBatch.coerce([ONE, replace(ONE, mass_ratio=0.5), replace(ONE, chi_1=np.nan), HEAVY])
    found = model.predict_time_domain(batch, options=EvaluationOptions(out_of_domain="flag"), **FAST)
    assert found.status.tolist() == [0, RowStatus.OUT_OF_DOMAIN, RowStatus.NOT_FINITE, 0]
    assert np.isnan(found.plus[1:3]).all()
    alone = model.predict_time_domain([ONE, HEAVY], **FAST)
    np.testing.assert_allclose(found.plus[[0, 3]], alone.plus, atol=1e-9 * np.abs(alone.plus).max())
    assert found.times.tolist() == alone.times.tolist()
    nothing = model.predict_time_domain(
        batch.rows(slice(1, 3)), options=EvaluationOptions(out_of_domain="flag"), **FAST
    )
    assert np.isnan(nothing.plus).all()


def test_an_empty_batch_has_an_axis_and_no_rows(model):
    assert model.predict_time_domain([], **FAST).plus.shape[0] == 0


def test_the_estimate_is_that_of_the_model(model, series):
    expected = model.predict([100.0], ONE).estimated_mismatch
    assert series.estimated_mismatch.tolist() == expected.tolist()


REFUSED = {
    "neither": ({}, InvalidRequest, "give one of the two"),
    "both": ({"f_min": 20.0, "duration": 4.0}, InvalidRequest, "give one of the two"),
    "no rate": ({"f_min": 60.0, "sampling_rate": 0.0}, InvalidRequest, "'sampling_rate' must be a positive"),
    "a rate in words": ({"f_min": 60.0, "sampling_rate": "fast"}, InvalidRequest, "'sampling_rate' must be a positive"),
    "a rate below the signal": ({"f_min": 60.0, "sampling_rate": 20.0}, InvalidRequest, "holds nothing of a signal"),
    "an endless rate": ({"f_min": 60.0, "sampling_rate": 1e300}, TooLarge, "more samples than"),
    "no frequency": ({"f_min": np.nan}, InvalidRequest, "'f_min' must be a positive"),
    "above the band": ({"f_min": 5000.0}, OutOfBand, "is above the model's band"),
    "no duration": ({"duration": -1.0}, InvalidRequest, "'duration' must be a positive"),
    "a moment": ({"duration": 1e-3}, InvalidRequest, "too short"),
    "no options": ({"f_min": 60.0, "options": "merger"}, InvalidRequest, "must be EvaluationOptions"),
    "no such mode": (
        {"f_min": 60.0, "options": EvaluationOptions(modes=[(9, 9)])},
        InvalidRequest,
        r"no mode \(9, 9\)",
    ),
}


@pytest.mark.parametrize(("how", "kind", "says"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_is_refused(model, how, kind, says):
    with pytest.raises(kind, match=says):
        model.predict_time_domain(ONE, **how)


BAD = {
    "out of the domain": (replace(ONE, mass_ratio=0.5), OutOfDomain),
    "not finite": (replace(ONE, time_shift=np.nan), InvalidParameters),
    "endless": (replace(ONE, time_shift=1e12), TooLarge),
    "no binary": ("binary", InvalidParameters),
}


@pytest.mark.parametrize(("parameters", "kind"), BAD.values(), ids=BAD)
@pytest.mark.parametrize("how", [{"f_min": 60.0}, {"duration": 2.0}], ids=["f_min", "duration"])
def test_what_is_no_binary_is_refused(model, parameters, kind, how):
    with pytest.raises(kind):
        predict_time_domain(model, parameters, **how)
