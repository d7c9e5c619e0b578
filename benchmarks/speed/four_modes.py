"""``python -m benchmarks.speed.four_modes``: batches of the same four modes, beside mlgw_bns 2.0.1's quickest way.

Who is compared takes turns in shuffled epochs on one processor, each in one thread; figures are medians. mlgw_bns
evaluates on numpy and, jitted, on JAX: the quicker of the two is what the ratio is against. What its regressions are,
and why that does not matter here, is said in ``benchmarks/peers/mlgw_bns_2_modes.py``.
"""

from __future__ import annotations

import argparse
import os
import sys
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.environments import find_python, folder_from_environment
from benchmarks.speed.bars import BARS
from benchmarks.speed.setup import Setup, one_cpu
from benchmarks.speed.table import lines_of
from benchmarks.workers import ROOT, Worker, WorkerFailed
from bnserve_service.bench.timing import shuffled

KEY = "four_modes"
ROWS, POINTS = 256, 1_000
TRAINING_POINTS = "8192"
_PEERS = ROOT / "benchmarks" / "peers"
_OURS = "bnserve"
_THEIRS = "mlgw_bns-2.0.1"
_WHERE: dict[str, tuple[str, ...]] = {
    _OURS: ("", "bnserve_local.py", "default", "22,21,33,44"),
    "mlgw_bns 2.0.1, JAX": (_THEIRS, "mlgw_bns_2_modes.py", "jax", TRAINING_POINTS),
    "mlgw_bns 2.0.1, numpy": (_THEIRS, "mlgw_bns_2_modes.py", "numpy", TRAINING_POINTS),
}
"""Environment, script, arguments."""


def four_modes(setup: Setup) -> dict[str, Any] | None:
    """How many times longer a waveform of a batch takes mlgw_bns 2.0.1; None, and a note, where it cannot be asked."""
    cases = {}
    with ExitStack() as stack:
        for name, (environment, script, *arguments) in _WHERE.items():
            python = find_python(setup.peers, environment)
            if python is None:
                setup.notes.append(f"{name} is not installed: see benchmarks/peers/{script}")
                return None
            worker = stack.enter_context(Worker([python, _PEERS / script, *arguments], cpus=setup.cpus))
            try:
                worker.ask("about")
            except WorkerFailed as error:
                setup.notes.append(f"{name}: {error.detail}")
                return None
            cases[name] = partial(_seconds, worker)
        found = shuffled(cases, setup.epochs)
    each = {name: 1e6 * median(seconds) / ROWS for name, seconds in found.items()}
    ours = each.pop(_OURS)
    return {"value": min(each.values()) / ours, "ours": ours, "peers": each}


def _seconds(worker: Worker) -> list[float]:
    found: list[float] = worker.ask("time", points=POINTS, rows=ROWS, calls=1)["seconds"]
    return found


def main() -> int:
    """Measure and print this row alone; exit status 3 where it could not be measured."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.speed.four_modes", description=__doc__)
    parser.add_argument("--epochs", type=int, default=11, metavar="N", help="how often everything is timed (11)")
    parser.add_argument(
        "--peers", type=Path, default=folder_from_environment("PEERS"), metavar="DIR", help="environments ($PEERS)"
    )
    options = parser.parse_args()
    setup = Setup(one_cpu(), os.sched_getaffinity(0), options.peers, None, options.epochs, 1.0)
    figure = four_modes(setup)
    print(
        "\n".join([*lines_of([bar for bar in BARS if bar.key == KEY], {KEY: figure} if figure else {}), *setup.notes])
    )
    return 0 if figure else 3


if __name__ == "__main__":
    sys.exit(main())
