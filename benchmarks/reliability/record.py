"""Measurements in files: the figures with the date, the command and the machine."""

from __future__ import annotations

import json
import os
import platform
import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from benchmarks.reliability.outcome import Outcome
from benchmarks.speed.setup import processor_name

RESULTS = Path(__file__).parent / "results"


class Clock:
    """How long a measurement takes, and how much of the processors somebody else had meanwhile."""

    def __init__(self) -> None:
        self._began, self._ticks = time.monotonic(), _ticks()

    def seconds(self) -> float:
        """Since the beginning."""
        return time.monotonic() - self._began

    def stolen(self) -> float:
        """The part of all processor time that the hypervisor gave to other machines."""
        passed = [now - then for now, then in zip(_ticks(), self._ticks, strict=True)]
        return passed[_STEAL] / max(1, sum(passed[: _STEAL + 1]))


_STEAL = 7
"""The place of ``steal`` in the first line of /proc/stat, see proc(5)."""


def _ticks() -> list[int]:
    return [int(value) for value in Path("/proc/stat").read_text().partition("\n")[0].split()[1:]]


def record_of(outcome: Outcome, command: str, clock: Clock) -> dict[str, Any]:
    """One measurement, made now."""
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "command": command,
        "machine": f"{processor_name()}, {os.cpu_count()} processors, Python {platform.python_version()}",
        "seconds": round(clock.seconds()),
        "stolen": round(clock.stolen(), 3),
        "passed": outcome.passed,
        "summary": outcome.summary,
        "figures": outcome.figures,
    }


def save(path: Path, name: str, record: dict[str, Any], injected: str | None) -> None:
    """Write a measurement; one with an injected fault beside those that are there."""
    known = read(path) or {"name": name, "injected": {}}
    if injected is None:
        known |= record
    else:
        known["injected"][injected] = record
    path.write_text(json.dumps(known, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def read(path: Path) -> dict[str, Any] | None:
    """What :func:`save` wrote, if there is such a file."""
    if not path.exists():
        return None
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found
