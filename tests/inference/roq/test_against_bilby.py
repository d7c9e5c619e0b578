"""bilby's ROQ likelihood with our file, against the sums over our basis written out in numpy."""

import warnings

import numpy as np
import pytest

from bnserve_client.bilby import binary_neutron_star
from bnserve_inference.roq import save_bilby
from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic
from tests.inference.bases import linear_basis, quadratic_basis

with warnings.catch_warnings():  # of the packages that bilby imports
    warnings.simplefilter("ignore")
    import bilby
    from bilby.gw.likelihood.roq import BilbyROQParamsRangeError, ROQGravitationalWaveTransient

pytestmark = pytest.mark.filterwarnings("default")  # of bilby and what it imports

START, DURATION, SAMPLING, MERGER = 1187008880.0, 4.0, 2048.0, 1187008882.4
OPTIONS = EvaluationOptions(alignment="merger", modes=[(2, 2)])
SKY = {"ra": 3.44616, "dec": -0.408084, "psi": 0.7, "geocent_time": MERGER + 0.0031}
ROQ_PARAMS = np.array((60.0, 400.0, 4.0), dtype=[("flow", float), ("fhigh", float), ("seglen", float)])
"""What bilby 2.8.2 would take from the file itself, in a form that numpy 2.4 no longer converts to a number."""
BINARIES = [
    {"chirp_mass": 1.1905, "mass_ratio": 1 / 1.15, "chi_1": 0.02, "chi_2": -0.03, "lambda_1": 400.0, "lambda_2": 500.0},
    {"chirp_mass": 1.1907, "mass_ratio": 1 / 1.02, "chi_1": -0.04, "chi_2": 0.01, "lambda_1": 20.0, "lambda_2": 900.0},
]
DISTANCE, INCLINATION, PHASE = 80.0, 2.6, 0.4


def our_parameters(chirp_mass, mass_ratio, **others):
    q = 1.0 / mass_ratio
    return ParametersWithExtrinsic(
        mass_ratio=q,
        total_mass=chirp_mass * (1.0 + q) ** 1.2 / q**0.6,
        distance_mpc=DISTANCE,
        inclination=INCLINATION,
        reference_phase=PHASE,
        **others,
    )


@pytest.fixture(scope="module")
def source(model):
    """A source model for bilby's ``WaveformGenerator``: our waveforms at the nodes."""

    def polarizations(frequency_array, chirp_mass, mass_ratio, chi_1, chi_2, lambda_1, lambda_2, **keywords):
        others = {"chi_1": chi_1, "chi_2": chi_2, "lambda_1": lambda_1, "lambda_2": lambda_2}
        parameters = our_parameters(chirp_mass, mass_ratio, **others)
        waveform = model.predict(keywords["frequency_nodes"], parameters, options=OPTIONS)
        linear, quadratic = keywords["linear_indices"], keywords["quadratic_indices"]
        return {
            "linear": {"plus": waveform.plus[linear], "cross": waveform.cross[linear]},
            "quadratic": {"plus": waveform.plus[quadratic], "cross": waveform.cross[quadratic]},
        }

    return polarizations


@pytest.fixture(scope="module")
def detectors(model):
    """Two detectors with seeded noise and the first binary."""
    bilby.core.utils.random.seed(17)
    bilby.core.utils.logger.disabled = True
    network = bilby.gw.detector.InterferometerList(["H1", "L1"])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        network.set_strain_data_from_power_spectral_densities(SAMPLING, DURATION, START)
    for detector in network:
        detector.minimum_frequency, detector.maximum_frequency = 60.0, 400.0
        frequencies = detector.frequency_array[detector.frequency_mask]
        waveform = model.predict(frequencies, our_parameters(**BINARIES[0]), options=OPTIONS)
        detector.strain_data._frequency_domain_strain[detector.frequency_mask] += projected(
            detector, waveform, frequencies
        )
    return network


def projected(detector, waveform, frequencies):
    """The strain in a detector, written out: antenna pattern, delay from the centre of the Earth, time of merger."""
    pattern = {
        mode: detector.antenna_response(SKY["ra"], SKY["dec"], SKY["geocent_time"], SKY["psi"], mode)
        for mode in ("plus", "cross")
    }
    delay = detector.time_delay_from_geocenter(SKY["ra"], SKY["dec"], SKY["geocent_time"])
    time = SKY["geocent_time"] - START + delay
    strain = pattern["plus"] * waveform.plus + pattern["cross"] * waveform.cross
    return strain * np.exp(-2j * np.pi * frequencies * time)


@pytest.fixture(scope="module")
def bilbys(basis, model, source, detectors, tmp_path_factory):
    path = tmp_path_factory.mktemp("bilby") / "basis.hdf5"
    save_bilby(path, basis, model)
    generator = bilby.gw.WaveformGenerator(
        duration=DURATION,
        sampling_frequency=SAMPLING,
        frequency_domain_source_model=source,
        parameter_conversion=lambda parameters: (parameters, []),
    )
    priors = bilby.core.prior.PriorDict({"geocent_time": bilby.core.prior.Uniform(MERGER - 0.1, MERGER + 0.1)})
    for name, (low, high) in basis.prior.items():
        ends = (1.0 / high, 1.0 / low) if name == "mass_ratio" else (low, high)
        priors[name] = bilby.core.prior.Uniform(*ends)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ROQGravitationalWaveTransient(
            detectors, generator, priors, linear_matrix=str(path), quadratic_matrix=str(path), roq_params=ROQ_PARAMS
        )


