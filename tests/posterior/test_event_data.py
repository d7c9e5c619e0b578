"""The data of an event: real strain as it is conditioned, signals that are simulated, and what is doubtful."""

import h5py
import numpy as np
import pytest

from benchmarks.gw170817.setting import DATA
from bnserve_inference import Detector, gwosc_segment
from bnserve_posterior.data import load_data, noise_curve, segment_start
from bnserve_posterior.events import EventInvalid, read_event
from bnserve_posterior.report._figures import whitened
from bnserve_protocol import AnalysisInvalid, OutOfDomain
from bnserve_surrogate import Model
from tests.posterior.networks import SMALL, TRIGGER, event

REAL = DATA.parent / "gw150914" / "H-H1_LOSC_4_V2-1126259446-32.hdf5"
EXAMPLE = DATA.parents[2] / "examples" / "gw150914.toml"


def real(**changes):
    detector = changes.pop("detector", {"strain": str(REAL)})
    start = {"data__trigger_time": 1126259462.4, "data__duration": 4.0, "data__f_min": 20.0}
    return event(data__injection=None, detectors={"H1": detector}, **{**start, **changes})


@pytest.fixture(scope="module")
def model():
    return Model.default()


def snr(data, band):
    total = 0.0
    for one in data.detectors:
        strain, density = one.weighted(one.band(*band))
        total += np.sum(density * np.abs(strain) ** 2)
    return np.sqrt(total)


def test_real_strain_is_windowed_as_it_says_and_its_noise_is_that_beside_the_segment(model):
    found = load_data(real(), model)
    (one,) = found.detectors
    assert (one.start_time, one.duration) == (1126259460.0, 4.0)
    assert (one.strain == gwosc_segment(REAL, 1126259460.0, 4.0)).all()
    assert found.injection is None
    assert found.digests[REAL.name].startswith("sha256:")
    said = " ".join(found.facts)
    for words in ("Tukey window that rises and falls within 0.4 s", "from 14 s of", "median of 13 pieces of 2 s"):
        assert words in said
    assert [doubt.partition(":")[0] for doubt in found.doubts] == ["H1", "H1"]
    assert "13 pieces alone" in found.doubts[0]
    assert "lines that are narrower" in found.doubts[1]


def test_the_noise_of_real_strain_is_that_of_the_observatory_of_that_day(model):
    """Hanford had 8e-24 at 150 Hz (Abbott et al. 2016, arXiv:1602.03844, fig. 2)."""
    (one,) = load_data(real(), model).detectors
    assert np.median(one.asd[4 * 140 : 4 * 160]) == pytest.approx(8e-24, rel=0.2)


def test_what_is_doubtful_is_said(model):
    found = load_data(real(data__f_max=2000.0), model)
    assert any("anti-alias filter from about 1700 Hz" in doubt for doubt in found.doubts)
    stretch = {"strain": str(REAL), "psd_start": 1126259448.0, "psd_duration": 30.0, "psd_segment": 4.0}
    found = load_data(real(detector=stretch), model)
    assert any("hold the segment itself" in doubt for doubt in found.doubts)
    assert not any("lines that are narrower" in doubt for doubt in found.doubts)


def test_a_gap_in_real_strain_is_refused(model, tmp_path):
    path = tmp_path / "gap.hdf5"
    path.write_bytes(REAL.read_bytes())
    with h5py.File(path, "r+") as file:
        mask = file["quality/simple/DQmask"][()]
        mask[1126259461 - 1126259446] -= 1  # the bit of DATA
        file["quality/simple/DQmask"][...] = mask
    with pytest.raises(AnalysisInvalid, match="no data in 1 s, the first GPS 1126259461"):
        load_data(real(detector={"strain": str(path)}), model)


def test_an_injection_has_the_signal_to_noise_ratio_that_was_asked_for(model):
    found = load_data(event(data__injection__zero_noise=True), model, ((2, 2),))
    assert snr(found, (64.0, 512.0)) == pytest.approx(15.0, rel=1e-6)
    assert found.injection["geocent_time"] == TRIGGER
    assert "15.0" in found.facts[0]
    assert "without noise" in found.facts[0]


def test_detectors_of_an_injection_turn_with_the_earth_unless_they_are_held(model):
    turning, still = (
        load_data(event(data__injection__response=response, data__injection__zero_noise=True), model, ((2, 2),))
        for response in ("moving", "static")
    )
    assert "in detectors that turn" in turning.facts[0]
    assert "stand still" in still.facts[0]
    one, other = turning.detectors[0].strain, still.detectors[0].strain
    assert 0.0 < np.abs(one - other).max() < 0.05 * np.abs(other).max()


