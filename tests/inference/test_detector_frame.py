"""Places and times relative to detectors: bilby's, to the last digits of a GPS time."""

import numpy as np
import pandas as pd
import pytest

from bnserve_inference import Detector, LikelihoodOptions, full_analysis, likelihood
from bnserve_protocol import DetectorFrame, InvalidParameters, InvalidRequest
from tests.inference.networks import DETECTORS, F_MAX, F_MIN, TRIGGER, TRUTH, columns, network

bilby = pytest.importorskip("bilby")
pytestmark = pytest.mark.filterwarnings("default")  # of bilby and what it imports
WIDE = LikelihoodOptions(prior={"coalescence_time": (-0.2, 0.2)})


@pytest.fixture(scope="module")
def analysis(model):
    """With bilby's tensors and places, which are LAL's beyond the digits that LAL keeps."""
    theirs = [bilby.gw.detector.get_empty_interferometer(name) for name in DETECTORS]
    sites = [Detector(one.name, np.array(one.detector_tensor), np.array(one.vertex)) for one in theirs]
    return full_analysis(network(model, sites), trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, options=WIDE)


def drawn(count, seed=8):
    random = np.random.default_rng(seed)
    return {
        "zenith": np.arccos(random.uniform(-1.0, 1.0, count)),
        "azimuth": random.uniform(0.0, 2.0 * np.pi, count),
        "time": TRIGGER + random.uniform(-0.1, 0.1, count),
    }


@pytest.mark.parametrize("pair", ["H1L1", "L1H1", "H1V1", ("L1", "V1")])
@pytest.mark.parametrize("reference", ["geocenter", "H1", "V1"])
def test_they_are_bilbys(analysis, pair, reference):
    given = drawn(50)
    name = "geocent_time" if reference == "geocenter" else f"{reference}_time"
    frame = DetectorFrame(analysis, reference_frame=pair, time_reference=reference)
    found = frame.to_sky({"zenith": given["zenith"], "azimuth": given["azimuth"], name: given["time"], "psi": 0.3})
    assert set(found) == {"right_ascension", "declination", "coalescence_time", "polarization_angle"}
    ifos = bilby.gw.detector.InterferometerList(list(pair) if isinstance(pair, tuple) else [pair[:2], pair[2:]])
    for row in range(50):
        time = given["time"][row]
        ra, dec = bilby.gw.utils.zenith_azimuth_to_ra_dec(given["zenith"][row], given["azimuth"][row], time, ifos)
        apart = np.remainder(found["right_ascension"][row] - ra + np.pi, 2.0 * np.pi) - np.pi
        assert abs(apart) < 1e-9
        assert found["declination"][row] == pytest.approx(dec, abs=1e-9)
        if reference != "geocenter":
            ifo = bilby.gw.detector.get_empty_interferometer(reference)
            time = time - ifo.time_delay_from_geocenter(ra, dec, time)
        assert found["coalescence_time"][row] == pytest.approx(time - TRIGGER, abs=3e-7)  # a GPS time in float64


def test_there_and_back(analysis):
    frame = DetectorFrame(analysis, reference_frame="H1L1", time_reference="L1")
    batch = columns(20)
    back = frame.to_sky(pd.DataFrame(frame.from_sky(batch)))
    for name, values in batch.items():
        np.testing.assert_allclose(back[name], values, rtol=1e-12, atol=3e-7 if name == "coalescence_time" else 1e-9)


def test_samples_of_a_likelihood(model, analysis):
    """One place and time in two frames has one likelihood."""
    bound = likelihood(model, analysis)
    batch = columns(5)
    frame = DetectorFrame(analysis, reference_frame="H1V1", time_reference="H1")
    relative = frame.from_sky(batch)
    assert {"zenith", "azimuth", "H1_time"} < set(relative)
    found = bound.log_likelihood(frame.to_sky(relative))
    np.testing.assert_allclose(found, bound.log_likelihood(batch), atol=0.1)  # of a GPS time in float64
    same = DetectorFrame(analysis).to_sky(batch)
    assert bound.log_likelihood(same).tobytes() == bound.log_likelihood(batch).tobytes()


def test_a_place_in_the_sky_with_a_time_at_a_detector(analysis):
    frame = DetectorFrame(analysis, time_reference="V1")
    found = frame.to_sky({"ra": TRUTH.right_ascension, "dec": TRUTH.declination, "V1_time": TRIGGER + 0.01})
    ifo = bilby.gw.detector.get_empty_interferometer("V1")
    delay = ifo.time_delay_from_geocenter(TRUTH.right_ascension, TRUTH.declination, TRIGGER + 0.01)
    assert found["coalescence_time"] == pytest.approx(0.01 - delay, abs=3e-7)


def test_what_is_no_frame_is_refused(analysis):
    for frame in ("H1K1", "K1L1", "H1H1", "H1", ("H1", "L1", "V1")):
        with pytest.raises(InvalidRequest):
            DetectorFrame(analysis, reference_frame=frame)
    with pytest.raises(InvalidRequest, match="no detector 'K1'"):
        DetectorFrame(analysis, time_reference="K1")
    frame = DetectorFrame(analysis, reference_frame="H1L1", time_reference="H1")
    good = {"zenith": 0.1, "azimuth": 0.2, "H1_time": TRIGGER}
    for bad in (
        {"zenith": 0.1, "H1_time": TRIGGER},
        {"zenith": 0.1, "azimuth": 0.2},
        good | {"ra": 1.0},
        good | {"geocent_time": TRIGGER},
        {"H1_time": TRIGGER},
    ):
        with pytest.raises(InvalidParameters):
            frame.to_sky(bad)
    with pytest.raises(InvalidParameters, match="a mapping or a table"):
        frame.to_sky([1.0])
