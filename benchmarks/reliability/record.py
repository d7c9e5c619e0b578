"""Measurements in files: the figures with the date, the command and the machine."""

from __future__ import annotations

import json
import os
import platform
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from benchmarks.reliability.outcome import Outcome
from benchmarks.speed.setup import processor_name

RESULTS = Path(__file__).parent / "results"


def record_of(outcome: Outcome, command: str) -> dict[str, Any]:
    """One measurement, made now."""
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "command": command,
        "machine": f"{processor_name()}, {os.cpu_count()} processors, Python {platform.python_version()}",
        "passed": outcome.passed,
        "summary": outcome.summary,
        "figures": outcome.figures,
    }


def save(path: Path, name: str, record: dict[str, Any], plant: str | None) -> None:
    """Write a measurement; one with a planted fault beside those that are there."""
    known = read(path) or {"name": name, "plants": {}}
    if plant is None:
        known |= record
    else:
        known["plants"][plant] = record
    path.write_text(json.dumps(known, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def read(path: Path) -> dict[str, Any] | None:
    """What :func:`save` wrote, if there is such a file."""
    if not path.exists():
        return None
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found
