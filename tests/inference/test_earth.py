"""Where detectors are and how far the Earth has turned: LAL's numbers, to the bit."""

import math

import lal
import numpy as np
import pytest

from bnserve_inference import Detector, sidereal_time
from bnserve_inference._earth import SITES
from bnserve_inference._sites import LAL_ARMS
from bnserve_protocol import AnalysisInvalid

LEAP_SECOND = 1167264017.0
"""The last one: 2016-12-31 23:59:60."""


@pytest.mark.parametrize("name", sorted(SITES))
def test_detectors_are_those_of_lal(name):
    theirs, ours = lal.cached_detector_by_prefix[name], Detector.named(name)
    assert np.array_equal(ours.response, theirs.response)
    assert np.array_equal(ours.location, theirs.location)


@pytest.mark.parametrize("name", sorted(LAL_ARMS))
def test_detectors_by_their_coordinates_are_those_of_lal(name):
    theirs = lal.cached_detector_by_prefix[name]
    site = theirs.frDetector
    ours = Detector.at(
        "X1", latitude=site.vertexLatitudeRadians, longitude=site.vertexLongitudeRadians,
        elevation=site.vertexElevation, x_azimuth=site.xArmAzimuthRadians, y_azimuth=site.yArmAzimuthRadians,
        x_altitude=site.xArmAltitudeRadians, y_altitude=site.yArmAltitudeRadians,
    )  # fmt: skip
    assert np.allclose(ours.location, theirs.location, rtol=0.0, atol=0.01)  # metres
    assert np.allclose(ours.response, theirs.response, rtol=0.0, atol=2e-7)  # theirs is in single precision
    long = Detector.named(name, finite_arms=True)
    assert np.array_equal(long.response, theirs.response)
    x, y = (arm / np.linalg.norm(arm) for arm in long.arms)
    assert np.allclose(0.5 * (np.outer(x, x) - np.outer(y, y)), theirs.response, rtol=0.0, atol=2e-7)
    midpoints = site.xArmMidpoint + site.yArmMidpoint
    assert np.allclose(np.linalg.norm(long.arms, axis=1), midpoints, rtol=1e-6, atol=0.0)


@pytest.mark.parametrize("prefix", ["ETS", "ETM"])
def test_a_triangle_is_closed(prefix):
    corners = [Detector.named(f"{prefix}{number}", finite_arms=True) for number in (1, 2, 3)]
    for here, there in zip(corners, corners[1:] + corners[:1], strict=True):
        assert np.allclose(here.location + here.arms[0], there.location, rtol=0.0, atol=1e-6)
        assert np.allclose(np.linalg.norm(here.arms, axis=1), 10000.0)
    assert np.abs(sum(corner.response for corner in corners)).max() < 1e-12


def test_arms_and_places_that_cannot_be_are_refused():
    with pytest.raises(AnalysisInvalid, match="latitude between"):
        Detector.at("X1", latitude=43.0, longitude=0.0, x_azimuth=0.0, y_azimuth=1.5)
    with pytest.raises(AnalysisInvalid, match="arms of X1 are 1e"):
        Detector.at("X1", latitude=0.5, longitude=0.0, x_azimuth=0.0, y_azimuth=1.5, arm_length=1e7)
    with pytest.raises(AnalysisInvalid, match="no arms of the detector V0"):
        Detector.named("V0", finite_arms=True)


def greenwich(gps: float) -> float:
    return lal.GreenwichMeanSiderealTime(lal.LIGOTimeGPS(gps))


def test_the_earth_turns_as_in_lal():
    times = [*np.random.default_rng(1).uniform(32.0, 1.6e9, 500).tolist(), 1187008882.4]
    times += [LEAP_SECOND + after for after in (-1.0, -0.5, 0.0, 0.5, 1.0, 1.5)]
    for gps in times:
        now, rate = sidereal_time(gps)
        assert now == math.fmod(greenwich(gps), 2.0 * math.pi) % (2.0 * math.pi)
        assert rate == (greenwich(gps + 32.0) - greenwich(gps - 32.0)) / 64.0


@pytest.mark.parametrize("gps", [math.nan, math.inf, -1.0, 4e9])
def test_what_is_no_gps_time_is_refused(gps):
    with pytest.raises(AnalysisInvalid, match="seconds from 1980-01-06"):
        sidereal_time(gps)


def test_a_detector_that_is_none_is_refused_with_those_there_are():
    with pytest.raises(AnalysisInvalid, match=r"no detector 'CE'; known are C1, .*H1, .*Give another one's response"):
        Detector.named("CE")
