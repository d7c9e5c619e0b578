"""Collections of good hyper-parameters by number of waveforms: as readable text, and looked up for a training."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Any

import msgspec

from bnserve_surrogate.training.config import ConfigurationInvalid, parse_configuration
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.sections import TrainingConfiguration
from bnserve_surrogate.training.validation.report import write_text

Values = dict[str, Any]
"""``{"regressor.network.alpha": 1e-4}``."""


def override(configuration: TrainingConfiguration, values: Mapping[str, Any]) -> TrainingConfiguration:
    """The configuration with some values replaced.

    Raises
    ------
    ConfigurationInvalid
        A key or value that it cannot have.
    """
    return parse_configuration(nested(flat(msgspec.to_builtins(configuration)) | dict(values)))


def flat(table: Mapping[str, Any], prefix: str = "") -> Values:
    """A nested table by dotted keys."""
    found: Values = {}
    for key, value in table.items():
        found |= flat(value, f"{prefix}{key}.") if isinstance(value, Mapping) else {f"{prefix}{key}": value}
    return found


def nested(values: Mapping[str, Any]) -> dict[str, Any]:
    """The inverse of :func:`flat`.

    Raises
    ------
    ConfigurationInvalid
        A key that lies below a value.
    """
    table: dict[str, Any] = {}
    for key, value in values.items():
        *sections, name = key.split(".")
        part = table
        for section in sections:
            part = part.setdefault(section, {})
            if not isinstance(part, dict):
                raise ConfigurationInvalid(f"The training configuration is wrong: '{section}' has no keys ({key}).")
        part[name] = value
    return table


class HyperparametersUnknown(TrainingError):
    """No collection, or no entry of it, that goes with a configuration."""

    code = "hyperparameters-unknown"
    title = "No hyper-parameters for this configuration"


class Hyperparameters(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Fragments of these two sections of a configuration; nothing else of it can come from a collection."""

    reduction: dict[str, Any] = {}
    regressor: dict[str, Any] = {}


class ParetoEntry(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One set of hyper-parameters that no other beats in both costs; the figures are those of ``TrialCost``.

    ``cost_seconds``: waveforms times the time for one, plus the training.
    """

    trial: int
    waveforms: int
    reconstruction_error: float
    median_mismatch: float
    training_seconds: float
    cost_seconds: float
    hyperparameters: Hyperparameters


class ParetoSetup(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What a collection was found for; the first three must agree with a configuration that uses it."""

    regressor: str
    reduction: str
    coordinates: str
    generator: str
    sampling: str
    waveforms: int
    waveform_seconds: float
    trials: int
    mass_ratio: tuple[float, float]
    chi: tuple[float, float]
    tidal_deformability: tuple[float, float]


class ParetoCollection(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Entries by increasing number of waveforms."""

    setup: ParetoSetup
    entry: tuple[ParetoEntry, ...]

    def best_for(self, waveforms: int) -> ParetoEntry:
        """The entry with the smallest error among those found with no more than ``waveforms`` training waveforms.

        On the front in both costs it need not be the one with the most: one with fewer and a longer training can be
        ahead of it. Of equals, the cheapest.

        Raises
        ------
        HyperparametersUnknown
            Every entry has more.
        """
        usable = [entry for entry in self.entry if entry.waveforms <= waveforms]
        if not usable:
            least = min((entry.waveforms for entry in self.entry), default=0)
            raise HyperparametersUnknown(
                f"The smallest training set among the best hyper-parameters has {least} waveforms; this configuration "
                f'has {waveforms}. Raise [dataset] count, or set [regressor] hyperparameters = "given".'
            )
        return min(usable, key=lambda entry: (entry.reconstruction_error, entry.cost_seconds))


def parse_collection(text: str, name: str) -> ParetoCollection:
    """Read a collection from TOML.

    Raises
    ------
    ConfigurationInvalid
        It is none; the message calls it ``name``.
    """
    try:
        return msgspec.convert(tomllib.loads(text), ParetoCollection)
    except (tomllib.TOMLDecodeError, msgspec.ValidationError) as error:
        raise ConfigurationInvalid(f"{name} is not a collection of hyper-parameters: {error}.") from error


def collection_text(collection: ParetoCollection, comment: str) -> str:
    """A collection as TOML, below a comment of one or more lines."""
    lines = [f"# {line}".rstrip() for line in comment.splitlines()]
    lines += ["", "[setup]", *_assignments(msgspec.to_builtins(collection.setup))]
    for entry in collection.entry:
        lines += ["", "[[entry]]", *_assignments(flat(msgspec.to_builtins(entry)))]
    return "\n".join(lines) + "\n"


def write_collection(path: Path, collection: ParetoCollection, comment: str) -> None:
    """Write :func:`collection_text` to a file, whole or not at all; DatasetUnwritable where there is no way."""
    write_text(path, collection_text(collection, comment))


def _assignments(table: dict[str, Any]) -> list[str]:
    # Strings, numbers, booleans and lists of them are written alike in JSON and TOML.
    return [f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in table.items()]


def with_best_hyperparameters(configuration: TrainingConfiguration) -> tuple[TrainingConfiguration, str]:
    """The configuration with the best hyper-parameters of a collection filled in, and a sentence about them.

    What the entry has replaces what the configuration gives, and the result has ``hyperparameters = "given"``, so that
    it does not depend on the collection any more.

    Raises
    ------
    HyperparametersUnknown
        No collection or entry goes with it.
    """
    name, collection = load_collection(configuration)
    entry = collection.best_for(configuration.dataset.count)
    values = flat(msgspec.to_builtins(entry.hyperparameters))
    filled = override(configuration, values | {"regressor.hyperparameters": "given", "regressor.pareto": ""})
    return filled, (
        f"Hyper-parameters: trial {entry.trial} of {name}, found with {entry.waveforms} waveforms "
        f"(error {entry.reconstruction_error:.3g}, median mismatch {entry.median_mismatch:.3g}); "
        f"this training has {configuration.dataset.count}"
    )


def load_collection(configuration: TrainingConfiguration) -> tuple[str, ParetoCollection]:
    """Name and content of the collection that a configuration asks for: ``[regressor] pareto``, or the shipped one.

    Raises
    ------
    HyperparametersUnknown
        There is none, or it was found for another regressor, reduction or coordinates.
    """
    section = configuration.regressor
    name = section.pareto or f"pareto_{section.kind}.toml"
    source = Path(name) if section.pareto else resources.files("bnserve_surrogate") / "data" / name
    try:
        text = source.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise HyperparametersUnknown(
            f"There is no collection of hyper-parameters {name}. Make one with bnserve search, and name it as "
            '[regressor] pareto; or set [regressor] hyperparameters = "given".'
        ) from error
    collection = parse_collection(text, name)
    wanted = {"regressor": section.kind, "reduction": configuration.reduction.kind, "coordinates": section.coordinates}
    found = {key: getattr(collection.setup, key) for key in wanted}
    if wanted != found:
        raise HyperparametersUnknown(
            f"The hyper-parameters of {name} were found for {_listed(found)}; this configuration has "
            f"{_listed(wanted)}. Search for yours with bnserve search, and name the result as [regressor] pareto."
        )
    return name, collection


def _listed(setup: Mapping[str, str]) -> str:
    return ", ".join(f"{key} {value}" for key, value in setup.items())