def direct_log_likelihood_ratio(basis, model, detectors, binary):
    """Sum over detectors of sum_j w_j h(F_j) - sum_k v_k abs(h(F_k))**2 / 2, with the weights as they are defined."""
    rows, squares = linear_basis(basis, model), quadratic_basis(basis, model)
    frequencies = basis.grid.frequencies()
    total = 0.0
    for detector in detectors:
        data = detector.frequency_domain_strain[detector.frequency_mask]
        noise = detector.power_spectral_density_array[detector.frequency_mask]
        pattern = {
            mode: detector.antenna_response(SKY["ra"], SKY["dec"], SKY["geocent_time"], SKY["psi"], mode)
            for mode in ("plus", "cross")
        }
        delay = detector.time_delay_from_geocenter(SKY["ra"], SKY["dec"], SKY["geocent_time"])
        time = SKY["geocent_time"] - START + delay
        at = {}
        for term, nodes in (("linear", basis.linear_nodes), ("quadratic", basis.quadratic_nodes)):
            waveform = model.predict(nodes, our_parameters(**binary), options=OPTIONS)
            at[term] = pattern["plus"] * waveform.plus + pattern["cross"] * waveform.cross
        shifted = np.conj(data) / noise * np.exp(-2j * np.pi * frequencies * time)
        product = 4.0 / DURATION * (rows @ shifted) @ at["linear"]
        norm = 4.0 / DURATION * (squares @ (1.0 / noise)) @ np.abs(at["quadratic"]) ** 2
        total += product.real - 0.5 * norm
    return total


def full_log_likelihood_ratio(model, detectors, binary):
    total = 0.0
    for detector in detectors:
        frequencies = detector.frequency_array[detector.frequency_mask]
        data = detector.frequency_domain_strain[detector.frequency_mask]
        noise = detector.power_spectral_density_array[detector.frequency_mask]
        waveform = model.predict(frequencies, our_parameters(**binary), options=OPTIONS)
        strain = projected(detector, waveform, frequencies)
        total += 4.0 / DURATION * np.sum((np.conj(data) * strain).real / noise - 0.5 * np.abs(strain) ** 2 / noise)
    return total


@pytest.mark.parametrize("binary", BINARIES, ids=["injected", "another"])
def test_bilby_gives_our_log_likelihood(bilbys, basis, model, detectors, binary):
    ours = direct_log_likelihood_ratio(basis, model, detectors, binary)
    theirs = bilbys.log_likelihood_ratio({**binary, **SKY})
    assert theirs == pytest.approx(ours, abs=2e-3)  # bilby interpolates its weights in time


@pytest.mark.parametrize("binary", BINARIES, ids=["injected", "another"])
def test_the_basis_gives_the_log_likelihood_of_the_full_grid(basis, model, detectors, binary):
    ours = direct_log_likelihood_ratio(basis, model, detectors, binary)
    assert ours == pytest.approx(
        full_log_likelihood_ratio(model, detectors, binary), abs=0.1
    )  # the root of its tolerance times the signal-to-noise ratio


def test_the_signal_is_loud_enough_to_tell(model, detectors):
    loud = full_log_likelihood_ratio(model, detectors, BINARIES[0])
    assert loud > 50.0
    assert abs(loud - full_log_likelihood_ratio(model, detectors, BINARIES[1])) > 5.0


def test_bilby_refuses_a_prior_beyond_the_basis(basis, model, source, detectors, tmp_path):
    save_bilby(tmp_path / "basis.hdf5", basis, model)
    generator = bilby.gw.WaveformGenerator(
        duration=DURATION, sampling_frequency=SAMPLING, frequency_domain_source_model=source
    )
    uniform = bilby.core.prior.Uniform
    priors = bilby.core.prior.PriorDict({name: uniform(pair[0] - 0.1, pair[1]) for name, pair in basis.prior.items()})
    priors["mass_ratio"] = uniform(0.5, 1.0)
    priors["geocent_time"] = uniform(MERGER - 0.1, MERGER + 0.1)
    path = str(tmp_path / "basis.hdf5")
    with pytest.raises(BilbyROQParamsRangeError, match="less than ROQ basis bound"):
        ROQGravitationalWaveTransient(
            detectors, generator, priors, linear_matrix=path, quadratic_matrix=path, roq_params=ROQ_PARAMS
        )


def test_its_likelihood_takes_the_source_model_of_the_client(basis, model, bilbys, detectors, tmp_path):
    """On the nodes of a basis as on the full grid, to the error of the basis."""
    path = tmp_path / "basis.hdf5"
    save_bilby(path, basis, model)
    generator = {
        "duration": DURATION,
        "sampling_frequency": SAMPLING,
        "frequency_domain_source_model": binary_neutron_star,
        "parameter_conversion": bilby.gw.conversion.convert_to_lal_binary_neutron_star_parameters,
    }
    arguments = {"reference_frequency": 60.0, "minimum_frequency": 60.0, "mode_array": [[2, 2]]}
    ours = ROQGravitationalWaveTransient(
        detectors, bilby.gw.WaveformGenerator(**generator, waveform_arguments=dict(arguments)), bilbys.priors,
        linear_matrix=str(path), quadratic_matrix=str(path), roq_params=ROQ_PARAMS,
    )  # fmt: skip
    full = bilby.gw.GravitationalWaveTransient(
        detectors, bilby.gw.WaveformGenerator(**generator, waveform_arguments=dict(arguments))
    )
    for binary in BINARIES:
        told = binary | SKY | {"luminosity_distance": DISTANCE, "theta_jn": INCLINATION, "phase": PHASE}
        values = [likelihood.log_likelihood_ratio(dict(told)) for likelihood in (ours, full)]
        assert values[0] == pytest.approx(values[1], abs=0.05)
        assert abs(values[1]) > 1.0
