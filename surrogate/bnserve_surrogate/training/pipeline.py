"""From a configuration to a published model; every stage can be interrupted and resumed."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_store import Artifact, Manifest, ModelStore
from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate._metadata import SurrogateMetadata
from bnserve_surrogate._model import Model
from bnserve_surrogate.training.config import TrainingConfiguration, parse_configuration
from bnserve_surrogate.training.data.baseline import baseline_amplitude
from bnserve_surrogate.training.data.dataset import ResidualDataset, joined
from bnserve_surrogate.training.data.generation import (
    Generation,
    check_room,
    configured_generator,
    configured_nodes,
    configured_sampling,
    validation_nodes,
)
from bnserve_surrogate.training.data.generators import FloatArray, WaveformGenerator, mass_seconds
from bnserve_surrogate.training.data.noise import noise_curve
from bnserve_surrogate.training.data.ranges import parameter_ranges
from bnserve_surrogate.training.data.residuals import flatten_phase
from bnserve_surrogate.training.data.sampling import EdgeSampling, Sampling, UniformSampling
from bnserve_surrogate.training.errors import GeneratorUnknown, TrainingError
from bnserve_surrogate.training.export import SCALARS, model_tensors, regression_targets
from bnserve_surrogate.training.plausibility import check_plausible
from bnserve_surrogate.training.publication import assemble, describe, estimating, provenance, with_results
from bnserve_surrogate.training.reduction.metric import MismatchMetric
from bnserve_surrogate.training.reduction.quadrature import dense_grid, noise_weights, spline_matrix
from bnserve_surrogate.training.reduction.reductions import MetricReduction, PaperReduction, Reduction
from bnserve_surrogate.training.regressors import MLP, Beside, ChebyshevPolynomial, Sum, export_regressor
from bnserve_surrogate.training.search.lookup import with_best_hyperparameters
from bnserve_surrogate.training.validation.error_estimate import ErrorEstimate, fit_error_estimate, with_error_estimate
from bnserve_surrogate.training.validation.measurement import Validation, validate, validation_frequencies
from bnserve_surrogate.training.validation.report import REPORT_FILE, page
from bnserve_surrogate.training.validation.verdict import check_worth_a_label

Say = Callable[[str], None]
_SCALAR_WEIGHTS = {"log_amplitude": 1e-4, "time_shift": 2e-3, "phase_shift": 1e-7}
"""What a squared error of a scalar costs against one of the components, when a polynomial is pruned: the match does not
see it, but the merger's alignment does. That of the time shift multiplies its own part of the metric."""
_ROOM = 2**24
"""Bytes that must be free in the store: the shipped models have a tenth of it, with their reports."""
_SCALAR_DEGREE = 4
"""Of the polynomial for the scalars beside a network, if there are five waveforms for four terms; lower if not."""
_EDGES = EdgeSampling(most=4)
"""Of training: corners are left to the validation, whose edges would else have been seen."""


@dataclass(frozen=True)
class Trained:
    """A trained model before it is published."""

    tensors: dict[str, NDArray[Any]]
    metadata: SurrogateMetadata
    model: Model
    validations: dict[str, Validation]


