"""Amplitude spectral densities: which are read, what a gap in one means, and what is none."""

import numpy as np
import pytest

from bnserve_inference import DetectorData, gaussian_noise, interpolate_asd, likelihood, read_asd
from bnserve_protocol import AnalysisInvalid
from tests.inference.networks import DURATION, F_MAX, F_MIN, POINTS, asds, columns, full, without

GRID = np.arange(POINTS) / DURATION


def changed(array, where, value):
    result = np.array(array)
    result[where] = value
    return result


def test_a_curve_is_interpolated_in_logarithms_and_infinite_outside():
    asd = interpolate_asd([10.0, 20.0], [1e-23, 4e-23], 4.0, 100)
    assert np.isinf(asd[:40]).all()
    assert np.isinf(asd[81:]).all()
    assert asd[[40, 80]] == pytest.approx([1e-23, 4e-23])
    assert asd[60] == pytest.approx(1e-23 * (15.0 / 10.0) ** 2)


BAD_CURVES = {
    "frequencies that do not increase": (([10.0, 5.0], [1e-23, 1e-23], 4.0, 100), "increasing"),
    "a negative value": (([10.0, 20.0], [1e-23, -1e-23], 4.0, 100), "positive"),
    "NaN": (([10.0, 20.0], [1e-23, np.nan], 4.0, 100), "positive"),
    "one value": (([10.0, 20.0], [1e-23, 0.0], 4.0, 100), "positive and finite at two frequencies"),
    "no duration": (([10.0, 20.0], [1e-23, 1e-23], 0.0, 100), "positive duration"),
    "no points": (([10.0, 20.0], [1e-23, 1e-23], 4.0, 0), "number of points"),
    "a PSD": (([10.0, 20.0], [1e-46, 1e-47], 4.0, 100), "it is a PSD"),
}


