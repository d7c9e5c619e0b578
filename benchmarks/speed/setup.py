"""What a run is made of: which processors, which peers, how many repetitions."""

from __future__ import annotations

import os
import platform
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any


@dataclass(frozen=True, slots=True)
class Setup:
    """The options of one run.

    Parameters
    ----------
    cpus:
        Where everything but the measurement of two cores runs: servers, clients and peers together.
    all_cpus:
        Where that one runs.
    peers, serving:
        Folders with the environments of peers and of model servers; None where there are none.
    epochs:
        How often everything is timed.
    load_seconds:
        How long a server is kept busy for one figure.
    """

    cpus: set[int]
    all_cpus: set[int]
    peers: Path | None
    serving: Path | None
    epochs: int
    load_seconds: float
    notes: list[str] = field(default_factory=list)
    """Filled by the measurements: what could not be measured, and why."""

    def about(self) -> dict[str, Any]:
        """The machine and the options, for the record."""
        return {
            "processor": processor_name(),
            "processors": len(self.all_cpus),
            "pinned_to": sorted(self.cpus) if self.cpus != self.all_cpus else None,
            "epochs": self.epochs,
            "python": platform.python_version(),
        }


def processor_name() -> str:
    """As the system calls it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "unknown")


def one_cpu() -> set[int]:
    """The last processor that this process may use: the first is where systems do their own work."""
    return {max(os.sched_getaffinity(0))}
