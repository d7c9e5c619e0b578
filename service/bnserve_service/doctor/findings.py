"""What was found, in order of what it means, and checks that fail themselves."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

from bnserve_protocol import BnserveError

Status: TypeAlias = Literal["ok", "warning", "fault"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One line: something works, may trouble somebody (``warning``), or does not work (``fault``)."""

    status: Status
    what: str
    """What was looked at, in a word or two."""
    says: str
    """What is so."""
    do: str = ""
    """What to do about it; empty where nothing is to be done."""


Findings: TypeAlias = Iterator[Finding]


def ok(what: str, says: str) -> Finding:
    """It works."""
    return Finding("ok", what, says)


def warning(what: str, says: str, do: str) -> Finding:
    """It may trouble somebody."""
    return Finding("warning", what, says, do)


def fault(what: str, says: str, do: str = "") -> Finding:
    """It does not work."""
    return Finding("fault", what, says, do)


def looking(what: str, check: Callable[[], Findings]) -> Findings:
    """What a check finds; one that ends with an error has found a fault, and does not keep the next from looking."""
    try:
        yield from check()
    except BnserveError as error:
        yield fault(what, error.detail)
    except Exception as error:  # whatever it is, the doctor is there to say it
        yield fault(what, f"cannot be looked at: {type(error).__name__}: {error}")
