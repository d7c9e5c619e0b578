"""``python -m benchmarks.speed``: every row of the table of speeds, measured side by side in one run.

Everything runs on one processor, servers and clients and peers together (but for the row about two), and takes turns in
shuffled epochs; figures are medians. Exit status: 0 when everything that must be reached is, 1 when something is
missed, 3 when nothing is missed but something could not be measured, because a peer is not installed.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.environments import folder_from_environment
from benchmarks.page import fill
from benchmarks.speed.bars import BARS
from benchmarks.speed.four_modes import four_modes
from benchmarks.speed.fresh import first_waveform, worker_memory
from benchmarks.speed.local import local_cases, local_figures, local_workers, two_cores
from benchmarks.speed.remote import remote_cases, remote_figures
from benchmarks.speed.serving import serving_figures
from benchmarks.speed.setup import Setup, one_cpu
from benchmarks.speed.table import lines_of, verdict
from benchmarks.workers import unwind_on_sigterm
from bnserve_protocol import BnserveError
from bnserve_service.bench.timing import shuffled


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    options = _parser().parse_args(arguments)
    everywhere = os.sched_getaffinity(0)
    cpus = everywhere if options.unpinned else {options.cpu} if options.cpu is not None else one_cpu()
    setup = Setup(
        cpus=cpus,
        all_cpus=everywhere,
        peers=options.peers,
        serving=options.serving,
        epochs=options.epochs or (5 if options.short else 25),
        load_seconds=1.0 if options.short else 4.0,
    )
    try:
        figures = measure(setup)
    except BnserveError as error:
        print(error.detail, file=sys.stderr)
        return 2
    verdicts = {bar.key: verdict(bar, figures.get(bar.key, {}).get("value")) for bar in BARS}
    record = {"setup": setup.about(), "figures": figures, "reached": verdicts, "notes": setup.notes}
    lines = _lines(setup, figures)
    print(json.dumps(record) if options.json else "\n".join(lines))
    if options.output:
        options.output.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    if options.page:
        command = "$ python -m benchmarks.speed" + (" --short" if options.short else "")
        fill(options.page, "speed", ["```text", command, *lines, "```"])
    return 1 if "MISSED" in verdicts.values() else 3 if "not measured" in verdicts.values() else 0


def _lines(setup: Setup, figures: dict[str, dict[str, Any]]) -> list[str]:
    about = setup.about()
    pinned = f"all on processor {about['pinned_to'][0]}" if about["pinned_to"] else "not pinned"
    head = f"{about['processor']}, Python {about['python']}, {pinned}, medians of {setup.epochs} epochs"
    notes = [f"not measured: {note}" for note in setup.notes]
    return [head, "", *lines_of(BARS, figures), *(["", *notes] if notes else [])]


def measure(setup: Setup) -> dict[str, dict[str, Any]]:
    """All figures by the key of their row; those that could not be measured are left out, and noted."""
    few = 3 if setup.epochs <= 5 else 7
    cores = two_cores(setup, 7 * few)
    os.sched_setaffinity(0, setup.cpus)
    try:
        of_four = four_modes(setup)
        figures = {"first_waveform": first_waveform(setup, few), "memory": worker_memory(setup)}
        with local_workers(setup) as workers, remote_cases(setup) as remote:
            seconds = shuffled(local_cases(workers) | remote, setup.epochs, after_epoch=_progress(setup.epochs))
        medians = {case: median(found) for case, found in seconds.items()}
    finally:
        os.sched_setaffinity(0, setup.all_cpus)
    figures |= local_figures(medians) | remote_figures(medians) | serving_figures(setup)
    return figures | ({"two_cores": cores} if cores else {}) | ({"four_modes": of_four} if of_four else {})


def _progress(epochs: int) -> Any:
    def show(epoch: int) -> None:
        if sys.stderr.isatty():
            print(f"\repoch {epoch} of {epochs}", end="\n" if epoch == epochs else "", file=sys.stderr, flush=True)

    return show


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.speed", description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true", help="few repetitions: minutes instead of a quarter of an hour")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of a table")
    parser.add_argument("--epochs", type=int, metavar="N", help="how often everything is timed (25; short: 5)")
    parser.add_argument("--cpu", type=int, metavar="N", help="the processor to run on (the last one)")
    parser.add_argument("--unpinned", action="store_true", help="let everything run where the system puts it")
    parser.add_argument(
        "--peers", type=Path, default=folder_from_environment("PEERS"), metavar="DIR",
        help="environments of the peers, made by python -m benchmarks.peers --install ($PEERS)",
    )  # fmt: skip
    parser.add_argument(
        "--serving", type=Path, default=folder_from_environment("SERVING"), metavar="DIR",
        help="environments of the model servers, made by python -m benchmarks.serving --install ($SERVING)",
    )  # fmt: skip
    parser.add_argument("--output", type=Path, metavar="FILE.json", help="also save the figures")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="put the table into this page, too")
    return parser


if __name__ == "__main__":
    unwind_on_sigterm()
    sys.exit(main())
