"""Collections of good hyper-parameters by number of training waveforms, as readable text."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

import msgspec

from bnserve_surrogate.training.config import ConfigurationInvalid
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.search.values import flat
from bnserve_surrogate.training.validation.report import write_text


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
    """Read a collection from TOML; raises ``ConfigurationInvalid``, which calls it ``name``."""
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
    """Write :func:`collection_text` to a file, whole or not at all; raises ``DatasetUnwritable``."""
    write_text(path, collection_text(collection, comment))


def _assignments(table: dict[str, Any]) -> list[str]:
    # Strings, numbers, booleans and lists of them are written alike in JSON and TOML.
    return [f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in table.items()]
