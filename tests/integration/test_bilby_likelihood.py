"""A service's likelihood as bilby's: made of its detectors and priors, the same value, and all that it can do."""

import copy
import multiprocessing
import pickle

import bilby
import numpy as np
import pandas as pd
import pytest
from bilby.core.prior import Constraint, PowerLaw, Sine, TruncatedGaussian, Uniform
from bilby.gw.prior import UniformComovingVolume, UniformSourceFrame

from bnserve_client import InvalidRequest, _chosen
from bnserve_client.bilby import ServiceLikelihood, binary_neutron_star
from bnserve_client.bilby._ranges import prior_ranges
from bnserve_protocol import PackageMissing
from tests.integration.test_bilby_source import QUADRUPOLE, SIGNAL, generator, network

pytestmark = pytest.mark.filterwarnings("default")  # of bilby and what it imports

WHEN = SIGNAL["geocent_time"]
NEAR = Uniform(WHEN - 0.01, WHEN + 0.01)
LALS = {"waveform_approximant": "IMRPhenomPv2_NRTidal"}


def priors(**others):
    """Around the signal, in chirp mass and mass ratio."""
    return bilby.gw.prior.BNSPriorDict(
        dictionary={
            **bilby.gw.prior.BNSPriorDict(),
            "chirp_mass": Uniform(1.2135, 1.2165),
            "mass_ratio": Uniform(0.5, 1.0),
            "chi_1": Uniform(-0.05, 0.05),
            "chi_2": Uniform(-0.05, 0.05),
            "geocent_time": NEAR,
            **others,
        }
    )


def samples(count, seed=5):
    """Of a posterior: off the signal by about as much as is known of it."""
    random = np.random.default_rng(seed)
    widths = {"mass_1": 1e-5, "lambda_1": 30.0, "phase": 0.1, "geocent_time": 1e-4, "ra": 0.01, "theta_jn": 0.1,
              "luminosity_distance": 5.0}  # fmt: skip
    return [SIGNAL | {name: SIGNAL[name] + width * random.normal() for name, width in widths.items()}
            for _ in range(count)]  # fmt: skip


@pytest.fixture(scope="module")
def arguments(bnserve_server):
    return {"bnserve_url": bnserve_server.address, "minimum_frequency": 40.0, "reference_frequency": 50.0}


@pytest.fixture(scope="module")
def data(arguments):
    return network(generator(binary_neutron_star, **arguments))


@pytest.fixture(scope="module")
def binned(data, arguments):
    return ServiceLikelihood.from_bilby(
        data, priors(), waveform_arguments=arguments, fiducial_parameters=SIGNAL
    )  # fmt: skip


@pytest.fixture(scope="module")
def sampled(data, arguments):
    """On the full grid, with nothing integrated."""
    return ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments)


# The same value as by the source model


@pytest.mark.parametrize("zero_points", [{}, LALS], ids=["own", "LAL's"])
@pytest.mark.parametrize("fiducial", [None, SIGNAL], ids=["full grid", "relative binning"])
def test_both_routes_agree(data, arguments, zero_points, fiducial):
    waveforms = generator(binary_neutron_star, **arguments, **zero_points)
    theirs = bilby.gw.GravitationalWaveTransient(data, waveforms)
    ours = ServiceLikelihood.from_bilby(
        data, priors(), waveform_arguments=arguments | zero_points, fiducial_parameters=fiducial
    )
    expected = [theirs.log_likelihood_ratio(sample) for sample in samples(20)]
    np.testing.assert_allclose(ours.log_likelihood_ratios(samples(20)), expected, rtol=0.0, atol=0.05)
    assert ours.noise_log_likelihood() == pytest.approx(theirs.noise_log_likelihood(), rel=1e-12)
    assert ours.log_likelihood(SIGNAL) == ours.log_likelihood_ratio(SIGNAL) + ours.noise_log_likelihood()


DISTANCES = {
    "a power": lambda: PowerLaw(2.0, 20.0, 100.0),
    "uniform in the source frame": lambda: UniformSourceFrame(20.0, 100.0, name="luminosity_distance"),
    "uniform in the comoving volume": lambda: UniformComovingVolume(20.0, 2000.0, name="luminosity_distance"),
    "a Gaussian": lambda: TruncatedGaussian(45.0, 10.0, 20.0, 100.0, name="luminosity_distance"),
}


