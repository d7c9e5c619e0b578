"""Where detectors are and how far the Earth has turned: LAL's numbers, to the bit."""

import math

import lal
import numpy as np
import pytest

from bnserve_inference import Detector, sidereal_time
from bnserve_inference._earth import SITES
from bnserve_protocol import AnalysisInvalid

LEAP_SECOND = 1167264017.0
"""The last one: 2016-12-31 23:59:60."""


@pytest.mark.parametrize("name", sorted(SITES))
def test_detectors_are_those_of_lal(name):
    theirs, ours = lal.cached_detector_by_prefix[name], Detector.named(name)
    assert np.array_equal(ours.response, theirs.response)
    assert np.array_equal(ours.location, theirs.location)


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
