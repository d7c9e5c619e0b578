"""A configuration that is built in two seconds, and what tests do with it."""

import copy
from typing import Any

from bnserve_inference.roq import RoqConfiguration, parse_roq_configuration

TINY: dict[str, Any] = {
    "name": "tiny",
    "band": {"f_min": 60.0, "f_max": 400.0, "duration": 4.0},
    "prior": {
        "chirp_mass": [1.18, 1.2],
        "mass_ratio": [1.0, 1.3],
        "chi_1": [-0.05, 0.05],
        "chi_2": [-0.05, 0.05],
        "lambda_1": [5.0, 1000.0],
        "lambda_2": [5.0, 1000.0],
    },
    "linear": {"tolerance": 1e-5, "preselection": {"elements": 8, "tolerance": 1e-6, "step": 64}},
    "quadratic": {"tolerance": 1e-8, "preselection": {"elements": 4, "tolerance": 1e-9, "step": 64}},
    "cycles": [{"size": 600, "relative_tolerance": 0.1}, {"size": 1500}],
    "validation": {"count": 1000, "edge_count": 300},
}


def changed(**entries: Any) -> dict[str, Any]:
    """The table with some entries replaced, by dotted name with ``__`` for the dots; None takes one out."""
    table = copy.deepcopy(TINY)
    for dotted, value in entries.items():
        *path, last = dotted.split("__")
        section = table
        for name in path:
            section = section.setdefault(name, {})
        section[last] = value
        if value is None:
            del section[last]
    return table


def tiny(**entries: Any) -> RoqConfiguration:
    """The configuration with some entries replaced."""
    return parse_roq_configuration(changed(**entries))


def toml(table: dict[str, Any]) -> str:
    """A table as TOML: enough for these."""
    lines, sections = [], []
    for name, value in table.items():
        if isinstance(value, dict):
            sections.append((f"[{name}]", value))
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            sections += [(f"[[{name}]]", entry) for entry in value]
        else:
            lines.append(f"{name} = {value!r}")
    for header, section in sections:
        inner = [(f"{header[:-1]}.{name}]", entry) for name, entry in section.items() if isinstance(entry, dict)]
        lines += [header, *(f"{name} = {entry!r}" for name, entry in section.items() if not isinstance(entry, dict))]
        for title, entries in inner:
            lines += [title, *(f"{name} = {entry!r}" for name, entry in entries.items())]
    return "\n".join(lines) + "\n"