@pytest.mark.parametrize("what", ["phase", "distance"])
def test_integrals_agree(data, arguments, what):
    """With bilby's, over the distance up to its table; over the phase its rule is for m = 2."""
    arguments = arguments | QUADRUPOLE
    prior = priors(luminosity_distance=DISTANCES["uniform in the source frame"]())
    options = {f"{what}_marginalization": True}
    ours = ServiceLikelihood.from_bilby(
        data, prior, waveform_arguments=arguments, fiducial_parameters=SIGNAL, **options
    )
    same = priors(luminosity_distance=DISTANCES["uniform in the source frame"]())
    theirs = bilby.gw.GravitationalWaveTransient(
        data, generator(binary_neutron_star, **arguments), priors=same, jitter_time=False, **options
    )
    name = {"phase": "phase", "distance": "luminosity_distance"}[what]
    assert float(prior[name]) == float(same[name])  # what is integrated over is fixed, in bilby's manner
    sample = SIGNAL | {name: float(prior[name])}
    assert ours.log_likelihood_ratio(sample) == pytest.approx(theirs.log_likelihood_ratio(sample), abs=0.05)


@pytest.mark.parametrize("distances", DISTANCES)
def test_a_prior_of_the_distance_is_bilbys(sampled, data, arguments, distances):
    """By sums over bilby's own density."""
    prior = DISTANCES[distances]()
    ours = ServiceLikelihood.from_bilby(
        data, priors(luminosity_distance=DISTANCES[distances]()), waveform_arguments=arguments,
        distance_marginalization=True,
    )  # fmt: skip
    at = np.geomspace(prior.minimum, prior.maximum, 501)
    values = sampled.log_likelihood_ratios(SIGNAL | {"luminosity_distance": at})
    expected = values.max() + np.log(np.trapezoid(np.exp(values - values.max()) * prior.prob(at), at))
    assert ours.log_likelihood_ratio(SIGNAL) == pytest.approx(expected, abs=2e-3)


def test_a_prior_of_the_distance_that_cannot_be_integrated_over_is_refused(data, arguments):
    for prior in (PowerLaw(2.0, 0.0, 100.0), 40.0, Sine(name="luminosity_distance", minimum=0.0, maximum=np.pi)):
        with pytest.raises(InvalidRequest, match="0 < minimum < maximum"):
            ServiceLikelihood.from_bilby(
                data, priors(luminosity_distance=prior), waveform_arguments=arguments, distance_marginalization=True
            )


def test_the_integral_over_the_time_is_the_mean_over_its_prior(binned, data, arguments):
    """bilby's own is a sum in steps of half a millisecond, which is coarser than a loud signal."""
    prior = priors()
    ours = ServiceLikelihood.from_bilby(
        data, prior, waveform_arguments=arguments, fiducial_parameters=SIGNAL, time_marginalization=True
    )
    times = np.linspace(NEAR.minimum, NEAR.maximum, 4001)
    values = binned.log_likelihood_ratios(SIGNAL | {"geocent_time": times})
    mean = np.trapezoid(np.exp(values - values.max()), times) / (NEAR.maximum - NEAR.minimum)
    found = ours.log_likelihood_ratio(SIGNAL | {"geocent_time": float(prior["geocent_time"])})
    assert found == pytest.approx(values.max() + np.log(mean), abs=0.05)


def test_what_is_integrated_over_is_reconstructed_by_bilby(data, arguments):
    arguments = arguments | QUADRUPOLE
    ours = ServiceLikelihood.from_bilby(
        data, priors(luminosity_distance=PowerLaw(2.0, 20.0, 100.0)), waveform_arguments=arguments,
        fiducial_parameters=SIGNAL, phase_marginalization=True, distance_marginalization=True,
    )  # fmt: skip
    bilby.core.utils.random.seed(2)
    found = ours.generate_posterior_sample_from_marginalized_likelihood(
        SIGNAL | {"phase": 0.0, "luminosity_distance": 60.0}
    )
    assert abs(found["luminosity_distance"] - 50.0) < 10.0
    assert np.cos(2.0 * (found["phase"] - SIGNAL["phase"])) > 0.9


