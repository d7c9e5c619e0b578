"""The likelihood on the full grid, and all that goes into it, against bilby 2.8."""

import logging
import warnings

import numpy as np
import pytest
from scipy import integrate

from bnserve_inference import Detector, antenna_pattern, calibration_nodes, likelihood, sidereal_time, time_delay
from bnserve_inference._calibration import calibration_splines
from bnserve_protocol import (
    Calibration,
    EvaluationOptions,
    ParameterBatch,
    TimeMarginalisation,
)
from tests.inference.networks import (
    DETECTORS,
    DURATION,
    F_MAX,
    F_MIN,
    PRIOR,
    START,
    TRIGGER,
    columns,
    full,
    network,
)

pytestmark = pytest.mark.filterwarnings("default")  # of bilby and what it imports
SAMPLING = 1024.0
NAMES = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination", "total_mass")


@pytest.fixture(scope="module")
def bilby():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        module = pytest.importorskip("bilby")
        import bilby.gw  # noqa: F401
    logging.getLogger("bilby").setLevel(logging.ERROR)
    return module


@pytest.fixture(scope="module")
def sites(bilby):
    """Our detectors with bilby's tensors and places, which are LAL's beyond the digits that LAL keeps."""
    found = []
    for name in DETECTORS:
        theirs = bilby.gw.detector.get_empty_interferometer(name)
        found.append(Detector(name, response=np.array(theirs.detector_tensor), location=np.array(theirs.vertex)))
    return found


@pytest.fixture(scope="module")
def same_data(model, sites):
    return network(model, sites)


def interferometers(bilby, data, calibration=None):
    found = bilby.gw.detector.InterferometerList(list(DETECTORS))
    for theirs, ours in zip(found, data, strict=True):
        theirs.minimum_frequency, theirs.maximum_frequency = F_MIN, F_MAX
        grid = np.arange(len(ours.strain)) / DURATION
        theirs.set_strain_data_from_frequency_domain_strain(ours.strain, frequency_array=grid, start_time=START)
        theirs.power_spectral_density = bilby.gw.detector.PowerSpectralDensity(grid, asd_array=ours.asd)
        if calibration is not None:
            theirs.calibration_model = bilby.gw.calibration.CubicSpline(
                f"recalib_{theirs.name}_", F_MIN, F_MAX, calibration.nodes
            )
    return found


def their_likelihood(bilby, model, data, calibration=None, **marginalised):
    def source(
        frequency_array,
        mass_ratio,
        lambda_1,
        lambda_2,
        chi_1,
        chi_2,
        distance_mpc,
        inclination,
        total_mass,
        reference_phase,
        **unused,  # what bilby adds
    ):  # bilby reads the names of the arguments
        parameters = dict(locals())
        band = (frequency_array >= F_MIN - 1e-9) & (frequency_array <= F_MAX + 1e-9)
        batch = ParameterBatch.coerce({name: parameters[name] for name in NAMES} | {"reference_phase": reference_phase})
        strain = model.predict_batch(frequency_array[band], batch, options=EvaluationOptions(alignment="merger"))
        found = {"plus": np.zeros(len(band), complex), "cross": np.zeros(len(band), complex)}
        found["plus"][band], found["cross"][band] = strain.plus[0], strain.cross[0]
        return found

    generator = bilby.gw.WaveformGenerator(
        duration=DURATION,
        sampling_frequency=SAMPLING,
        start_time=START,
        frequency_domain_source_model=source,
        parameter_conversion=lambda parameters: (parameters, []),
    )
    priors = bilby.core.prior.PriorDict(
        {
            "geocent_time": bilby.core.prior.Uniform(
                TRIGGER + PRIOR["coalescence_time"][0], TRIGGER + PRIOR["coalescence_time"][1]
            ),
            "phase": bilby.core.prior.Uniform(0, 2 * np.pi),
        }
    )
    return bilby.gw.GravitationalWaveTransient(
        interferometers(bilby, data, calibration), generator, priors=priors, jitter_time=False, **marginalised
    )


def their_value(likelihood, row):
    parameters = {name: row[name] for name in (*NAMES, "reference_phase")}
    parameters |= {
        "ra": row["right_ascension"],
        "dec": row["declination"],
        "psi": row["polarization_angle"],
        "geocent_time": TRIGGER + row["coalescence_time"],
        "phase": 0.0,
        "luminosity_distance": row["distance_mpc"],
    }
    parameters |= {name: value for name, value in row.items() if name.startswith("recalib")}
    return likelihood.log_likelihood_ratio(parameters)


def rows_of(batch):
    return [dict(zip(batch, values, strict=True)) for values in zip(*batch.values(), strict=True)]


def test_antenna_patterns_delays_and_sidereal_time_are_theirs(bilby, sites):
    draw = np.random.default_rng(0)
    for site in sites:
        theirs = bilby.gw.detector.get_empty_interferometer(site.name)
        for ra, dec, psi, time in draw.uniform((0, -1.5, 0, 1.1e9), (6.3, 1.5, 3.1, 1.4e9), (20, 4)):
            sidereal = sidereal_time(time)[0]
            plus, cross = antenna_pattern(site, ra, dec, psi, sidereal)
            assert plus == pytest.approx(theirs.antenna_response(ra, dec, time, psi, "plus"), abs=1e-11)
            assert cross == pytest.approx(theirs.antenna_response(ra, dec, time, psi, "cross"), abs=1e-11)
            delay = time_delay(site, ra, dec, sidereal)
            assert delay == pytest.approx(theirs.time_delay_from_geocenter(ra, dec, time), abs=1e-11)


