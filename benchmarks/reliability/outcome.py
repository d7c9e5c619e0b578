"""What a measurement gives, and what a module of this package looks like."""

from __future__ import annotations

import importlib
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeAlias, cast

from bnserve_protocol import BnserveError

Figures: TypeAlias = dict[str, float | int | str]
Log: TypeAlias = Callable[[str], None]

NAMES = (
    "kill",
    "overload",
    "vanishing",
    "drain",
    "reload",
    "artifacts",
    "hung",
    "shared_folder",
    "fork",
    "digests",
    "same_bits",
    "decode",
    "body_cap",
    "slow_clients",
    "slow_readers",
    "trailers",
    "framing",
    "no_code",
    "tokens",
    "soak",
    "outage",
    "faults",
    "history",
    "quotas",
    "cpu_types",
)
"""The promises, in the order of the tables."""
_RENAMED = {"shares": "quotas", "patience-restarts": "timeout-restarts", "--plant": "--inject"}
"""What had another name before, for one version."""


class PromiseUnknown(BnserveError):
    """There is no promise, or no fault, of that name."""

    code = "promise-unknown"
    title = "Unknown promise or fault"


@dataclass(frozen=True, slots=True)
class Outcome:
    """One measurement."""

    figures: Mapping[str, float | int | str]
    passed: bool
    """Whether the bar is reached."""
    summary: str
    """The figures that count, in half a line."""


class Promise(Protocol):
    """What a module of this package has."""

    __doc__: str | None
    MECHANISM: str
    BAR: str
    INJECTED_FAULTS: dict[str, str]

    def run(self, short: bool, log: Log, injected: str | None = None) -> Outcome:
        """Measure. ``short`` takes seconds; ``injected``, of ``INJECTED_FAULTS``, takes the mechanism away first."""


def names() -> list[str]:
    """The promises that have a measurement."""
    here = Path(__file__).parent
    return [name for name in NAMES if (here / f"{name}.py").exists()]


def find(name: str, injected: str | None = None) -> Promise:
    """The module of a promise.

    Raises
    ------
    PromiseUnknown
        No such promise, or it knows no such fault.
    """
    if name not in names():
        raise PromiseUnknown(f"There is no promise '{name}'; there are: {', '.join(names())}.")
    promise = cast(Promise, importlib.import_module(f"benchmarks.reliability.{name}"))
    if injected is not None and injected not in promise.INJECTED_FAULTS:
        raise PromiseUnknown(f"'{name}' knows no fault '{injected}'; it knows: {', '.join(promise.INJECTED_FAULTS)}.")
    return promise


def promise_of(promise: Promise) -> str:
    """The first line of a module's docstring, without its full stop."""
    return (promise.__doc__ or "").strip().splitlines()[0].rstrip(".")


def in_present_names(text: str) -> str:
    """A command or a summary that was kept, with the names of today."""
    return " ".join(_RENAMED.get(word, word) for word in text.split(" "))


def present_name(name: str) -> str:
    """The name of a promise, a fault or an option; with a warning if it is that of before."""
    if name not in _RENAMED:
        return name
    warnings.warn(f"'{name}' is called '{_RENAMED[name]}'.", DeprecationWarning, stacklevel=2)
    return _RENAMED[name]