@pytest.mark.parametrize(("arguments", "reason"), BAD_CURVES.values(), ids=BAD_CURVES)
def test_what_is_no_curve_is_refused(arguments, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        interpolate_asd(*arguments)


def test_files_are_checked_when_they_are_read(tmp_path):
    path = tmp_path / "asd.txt"
    path.write_text("10 1e-23 3\n20 1e-23 3\n")
    with pytest.raises(AnalysisInvalid, match="3 columns"):
        read_asd(path, 4.0, 100)
    with pytest.raises(AnalysisInvalid, match=r"gone\.txt"):
        read_asd(tmp_path / "gone.txt", 4.0, 100)
    path.write_text("10 1e-46\n20 -4e-46\n")
    with pytest.raises(AnalysisInvalid, match="positive"):
        read_asd(path, 4.0, 100, psd=True)
    path.write_text("10 1\n20 4\n")  # of no detector, but neither an ASD of one
    assert read_asd(path, 4.0, 100, psd=True)[80] == pytest.approx(2.0)


def test_a_psd_and_an_asd_are_told_apart(tmp_path):
    asd, psd = tmp_path / "asd.txt", tmp_path / "psd.txt"
    curve = asds()[0]
    inside = np.isfinite(curve)
    np.savetxt(asd, np.transpose([GRID[inside], curve[inside]]))
    np.savetxt(psd, np.transpose([GRID[inside], curve[inside] ** 2]))
    np.testing.assert_allclose(read_asd(psd, DURATION, POINTS, psd=True), read_asd(asd, DURATION, POINTS), rtol=1e-12)
    with pytest.raises(AnalysisInvalid, match=r"it is a PSD.*psd=True"):
        read_asd(psd, DURATION, POINTS)
    with pytest.raises(AnalysisInvalid, match="it is an ASD"):
        read_asd(asd, DURATION, POINTS, psd=True)


def test_an_array_that_is_a_psd_or_the_root_of_an_asd_makes_no_analysis(data):
    """With the PSD for the ASD, ln L was 8.9e47."""
    with pytest.raises(AnalysisInvalid, match="ASD of L1 at 40 Hz is below 1e-30: it is a PSD"):
        full(without(data, 1, asd=data[1].asd ** 2))
    with pytest.raises(AnalysisInvalid, match="it is no ASD of strain"):
        full(without(data, 1, asd=np.sqrt(data[1].asd)))


@pytest.mark.parametrize("gap", [np.inf, 0.0])
def test_a_gap_in_a_file_is_a_gap_in_the_curve_and_the_rest_is_as_it_was(tmp_path, gap):
    curve = asds()[0]
    inside = np.isfinite(curve)
    notch = (GRID > 59.0) & (GRID < 61.0)
    path = tmp_path / "asd.txt"
    np.savetxt(path, np.transpose([GRID, changed(curve, notch, gap)])[inside])
    found = read_asd(path, DURATION, POINTS)
    assert (np.isinf(found) == (notch | ~inside)).all()
    np.testing.assert_allclose(found[inside & ~notch], curve[inside & ~notch], rtol=1e-12)
    coarse = read_asd(path, DURATION / 8.0, POINTS // 8)  # two points of this grid are beside the notch, three in it
    at = np.arange(POINTS // 8) / (DURATION / 8.0)
    assert np.isinf(coarse[(at > 59.0) & (at < 61.0)]).all()
    assert np.isfinite(coarse[(at >= F_MIN) & (at <= F_MAX) & ((at <= 59.0) | (at >= 61.0))]).all()
    fine = read_asd(path, 3.0 * DURATION, 3 * POINTS)  # and of this one some are between a good value and a bad one
    at = np.arange(3 * POINTS) / (3.0 * DURATION)
    assert (np.isinf(fine) == (at > 59.0 + 1e-6) & (at < 61.0 - 1e-6))[(at > 50.0) & (at < 70.0)].all()


@pytest.mark.filterwarnings("default")  # of bilby and what it imports
def test_what_bilby_saves_is_read(tmp_path, data):
    bilby = pytest.importorskip("bilby")
    theirs = bilby.gw.detector.get_empty_interferometer("H1")
    theirs.minimum_frequency, theirs.maximum_frequency = F_MIN, F_MAX
    theirs.set_strain_data_from_frequency_domain_strain(data[0].strain, frequency_array=GRID, start_time=0.0)
    inside = np.isfinite(data[0].asd)
    theirs.power_spectral_density = bilby.gw.detector.PowerSpectralDensity(GRID[inside], asd_array=data[0].asd[inside])
    theirs.save_data(tmp_path)
    found = read_asd(tmp_path / "H1_asd.dat", DURATION, POINTS)
    assert (np.isinf(found) == ~inside).all()
    np.testing.assert_allclose(found[inside], data[0].asd[inside], rtol=1e-12)


@pytest.mark.parametrize("gap", [np.inf, 0.0])
def test_a_gap_inside_of_the_band_has_no_weight(model, data, gap):
    batch = columns(3)
    notch = (GRID > 55.0) & (GRID < 65.0)
    notched = without(data, 1, asd=changed(data[1].asd, notch, gap))
    found = likelihood(model, full(notched))
    unheard = without(data, 1, asd=changed(data[1].asd, notch, 1e-15))  # as loud as can be
    expected = likelihood(model, full(unheard)).log_likelihood(batch)
    np.testing.assert_allclose(found.log_likelihood(batch), expected, rtol=1e-9)
    assert np.abs(expected - likelihood(model, full(data)).log_likelihood(batch)).min() > 1.0
    nothing_there = without(notched, 1, strain=changed(data[1].strain, notch, np.nan))
    assert (likelihood(model, full(nothing_there)).log_likelihood(batch) == found.log_likelihood(batch)).all()


def test_a_detector_may_have_a_band_of_its_own(model, data):
    batch = columns(3)
    below = without(data, 1, asd=changed(data[1].asd, GRID < 100.0, np.inf))
    found = likelihood(model, full(below)).log_likelihood(batch)
    both = likelihood(model, full([data[0], data[2]])).log_likelihood(batch)
    alone = likelihood(model, full([DetectorData("L1", data[1].strain, below[1].asd, data[1].start_time, DURATION)]))
    np.testing.assert_allclose(found, both + alone.log_likelihood(batch), rtol=1e-12)


def test_a_detector_without_data_in_the_band_is_refused(data):
    with pytest.raises(AnalysisInvalid, match="ASD of L1 is zero or infinite from 40"):
        full(without(data, 1, asd=np.full(POINTS, np.inf)))


def test_noise_without_an_extent_is_refused():
    with pytest.raises(AnalysisInvalid, match="positive number of seconds"):
        gaussian_noise(np.ones(5), 0.0, 1)