def calibrated(data, *names):
    """The data with splines of calibration errors in some of the detectors."""
    changed = copy.deepcopy(data)
    for interferometer in changed:
        if interferometer.name in names:
            spline = bilby.gw.calibration.CubicSpline(f"recalib_{interferometer.name}_", 40.0, 1024.0, 5)
            interferometer.calibration_model = spline
    return changed


@pytest.mark.parametrize("fiducial", [None, SIGNAL], ids=["full grid", "relative binning"])
def test_calibration_errors_are_bilbys(data, arguments, fiducial):
    """Sampled by the names of bilby's priors, which say how large they are."""
    changed, prior = calibrated(data, "H1", "L1", "V1"), priors()
    for name in ("H1", "L1", "V1"):
        prior.update(bilby.gw.prior.CalibrationPriorDict.constant_uncertainty_spline(0.03, 0.02, 40.0, 1024.0, 5, name))
    ours = ServiceLikelihood.from_bilby(changed, prior, waveform_arguments=arguments, fiducial_parameters=fiducial)
    settings = ours.likelihood.analysis.settings.calibration
    assert (settings.nodes, settings.amplitude_width, settings.phase_width) == (5, 0.03, 0.02)
    theirs = bilby.gw.GravitationalWaveTransient(changed, generator(binary_neutron_star, **arguments))
    bilby.core.utils.random.seed(4)
    errors = [{name: value for name, value in prior.sample().items() if "recalib" in name} for _ in range(5)]
    rows = [sample | found for sample, found in zip(samples(5), errors, strict=True)]
    expected = [theirs.log_likelihood_ratio(row) for row in rows]
    np.testing.assert_allclose(ours.log_likelihood_ratios(rows), expected, rtol=0.0, atol=0.05)
    assert np.ptp([ours.log_likelihood_ratio(SIGNAL | found) for found in errors]) > 1.0


# Places and times relative to detectors


@pytest.mark.parametrize(
    ("frame", "reference", "fiducial"),
    [("H1L1", "geocenter", None), ("sky", "L1", None), ("L1V1", "H1", None), ("H1L1", "H1", SIGNAL)],
)
def test_places_and_times_relative_to_detectors_are_bilbys(data, arguments, frame, reference, fiducial):
    name = "geocent_time" if reference == "geocenter" else f"{reference}_time"
    frames = {"reference_frame": frame, "time_reference": reference}
    prior = priors(**{name: NEAR, "zenith": Sine(), "azimuth": Uniform(0.0, 2.0 * np.pi)})
    if name != "geocent_time":
        del prior["geocent_time"]
    ours = ServiceLikelihood.from_bilby(
        data, prior, waveform_arguments=arguments, fiducial_parameters=fiducial, **frames
    )
    theirs = bilby.gw.GravitationalWaveTransient(data, generator(binary_neutron_star, **arguments), **frames)
    random = np.random.default_rng(5)
    for row in samples(6):
        angles = {"zenith": random.uniform(0.1, 3.0), "azimuth": random.uniform(0.0, 6.0)}
        row = row | {name: WHEN + random.uniform(-0.005, 0.005)} | angles
        for other in {"geocent_time"} - {name} | ({"ra", "dec"} if frame != "sky" else {"zenith", "azimuth"}):
            del row[other]
        assert ours.log_likelihood_ratio(row) == pytest.approx(theirs.log_likelihood_ratio(row), abs=0.3, rel=1e-3)
    assert ours.likelihood.counts.out_of_prior == 0


def test_a_time_at_a_detector_is_not_integrated_over(data, arguments):
    prior = priors(H1_time=NEAR)
    del prior["geocent_time"]
    with pytest.raises(InvalidRequest, match="leave out 'time_reference'"):
        ServiceLikelihood.from_bilby(
            data, prior, waveform_arguments=arguments, time_reference="H1", time_marginalization=True
        )


# Parameters and priors


