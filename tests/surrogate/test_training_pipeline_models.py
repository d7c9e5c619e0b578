"""Every kind of nodes, reduction and regressor becomes a model that gives what its parts give, and its generator."""

import numpy as np
import pytest

from bnserve_protocol import (
    INTRINSIC_NAMES,
    MEGAPARSEC_SECONDS,
    SOLAR_MASS_SECONDS,
    AmplitudePhase,
    EvaluationOptions,
    ModelDescription,
    ParameterBatch,
    ParametersWithExtrinsic,
    time_until_merger,
)
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.generation import Generation, make_generator, training_set
from bnserve_surrogate.training.pipeline import train
from bnserve_surrogate.training.publication import assemble, describe
from bnserve_surrogate.training.reduction.nodes import configured_nodes
from bnserve_surrogate.training.reduction.reductions import ReducedResiduals, reduce_dataset
from bnserve_surrogate.training.reduction.weights import mismatch_metric
from bnserve_surrogate.training.regressors import coordinate_map, export_regressor, make_regressor
from bnserve_surrogate.training.regressors.exported import model_tensors
from tests.surrogate.smooth_waveforms import merger_phase, merger_time, residual_shapes, waveform
from tests.surrogate.training_runs import SMOOTH, merged

pytestmark = pytest.mark.filterwarnings("ignore::sklearn.exceptions.ConvergenceWarning")  # a few epochs must do

NETWORK = {"hidden_layer_sizes": [24], "max_iter": 150, "batch_size": 20, "learning_rate_init": 0.01, "alpha": 1e-6}
KINDS = {
    "polynomial": {},
    "polynomial of raw parameters": {"regressor": {"coordinates": "raw"}},
    "pruned polynomial": {"regressor": {"polynomial": {"terms": 60}}},
    "network": {"regressor": {"kind": "network", "network": NETWORK}},
    "network of raw parameters": {"regressor": {"kind": "network", "coordinates": "raw", "network": NETWORK}},
    "relu network": {"regressor": {"kind": "network", "network": {**NETWORK, "activation": "relu"}}},
    "sum": {"regressor": {"kind": "sum", "polynomial": {"degree": 1}, "network": NETWORK}},
    "the paper's reduction": {"reduction": {"kind": "paper"}},
    "the paper's reduction and a network": {
        "reduction": {"kind": "paper"},
        "regressor": {"kind": "network", "coordinates": "raw", "network": NETWORK},
    },
    "greedy nodes": {
        "nodes": {"kind": "greedy", "waveforms": 8, "tolerance": 1e-4},
        "ranges": {"frequency_band": [100.0, 1024.0]},
    },
    "greedy nodes on waveforms": {
        "nodes": {"kind": "greedy", "waveforms": 4, "tolerance": 1e-3, "on": "waveforms"},
        "ranges": {"frequency_band": [200.0, 1024.0]},
    },
}
GAIN = {"polynomial": 500.0, "network": 3.0, "sum": 3.0}
"""At least this factor between the median mismatches of the baseline and the model, by kind of regressor."""
MERGER_SECONDS = {"polynomial": 0.003, "network": 0.003, "sum": 0.04}
"""Largest error of a merger time that varies by 60 ms; of the sum, its polynomial of degree 1 alone learns it."""
MERGER = EvaluationOptions(alignment="merger")


def training_waveforms(configuration, generator, work):
    generate = Generation(configuration, generator, work, n_jobs=1, backend="sequential", progress=False)
    return training_set(generate, *configured_nodes(generate, lambda line: None), lambda line: None)


def theta_in_the_box(rows, seed=11):
    random = np.random.default_rng(seed)
    return random.uniform([1.0, -0.5, -0.5, 5.0, 5.0], [3.0, 0.5, 0.5, 5000.0, 5000.0], (rows, 5))


def batch_of(theta, total_mass=2.8):
    columns = dict(zip(INTRINSIC_NAMES, theta.T, strict=True))
    return ParameterBatch.coerce({**columns, "distance_mpc": 40.0, "inclination": 0.0, "total_mass": total_mass})


def strain_scale(theta, total_mass=2.8):
    nu = theta[:, 0] / (1.0 + theta[:, 0]) ** 2
    return (nu * (total_mass * SOLAR_MASS_SECONDS) ** 2 / (40.0 * MEGAPARSEC_SECONDS))[:, None]


@pytest.fixture(scope="module")
def work(tmp_path_factory):
    """Waveforms are made once for all configurations that want the same."""
    return tmp_path_factory.mktemp("work")


