"""Strain from files: the samples that were asked for, at the time they have, and windowed as bilby windows them."""

import h5py
import numpy as np
import pytest

from benchmarks.gw170817.setting import DATA
from bnserve_inference import DetectorData, fourier_strain, gwosc_segment, likelihood, read_gwosc
from bnserve_protocol import AnalysisInvalid
from tests.inference.networks import DURATION, START, columns, full, network, without

REAL = DATA.parent / "gw150914" / "H-H1_LOSC_4_V2-1126259446-32.hdf5"
EVENT = 1126259462.43  # GPS seconds; there is no sample at that time


def write_gwosc(path, strain, start=1000.0, interval=1.0 / 256.0):
    with h5py.File(path, "w") as file:
        dataset = file.create_dataset("strain/Strain", data=strain)
        dataset.attrs["Xspacing"] = interval
        file["meta/GPSstart"] = start
    return path


def test_a_file_of_the_observatories_is_read():
    strain, start, interval = read_gwosc(REAL)
    assert (len(strain), start, interval) == (32 * 4096, 1126259446.0, 1.0 / 4096.0)


def test_a_start_between_two_samples_is_refused_and_both_are_named():
    with pytest.raises(AnalysisInvalid, match=r"1126259458\.42993.* or 1126259458\.43017") as caught:
        gwosc_segment(REAL, EVENT - 4.0, 8.0)
    assert caught.value.errors[0].parameter == "start_time"
    for start in (1126259458.429931640625, 1126259458.43017578125):
        assert len(gwosc_segment(REAL, start, 8.0)) == 4 * 4096 + 1


def test_a_duration_between_two_samples_is_refused_and_both_are_named():
    with pytest.raises(AnalysisInvalid, match=r"'duration' .* between two samples"):
        gwosc_segment(REAL, 1126259458.0, 8.0001)


def test_times_that_only_rounding_moves_are_taken():
    start = np.nextafter(1126259458.25, 0.0)
    assert (gwosc_segment(REAL, start, 8.0) == gwosc_segment(REAL, 1126259458.25, 8.0)).all()
    assert (gwosc_segment(REAL, 1126259458.25, 7.1 + 0.9) == gwosc_segment(REAL, 1126259458.25, 8.0)).all()


def test_a_signal_in_a_file_has_the_likelihood_it_has_in_the_data_that_were_written(model, tmp_path):
    """A signal that is taken to be 68 microseconds earlier than it is loses ten of them."""
    data = network(model)
    plain = columns(1, width=0.0)
    expected = likelihood(model, full(data)).log_likelihood(plain)[0]
    read, early = data, data
    for index, one in enumerate(data):
        samples = np.fft.irfft(one.strain) * (2 * (len(one.strain) - 1)) / DURATION
        path = write_gwosc(tmp_path / f"{one.name}.hdf5", samples, START, DURATION / len(samples))
        strain = gwosc_segment(path, START, DURATION, roll_off=0.0)
        read = without(read, index, strain=strain)
        early = without(early, index, strain=strain, start_time=START - 68e-6)
        with pytest.raises(AnalysisInvalid, match="between two samples"):
            gwosc_segment(path, START - 68e-6, DURATION, roll_off=0.0)
    assert likelihood(model, full(read)).log_likelihood(plain)[0] == pytest.approx(expected, abs=1e-6)
    assert likelihood(model, full(early)).log_likelihood(plain)[0] < expected - 0.1


@pytest.mark.filterwarnings("default")  # of bilby and what it imports
@pytest.mark.parametrize("roll_off", [0.2, 0.4])
def test_windowed_strain_is_bilbys(roll_off):
    bilby = pytest.importorskip("bilby")
    strain, start, interval = read_gwosc(REAL)
    theirs = bilby.gw.detector.strain_data.InterferometerStrainData(roll_off=roll_off)
    theirs.maximum_frequency = 2048.0
    theirs.set_from_time_domain_strain(
        strain[4096 : 9 * 4096], sampling_frequency=1.0 / interval, duration=8.0, start_time=start + 1.0
    )
    ours = gwosc_segment(REAL, start + 1.0, 8.0, roll_off=roll_off)
    np.testing.assert_allclose(ours, theirs.frequency_domain_strain, atol=1e-12 * np.abs(ours).max())
    assert gwosc_segment(REAL, start + 1.0, 8.0).tobytes() == gwosc_segment(REAL, start + 1.0, 8.0, 0.4).tobytes()


def test_a_line_in_a_file_is_found(tmp_path):
    times = np.arange(256 * 16) / 256.0
    path = write_gwosc(tmp_path / "strain.hdf5", np.sin(2.0 * np.pi * 32.0 * times))
    found = gwosc_segment(path, 1004.0, 8.0)
    assert found.shape == (1025,)
    line = np.argmax(np.abs(found))
    assert line == 32 * 8
    assert np.abs(found[line]) == pytest.approx(0.5 * 8.0, rel=0.06)  # less what the window takes
    assert np.angle(found[line]) == pytest.approx(-0.5 * np.pi, abs=0.01)


def test_a_file_that_is_not_there_is_said_not_to_be_there(tmp_path):
    with pytest.raises(AnalysisInvalid, match=r"There is no file .*gone\.hdf5"):
        read_gwosc(tmp_path / "gone.hdf5")


def test_files_that_do_not_serve_are_refused(tmp_path):
    path = tmp_path / "strain.hdf5"
    strain = np.ones(256 * 16)
    write_gwosc(path, strain)
    with pytest.raises(AnalysisInvalid, match="not inside"):
        gwosc_segment(path, 1010.0, 8.0)
    strain[1500] = np.nan
    write_gwosc(path, strain)
    with pytest.raises(AnalysisInvalid, match=r"1 samples .* gap"):
        gwosc_segment(path, 1004.0, 8.0)
    path.write_bytes(b"not HDF5")
    with pytest.raises(AnalysisInvalid, match="not a GWOSC strain file"):
        gwosc_segment(path, 1004.0, 8.0)


@pytest.mark.parametrize("strain", [np.ones((2, 4)), np.ones(0)])
def test_strain_that_is_no_vector_is_refused(tmp_path, strain):
    with pytest.raises(AnalysisInvalid, match="must be a vector"):
        read_gwosc(write_gwosc(tmp_path / "strain.hdf5", strain))


@pytest.mark.parametrize("duration", [0.0, -8.0, float("nan"), float("inf")])
def test_segments_without_an_extent_are_refused(duration):
    with pytest.raises(AnalysisInvalid, match="positive duration"):
        gwosc_segment(REAL, 1126259458.0, duration)


BAD_SAMPLES = {
    "no samples": ((np.ones(0), 1.0 / 4096.0), "at least two samples"),
    "no interval": ((np.ones(64), 0.0), "interval must be a positive"),
    "NaN for an interval": ((np.ones(64), float("nan")), "interval must be a positive"),
    "flanks longer than the segment": ((np.ones(64), 1.0 / 4096.0), "at most half of the segment"),
    "a negative roll-off": ((np.ones(64), 1.0, -1.0), "at most half of the segment"),
}


@pytest.mark.parametrize(("arguments", "reason"), BAD_SAMPLES.values(), ids=BAD_SAMPLES)
def test_samples_that_cannot_be_windowed_are_refused(arguments, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        fourier_strain(*arguments)


def test_data_without_an_extent_are_refused(data):
    with pytest.raises(AnalysisInvalid, match="duration positive"):
        DetectorData("H1", data[0].strain, data[0].asd, start_time=START, duration=0.0)