STARS = 400.0, 450.0, 1.5, 1.3
TIDES = {
    "lambda_tilde": bilby.gw.conversion.lambda_1_lambda_2_to_lambda_tilde(*STARS),
    "delta_lambda_tilde": bilby.gw.conversion.lambda_1_lambda_2_to_delta_lambda_tilde(*STARS),
}
CHIRP_MASS = 1.95**0.6 / 2.8**0.2
PARAMETERS = [
    ({"mass_1", "mass_2"}, {"chirp_mass": CHIRP_MASS, "mass_ratio": 1.3 / 1.5}),
    ({"mass_1", "mass_2"}, {"chirp_mass": CHIRP_MASS, "symmetric_mass_ratio": 1.95 / 2.8**2}),
    ({"mass_1", "mass_2"}, {"total_mass": 2.8, "mass_ratio": 1.3 / 1.5}),
    (set(), {"mass_1": 1.3, "mass_2": 1.5, "lambda_1": 450.0, "lambda_2": 400.0}),
    ({"lambda_1", "lambda_2"}, TIDES),
    ({"theta_jn"}, {"cos_theta_jn": np.cos(0.4)}),
    ({"chi_1", "chi_2"}, {"a_1": 0.02, "a_2": 0.02, "tilt_1": 0.0, "tilt_2": 0.0}),
]


@pytest.mark.parametrize(("instead_of", "given"), PARAMETERS)
def test_parameters_are_bilbys(binned, instead_of, given):
    sample = {name: value for name, value in SIGNAL.items() if name not in instead_of} | given
    assert binned.log_likelihood_ratio(sample) == pytest.approx(binned.log_likelihood_ratio(SIGNAL), abs=1e-4)


@pytest.mark.parametrize("zero_points", [{}, LALS], ids=["own", "LAL's"])
def test_a_sample_outside_is_as_in_bilby(data, arguments, zero_points):
    binned = ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments | zero_points)
    outside = [SIGNAL | {"lambda_1": -1.0}, SIGNAL, SIGNAL | {"mass_1": 4.9}, SIGNAL | {"chi_1": np.nan}]
    values = binned.log_likelihood_ratios(outside)
    assert abs(values[1]) < 1e4
    assert (values[[0, 2, 3]] == np.nan_to_num(-np.inf)).all()


def test_samples_may_be_a_table(binned):
    rows = samples(5)
    expected = binned.log_likelihood_ratios(rows)
    np.testing.assert_array_equal(binned.log_likelihood_ratios(pd.DataFrame(rows)), expected)
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    np.testing.assert_array_equal(binned.log_likelihood_ratios(columns), expected)
    assert [binned.log_likelihood_ratio(row) for row in rows] == expected.tolist()


PRIORS = [
    {"chirp_mass": Uniform(1.1, 1.3), "mass_ratio": Uniform(0.4, 1.0)},
    {"mass_1": Uniform(1.2, 2.0), "mass_2": Uniform(1.0, 1.5)},
    {"total_mass": Uniform(2.5, 3.0), "mass_ratio": Uniform(0.5, 0.9)},
    {"chirp_mass": Uniform(1.1, 1.3), "symmetric_mass_ratio": Uniform(0.2, 0.25)},
    {"chirp_mass": Uniform(1.1, 1.3), "mass_ratio": Uniform(0.7, 1.4), "mass_1": Constraint(1.0, 1.6)},
]


@pytest.mark.parametrize("given", PRIORS, ids=lambda given: ", ".join(given))
def test_no_draw_of_a_prior_lies_outside_of_its_ranges(given):
    bilby.core.utils.random.seed(1)
    prior = bilby.gw.prior.BNSPriorDict(dictionary={**given, "geocent_time": NEAR})
    ranges = prior_ranges(prior, WHEN)
    draws = bilby.gw.conversion.generate_mass_parameters(prior.sample(2000))
    draws["mass_ratio"] = np.maximum(draws["mass_ratio"], 1.0 / draws["mass_ratio"])
    for name in ("chirp_mass", "total_mass", "mass_ratio"):
        low, high = ranges[name]
        assert low <= draws[name].min() < low + 0.2 * (high - low)
        assert high - 0.2 * (high - low) < draws[name].max() <= high


