"""Strain from files of any kind, its gaps and flags, and the noise estimated from it."""

import gzip

import h5py
import numpy as np
import pytest
from scipy.signal import welch

from benchmarks.gw170817.setting import DATA
from bnserve_inference.strain import Strain, bad_seconds, data_doubts, estimate_asd, read_strain, refuse_gaps
from bnserve_protocol import AnalysisInvalid

REAL = DATA.parent / "gw150914" / "H-H1_LOSC_4_V2-1126259446-32.hdf5"
START, RATE = 1000.0, 256


def noise(seconds=64, seed=1):
    return 1e-21 * np.random.default_rng(seed).standard_normal(seconds * RATE)


def strain(values, **flags):
    return Strain("x.hdf5", values, START, 1.0 / RATE, {name: np.array(passes) for name, passes in flags.items()})


def write_gwpy(path, values, names=("H1:X",)):
    """As ``TimeSeries.write`` of gwpy 4.1."""
    with h5py.File(path, "w") as file:
        for name in names:
            dataset = file.create_dataset(name, data=values)
            dataset.attrs.update({"x0": START, "dx": 1.0 / RATE, "unit": "strain", "xunit": "s", "channel": name})
    return path


def test_a_file_of_the_observatories_is_read_with_its_flags():
    found = read_strain(REAL)
    assert (found.start, found.interval, len(found.values)) == (1126259446.0, 1.0 / 4096.0, 32 * 4096)
    assert {"DATA", "CBC_CAT1", "CBC_CAT3", "NO_CBC_HW_INJ"} <= found.flags.keys()
    assert all(passes.shape == (32,) and passes.all() for passes in found.flags.values())


def test_a_file_of_gwpy_is_read_and_of_several_series_the_one_that_is_named(tmp_path):
    values = noise(4)
    found = read_strain(write_gwpy(tmp_path / "a.h5", values))
    assert (found.start, found.interval, (found.values == values).all()) == (START, 1.0 / RATE, True)
    several = write_gwpy(tmp_path / "b.h5", values, ("H1:X", "H1:Y"))
    assert (read_strain(several, "H1:Y").values == values).all()
    for channel, sentence in ((None, "Say which with 'channel'"), ("H1:Z", "There is no 'H1:Z'")):
        with pytest.raises(AnalysisInvalid, match=sentence):
            read_strain(several, channel)


@pytest.mark.parametrize("ending", ["txt", "csv", "txt.gz"])
def test_text_is_read_with_times_or_with_the_header_of_the_observatories(tmp_path, ending):
    values, path = noise(4), tmp_path / f"a.{ending}"
    times = START + np.arange(len(values)) / RATE
    np.savetxt(path, np.stack([times, values], axis=1), delimiter="," if ending == "csv" else " ")
    found = read_strain(path)
    assert (found.start, found.interval, (found.values == values).all()) == (START, 1.0 / RATE, True)
    if ending == "csv":
        return
    header = f"Gravitational wave strain\nThis file has {RATE} samples per second\nstarting GPS 1000 duration 4"
    np.savetxt(path, values, header=header)
    found = read_strain(path)
    assert (found.start, found.interval, (found.values == values).all()) == (START, 1.0 / RATE, True)


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("a.txt", "1.0 2.0 3.0\n4.0 5.0 6.0\n", "has 3 columns"),
        ("a.txt", "0.0 1.0\n1.0 1.0\n5.0 1.0\n", "not evenly spaced"),
        ("a.txt", "1.0\n2.0\n", "one column and no header"),
        ("a.txt", "strain\n", "not a text file of numbers"),
        ("a.hdf5", "no HDF5", "no HDF5 file of strain"),
        ("a.wav", "RIFF", r"files that end in .*hdf5.*gwf; got a.wav"),
    ],
)
def test_what_is_no_strain_is_refused(tmp_path, name, content, sentence):
    (tmp_path / name).write_text(content)
    with pytest.raises(AnalysisInvalid, match=sentence):
        read_strain(tmp_path / name)
    with pytest.raises(AnalysisInvalid, match="There is no file"):
        read_strain(tmp_path / f"other-{name}")


def test_frames_need_a_channel(tmp_path):
    (tmp_path / "a.gwf").write_bytes(b"IGWD")
    with pytest.raises(AnalysisInvalid, match="say which with 'channel'"):
        read_strain(tmp_path / "a.gwf")


def test_compressed_text_that_is_none_is_refused(tmp_path):
    (tmp_path / "a.txt.gz").write_bytes(gzip.compress(b"\xff\xfe"))
    with pytest.raises(AnalysisInvalid, match="not a text file"):
        read_strain(tmp_path / "a.txt.gz")


