"""The paper's procedure with every peer in a process of its own, all in one run."""

from __future__ import annotations

import json
import sys
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

from benchmarks.environments import find_python
from benchmarks.peers.candidates import Entry, candidates
from benchmarks.workers import Worker, WorkerFailed
from bnserve_service.bench.timing import fit_cost, grid_sizes, shuffled

BATCHES = ((256, 277), (256, 1_000), (16, 10_000))
QUOTED = (277, 1_000, 10_000, 253_056)
"""Points whose times the tables quote."""


class Effort(NamedTuple):
    """Sizes of grids, parameter draws, and epochs."""

    grids: int = 50
    draws: int = 20
    epochs: int = 10

    @property
    def options(self) -> str:
        """What to type for it; nothing for the paper's."""
        names = zip(self._fields, self, self._field_defaults.values(), strict=True)
        return "".join(f" --{name} {value}" for name, value, usual in names if value != usual)


def measure(f_min: float, folder: Path | None, cpus: set[int], effort: Effort) -> dict[str, Any]:
    """Time all peers that are installed on uniform grids from ``f_min`` to 2048 Hz.

    Parameters
    ----------
    f_min:
        5 or 15 Hz.
    folder:
        Of the peers' environments.
    cpus:
        Where all of them run.
    effort:
        How many grids, draws and epochs.

    Returns
    -------
    ``peers``: of each its versions, points, median seconds, fit and batches; ``missing``: of each of the others, why.
    """
    sizes = sorted({*grid_sizes(effort.grids), *QUOTED})
    draws, epochs = effort.draws, effort.epochs
    with ExitStack() as stack:
        workers, missing = _workers(stack, candidates(f_min), folder, cpus)
        cases = {}
        for entry, (worker, _) in workers.items():
            for points in sizes:
                calls = max(1, min(draws, 400_000 // (points + 10_000)))
                cases[entry.name, 1, points] = partial(_time, worker, points=points, calls=calls)
            for rows, points in BATCHES if entry.batches else ():
                cases[entry.name, rows, points] = partial(_time, worker, points=points, rows=rows)
        found = shuffled(cases, epochs, after_epoch=partial(_progress, f_min, epochs))
    seconds = {case: median(values) for case, values in found.items()}
    return {
        "f_min": f_min,
        "grids": effort.grids,
        "draws": draws,
        "epochs": epochs,
        "peers": [_row(entry, about, sizes, seconds) for entry, (_, about) in workers.items()],
        "missing": missing,
    }


def _workers(
    stack: ExitStack, entries: tuple[Entry, ...], folder: Path | None, cpus: set[int]
) -> tuple[dict[Entry, tuple[Worker, dict[str, Any]]], dict[str, str]]:
    workers, missing = {}, {}
    for entry in entries:
        python = find_python(folder, entry.environment)
        if python is None:
            missing[entry.name] = f"not installed, see benchmarks/peers/{entry.script}"
            continue
        worker = stack.enter_context(Worker([python, entry.path, entry.argument], cpus=cpus))
        try:
            workers[entry] = worker, worker.ask("about")
            worker.ask("time", points=100)
        except WorkerFailed as error:
            workers.pop(entry, None)
            missing[entry.name] = error.detail.strip().splitlines()[-1].strip()
    return workers, missing


def _time(worker: Worker, **request: Any) -> list[float]:
    found: list[float] = worker.ask("time", **request)["seconds"]
    return found


def _row(entry: Entry, about: dict[str, Any], sizes: list[int], seconds: dict[Any, float]) -> dict[str, Any]:
    times = [seconds[entry.name, 1, points] for points in sizes]
    fit = fit_cost(sizes, times)
    return {
        "name": entry.name,
        "versions": about["versions"],
        "overhead_seconds": fit.overhead,
        "per_point_seconds": fit.per_point,
        "points": sizes,
        "seconds": times,
        "batches": [
            {"rows": rows, "points": points, "seconds_per_waveform": seconds[entry.name, rows, points] / rows}
            for rows, points in BATCHES
            if entry.batches
        ],
    }


def _progress(f_min: float, epochs: int, epoch: int) -> None:
    print(f"from {f_min:g} Hz: epoch {epoch} of {epochs}", file=sys.stderr, flush=True)


def save(found: dict[str, Any], folder: Path, setup: dict[str, Any]) -> None:
    """One JSON file for each peer, and one that says who is missing and why."""
    folder.mkdir(parents=True, exist_ok=True)
    where = {key: found[key] for key in ("f_min", "grids", "draws", "epochs")} | {"setup": setup}
    for row in found["peers"]:
        name = row["name"].lower().replace(" ", "-")
        text = json.dumps(where | row, indent=1)
        (folder / f"from-{found['f_min']:g}-hz-{name}.json").write_text(text + "\n", encoding="utf-8")
    text = json.dumps(where | {"missing": found["missing"]}, indent=1)
    (folder / f"from-{found['f_min']:g}-hz.json").write_text(text + "\n", encoding="utf-8")