def configured(*changes):
    return parse_configuration(merged(SMOOTH, *changes))


@pytest.fixture(scope="module", params=KINDS.values(), ids=list(KINDS))
def trained(request, work):
    return train(configured(request.param), work, n_jobs=1, backend="sequential", progress=False, say=lambda line: None)


def test_the_model_is_nearer_to_the_generator_than_the_baseline(trained):
    kind = trained.metadata.provenance["configuration"]["regressor"]["kind"]
    for validation in trained.validations.values():
        assert np.median(validation.baseline_mismatch) > GAIN[kind] * np.median(validation.mismatch)
        assert (np.abs(validation.merger_time) < MERGER_SECONDS[kind]).all()


def test_its_own_words_agree_with_what_was_measured(trained):
    accuracy = trained.metadata.accuracy["uniform"]
    mismatch = trained.validations["uniform"].mismatch
    assert accuracy["count"] == len(mismatch) == 12
    assert accuracy["mismatch"]["max"] == pytest.approx(mismatch.max(), rel=0.01)
    assert trained.model.self_check()
    assert trained.metadata.provenance["waveforms"] == 200
    assert trained.metadata.provenance["failed_waveforms"] == 0
    assert trained.metadata.provenance["configuration"]["name"] == "smooth"


def residuals_of_the_parts(configuration, dataset, metric, reduction, predicted):
    """The reduction's inverse of the regressor's outputs, in radians and logarithms at the nodes."""
    k = configuration.reduction.components
    log_amplitude, slope, constant = predicted[:, k], predicted[:, k + 1], predicted[:, k + 2]
    if configuration.reduction.kind == "metric":
        phase = constant + slope * metric.reference_frequency
        return reduction.inverse_transform(ReducedResiduals(predicted[:, :k], log_amplitude, phase, slope))
    nothing = np.zeros(len(predicted))
    amplitude, phase = reduction.inverse_transform(ReducedResiduals(predicted[:, :k], nothing, nothing, nothing))
    return amplitude + log_amplitude[:, None], phase + constant[:, None] + np.multiply.outer(slope, dataset.mf_phase)


@pytest.mark.parametrize("change", KINDS.values(), ids=list(KINDS))
def test_the_exported_model_equals_its_parts_to_rounding(change, work):
    """Kernel against scikit-learn's predict, the reduction's inverse and the baseline's reference functions."""
    configuration = configured(change)
    generator = make_generator(configuration.generator.name, **configuration.generator.options)
    dataset = training_waveforms(configuration, generator, work)
    metric = mismatch_metric(dataset, configuration)
    reduction, targets, start_mf = reduce_dataset(configuration, generator, metric, dataset)
    coordinates = coordinate_map(configuration, dataset.theta)
    regressor = make_regressor(configuration, metric).fit(coordinates(dataset.theta), targets)
    exported = export_regressor(regressor)
    tensors = model_tensors(reduction, exported, coordinates, dataset.mf_amplitude, dataset.mf_phase)
    metadata = describe(configuration, exported.metadata.get("mlp_activation", "tanh"), start_mf)
    model = assemble(configuration, metadata, tensors)

    theta = theta_in_the_box(9)
    predicted = regressor.predict(coordinates(theta))
    ratio, difference = residuals_of_the_parts(configuration, dataset, metric, reduction, predicted)
    mass = 2.8 * SOLAR_MASS_SECONDS
    columns = theta.T
    amplitude = strain_scale(theta) * taylorf2_amplitude(dataset.mf_amplitude, *columns[:3]) * np.exp(ratio)
    psi = taylorf2_phase(dataset.mf_phase, *columns) + difference
    ours = model.predict_amplitude_phase(dataset.mf_amplitude / mass, batch_of(theta), options=MERGER)
    np.testing.assert_allclose(ours.amplitude, amplitude, rtol=1e-11)
    ours = model.predict_amplitude_phase(dataset.mf_phase / mass, batch_of(theta), options=MERGER)
    np.testing.assert_allclose(ours.phase, -psi, rtol=1e-13, atol=1e-8)


