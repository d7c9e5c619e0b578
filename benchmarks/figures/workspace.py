"""Where the figures' waveforms come from: data sets that are made once, kept, and shared with ``bnserve validate``."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import __version__
from bnserve_store import Artifact
from bnserve_surrogate import Model
from bnserve_surrogate._artifact import SurrogateMetadata
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.dataset import DatasetSpecification, ResidualDataset, build_dataset
from bnserve_surrogate.training.data.generation import configured_generator
from bnserve_surrogate.training.data.sampling import (
    EdgeSampling,
    Sampling,
    UniformSampling,
    parameter_ranges,
    training_band,
)
from bnserve_surrogate.training.reduction.nodes import smooth_nodes
from bnserve_surrogate.training.sections import TrainingConfiguration
from bnserve_surrogate.training.validation.measurement import Validation, validate

VALIDATION_SEED = 2024
"""That of ``bnserve validate``: its waveforms are used again."""
_SAMPLINGS: dict[str, Sampling] = {"uniform": UniformSampling(), "edges": EdgeSampling()}
Arrays = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Workspace:
    """What all figures share.

    Parameters
    ----------
    recipe, paper:
        The configurations that are compared: the shipped model's and the paper's.
    artifact:
        The shipped model.
    directory:
        Of the data sets.
    pareto:
        Folder of the collections that ``bnserve search`` wrote.
    short:
        Small numbers everywhere: minutes become seconds.
    largest, paper_largest:
        Most waveforms to train on, with our recipe and with the paper's.
    fresh:
        Waveforms to measure on, uniform in the box; a quarter as many on its faces, edges and corners.
    jobs:
        Processes at once.
    seed:
        Of the waveforms to measure on, where a figure has its own.
    again:
        Compute anew what is kept.
    """

    recipe: TrainingConfiguration
    paper: TrainingConfiguration
    artifact: Artifact
    directory: Path
    pareto: Path
    short: bool = False
    largest: int = 2**14
    paper_largest: int = 2**15
    fresh: int = 4096
    jobs: int = -1
    seed: int = VALIDATION_SEED
    again: bool = False

    def count(self, full: int, short: int) -> int:
        """One of two numbers."""
        return short if self.short else full

    @cached_property
    def metadata(self) -> SurrogateMetadata:
        """Of the shipped model."""
        return SurrogateMetadata.read(self.artifact.manifest.metadata)

    @property
    def model_name(self) -> str:
        """Name and version of the shipped model."""
        return f"{self.artifact.manifest.name} {self.artifact.manifest.version}"

    def waveforms(self, kind: str, count: int, configuration: TrainingConfiguration | None = None) -> ResidualDataset:
        """Waveforms that no model has seen: ``"uniform"`` in the box or on its ``"edges"``.

        The box is that of a configuration, by default of the shipped model's.
        """
        trained = configuration or parse_configuration(self.metadata.provenance["configuration"])
        generator = configured_generator(trained)
        nodes = smooth_nodes(*training_band(trained), 300, trained.ranges.reference_mass)  # as validate_artifact's
        specification = DatasetSpecification(
            generator, parameter_ranges(trained), _SAMPLINGS[kind], VALIDATION_SEED, f"validate {kind}", nodes, nodes
        )
        return build_dataset(specification, count, self.directory, n_jobs=self.jobs)

    def validation(self, dataset: ResidualDataset) -> Validation:
        """The shipped model's differences to these waveforms."""
        return validate(Model.from_artifact(self.artifact), self.metadata, dataset)

    def kept(self, name: str, inputs: Mapping[str, Any], compute: Callable[[], Arrays]) -> Arrays:
        """Arrays from the disk if they were computed from the same inputs by the same version, computed otherwise."""
        key = json.dumps({"version": __version__, **inputs}, sort_keys=True, default=str)
        path = self.directory / "figures" / f"{name}-{hashlib.sha256(key.encode()).hexdigest()[:16]}.npz"
        if path.exists() and not self.again:
            with np.load(path, allow_pickle=False) as archive:
                return dict(archive)
        arrays = compute()
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary = path.with_name(f".{path.name}")
        with temporary.open("wb") as file:
            np.savez(file, allow_pickle=False, **arrays)
        temporary.replace(path)
        return arrays