def train(
    configuration: TrainingConfiguration,
    directory: Path,
    *,
    n_jobs: int = -1,
    backend: str = "loky",
    progress: bool | None = None,
    say: Say = print,
) -> Trained:
    """Run every stage: nodes, waveforms, reduction, regression, validation.

    Parameters
    ----------
    configuration:
        What to train.
    directory:
        Where waveforms are kept, chunk by chunk: the same call after an interruption goes on from there.
    n_jobs, backend, progress:
        As for :func:`build_dataset`.
    say:
        Called with a line at the beginning of each stage.

    Raises
    ------
    TrainingError
        With what to do; finished work is kept.
    """
    started = time.monotonic()
    configuration, choice = with_best_hyperparameters(configuration)
    if choice:
        say(choice)
    check_plausible(configuration)
    check_room(configuration, directory)
    generator = configured_generator(configuration)
    generate = Generation(configuration, generator, directory, n_jobs, backend, progress)
    dataset = training_dataset(
        configuration, generator, directory, n_jobs=n_jobs, backend=backend, progress=progress, say=say
    )
    say(f"Reduction: {configuration.reduction.kind}, {configuration.reduction.components} components")
    metric = mismatch_metric(dataset, configuration)
    reduction, targets, start_mf = reduce_dataset(configuration, generator, metric, dataset)
    say(f"Regression: {configuration.regressor.kind} in {configuration.regressor.coordinates} coordinates")
    coordinates = coordinate_map(configuration, dataset.theta)
    regressor = make_regressor(configuration, metric).fit(coordinates(dataset.theta), targets)
    exported = export_regressor(regressor)
    tensors = model_tensors(reduction, exported, coordinates, dataset.mf_amplitude, dataset.mf_phase)
    metadata = describe(configuration, exported.metadata.get("mlp_activation", "tanh"), start_mf)
    say("Validation on fresh waveforms")
    model = assemble(configuration, metadata, tensors)
    validations = _validate(configuration, generate, model, metadata)
    estimate = _error_estimate(coordinates, validations)
    if estimate is not None:
        tensors = with_error_estimate(tensors, estimate)
        metadata = estimating(metadata)
        model = assemble(configuration, metadata, tensors)
    origin = provenance(configuration, generator, dataset, tensors, time.monotonic() - started)
    metadata = with_results(metadata, origin, validations, model)
    return Trained(tensors, metadata, model, validations)


def training_dataset(
    configuration: TrainingConfiguration,
    generator: WaveformGenerator,
    directory: Path,
    *,
    n_jobs: int = -1,
    backend: str = "loky",
    progress: bool | None = None,
    say: Say = print,
) -> ResidualDataset:
    """The nodes and the waveforms of a configuration; parameters and errors are those of :func:`train`."""
    generate = Generation(configuration, generator, directory, n_jobs, backend, progress)
    section = configuration.dataset
    say(f"Nodes: {configuration.nodes.kind}")
    mf_amplitude, mf_phase = configured_nodes(configuration, generator, directory, n_jobs)
    say(f"  {len(mf_amplitude)} for the amplitude, {len(mf_phase)} for the phase")
    edges = f" and {section.edge_count} on faces and edges" if section.edge_count else ""
    generate.check(mf_phase)
    say(f"Waveforms: {section.count}{edges} of {generator.name} {generator.version}")
    dataset = generate(configured_sampling(configuration), "train", section.seed, section.count, mf_amplitude, mf_phase)
    if section.edge_count:
        others = generate(_EDGES, "train edges", section.seed, section.edge_count, mf_amplitude, mf_phase)
        dataset = joined(dataset, others, section.count)
    say(f"  {len(dataset)} ready, {len(dataset.failures)} failed and left out")
    return dataset


def publish(
    configuration: TrainingConfiguration,
    trained: Trained,
    store: Path | str,
    *,
    with_report: bool = False,
    force: bool = False,
) -> Manifest:
    """Publish a trained model into a store, with its labels and its report, or not at all.

    Parameters
    ----------
    with_report:
        A page with plots lies beside the manifest.
    force:
        Give it its labels whatever it is worth.

    Raises
    ------
    NotBetter
        It has labels to get, and is not better than its baseline by a factor of ten.
    VersionExists, BnserveError
        The version is there already, or the store cannot be written; nothing was published.
    """
    if configuration.labels and not force:
        check_worth_a_label(trained.validations)
    return ModelStore([store]).publish(
        configuration.name,
        configuration.version,
        trained.tensors,
        trained.metadata.write(),
        labels=configuration.labels,
        created=datetime.now(UTC),
        beside=(lambda manifest: _report(manifest, trained)) if with_report else None,
    )


def _report(manifest: Manifest, trained: Trained) -> dict[str, bytes]:
    return {REPORT_FILE: page(f"{manifest.name} {manifest.version}", manifest.digest, trained).encode()}


