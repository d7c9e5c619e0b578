"""The configuration of a training, read and checked: a misspelt key is an error that suggests the right one."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec

from bnserve_protocol import check_table, read_table
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.sections import TrainingConfiguration


class ConfigurationInvalid(TrainingError):
    """A training configuration that cannot be read or makes no sense."""

    code = "configuration-invalid"
    title = "Training configuration invalid"


_NARROWEST_BAND = 1.01
"""Between the ends of a band: less has no room for nodes, and no waveform to speak of."""


def read_configuration(path: Path | str) -> TrainingConfiguration:
    """Read a TOML file.

    Raises
    ------
    ConfigurationInvalid
        Not readable, not TOML, or a key or value that the schema does not have; the nearest key is suggested.
    """
    return parse_configuration(read_table(path, ConfigurationInvalid))


def parse_configuration(table: dict[str, Any]) -> TrainingConfiguration:
    """Check a configuration given as nested dictionaries.

    Raises
    ------
    ConfigurationInvalid
        A key or value that the schema does not have; the nearest key is suggested.
    """
    return check_table(table, TrainingConfiguration, ConfigurationInvalid, "The training configuration")


def demand(holds: bool, complaint: str) -> None:
    """Refuse a configuration with a complaint.

    Raises
    ------
    ConfigurationInvalid
        Unless what is demanded holds.
    """
    if not holds:
        raise ConfigurationInvalid(f"The training configuration is wrong: {complaint}.")


def check_numbers(configuration: TrainingConfiguration) -> None:
    """Refuse what the schema cannot say of numbers.

    Raises
    ------
    ConfigurationInvalid
        A number that is not finite, an interval that decreases, a reference mass outside its interval, no validation.
    """
    for name, value in _numbers(msgspec.to_builtins(configuration)):
        demand(math.isfinite(value), f"'{name}' is {value}, and must be a finite number")
    ranges, validation = configuration.ranges, configuration.validation
    low, high = ranges.total_mass
    demand(low <= high, f"'total_mass' in [ranges] must be two increasing numbers, or one twice; got {low:g}, {high:g}")
    inside = low <= ranges.reference_mass <= high
    demand(inside, f"'reference_mass' in [ranges], {ranges.reference_mass:g}, must lie in total_mass")
    first, last = ranges.frequency_band
    demand(
        _NARROWEST_BAND * first <= last,
        f"'frequency_band' in [ranges] must be two increasing numbers, at least 1 % apart; got {first:g} and {last:g}",
    )
    demand(validation.count + validation.edge_count > 0, "'count' and 'edge_count' in [validation] are both 0")


def _numbers(value: Any, name: str = "") -> Iterator[tuple[str, float]]:
    if isinstance(value, dict):
        for key, part in value.items():
            yield from _numbers(part, f"{name}.{key}" if name else key)
    elif isinstance(value, list | tuple):
        for part in value:
            yield from _numbers(part, name)
    elif isinstance(value, float):
        yield name, value
