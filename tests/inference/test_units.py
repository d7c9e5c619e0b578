"""Everything that an analysis is built from may carry a unit: the analysis is the same to the bit, or refused."""

import astropy.units as u
import numpy as np
import pandas as pd
import pytest
from astropy.time import Time

from bnserve_inference import (
    Detector,
    DetectorData,
    LikelihoodOptions,
    antenna_pattern,
    detector_strain,
    fourier_strain,
    full_analysis,
    gaussian_noise,
    gwosc_segment,
    interpolate_asd,
    read_asd,
    relative_binning_analysis,
    sidereal_time,
    simulate_data,
    time_delay,
)
from bnserve_inference.roq import PriorNotCovered, load_shipped_basis
from bnserve_protocol import (
    Analysis,
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    ParametersWithExtrinsic,
    TimeMarginalisation,
)
from tests.inference.networks import DURATION, F_MAX, F_MIN, PRIOR, START, TRIGGER, TRUTH, full, network

ASD = u.Hz**-0.5


@pytest.fixture(scope="module")
def data(model):
    return network(model, ("H1", "L1"))


def carrying(one, **changes):
    """The data of a detector as quantities, in units that are a power of two from ours so that nothing is rounded."""
    given = {
        "strain": (one.strain * 2.0**-10) * u.def_unit("blink", 2**10 / u.Hz),
        "asd": (one.asd * 2.0**10) * u.def_unit("hush", 2**-10 * ASD),
        "start_time": one.start_time * u.s,
        "duration": one.duration / 4.0 * u.def_unit("four", 4 * u.s),
    } | changes
    return DetectorData(one.detector, **given)


def test_data_that_carries_units_is_the_same_data(data):
    for one in data:
        there = carrying(one)
        assert (type(there.strain), type(there.asd)) == (np.ndarray, np.ndarray)
        assert there.strain.tobytes() == one.strain.tobytes()
        assert there.asd.tobytes() == one.asd.tobytes()
        assert (there.start_time, there.duration) == (one.start_time, one.duration)


def test_an_analysis_of_what_carries_units_is_the_same_analysis(data):
    options = LikelihoodOptions(
        prior={
            "coalescence_time": np.array([-50.0, 50.0]) * 1e-3 * u.s,
            "total_mass": (2.0 * u.solMass, 4.0 * u.solMass),
        },
        phase_marginalisation=np.True_,
        distance_marginalisation=DistanceMarginalisation(minimum=np.int64(10), maximum=0.25 * u.Gpc),
        calibration=Calibration(nodes=np.int64(5), f_min=np.float32(40), f_max=0.5 * u.kHz),
    )
    there = full_analysis(
        [carrying(one) for one in data],
        trigger_time=np.array(TRIGGER), f_min=0.04 * u.kHz, f_max=np.int64(F_MAX), options=options,
    )  # fmt: skip
    here = full(
        data,
        prior=PRIOR | {"total_mass": (2.0, 4.0)},
        phase_marginalisation=True,
        distance_marginalisation=DistanceMarginalisation(minimum=10.0, maximum=250.0),
        calibration=Calibration(nodes=5, f_min=40.0, f_max=500.0),
    )
    assert there.digest == here.digest


def test_relative_binning_takes_units_too(model, data):
    fiducial = ParametersWithExtrinsic.gw170817()
    options = LikelihoodOptions(prior=PRIOR)
    common = {"fiducial": fiducial, "model": model, "options": options}
    here = relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, phase_tolerance=0.5, **common
    )
    there = relative_binning_analysis(
        data, trigger_time=TRIGGER * u.s, f_min=F_MIN * u.Hz, f_max=0.5 * u.kHz, phase_tolerance=0.5 * u.rad, **common
    )
    assert there.digest == here.digest


def test_simulated_data_takes_units_too(model, data):
    there = simulate_data(
        ("H1",), [data[0].asd * ASD], model=model, parameters=TRUTH, seed=11,
        trigger_time=TRIGGER * u.s, start_time=START * u.s, duration=DURATION * u.s, f_min=0.03 * u.kHz,
    )  # fmt: skip
    assert there[0].strain.tobytes() == network(model, ("H1",))[0].strain.tobytes()


def test_noise_curves_take_units_too(tmp_path):
    f, values = np.geomspace(20.0, 600.0, 50), np.geomspace(1e-22, 1e-23, 50)
    here = interpolate_asd(f, values, 4.0, 2049)
    carried = interpolate_asd(f * u.Hz, pd.Series(values), 4.0 * u.s, 2049), interpolate_asd(f, values * ASD, 4, 2049)
    assert all(there.tobytes() == here.tobytes() for there in carried)
    np.savetxt(tmp_path / "asd.txt", np.column_stack([f, values]))
    assert (
        read_asd(tmp_path / "asd.txt", 4.0 * u.s, 2049).tobytes() == read_asd(tmp_path / "asd.txt", 4.0, 2049).tobytes()
    )
    assert gaussian_noise(here * ASD, 4.0 * u.s, 1).tobytes() == gaussian_noise(here, 4.0, 1).tobytes()


def test_samples_take_units_too():
    samples = np.random.default_rng(1).normal(size=4096)
    here = fourier_strain(samples, 1.0 / 1024.0, 0.25)
    there = fourier_strain(samples * u.dimensionless_unscaled, 1.0 / 1024.0 * u.s, 0.25 * u.s)
    assert there.tobytes() == here.tobytes()


