"""The lookup of ``bnserve train``: hyper-parameters that a search has found for the number of waveforms at hand."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from pathlib import Path

import msgspec

from bnserve_surrogate.training.config import TrainingConfiguration
from bnserve_surrogate.training.search.pareto import HyperparametersUnknown, ParetoCollection, parse_collection
from bnserve_surrogate.training.search.values import flat, override


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
    shipped = resources.files("bnserve_surrogate") / "data" / name
    source = Path(name) if section.pareto else shipped
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