def test_edges_come_after_the_other_waveforms_and_no_corner_is_among_them(work):
    def made(*changes):
        configuration = configured(*changes)
        generator = make_generator(configuration.generator.name, **configuration.generator.options)
        return training_waveforms(configuration, generator, work)

    plain, enriched = made(), made({"dataset": {"edge_count": 40}})
    np.testing.assert_array_equal(enriched.theta[:200], plain.theta)
    np.testing.assert_array_equal(enriched.psi_residual[:200], plain.psi_residual)
    assert enriched.index.tolist() == list(range(240))
    bound = np.isin(enriched.theta[200:], [1.0, 3.0, -0.5, 0.5, 5.0, 5000.0]).sum(axis=1)
    assert set(bound) == {1, 2, 3, 4}
    assert enriched.digest != plain.digest


@pytest.mark.parametrize("waveforms", [8, 60])
def test_a_network_can_be_trained_on_few_waveforms(work, waveforms):
    """The scalars beside it then have a polynomial of lower degree."""
    few = {"dataset": {"count": waveforms}, "reduction": {"components": 4}, "regressor": {
        "kind": "network", "network": {**NETWORK, "batch_size": 4, "validation_fraction": 0.25}}}  # fmt: skip
    options = {"n_jobs": 1, "backend": "sequential", "progress": False, "say": lambda line: None}
    assert train(configured(few), work, **options).model.self_check()


@pytest.fixture(scope="module")
def exact(work):
    trained = train(configured(), work, n_jobs=1, backend="sequential", progress=False, say=lambda line: None)
    return assemble(configured(), trained.metadata, trained.tensors)


@pytest.mark.parametrize("total_mass", [2.0, 2.8, 4.0])
def test_aligned_at_the_merger_the_model_has_the_generators_phase_and_amplitude(exact, total_mass):
    theta = theta_in_the_box(20)
    f = np.geomspace(5.0, 2048.0, 300)
    ours = exact.predict_amplitude_phase(f, batch_of(theta, total_mass), options=MERGER)
    truth = [waveform(row, f * total_mass * SOLAR_MASS_SECONDS) for row in theta]
    np.testing.assert_allclose(ours.phase, [-psi for _, psi in truth], rtol=0.0, atol=1e-5)
    expected = strain_scale(theta, total_mass) * [amplitude for amplitude, _ in truth]
    np.testing.assert_allclose(ours.amplitude, expected, rtol=1e-6)


def test_a_polynomial_generator_is_reproduced_to_rounding(exact):
    assert exact.description.accuracy["uniform"]["mismatch"]["max"] < 1e-12
    assert exact.description.accuracy["edges"]["merger_time_error_seconds"]["max"] < 1e-8


def test_aligned_with_the_baseline_only_a_line_is_missing(exact):
    """The line that touches the residual phase at the first trained frequency."""
    theta = theta_in_the_box(10)
    f = np.geomspace(5.0, 2048.0, 300)
    difference = (
        exact.predict_amplitude_phase(f, batch_of(theta)).phase
        - exact.predict_amplitude_phase(f, batch_of(theta), options=MERGER).phase
    )
    mass = 2.8 * SOLAR_MASS_SECONDS
    first = 5.0 * 2.0 / 2.8 * mass
    around = first * np.array([1.0, 1.0 + 1e-6])
    residual = residual_shapes(theta, around)[1] + merger_phase(theta)[:, None]
    residual += 2.0 * np.pi * np.multiply.outer(merger_time(theta), around)
    slope = np.diff(residual, axis=1)[:, 0] / np.diff(around)
    expected = residual[:, :1] + np.multiply.outer(slope, f * mass - first)
    np.testing.assert_allclose(difference, expected, rtol=1e-3, atol=1e-3)


class Generator:
    """The generator as a waveform model."""

    description = ModelDescription(
        name="smooth",
        version="1",
        digest="",
        modes=[(2, 2)],
        parameters=[],
        frequency_band=(5.0, 2048.0),
        training_band=(5.0 * 2.0 / 2.8, 2048.0 * 4.0 / 2.8),
        reference_mass=2.8,
    )

    def predict_amplitude_phase(self, frequencies, batch, *, options):
        theta = np.array([batch[name][0] for name in INTRINSIC_NAMES])
        amplitude, psi = waveform(theta, frequencies * batch["total_mass"][0] * SOLAR_MASS_SECONDS)
        return AmplitudePhase(amplitude=amplitude[None], phase=-psi[None], status=np.zeros(1, np.uint8))


@pytest.mark.parametrize("frequency", [6.0, 30.0, 500.0])
def test_the_time_until_merger_is_the_generators(exact, frequency):
    one = ParametersWithExtrinsic.gw170817()
    expected = time_until_merger(Generator(), frequency, one)
    assert exact.time_until_merger(frequency, one) == pytest.approx(expected, abs=1e-6)