def test_places_and_directions_take_units_too(model):
    site = Detector.named("H1")
    moved = Detector("H1", site.response, site.location / 1000.0 * u.km)
    np.testing.assert_allclose(moved.location, site.location, rtol=1e-15)
    assert sidereal_time(TRIGGER * u.s) == sidereal_time(TRIGGER)
    angles = np.array([100.0, -20.0, 30.0, 250.0]) * u.deg
    plain = angles.to_value("rad")
    assert antenna_pattern(site, *angles) == antenna_pattern(site, *plain)
    assert time_delay(site, *angles[[0, 1, 3]]) == time_delay(site, *plain[[0, 1, 3]])
    f = np.array([50.0, 100.0])
    there = detector_strain(site, f * u.Hz, model, TRUTH, trigger_time=TRIGGER * u.s)
    assert there.tobytes() == detector_strain(site, f, model, TRUTH, trigger_time=TRIGGER).tobytes()


MASK = np.arange(16 * 512 + 1) == 1000
BAD_DATA = {
    "a PSD": {"asd": lambda one: one.asd**2 / u.Hz},
    "an ASD without its frequency": {"asd": lambda one: one.asd * u.m},
    "a masked ASD": {"asd": lambda one: np.ma.array(one.asd, mask=MASK)},
    "a complex ASD": {"asd": lambda one: one.asd + 0j},
    "an ASD as text": {"asd": lambda one: one.asd.astype(str)},
    "strain in metres": {"strain": lambda one: one.strain * u.m},
    "masked strain": {"strain": lambda one: np.ma.array(one.strain, mask=MASK)},
    "no strain": {"strain": lambda one: None},
    "a start as a date": {"start_time": lambda one: Time("2017-08-17")},
    "a start in metres": {"start_time": lambda one: one.start_time * u.m},
    "a duration that is true": {"duration": lambda one: True},
    "a duration as text": {"duration": lambda one: "16"},
}


@pytest.mark.parametrize("change", BAD_DATA.values(), ids=BAD_DATA)
def test_data_that_is_no_numbers_or_has_another_unit_is_refused_by_name(data, change):
    [(name, spoilt)] = change.items()
    with pytest.raises(AnalysisInvalid, match=f"'{name}' must be numbers in .*; it ") as raised:
        carrying(data[0], **{name: spoilt(data[0])})
    assert raised.value.errors[0].parameter == name


@pytest.mark.parametrize(
    "times", [(-0.05, None), ("a", "b"), (-1.0 * u.m, 1.0 * u.m), (True, False), (0.0, 0.1, 0.2), 0.1]
)
def test_prior_ranges_that_are_none_are_refused_by_name(times):
    with pytest.raises(AnalysisInvalid, match="coalescence_time"):
        LikelihoodOptions(prior={"coalescence_time": times})


def test_settings_that_are_no_numbers_are_refused_by_name(data):
    for name, value in {"trigger_time": TRIGGER * u.m, "f_min": "40", "f_max": np.ma.masked}.items():
        settings = {"trigger_time": TRIGGER, "f_min": F_MIN, "f_max": F_MAX} | {name: value}
        with pytest.raises(AnalysisInvalid, match=f"'{name}' must be numbers in"):
            full_analysis(data, **settings, options=LikelihoodOptions(prior=PRIOR))
    with pytest.raises(AnalysisInvalid, match="'minimum' of TimeMarginalisation must be a number in s; it"):
        TimeMarginalisation(minimum=-1.0 * u.m, maximum=1.0, step=0.1)
    with pytest.raises(AnalysisInvalid, match="'start_time' must be numbers in s"):
        gwosc_segment("nothing", "now", 4.0)


def test_arrays_of_an_analysis_are_numbers(data):
    analysis = full(data)

    def with_(name, change):
        return Analysis(settings=analysis.settings, arrays={**analysis.arrays, name: change(analysis.arrays[name])})

    assert with_("location/H1", lambda metres: metres / 1000.0 * u.km).arrays["location/H1"] == pytest.approx(
        analysis.arrays["location/H1"], rel=1e-15
    )
    changes = {
        "location/H1": lambda metres: metres * u.s,
        "linear_weights/H1": lambda weights: weights * u.Hz,
        "quadratic_weights/H1": lambda weights: np.ma.array(weights, mask=weights > 0.0),
        "response/H1": lambda response: response > 0.0,
    }
    for name, change in changes.items():
        with pytest.raises(AnalysisInvalid, match=f"Array '{name}' of the analysis must hold numbers; it"):
            with_(name, change)


def test_ranges_that_a_basis_is_to_cover_take_units_too():
    basis = load_shipped_basis("gw170817")
    basis.check_prior({"chirp_mass": [1.197, 1.198] * u.M_sun, "lambda_1": (5.0, 1e5 * u.percent)})
    with pytest.raises(PriorNotCovered, match=r"'chirp_mass' needs 1\.197 to 1\.2, "):
        basis.check_prior({"chirp_mass": (1.197 * u.M_sun, (1.2 * u.M_sun).to(u.kg))})
    with pytest.raises(AnalysisInvalid, match="'chirp_mass' must be numbers in Msun; it has the unit"):
        basis.check_prior({"chirp_mass": (1.197 * u.Hz, 1.198 * u.Hz)})
