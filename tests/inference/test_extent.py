"""A signal has to fit into the data: its coalescence, and what comes before it in the band."""

import numpy as np
import pytest

from bnserve_inference import LikelihoodOptions, full_analysis, likelihood, relative_binning_analysis, simulate_data
from bnserve_inference._extent import heaviest, seconds_in_band
from bnserve_protocol import AnalysisInvalid, RowStatus, TimeMarginalisation
from tests.inference.networks import DURATION, F_MAX, F_MIN, START, TRIGGER, TRUTH, asds, columns, full, without
from tests.inference.test_kinds_agree import FIDUCIAL


def short(data, seconds, until=2.0):
    """The last seconds of data before some time after the trigger, with nothing in them."""
    points = round(seconds * 512.0) + 1
    start = TRIGGER + until - seconds
    fields = {"strain": np.zeros(points, complex), "asd": np.full(points, 1e-23), "start_time": start}
    for index in range(len(data)):
        data = without(data, index, duration=seconds, **fields)
    return data


def test_how_long_a_signal_lasts():
    assert seconds_in_band(20.0, 1.1865) == pytest.approx(165.0, rel=0.01)  # GW170817
    assert seconds_in_band(40.0, 1.1865) == pytest.approx(165.0 / 2.0 ** (8.0 / 3.0), rel=0.01)


def test_the_shortest_signal_of_a_prior_is_that_of_the_heaviest_binary():
    assert heaviest({"chirp_mass": (1.1, 1.3)}) == 1.3
    assert heaviest({"total_mass": (2.0, 4.0)}) == pytest.approx(4.0 * 0.25**0.6)
    assert heaviest({"total_mass": (2.0, 4.0), "mass_ratio": (2.0, 3.0)}) == pytest.approx(4.0 * (2.0 / 9.0) ** 0.6)
    assert heaviest({"total_mass": (2.0, 4.0), "chirp_mass": (1.1, 1.3)}) == 1.3
    assert heaviest({}) == 1.75  # of neutron stars


@pytest.mark.parametrize("prior", [{}, {"chirp_mass": (1.18, 1.2)}, {"total_mass": (2.7, 2.8)}])
def test_four_seconds_of_data_for_a_signal_of_165_are_refused(data, prior):
    with pytest.raises(
        AnalysisInvalid, match=r"lasts .* s .*, and the data of H1 begin 2 s before the coalescence"
    ) as caught:
        full_analysis(
            short(data, 4.0), trigger_time=TRIGGER, f_min=20.0, f_max=200.0, options=LikelihoodOptions(prior=prior)
        )
    assert caught.value.errors[0].parameter == "f_min"


def test_the_error_says_from_where_it_would_fit(data):
    prior = {"chirp_mass": (1.18, 1.2)}
    settings = {"trigger_time": TRIGGER, "f_max": 200.0, "options": LikelihoodOptions(prior=prior)}
    with pytest.raises(AnalysisInvalid, match=r"begin the band at 103\.9 Hz"):
        full_analysis(short(data, 4.0), f_min=20.0, **settings)
    assert full_analysis(short(data, 4.0), f_min=104.0, **settings).settings.f_min == 104.0


def test_what_has_no_weight_need_not_fit(data):
    some = short(data, 4.0)
    for index in range(len(some)):
        some = without(some, index, asd=np.where(np.arange(2049) / 4.0 < 80.0, np.inf, 1e-23))
    assert full_analysis(some, trigger_time=TRIGGER, f_min=20.0, f_max=200.0).settings.f_min == 20.0


def test_every_detector_has_to_hold_the_signal_from_its_own_lowest_frequency_on(data):
    settings = {"trigger_time": TRIGGER, "f_min": 60.0, "f_max": 200.0}
    full_analysis(short(data, 16.0), **settings)
    late = without(short(data, 16.0), 2, start_time=TRIGGER - 1.0)
    with pytest.raises(AnalysisInvalid, match="the data of V1 begin 1 s before"):
        full_analysis(late, **settings)
    full_analysis(without(late, 2, start_time=TRIGGER - 1.0, f_min=150.0), **settings)