def test_noise_is_seeded(model):
    one, again, other = (
        load_data(event(data__injection__seed=seed), model, ((2, 2),)).detectors[0].strain for seed in (3, 3, 4)
    )
    assert (one == again).all()
    assert (one != other).any()


def test_an_injection_without_a_distance_is_refused(model):
    with pytest.raises(EventInvalid, match="no distance"):
        load_data(event(data__injection__snr=None), model)


@pytest.mark.parametrize(
    ("name", "error", "words"),
    [("theta_jn", EventInvalid, "from 0 to pi; got 150"), ("dec", OutOfDomain, "declination of 150")],
)
def test_an_injection_in_degrees_is_refused(model, name, error, words):
    with pytest.raises(error, match=words):
        load_data(event(**{f"data__injection__parameters__{name}": 150.0}), model)


def test_a_detector_may_have_a_band_and_notches_of_its_own(model):
    plain = load_data(event(), model, ((2, 2),)).detectors[0]
    narrow = {"asd": "aLIGO_O4_high_asd.txt", "f_min": 80.0, "f_max": 400.0, "notches": [[119.0, 121.0]]}
    found = load_data(event(detectors__H1=narrow), model, ((2, 2),)).detectors[0]
    some = slice(64 * 8, 480 * 8)
    f = np.arange(some.start, some.stop) / 8.0
    out = (f < 80.0) | (f > 400.0) | ((f >= 119.0) & (f <= 121.0))
    (_, everywhere), (_, density) = plain.weighted(some), found.weighted(some)
    assert (everywhere > 0.0).all()
    assert ((density == 0.0) == out).all()
    white = np.fft.rfft(whitened(found, found.strain)[1])
    assert np.abs(white[some][out]).max() < 1e-6 * np.abs(white[some]).max()


@pytest.mark.parametrize("arm_length", [None, 40e3])
def test_a_detector_may_be_given_by_its_coordinates(model, arm_length):
    site = {"latitude": 0.8, "longitude": -2.0, "elevation": 100.0, "x_azimuth": 0.3, "y_azimuth": 1.9}
    site |= {} if arm_length is None else {"arm_length": arm_length}
    section = {"asd": "aLIGO_O4_high_asd.txt", "site": site}
    (found,) = load_data(event(detectors={"X1": section}), model, ((2, 2),)).detectors
    expected = Detector.at("X1", **site)
    assert (found.name, found.site().location.tolist()) == ("X1", expected.location.tolist())
    assert (found.site().response == expected.response).all()
    assert (found.site().arms is None) == (arm_length is None)


def test_the_length_of_arms_counts_where_it_is_asked_for(model):
    asd = {"asd": "aLIGO_O4_high_asd.txt"}
    long = load_data(event(detectors={"CE40": {**asd, "finite_arms": True}}), model, ((2, 2),)).detectors[0]
    short = load_data(event(detectors={"CE40": asd}), model, ((2, 2),)).detectors[0]
    assert (long.site().arms is None, short.site().arms is None) == (False, True)
    assert (long.strain != short.strain).any()


def test_the_segment_begins_at_a_whole_second_and_ends_two_seconds_after_the_trigger():
    start = segment_start(event().data)
    assert start == 1187008876.0
    assert segment_start(event(data__start_time=1187008880.5).data) == 1187008880.5


def test_noise_curves_are_files_archives_or_those_of_bilby(tmp_path):
    path = DATA / "asd.npz"
    curve = noise_curve(str(path), "L1", 128.0, 262145)
    assert np.isinf(curve[2943])
    assert curve[2944] == pytest.approx(4.8198667e-23)
    bilbys = noise_curve("aLIGO_O4_high_asd.txt", "H1", 4.0, 4097)
    assert 1e-24 < bilbys[400] < 1e-23
    asd, psd = noise_curve("ET_D_asd.txt", "E1", 4.0, 4097), noise_curve("ET_D_psd.txt", "E1", 4.0, 4097, psd=True)
    both = np.isfinite(asd) & np.isfinite(psd)
    np.testing.assert_allclose(asd[both], psd[both], rtol=0.01)
    with pytest.raises(EventInvalid, match=r"it has .*ET_D_psd\.txt"):
        noise_curve("ET_E_psd.txt", "E1", 4.0, 4097)
    with pytest.raises(EventInvalid, match="no noise curve of K1"):
        noise_curve(str(path), "K1", 128.0, 262145)


def test_the_example_of_real_strain_is_read(model):
    found = load_data(read_event(EXAMPLE), model)
    assert [one.name for one in found.detectors] == ["H1"]


def test_the_table_of_the_small_event_is_not_changed():
    assert SMALL["data"]["injection"]["seed"] == 3