def check_publishable(configuration: TrainingConfiguration, store: Path | str) -> None:
    """Find out before hours are spent whether :func:`publish` will refuse the version, its name, labels or store.

    Raises
    ------
    VersionExists
        The version is there already.
    InvalidRequest, BnserveError
        As :meth:`ModelStore.check_publishable`; the store cannot be written.
    """
    ModelStore([store]).check_publishable(configuration.name, configuration.version, configuration.labels, room=_ROOM)


def validate_artifact(
    artifact: Artifact,
    directory: Path,
    *,
    counts: dict[str, int],
    seed: int,
    noise: str = "ET-D",
    total_mass: float | None = None,
    f_min: float | None = None,
    n_jobs: int = -1,
    own_function: str | None = None,
) -> dict[str, Validation]:
    """Measure a published model on fresh waveforms of the generator it was trained on.

    Parameters
    ----------
    artifact:
        Of a store.
    directory:
        Where waveforms are kept.
    counts:
        How many ``"uniform"`` in the box and on its ``"edges"``.
    seed:
        Of the waveforms; different from the configuration's seeds, they are new to the model.
    noise, total_mass, f_min:
        As for :func:`validate`.
    n_jobs:
        Processes at once.
    own_function:
        The user's function that the model was trained on, as ``module:function``. A model that names another, or any
        when this is None, is refused: importing is running, and what a model names is data.

    Raises
    ------
    TrainingError
        The model does not say how it was trained, or no waveforms can be had.
    GeneratorUnknown
        The model was trained on a function, and not on ``own_function``.
    InvalidParameters, InvalidFrequencies
        The noise, mass or frequency do not go with the model; found before any waveform is computed.
    """
    metadata = SurrogateMetadata.read(artifact.manifest.metadata)
    if "configuration" not in metadata.provenance or not any(count > 0 for count in counts.values()):
        raise TrainingError(
            "There is nothing to validate with: the model must have been published by bnserve train, and at least one "
            "waveform be asked for."
        )
    validation_frequencies(metadata, noise, total_mass, f_min)
    configuration = parse_configuration(metadata.provenance["configuration"])
    _refuse_foreign_function(configuration, own_function)
    generator = configured_generator(configuration)
    generate = Generation(configuration, generator, directory, n_jobs, "loky", None)
    model = Model.from_artifact(artifact)
    nodes = validation_nodes(configuration)
    return {
        kind: validate(
            model,
            metadata,
            generate(_VALIDATION_SAMPLING[kind], f"validate {kind}", seed, count, nodes, nodes),
            noise=noise,
            total_mass=total_mass,
            f_min=f_min,
        )
        for kind, count in counts.items()
        if count > 0
    }


def _refuse_foreign_function(configuration: TrainingConfiguration, own_function: str | None) -> None:
    if configuration.generator.name != "callable":
        return
    path = configuration.generator.options.get("path")
    if path != own_function:
        raise GeneratorUnknown(
            f"This model says that it was trained on the function '{path}', which would be imported and run. If you "
            f"know it, name it: --generator {path}"
        )


