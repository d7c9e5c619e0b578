"""Mismatch, maximised over time and phase: against brute force in extended precision, and its invariances."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from bnserve_surrogate.training.data.noise import einstein_telescope_d, noise_weights
from bnserve_surrogate.training.reduction.metric import spline_matrix
from bnserve_surrogate.training.reduction.nodes import smooth_nodes
from bnserve_surrogate.training.validation.mismatch import NodeMismatch, mismatch

FREQUENCIES = smooth_nodes(10.0, 2048.0, 700, total_mass=1.0) / smooth_nodes(1.0, 2.0, 2, total_mass=1.0)[0]
WEIGHTS = noise_weights(FREQUENCIES, FREQUENCIES ** (-7 / 6), einstein_telescope_d)
SHAPES = np.array([np.cos(k * np.arccos(np.linspace(-1, 1, 700))) for k in range(8)])


def overlap(log_amplitude, phase, times):
    """Modulus of the overlap of unit vectors, straight from the definition, in the precision of ``times``."""
    w, f = WEIGHTS.astype(times.dtype), FREQUENCIES.astype(times.dtype)
    ratio = np.exp(log_amplitude.astype(times.dtype))
    angle = phase.astype(times.dtype) - 2 * np.arccos(times.dtype.type(-1)) * np.multiply.outer(times, f)
    integrals = np.stack([(np.cos(angle) * ratio) @ w, (np.sin(angle) * ratio) @ w])
    return np.hypot(*integrals) / np.sqrt(w.sum() * (ratio**2 @ w))


def brute_force(log_amplitude, phase, low, high, points):
    """1 - max over a fine grid of times, then zoomed in on in extended precision until nothing changes."""
    times = np.linspace(low, high, points)
    best, width = times[np.argmax(overlap(log_amplitude, phase, times))], 2 * (times[1] - times[0])
    for _ in range(14):  # Each zoom is by four; the maximum is flat, so 1e-9 of a grid step is more than enough.
        times = np.linspace(best - width, best + width, 17, dtype=np.longdouble)
        values = overlap(log_amplitude, phase, times)
        best, width = times[np.argmax(values)], width / 4
    return float(1 - values.max())


coefficients = st.lists(st.floats(-1, 1), min_size=8, max_size=8).map(np.array)


@given(coefficients, coefficients, st.integers(-7, 0))
@settings(max_examples=40, deadline=None)
def test_small_differences_agree_with_brute_force_in_extended_precision(amplitude, phase, exponent):
    scale = 10.0**exponent
    log_amplitude, angle = scale * amplitude @ SHAPES, scale * phase @ SHAPES
    expected = brute_force(log_amplitude, angle, -0.02, 0.02, 401)
    assume(expected < 0.3)
    found = mismatch(FREQUENCIES, WEIGHTS, log_amplitude[None], angle[None]).mismatch[0]
    # 2e-19 is the rounding of the reference itself; the mismatch's own error is relative.
    assert abs(found - expected) <= 2e-18 + 1e-9 * expected


def test_mismatches_far_below_double_precision_keep_their_digits():
    shape = SHAPES[3] * 1e-12
    tiny = mismatch(FREQUENCIES, WEIGHTS, 0 * shape[None], shape[None]).mismatch[0]
    large = mismatch(FREQUENCIES, WEIGHTS, 0 * shape[None], 1e6 * shape[None]).mismatch[0]
    assert tiny == pytest.approx(large * 1e-12, rel=1e-9)
    assert 0 < tiny < 1e-23


@pytest.mark.parametrize("seed", range(12))
def test_large_differences_find_the_global_maximum(seed):
    rng = np.random.default_rng(seed)
    tidal_like = rng.normal() * 30 * (FREQUENCIES / 1000.0) ** (5 / 3) + rng.normal() * 20 * (10.0 / FREQUENCIES)
    angle = tidal_like + 3 * rng.normal(size=8) @ SHAPES
    log_amplitude = 0.3 * rng.normal(size=8) @ SHAPES
    expected = brute_force(log_amplitude, angle, -0.3, 0.3, 6_001)
    found = mismatch(FREQUENCIES, WEIGHTS, log_amplitude[None], angle[None]).mismatch[0]
    assert found == pytest.approx(expected, rel=1e-9)


@given(coefficients, st.floats(-0.2, 0.2), st.floats(-1e4, 1e4), st.floats(-5, 5))
@settings(max_examples=40, deadline=None)
def test_time_phase_and_loudness_do_not_count_and_are_recovered(phase, time, angle, level):
    base = 0.02 * phase @ SHAPES
    line = 2 * np.pi * FREQUENCIES * time + angle
    rows = np.stack([base, base + line])
    found = mismatch(FREQUENCIES, WEIGHTS, np.array([0.0, level])[:, None] + 0 * rows, rows)
    assert found.mismatch[1] == pytest.approx(found.mismatch[0], rel=1e-6, abs=1e-22)
    assert found.time[1] - found.time[0] == pytest.approx(time, abs=1e-11)
    assert found.phase[1] - found.phase[0] == pytest.approx(angle, abs=1e-8)


def test_a_time_shift_of_tens_of_milliseconds_on_top_of_a_large_difference_changes_nothing():
    angle = 25.0 * (FREQUENCIES / 1000.0) ** (5 / 3)
    line = 2 * np.pi * FREQUENCIES * 0.053
    found = mismatch(FREQUENCIES, WEIGHTS, np.zeros((2, 700)), np.stack([angle, angle + line])).mismatch
    assert found[0] > 0.01
    assert found[1] == pytest.approx(found[0], rel=1e-10)


def test_rows_do_not_influence_each_other_and_may_have_weights_of_their_own():
    rng = np.random.default_rng(1)
    log_amplitude, angle = rng.normal(size=(2, 50, 8)) @ SHAPES * np.geomspace(1e-6, 3, 50)[:, None]
    weights = WEIGHTS * np.exp(0.3 * rng.normal(size=(50, 8)) @ SHAPES)
    together = mismatch(FREQUENCIES, weights, log_amplitude, angle)
    for row in range(50):
        alone = mismatch(FREQUENCIES, weights[row], log_amplitude[row : row + 1], angle[row : row + 1])
        assert alone.mismatch[0] == pytest.approx(together.mismatch[row], rel=1e-9)


def test_equal_waveforms_have_no_mismatch_and_no_rows_give_no_rows():
    assert mismatch(FREQUENCIES, WEIGHTS, np.zeros((3, 700)), np.zeros((3, 700))).mismatch.tolist() == [0, 0, 0]
    assert mismatch(FREQUENCIES, WEIGHTS, np.zeros((0, 700)), np.zeros((0, 700))).mismatch.shape == (0,)


def test_differences_at_nodes_are_splined_to_the_dense_grid():
    rng = np.random.default_rng(2)
    amplitude_nodes, phase_nodes = FREQUENCIES[::9], np.append(FREQUENCIES[::11], FREQUENCIES[-1])
    amplitude_nodes = np.append(amplitude_nodes, FREQUENCIES[-1])
    at_amplitude = 0.01 * np.cumsum(rng.normal(size=(5, len(amplitude_nodes))), axis=1)
    at_phase = 0.01 * np.cumsum(rng.normal(size=(5, len(phase_nodes))), axis=1)
    direct = mismatch(
        FREQUENCIES,
        WEIGHTS,
        at_amplitude @ spline_matrix(amplitude_nodes, FREQUENCIES).T,
        at_phase @ spline_matrix(phase_nodes, FREQUENCIES).T,
    )
    nodes = NodeMismatch(amplitude_nodes, phase_nodes, FREQUENCIES, WEIGHTS)(at_amplitude, at_phase)
    np.testing.assert_allclose(nodes.mismatch, direct.mismatch, rtol=1e-12)


@pytest.mark.parametrize(
    ("frequencies", "weights", "amplitude", "phase", "complaint"),
    [
        (FREQUENCIES, WEIGHTS, np.zeros((2, 700)), np.zeros((3, 700)), "shape"),
        (FREQUENCIES, WEIGHTS[:-1], np.zeros((2, 700)), np.zeros((2, 700)), "Weights"),
        (FREQUENCIES, WEIGHTS, np.full((2, 700), np.nan), np.zeros((2, 700)), "finite"),
        (FREQUENCIES, -WEIGHTS, np.zeros((2, 700)), np.zeros((2, 700)), "negative"),
        (FREQUENCIES, 0 * WEIGHTS, np.zeros((2, 700)), np.zeros((2, 700)), "vanish"),
    ],
)
def test_nonsense_is_refused_with_a_reason(frequencies, weights, amplitude, phase, complaint):
    with pytest.raises(ValueError, match=complaint):
        mismatch(frequencies, weights, amplitude, phase)


def test_failed_waveforms_at_nodes_are_refused_before_they_spread():
    measure = NodeMismatch(FREQUENCIES, FREQUENCIES, FREQUENCIES, WEIGHTS)
    with pytest.raises(ValueError, match="screen failed waveforms"):
        measure(np.full((1, 700), -np.inf), np.zeros((1, 700)))
    with pytest.raises(ValueError, match="2 amplitude differences and 3"):
        measure(np.zeros((2, 700)), np.zeros((3, 700)))
