"""Models whose binaries precess: their own modes are twisted, and where nothing precesses nothing changes."""

import dataclasses

import numpy as np
import pytest

from bnserve_protocol import EvaluationOptions, InvalidParameters, ParameterBatch, ParametersWithExtrinsic
from bnserve_surrogate import _precessing
from bnserve_surrogate.precession import twist
from tests.surrogate.seven_modes import seven_mode_metadata, seven_mode_model, seven_mode_tensors

F = np.geomspace(12.0, 1800.0, 200)
AT_20_HZ = EvaluationOptions(reference_frequency=20.0)
ONE = ParametersWithExtrinsic.gw170817()
SPINS = {"chi_1x": 0.2, "chi_1y": -0.1, "chi_2x": 0.05, "chi_2y": 0.3}
PRECESSING = dataclasses.replace(ONE, **SPINS)


@pytest.fixture(scope="module")
def seven():
    return seven_mode_model(seven_mode_metadata(), seven_mode_tensors())


@pytest.mark.parametrize("modes", [None, ((2, 2),), ((3, 3), (2, 1), (2, 2))])
def test_the_chosen_modes_are_twisted(seven, modes):
    options = EvaluationOptions(reference_frequency=20.0, modes=modes, alignment="merger")
    plus, cross = seven.predict(F, PRECESSING, options=options)
    aligned = seven.predict_modes(F, ONE, options=options)
    expected = twist(F, aligned.modes, aligned.h, ParameterBatch.one(PRECESSING), 20.0)
    np.testing.assert_array_equal(plus, expected[0][0])
    np.testing.assert_array_equal(cross, expected[1][0])


def test_at_the_reference_frequency_the_signal_is_that_of_aligned_spins(seven):
    options = EvaluationOptions(reference_frequency=20.0, modes=((2, 2),))
    there = np.array([20.0])
    for one, other in zip(
        seven.predict(there, PRECESSING, options=options), seven.predict(there, ONE, options=options), strict=True
    ):
        np.testing.assert_allclose(one, other, rtol=1e-12)


@pytest.mark.parametrize("size", [1e-6, 1e-9, 1e-12])
def test_as_spins_become_aligned_so_does_the_waveform(seven, size):
    slightly = dataclasses.replace(ONE, **{name: size * value for name, value in SPINS.items()})
    aligned = seven.predict(F, ONE, options=AT_20_HZ)
    for one, other in zip(seven.predict(F, slightly, options=AT_20_HZ), aligned, strict=True):
        assert np.abs(one - other).max() < (size + 1e-12) * np.abs(aligned.plus).max()


def test_without_spins_in_the_plane_the_bits_are_those_of_ever(seven):
    aligned = seven.predict(F, ONE, options=AT_20_HZ)
    zero = seven.predict(F, dataclasses.replace(ONE, **dict.fromkeys(SPINS, 0.0)), options=AT_20_HZ)
    among = seven.predict_batch(F, [PRECESSING, ONE, PRECESSING], options=AT_20_HZ)
    for one in (zero.plus, among.plus[1]):
        np.testing.assert_array_equal(one, aligned.plus)


def test_a_batch_in_pieces_has_the_same_bits(seven, monkeypatch):
    random = np.random.default_rng(3)
    columns = dataclasses.asdict(ONE) | {name: random.uniform(-0.3, 0.3, 20) for name in SPINS}
    whole = seven.predict_batch(F, columns, options=AT_20_HZ)
    monkeypatch.setattr(_precessing, "_MOST_SAMPLES", 1)
    pieces = seven.predict_batch(F, columns, options=AT_20_HZ)
    np.testing.assert_array_equal(whole.plus, pieces.plus)
    np.testing.assert_array_equal(whole.cross, pieces.cross)
    np.testing.assert_array_equal(whole.estimated_mismatch, pieces.estimated_mismatch)


def test_single_precision_is_the_rounded_double_precision(seven):
    double, single = (seven.predict(F, PRECESSING, options=AT_20_HZ, dtype=dtype) for dtype in ("c16", "c8"))
    assert single.plus.dtype == np.complex64
    np.testing.assert_array_equal(single.plus, double.plus.astype(np.complex64))


def test_strain_larger_than_numbers_is_refused(seven):
    near = dataclasses.replace(PRECESSING, distance_mpc=1e-60)
    with pytest.raises(InvalidParameters, match="larger than the largest number"):
        seven.predict(F, near, options=AT_20_HZ, dtype="complex64")


def test_above_the_band_there_is_nothing(seven):
    above = np.array([1000.0, 9000.0])
    plus, cross = seven.predict(above, PRECESSING, options=AT_20_HZ)
    assert plus[0] != 0.0
    assert (plus[1], cross[1]) == (0.0, 0.0)


def test_stars_that_change_names_are_the_same_binary(seven):
    equal = dataclasses.replace(PRECESSING, mass_ratio=1.0)
    swapped = dataclasses.replace(
        equal, lambda_1=equal.lambda_2, lambda_2=equal.lambda_1, chi_1=equal.chi_2, chi_2=equal.chi_1,
        chi_1x=-equal.chi_2x, chi_1y=-equal.chi_2y, chi_2x=-equal.chi_1x, chi_2y=-equal.chi_1y,
        reference_phase=equal.reference_phase + 2.0 * np.pi,
    )  # fmt: skip
    one, other = (seven.predict(F, binary, options=AT_20_HZ) for binary in (equal, swapped))
    np.testing.assert_allclose(one.plus, other.plus, atol=1e-9 * np.abs(one.plus).max())
    np.testing.assert_allclose(one.cross, other.cross, atol=1e-9 * np.abs(one.cross).max())