def mismatch_metric(dataset: ResidualDataset, configuration: TrainingConfiguration) -> MismatchMetric:
    """The metric with the mean weights |h|^2 / S_n of the data set, at its nodes."""
    mass = mass_seconds(configuration.ranges.reference_mass)
    dense = dense_grid(dataset.mf_amplitude)
    to_dense = spline_matrix(dataset.mf_amplitude, dense).T
    every = max(1, len(dataset) // 1024)
    amplitudes = np.array(
        [
            np.exp(ratio @ to_dense) * baseline_amplitude(theta, dense)
            for theta, ratio in zip(dataset.theta[::every], dataset.log_amplitude_ratio[::every], strict=True)
        ]
    )
    weights = noise_weights(dense / mass, amplitudes, noise_curve(configuration.reduction.noise)).mean(axis=0)
    return MismatchMetric.from_dense(dataset.mf_amplitude, dataset.mf_phase, dense, weights)


def reduce_dataset(
    configuration: TrainingConfiguration, generator: WaveformGenerator, metric: MismatchMetric, dataset: ResidualDataset
) -> tuple[Reduction, FloatArray, float]:
    """The fitted reduction, the regressor's targets, and where the generator's phase starts from zero."""
    section = configuration.reduction
    start_mf = float(getattr(generator, "phase_start", 0.0))
    if section.kind == "metric":
        reduction: Reduction = MetricReduction(metric, section.components)
        phase = dataset.psi_residual
        constant = slope = np.zeros(len(dataset))
    else:
        reduction = PaperReduction(section.components, section.eigenvalue_exponent)
        flat = flatten_phase(dataset.mf_phase, dataset.psi_residual)
        phase, constant, slope = flat.residual, flat.constant, 2.0 * np.pi * flat.time_shift
    reduced = reduction.fit(dataset.log_amplitude_ratio, phase).transform(dataset.log_amplitude_ratio, phase)
    reference = metric.reference_frequency if section.kind == "metric" else 0.0
    reduced = reduced._replace(phase=reduced.phase + constant, phase_slope=reduced.phase_slope + slope)
    return reduction, regression_targets(reduced, dataset.theta, reference, start_mf), start_mf


def coordinate_map(configuration: TrainingConfiguration, theta: FloatArray) -> CoordinateMap:
    """The regressor's coordinates of training parameters (N, 5)."""
    if configuration.regressor.coordinates == "raw":
        return CoordinateMap.standardised(theta)
    ranges = parameter_ranges(configuration)
    return CoordinateMap.physical(ranges.lower, ranges.upper)


def make_regressor(configuration: TrainingConfiguration, metric: MismatchMetric) -> Any:
    """The estimator of a configuration, not yet fitted; its outputs are the components and the scalars."""
    section = configuration.regressor
    inertia = float(metric.phase_weights @ (metric.phase_frequencies - metric.reference_frequency) ** 2)
    scalars = dict(_SCALAR_WEIGHTS, time_shift=_SCALAR_WEIGHTS["time_shift"] * 0.5 * inertia)
    components, scalar_weights = configuration.reduction.components, [scalars[name] for name in SCALARS]

    def polynomial(output_weights: list[float]) -> ChebyshevPolynomial:
        options = section.polynomial
        return ChebyshevPolynomial(options.degree, options.weights, options.terms, output_weights=output_weights)

    if section.kind == "polynomial":
        return polynomial([1.0] * components + scalar_weights)
    options = {name: getattr(section.network, name) for name in section.network.__struct_fields__ if name != "seed"}
    network = MLP(**options, random_state=section.network.seed)
    if section.kind == "sum":
        return Beside(Sum(polynomial([1.0] * components), network), polynomial(scalar_weights), components)
    return Beside(network, ChebyshevPolynomial(_scalar_degree(configuration)), components)


def _scalar_degree(configuration: TrainingConfiguration) -> float:
    waveforms = configuration.dataset.count + configuration.dataset.edge_count
    degrees = range(1, _SCALAR_DEGREE + 1)
    return float(max((d for d in degrees if 1.25 * math.comb(d + 5, 5) <= waveforms), default=1))


def _error_estimate(coordinates: CoordinateMap, validations: dict[str, Validation]) -> ErrorEstimate | None:
    """Fitted to all waveforms of the validation; calibrated for the middle and for the edges, each by itself."""
    parts = validations.values()
    theta = np.concatenate([validation.theta for validation in parts])
    mismatch = np.concatenate([validation.mismatch for validation in parts])
    kinds = np.concatenate([np.full(len(validation.mismatch), kind) for kind, validation in enumerate(parts)])
    return fit_error_estimate(coordinates(theta), mismatch, kinds)


_VALIDATION_SAMPLING: dict[str, Sampling] = {"uniform": UniformSampling(), "edges": EdgeSampling()}


def _validate(
    configuration: TrainingConfiguration, generate: Generation, model: Model, metadata: SurrogateMetadata
) -> dict[str, Validation]:
    section = configuration.validation
    nodes = validation_nodes(configuration)
    return {
        kind: validate(
            model, metadata, generate(_VALIDATION_SAMPLING[kind], f"validate {kind}", section.seed, count, nodes, nodes)
        )
        for kind, count in {"uniform": section.count, "edges": section.edge_count}.items()
        if count > 0
    }
