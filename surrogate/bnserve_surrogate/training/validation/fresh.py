"""A model against fresh waveforms of its generator, in the middle of the box and on its edges."""

from __future__ import annotations

from pathlib import Path

from bnserve_store import Artifact
from bnserve_surrogate._artifact import SurrogateMetadata
from bnserve_surrogate._model import Model
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.generation import Generation, configured_generator
from bnserve_surrogate.training.errors import GeneratorUnknown, TrainingError
from bnserve_surrogate.training.sections import TrainingConfiguration
from bnserve_surrogate.training.validation.measurement import (
    Validation,
    validate_on_fresh,
    validation_frequencies,
)


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
    artifact
        Of a store.
    directory
        Where waveforms are kept.
    counts
        How many ``"uniform"`` in the box and on its ``"edges"``.
    seed
        Of the waveforms; different from the configuration's seeds, they are new to the model.
    noise, total_mass, f_min
        As for :func:`validate`.
    n_jobs
        Processes at once.
    own_function
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
    generate = Generation(configuration, generator, directory, n_jobs)
    model = Model.from_artifact(artifact)
    return validate_on_fresh(generate, model, metadata, counts, seed, noise=noise, total_mass=total_mass, f_min=f_min)


def _refuse_foreign_function(configuration: TrainingConfiguration, own_function: str | None) -> None:
    if configuration.generator.name != "callable":
        return
    path = configuration.generator.options.get("path")
    if path != own_function:
        raise GeneratorUnknown(
            f"This model says that it was trained on the function '{path}', which would be imported and run. If you "
            f"know it, name it: --generator {path}"
        )