def test_named_detectors_are_theirs_to_the_digits_that_lal_keeps(sites):
    for site in sites:
        named = Detector.named(site.name)
        assert np.abs(named.response - site.response).max() < 3e-8
        assert np.abs(named.location - site.location).max() < 1e-5  # ten micrometres


def test_the_rate_of_sidereal_time_is_good_for_the_times_around_a_trigger():
    now, rate = sidereal_time(TRIGGER)
    for offset in (-10.0, 0.1, 10.0):
        there = sidereal_time(TRIGGER + offset)[0]
        assert (now + rate * offset - there + np.pi) % (2.0 * np.pi) - np.pi == pytest.approx(
            0.0, abs=5e-9
        )  # LAL's own steps


def test_calibration_splines_are_theirs(bilby):
    calibration = Calibration(nodes=10, f_min=F_MIN, f_max=F_MAX)
    draw = np.random.default_rng(1)
    amplitude, phase = draw.normal(0.0, 0.1, (2, 10))
    theirs = bilby.gw.calibration.CubicSpline("", F_MIN, F_MAX, 10)
    frequencies = np.linspace(30.0, 600.0, 1000)  # also beyond the ends
    values = {f"amplitude_{i}": amplitude[i] for i in range(10)} | {f"phase_{i}": phase[i] for i in range(10)}
    factor = theirs.get_calibration_factor(frequencies, prefix="", **values)
    splines = calibration_splines(calibration, frequencies)
    a, p = amplitude @ splines, phase @ splines
    np.testing.assert_allclose((1 + a) * (2 + 1j * p) / (2 - 1j * p), factor, rtol=1e-11)
    np.testing.assert_allclose(np.log10(calibration_nodes(calibration)), theirs.log_spline_points, rtol=1e-13)


def test_the_full_likelihood_is_theirs(bilby, model, same_data):
    batch = columns(12)
    theirs = their_likelihood(bilby, model, same_data)
    analysis = full(same_data)
    ours = likelihood(model, analysis).log_likelihood(batch)
    np.testing.assert_allclose(ours, [their_value(theirs, row) for row in rows_of(batch)], atol=2e-7)
    assert analysis.settings.noise_log_likelihood == pytest.approx(theirs.noise_log_likelihood(), rel=1e-12)


def test_the_phase_is_marginalised_as_theirs(bilby, model, same_data):
    batch = columns(6)
    theirs = their_likelihood(bilby, model, same_data, phase_marginalization=True)
    ours = likelihood(model, full(same_data, phase_marginalisation=True)).log_likelihood(batch)
    np.testing.assert_allclose(ours, [their_value(theirs, row) for row in rows_of(batch)], atol=2e-7)


@pytest.mark.parametrize("phase", [False, True])
def test_the_time_is_integrated_over_as_their_likelihood_says(bilby, model, same_data, phase):
    """Their own sum over times takes steps of 1 / sampling frequency, which at this band and loudness is 20 off."""
    times = TimeMarginalisation(minimum=-0.001, maximum=0.006)
    theirs = their_likelihood(bilby, model, same_data, phase_marginalization=phase)
    analysis = full(same_data, time_marginalisation=times, phase_marginalisation=phase)
    batch = columns(2, width=0.1)
    ours = likelihood(model, analysis).log_likelihood(batch)
    steps = 2**9  # of 14 microseconds; a GPS time has some of 0.24
    at = np.round(np.linspace(times.minimum, times.maximum, steps + 1) * 2.0**22) / 2.0**22
    for value, row in zip(ours, rows_of(batch), strict=True):
        log_l = np.array([their_value(theirs, row | {"coalescence_time": float(time)}) for time in at])
        integral = integrate.simpson(np.exp(log_l - log_l.max()), x=at)
        assert value == pytest.approx(log_l.max() + np.log(integral / (at[-1] - at[0])), abs=1e-3)


def test_calibration_errors_act_as_theirs(bilby, model, same_data):
    calibration = Calibration(nodes=10, f_min=F_MIN, f_max=F_MAX)
    draw = np.random.default_rng(4)
    batch = columns(3)
    errors = {name: draw.normal(0.0, 0.05, (2, 3, 10)) for name in DETECTORS}
    theirs = their_likelihood(bilby, model, same_data, calibration)
    expected = []
    for index, row in enumerate(rows_of(batch)):
        named = {
            f"recalib_{name}_{kind}_{node}": errors[name][which, index, node]
            for name in DETECTORS
            for which, kind in enumerate(("amplitude", "phase"))
            for node in range(10)
        }
        expected.append(their_value(theirs, row | named))
    given = {
        "calibration_amplitude": {name: errors[name][0] for name in DETECTORS},
        "calibration_phase": {name: errors[name][1] for name in DETECTORS},
    }
    ours = likelihood(model, full(same_data, calibration=calibration)).log_likelihood(batch | given)
    np.testing.assert_allclose(ours, expected, atol=2e-7)
    assert np.abs(ours - likelihood(model, full(same_data)).log_likelihood(batch)).min() > 0.01