def test_modes_that_pass_a_frequency_earlier_last_longer(data):
    settings = {"trigger_time": TRIGGER, "f_min": 60.0, "f_max": 200.0}
    for modes in (None, [(2, 2), (4, 4)], [(2, 1)]):
        full_analysis(short(data, 6.0), **settings, options=LikelihoodOptions(modes=modes))
    with pytest.raises(AnalysisInvalid, match="in modes of m = 4, and the data of H1 begin 4 s before"):
        full_analysis(short(data, 6.0), **settings, options=LikelihoodOptions(modes=[(4, 4)]))


def test_relative_binning_takes_the_fiducial_signal(model, data):
    with pytest.raises(AnalysisInvalid, match=r"chirp mass 1\.\d+ Msun lasts"):
        relative_binning_analysis(
            short(data, 4.0), trigger_time=TRIGGER, f_min=20.0, f_max=200.0, fiducial=FIDUCIAL, model=model,
            options=LikelihoodOptions(prior={"coalescence_time": (-0.1, 0.1)}),
        )  # fmt: skip


OUTSIDE = {
    "before the data": (-20.0, 0.1),
    "after the data": (0.0, 10.0),
    "not a number": (float("nan"), 0.1),
    "up to nothing": (0.0, float("nan")),
    "reversed": (0.1, -0.1),
}


@pytest.mark.parametrize("times", OUTSIDE.values(), ids=OUTSIDE)
def test_coalescence_times_that_are_no_range_inside_of_the_data_are_refused(model, data, times):
    prior = {"coalescence_time": times}
    with pytest.raises(AnalysisInvalid, match=r"beyond the data of H1|finite and increasing"):
        full(data, prior=prior)
    with pytest.raises(AnalysisInvalid, match=r"beyond the data of H1|finite and increasing"):
        relative_binning_analysis(
            data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, fiducial=FIDUCIAL, model=model,
            options=LikelihoodOptions(prior=prior),
        )  # fmt: skip


def test_a_trigger_outside_of_the_data_is_refused(data):
    for trigger in (START - 1.0, START + DURATION + 1.0, float("nan")):
        with pytest.raises(AnalysisInvalid, match="beyond the data of H1"):
            full_analysis(data, trigger_time=trigger, f_min=F_MIN, f_max=F_MAX)


def test_an_integral_over_times_outside_of_the_data_is_refused(data):
    times = TimeMarginalisation(minimum=-0.1, maximum=5.0)
    with pytest.raises(AnalysisInvalid, match="beyond the data of H1"):
        full(data, prior={}, time_marginalisation=times)


def test_samples_that_coalesce_outside_of_the_data_are_out_of_the_prior_where_it_is_silent(model, data):
    ours = likelihood(model, full(data, prior={}))
    batch = columns(3) | {"coalescence_time": np.array([-12.5, 0.0, 3.6])}
    assert ours.evaluate(batch).status.tolist() == [RowStatus.OUT_OF_PRIOR, 0, RowStatus.OUT_OF_PRIOR]


def test_a_signal_is_not_put_into_data_that_end_before_it(model):
    settings = {"model": model, "parameters": TRUTH, "duration": DURATION, "seed": None, "f_min": F_MIN}
    for start in (TRIGGER + 1.0, TRIGGER - DURATION - 1.0):
        with pytest.raises(AnalysisInvalid, match="after the start of data that last 16 s"):
            simulate_data(["H1"], asds()[:1], trigger_time=TRIGGER, start_time=start, **settings)
    with pytest.raises(AnalysisInvalid, match="positive number of seconds"):
        simulate_data(["H1"], asds()[:1], trigger_time=TRIGGER, start_time=START, **(settings | {"duration": 0.0}))
