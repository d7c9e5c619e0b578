"""From a configuration to a trained model: the sequence of stages, each of which can be interrupted and resumed."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from bnserve_surrogate.training.config import check_numbers
from bnserve_surrogate.training.data.generation import (
    Generation,
    check_room,
    configured_generator,
    fewest_waveforms,
    training_set,
)
from bnserve_surrogate.training.data.sampling import parameter_ranges
from bnserve_surrogate.training.publication import Trained, assemble, describe, estimating, provenance, with_results
from bnserve_surrogate.training.reduction.nodes import check_reduction, configured_nodes, mode_nodes
from bnserve_surrogate.training.reduction.reductions import reduce_dataset
from bnserve_surrogate.training.reduction.weights import mismatch_metric
from bnserve_surrogate.training.regressors import check_regressor, coordinate_map, export_regressor, make_regressor
from bnserve_surrogate.training.regressors.exported import model_tensors
from bnserve_surrogate.training.regressors.ratios import train_ratios
from bnserve_surrogate.training.search.hyperparameters import with_best_hyperparameters
from bnserve_surrogate.training.sections import TrainingConfiguration
from bnserve_surrogate.training.validation.error_estimate import estimates_from, with_error_estimate
from bnserve_surrogate.training.validation.measurement import validate_on_fresh


def check_plausible(configuration: TrainingConfiguration) -> None:
    """Refuse values that do not go together, before any waveform is computed: what the schema cannot say.

    Raises
    ------
    ConfigurationInvalid
        Numbers that are not finite, intervals that decrease, more components or terms than waveforms determine, no
        validation.
    InvalidParameters, InvalidFrequencies
        A box that is not physical; a noise curve that does not exist, or does not cover the band.
    """
    check_numbers(configuration)
    parameter_ranges(configuration)
    waveforms = fewest_waveforms(configuration)
    check_reduction(configuration, *waveforms)
    check_regressor(configuration, *waveforms)


def train(
    configuration: TrainingConfiguration,
    directory: Path,
    *,
    n_jobs: int = -1,
    backend: str = "loky",
    progress: bool | None = None,
    say: Callable[[str], None] = print,
) -> Trained:
    """Run every stage: nodes, waveforms, reduction, regression, validation.

    Parameters
    ----------
    configuration
        What to train.
    directory
        Where waveforms are kept, chunk by chunk: the same call after an interruption goes on from there.
    n_jobs, backend, progress
        As for :func:`build_dataset`.
    say
        Called with a line at the beginning of each stage.

    Raises
    ------
    TrainingError
        With what to do; finished work is kept.
    """
    started = time.monotonic()
    if configuration.regressor.hyperparameters == "best":
        configuration, choice = with_best_hyperparameters(configuration)
        say(choice)
    check_plausible(configuration)
    check_room(configuration, directory)
    generator = configured_generator(configuration)
    generate = Generation(configuration, generator, directory, n_jobs, backend, progress)
    dataset = training_set(generate, *configured_nodes(generate, say), say, mode_nodes(configuration))
    say(f"Reduction: {configuration.reduction.kind}, {configuration.reduction.components} components")
    metric = mismatch_metric(dataset, configuration)
    reduction, targets, start_mf = reduce_dataset(configuration, generator, metric, dataset)
    say(f"Regression: {configuration.regressor.kind} in {configuration.regressor.coordinates} coordinates")
    coordinates = coordinate_map(configuration, dataset.theta)
    regressor = make_regressor(configuration, metric).fit(coordinates(dataset.theta), targets)
    exported = export_regressor(regressor)
    tensors = model_tensors(reduction, exported, coordinates, dataset.mf_amplitude, dataset.mf_phase)
    for ratio in train_ratios(configuration, dataset, coordinates):
        tensors |= ratio.tensors
    metadata = describe(configuration, exported.metadata.get("mlp_activation", "tanh"), start_mf)
    say("Validation on fresh waveforms")
    model = assemble(configuration, metadata, tensors)
    section = configuration.validation
    counts = {"uniform": section.count, "edges": section.edge_count}
    validations = validate_on_fresh(generate, model, metadata, counts, section.seed)
    estimates = estimates_from(validations, coordinates)
    for mode, estimate in estimates.items():
        tensors = with_error_estimate(tensors, estimate, mode)
    if estimates:
        metadata = estimating(metadata)
        model = assemble(configuration, metadata, tensors)
    origin = provenance(configuration, generator, dataset, tensors, time.monotonic() - started)
    metadata = with_results(metadata, origin, validations, model)
    return Trained(tensors, metadata, model, validations)