def test_a_gap_in_the_segment_is_refused_and_its_time_named():
    values = noise(16)
    values[5 * RATE + 1] = np.nan
    with pytest.raises(AnalysisInvalid, match=r"a gap in H1: x.hdf5 has no strain at 1 samples, .* GPS 1005\.0039"):
        refuse_gaps(strain(values), "H1", 1004.0, 4.0)
    refuse_gaps(strain(values), "H1", 1006.0, 4.0)
    with pytest.raises(AnalysisInvalid, match="zero throughout"):
        refuse_gaps(strain(np.zeros(16 * RATE)), "H1", 1004.0, 4.0)


@pytest.mark.parametrize("flag", ["DATA", "CBC_CAT1"])
def test_seconds_without_data_are_refused(flag):
    passes = np.arange(16) != 7
    found = strain(noise(16), **{flag: passes})
    assert bad_seconds(found, 1004.0, 4.0) == [1007]
    with pytest.raises(AnalysisInvalid, match=r"no data in 1 s, the first GPS 1007"):
        refuse_gaps(found, "H1", 1004.0, 4.0)
    refuse_gaps(found, "H1", 1008.0, 4.0)


def test_what_is_doubtful_is_said():
    good = np.ones(16, dtype=bool)
    found = strain(noise(16), DATA=good, CBC_CAT3=np.arange(16) != 5, NO_CBC_HW_INJ=np.arange(16) != 6)
    assert data_doubts(found, "L1", 1008.0, 4.0, (20.0, 100.0)) == []
    doubts = data_doubts(found, "L1", 1004.0, 4.0, (5.0, 120.0))
    assert len(doubts) == 4
    assert all(doubt.startswith("L1: ") for doubt in doubts)
    for sentence in ("anti-alias filter from about 106 Hz", "calibrate from 10 Hz", "1 s of the segment fail CBC_CAT3",
                     "injected into the hardware"):  # fmt: skip
        assert any(sentence in doubt for doubt in doubts)
    assert "no flags of data quality" in data_doubts(strain(noise(16)), "L1", 1004.0, 4.0, (20.0, 100.0))[0]


def test_the_band_up_to_which_gwosc_trusts_its_files_of_4096_hz_is_not_doubted():
    """It says 1700 Hz."""
    real = read_strain(REAL)
    assert data_doubts(real, "H1", 1126259460.0, 4.0, (20.0, 1699.75)) == []
    assert "1700 Hz" in data_doubts(real, "H1", 1126259460.0, 4.0, (20.0, 2000.0))[0]


@pytest.mark.parametrize("segment", [4.0, 2.0])
def test_the_noise_is_that_of_scipy_s_median_of_periodograms(segment):
    """SciPy subtracts the mean of each piece as we do."""
    found = estimate_asd(read_strain(REAL), 1126259446.0, 32.0, segment)
    count = round(4096 * segment)
    f, density = welch(
        read_strain(REAL).values, 4096.0, "hann", count, average="median", detrend="constant"
    )  # fmt: skip
    assert found.pieces == round(2.0 * 32.0 / segment) - 1
    np.testing.assert_allclose(found.frequencies, f[2:-1], rtol=1e-12)
    np.testing.assert_allclose(found.asd, np.sqrt(density[2:-1]), rtol=1e-9)


def test_white_noise_has_the_level_it_was_made_with():
    found = estimate_asd(strain(noise(512)), START, 512.0, 4.0)
    assert np.mean(found.asd**2) == pytest.approx(2.0 * 1e-42 / RATE, rel=0.02)


def test_pieces_with_gaps_or_with_injections_are_left_out():
    values = noise(64)
    whole = estimate_asd(strain(values), START, 64.0, 4.0)
    gap = values.copy()
    gap[20 * RATE] = np.nan
    loud = values.copy()
    loud[40 * RATE : 41 * RATE] *= 1e6
    injected = np.arange(64) != 40
    for found in (
        estimate_asd(strain(gap), START, 64.0, 4.0),
        estimate_asd(strain(loud, NO_CBC_HW_INJ=injected), START, 64.0, 4.0),
    ):
        assert found.left_out == 2
        assert found.pieces == whole.pieces - 2
        assert np.isfinite(found.asd).all()
        assert np.median(found.asd / whole.asd) == pytest.approx(1.0, abs=0.02)


def test_too_little_strain_says_nothing_of_the_noise():
    with pytest.raises(AnalysisInvalid, match=r"only 3 of 3 pieces of 4 s"):
        estimate_asd(strain(noise(8)), START, 8.0, 4.0)
    with pytest.raises(AnalysisInvalid, match="do not fit into 8 s"):
        estimate_asd(strain(noise(8)), START, 8.0, 16.0)


def test_a_segment_beyond_the_file_or_between_samples_is_refused():
    found = strain(noise(8))
    for start, sentence in ((1006.0, "holds GPS 1000 to 1008; 4 s from 1006 are not inside"), (999.0, "not inside"),
                            (1001.001, "between two samples")):  # fmt: skip
        with pytest.raises(AnalysisInvalid, match=sentence):
            found.piece(start, 4.0)
