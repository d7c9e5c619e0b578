"""Where detectors and binaries may be in a forecast, and when."""

import dataclasses

import numpy as np
import pytest

from bnserve_inference import Detector
from bnserve_inference.fisher import ForecastOptions, Network, forecast, signal_to_noise
from bnserve_protocol import AnalysisInvalid, InvalidRequest, LikelihoodBatch, RowStatus
from bnserve_surrogate import Model
from tests.inference.fisher.test_forecast import BINARY, TRIGGER, curve, network


@pytest.fixture(scope="module")
def model():
    return Model.load("default", "2.0.0")


NO_PLACES = {
    "declination": [9.0, -1.5709],
    "right_ascension": [1e7, -1e300],
    "inclination": [1e7],
    "coalescence_time": [1e12, -TRIGGER - 1.0, 1e300],
}


@pytest.mark.parametrize("name", NO_PLACES)
def test_binaries_without_a_place_or_a_time_are_flagged_and_the_others_are_as_they_are(model, name):
    values = NO_PLACES[name]
    batch = LikelihoodBatch(np.repeat(LikelihoodBatch.coerce(BINARY).values, 2 + len(values), axis=0))
    batch[name][1:-1] = values
    expected = [RowStatus.OK, *[RowStatus.OUT_OF_DOMAIN] * len(values), RowStatus.OK]
    options = ForecastOptions(modes=[(2, 2)])
    for found in (forecast(model, network(), batch, options), signal_to_noise(model, network(), batch, options)):
        assert found.status.tolist() == expected
        assert np.isnan(found.snr).tolist() == [status != RowStatus.OK for status in expected]
    assert np.isnan(forecast(model, network(), batch, options).sky_area(batch["declination"])).sum() == len(values)
    alone = forecast(model, network(), BINARY, options)
    assert alone.root[0].tobytes() == forecast(model, network(), batch, options).root[-1].tobytes()
    poles = dataclasses.replace(BINARY, declination=0.5 * np.pi), dataclasses.replace(BINARY, declination=-0.5 * np.pi)
    assert forecast(model, network(), poles, options).status.tolist() == [0, 0]


@pytest.mark.parametrize("years", [-1.0, 1.0, 10.0])
def test_detectors_have_turned_as_far_years_after_the_trigger_as_they_have_then(model, years):
    """By the formula of sidereal time, which the trigger's rate is a derivative of."""
    later = years * 365.25 * 86400.0
    start, options = 1.5e9, ForecastOptions(modes=[(2, 2)])
    curves = [curve(), curve()]
    then, now = (Network(["CE40", "L1"], curves, 20.0, 1000.0, start + at) for at in (later, 0.0))
    one = forecast(model, then, dataclasses.replace(BINARY, coalescence_time=0.0), options)
    other = forecast(model, now, dataclasses.replace(BINARY, coalescence_time=later), options)
    assert other.detector_snr == pytest.approx(one.detector_snr, rel=1e-7)
    assert other.errors()["right_ascension"] == pytest.approx(one.errors()["right_ascension"], rel=1e-6)


def test_a_detector_counts_once_and_two_at_one_place_count_both(model):
    for twice in (["E1", "H1", "E1"], [Detector.named("E1"), "E1"]):
        with pytest.raises(AnalysisInvalid, match=r"distinct names .* got 'E1' 2 times"):
            network(twice)
    site = Detector.named("E1")
    with pytest.raises(AnalysisInvalid, match=r"distinct names .* got 'E 1'"):
        network([Detector("E 1", site.response, site.location)])
    beside = Detector("E1-beside", site.response, site.location)
    one, both = (signal_to_noise(model, network(sites), BINARY) for sites in (["E1"], ["E1", beside]))
    assert both.snr == pytest.approx(np.sqrt(2.0) * one.snr, rel=1e-14)


def test_how_far_a_binary_is_changes_nothing_else(model):
    """Up to where its strain is no number any more: neither rounding nor a slope that underflows."""
    options = ForecastOptions(modes=[(2, 2)])
    near, far = (
        forecast(model, network(), dataclasses.replace(BINARY, distance_mpc=d), options) for d in (1e-20, 1e20)
    )
    assert far.condition == pytest.approx(near.condition, rel=1e-6)
    batch = LikelihoodBatch(np.repeat(LikelihoodBatch.coerce(BINARY).values, 2, axis=0))
    batch["distance_mpc"][1] = 1e300
    found = forecast(model, network(), batch, options)
    assert found.singular.tolist() == [False, True]
    assert found.status.tolist() == [RowStatus.OK, RowStatus.NOT_FINITE]


def test_a_prior_so_narrow_that_its_weight_is_no_number_is_refused(model):
    for width in (1e-160, 5e-324):
        with pytest.raises(InvalidRequest, match="1e-100 or more"):
            forecast(model, network(), BINARY, ForecastOptions(priors={"chi_1": width}))
    fixed = forecast(model, network(), BINARY, ForecastOptions(priors={"chi_1": 1e-100}))
    assert fixed.errors()["chi_1"][0] == pytest.approx(1e-100)