def test_a_detector_keeps_its_band_and_its_notches(arguments, data):
    changed = copy.deepcopy(data)
    changed[0].minimum_frequency, changed[1].maximum_frequency = 60.0, 500.0
    changed[2].strain_data.notch_list = [(100.0, 120.0)]
    for interferometer in changed:
        interferometer.strain_data._frequency_mask_updated = False
    waveforms = generator(binary_neutron_star, **arguments)
    theirs = bilby.gw.GravitationalWaveTransient(changed, waveforms)
    ours = ServiceLikelihood.from_bilby(changed, priors(), waveform_arguments=arguments)
    assert ours.log_likelihood_ratio(SIGNAL) == pytest.approx(theirs.log_likelihood_ratio(SIGNAL), abs=1e-3)
    assert ours.log_likelihood_ratio(SIGNAL) < 0.95 * bilby.gw.GravitationalWaveTransient(
        data, waveforms
    ).log_likelihood_ratio(SIGNAL)


def test_what_cannot_be_is_refused_with_what_to_do(data, arguments, monkeypatch):
    with pytest.raises(InvalidRequest, match="and 'waveform_approximant', whose times are others"):
        ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments | LALS, time_marginalization=True)
    with pytest.raises(InvalidRequest, match="no 'geocent_time': give it"):
        ServiceLikelihood.from_bilby(data, bilby.gw.prior.BNSPriorDict(), waveform_arguments=arguments)
    with pytest.raises(InvalidRequest, match="No frequency of the data"):
        ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments | {"minimum_frequency": 2000.0})
    with pytest.raises(InvalidRequest, match="CubicSpline, Recalibrate with 1 sets of nodes: give every detector"):
        ServiceLikelihood.from_bilby(calibrated(data, "H1"), priors(), waveform_arguments=arguments)
    monkeypatch.setattr(_chosen, "entry_points", lambda **_: [])
    _chosen.local_part.cache_clear()
    with pytest.raises(PackageMissing, match=r"pip install ./protocol ./model_store ./surrogate ./inference$"):
        ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments)
    monkeypatch.undo()
    _chosen.local_part.cache_clear()


# How it lives


def value_of(likelihood):
    return likelihood.log_likelihood_ratio(SIGNAL)


def test_it_is_copied_and_pickled(binned):
    binned.together(2)
    try:
        for other in (pickle.loads(pickle.dumps(binned)), copy.deepcopy(binned), copy.copy(binned)):
            assert other._together is None
            assert value_of(other) == binned.log_likelihood_ratios([SIGNAL])[0]
    finally:
        binned._together = None


@pytest.mark.slow
@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_it_is_the_same_in_other_processes(binned, method):
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map(value_of, [binned] * 2) == [value_of(binned)] * 2


def test_questions_of_threads_are_one_request(binned):
    rows = samples(16)
    pool = binned.together(8)
    try:
        assert pool.map(binned.log_likelihood_ratio, rows) == binned.log_likelihood_ratios(rows).tolist()
        assert pool.requests == 2
    finally:
        binned._together = None
        pool.close()


@pytest.mark.slow
@pytest.mark.parametrize("npool", [1, 2])
def test_dynesty_samples_with_it(data, arguments, tmp_path, npool):
    """A short run in which bilby makes checkpoints, converts its samples and computes their signal-to-noise ratios."""
    prior = priors()
    for name in prior.keys() - {"chirp_mass", "mass_ratio", "mass_1", "mass_2", "phase"}:
        prior[name] = SIGNAL[name]
    likelihood = ServiceLikelihood.from_bilby(
        data, prior, waveform_arguments=arguments, fiducial_parameters=SIGNAL, phase_marginalization=True
    )
    bilby.core.utils.random.seed(1)
    result = bilby.run_sampler(
        likelihood, prior, sampler="dynesty", outdir=str(tmp_path), label="short", nlive=30, sample="unif", npool=npool,
        maxiter=100, use_ratio=True, print_progress=False, save=False,
        conversion_function=bilby.gw.conversion.generate_all_bns_parameters,
    )  # fmt: skip
    assert len(result.posterior) > 0
    assert {"lambda_tilde", "H1_optimal_snr", "mass_1_source"} <= set(result.posterior)
