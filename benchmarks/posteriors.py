"""Posteriors by ``bnserve analyse``: what they cost, and whether seeds and populations agree.

    python -m benchmarks.posteriors examples/einstein_telescope.toml
    python -m benchmarks.posteriors examples/gw170817.toml

The command is run with two seeds, and with twice the particles; it prints a table in Markdown, and by how many combined
errors any two of the evidences differ at most. What is finished is kept in ``--work``, and not run again.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import resource
import subprocess
import sys
import time
import tomllib
from pathlib import Path
from typing import Any

import numpy as np

RUNS = {"seed 1": (1, 1), "seed 2": (2, 1), "twice the particles": (1, 2)}
"""Seed, and how many times the particles, of each run."""
_PARTICLES = 3000
"""Of an event that says nothing."""


def analysed(event: Path, folder: Path, seed: int, particles: int) -> dict[str, Any]:
    """What the command prints, with its seconds of the wall clock and of processors and the load of the machine."""
    kept = folder.with_suffix(".json")
    if kept.exists():
        return dict(json.loads(kept.read_text()))
    command = [sys.executable, "-m", "bnserve_service", "analyse", str(event), "--output", str(folder), "--json"]
    command += ["--seed", str(seed), "--particles", str(particles), "--resume"]
    before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    found = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True).stdout)
    wall, after = time.monotonic() - started, resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    found |= {"wall": wall, "processors": spent, "load": os.getloadavg()[1]}
    kept.write_text(json.dumps(found))
    return dict(found)


def table(found: dict[str, dict[str, Any]]) -> str:
    """A row for each figure, a column for each run."""

    def pair(value: float, error: float) -> str:
        return f"{value:.3f} +- {error:.3f}"

    rows = {
        "seconds, wall clock": lambda run: f"{run['wall']:.0f}",
        "of them sampling": lambda run: f"{run['seconds']['sampling']:.0f}",
        "seconds of processors": lambda run: f"{run['processors']:.0f}",
        "load average": lambda run: f"{run['load']:.0f}",
        "likelihoods": lambda run: f"{run['likelihoods']:,}",
        "effective samples": lambda run: f"{run['effective_samples']:,}",
        "k-hat": lambda run: f"{run['k_hat']:.2f}",
        "ln of the evidence ratio": lambda run: pair(run["log_evidence"], run["log_evidence_error"]),
        "the same by either half": lambda run: ", ".join(
            pair(*each) for each in zip(run["log_evidences"], run["log_evidence_errors"], strict=True)
        ),
        "largest difference of ln L to the full grid": lambda run: (
            f"{run['check']['largest']:.2g} of {run['check']['samples']}" if run["check"] else "not looked at"
        ),
    }
    lines = [f"| | {' | '.join(found)} |", f"|---|{'---|' * len(found)}"]
    lines += [f"| {name} | {' | '.join(map(cell, found.values()))} |" for name, cell in rows.items()]
    return "\n".join(lines)


def largest_difference(found: dict[str, dict[str, Any]]) -> float:
    """Of any two evidences, in their combined errors."""
    evidences = [(run["log_evidence"], run["log_evidence_error"]) for run in found.values()]
    pairs = itertools.combinations(evidences, 2)
    return max(abs(one[0] - other[0]) / float(np.hypot(one[1], other[1])) for one, other in pairs)


def main() -> None:
    """Run, and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("event", type=Path)
    parser.add_argument("--work", type=Path, default=Path("runs") / "posteriors", metavar="DIR")
    parser.add_argument("--runs", nargs="+", choices=RUNS, default=list(RUNS))
    options = parser.parse_args()
    particles = tomllib.loads(options.event.read_text()).get("sampler", {}).get("particles", _PARTICLES)
    options.work.mkdir(parents=True, exist_ok=True)
    found = {}
    for name in options.runs:
        seed, times = RUNS[name]
        folder = options.work / f"{options.event.stem}-{seed}-{times * particles}"
        found[name] = analysed(options.event, folder, seed, times * particles)
    print(table(found))
    if len(found) > 1:
        print(f"\nEvidences differ by at most {largest_difference(found):.1f} of their combined errors.")


if __name__ == "__main__":
    main()
