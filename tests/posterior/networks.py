"""A small event: seconds of two detectors, with five parameters to sample."""

import copy
import tomllib
from pathlib import Path

from bnserve_posterior.events import parse_event

TRIGGER = 1187008882.43
TOML = (Path(__file__).parent / "small.toml").read_text()
SMALL = tomllib.loads(TOML)


def with_values(table=SMALL, **changes):
    """A copy with other values, by path: ``data__f_min``; None takes one away."""
    table = copy.deepcopy(table)
    for path, value in changes.items():
        *sections, key = path.split("__")
        place = table
        for section in sections:
            place = place.setdefault(section, {})
        if value is None:
            place.pop(key, None)
        else:
            place[key] = value
    return table


def event(**changes):
    return parse_event(with_values(**changes))
