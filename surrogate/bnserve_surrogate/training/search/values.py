"""Parts of a training configuration by dotted key."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec

from bnserve_surrogate.training.config import ConfigurationInvalid, TrainingConfiguration, parse_configuration

Values = dict[str, Any]
"""``{"regressor.network.alpha": 1e-4}``."""


def override(configuration: TrainingConfiguration, values: Mapping[str, Any]) -> TrainingConfiguration:
    """The configuration with some values replaced; raises ``ConfigurationInvalid`` for a key it does not have."""
    table = msgspec.to_builtins(configuration)
    for key, value in values.items():
        *sections, name = key.split(".")
        part = table
        for section in sections:
            part = part.setdefault(section, {})
            if not isinstance(part, dict):
                raise ConfigurationInvalid(f"The training configuration is wrong: '{section}' has no keys ({key}).")
        part[name] = value
    return parse_configuration(table)


def flat(table: Mapping[str, Any], prefix: str = "") -> Values:
    """A nested table by dotted keys."""
    found: Values = {}
    for key, value in table.items():
        found |= flat(value, f"{prefix}{key}.") if isinstance(value, Mapping) else {f"{prefix}{key}": value}
    return found


def nested(values: Mapping[str, Any]) -> dict[str, Any]:
    """The inverse of :func:`flat`."""
    table: dict[str, Any] = {}
    for key, value in values.items():
        *sections, name = key.split(".")
        part = table
        for section in sections:
            part = part.setdefault(section, {})
        part[name] = value
    return table
