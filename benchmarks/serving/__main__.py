"""``python -m benchmarks.serving``: the same model behind bnserve and behind model servers, side by side.

Each server runs beside bnserve and is measured in turns with it, in short slices; both and their client on one
processor. Every answer is checked to be the model's. Needs the environments that ``--install`` makes.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from benchmarks.environments import folder_from_environment, install
from benchmarks.page import fill
from benchmarks.serving.contestants import CONTESTANTS
from benchmarks.serving.measuring import measure
from benchmarks.speed.setup import one_cpu, processor_name
from benchmarks.workers import ROOT, unwind_on_sigterm


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status: 0, or 1 when a server could not be measured."""
    options = _parser().parse_args(arguments)
    chosen = [each for each in CONTESTANTS if "all" in options.names or each.key in options.names]
    if options.serving is None:
        print("Name a folder for the servers' environments with --serving DIR or $SERVING.", file=sys.stderr)
        return 2
    if options.install:
        done = [install(each.script, "SERVING", options.serving, ROOT) for each in chosen]
        return 0 if all(done) else 1
    everywhere = os.sched_getaffinity(0)
    cpus = everywhere if options.unpinned else {options.cpu} if options.cpu is not None else one_cpu()
    os.sched_setaffinity(0, cpus)
    try:
        rows = measure(chosen, options.serving, cpus, short=options.short)
    finally:
        os.sched_setaffinity(0, everywhere)
    pinned = None if options.unpinned else sorted(cpus)
    record = {"setup": {"processor": processor_name(), "pinned_to": pinned, "short": options.short}, "servers": rows}
    text = json.dumps(record, indent=1)
    if options.output:
        options.output.write_text(text + "\n", encoding="utf-8")
    lines = table(rows)
    print(text if options.json else "\n".join(lines))
    if options.page:
        mark = "serving, not pinned" if options.unpinned else "serving"
        command = "$ python -m benchmarks.serving" + (" --unpinned" if options.unpinned else "")
        fill(options.page, mark, ["```text", command + (" --short" if options.short else ""), *lines, "```"])
    return 1 if any("error" in row for row in rows) else 0


def table(rows: list[dict[str, Any]]) -> list[str]:
    """Aligned lines; in brackets how many times better bnserve was in the same minutes."""
    lines = [
        f"{'':<20}{'one request':>20}{'256 x 277, rows/s':>24}{'64 x 10,000, rows/s':>24}{'32 clients, rows/s':>24}"
    ]
    for row in rows:
        if "error" in row:
            lines.append(f"{row['name']:<20}not measured: {row['error']}")
            continue
        cells = [f"{1e3 * row['theirs']['one']:.2f} ms ({row['ratio']['one']:.1f}x)"]
        for key in ("rows_277", "rows_10000", "clients_32"):
            cells.append(f"{row['theirs'][key]:,.0f} ({row['ratio'][key]:.1f}x)")
        lines.append(f"{row['name']:<20}{cells[0]:>20}" + "".join(f"{cell:>24}" for cell in cells[1:]))
    measured = [row["ours"] for row in rows if "ours" in row]
    if measured:
        ranges = {key: (min(o[key] for o in measured), max(o[key] for o in measured)) for key in measured[0]}
        cells = [f"{1e3 * ranges['one'][0]:.2f} to {1e3 * ranges['one'][1]:.2f} ms"]
        cells += [f"{low:,.0f} to {high:,.0f}" for key, (low, high) in ranges.items() if key != "one"]
        lines.append(f"{'bnserve':<20}{cells[0]:>20}" + "".join(f"{cell:>24}" for cell in cells[1:]))
    return lines


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.serving", description=__doc__.splitlines()[0])
    names = [each.key for each in CONTESTANTS]
    parser.add_argument(
        "names", nargs="*", choices=["all", *names], default="all", metavar="NAME", help=f"of {', '.join(names)} (all)"
    )
    parser.add_argument("--serving", type=Path, default=folder_from_environment("SERVING"), metavar="DIR",
                        help="the servers' environments ($SERVING)")  # fmt: skip
    parser.add_argument("--install", action="store_true", help="make the environments, and end")
    parser.add_argument("--short", action="store_true", help="short slices, few repetitions")
    parser.add_argument("--cpu", type=int, metavar="N", help="the processor to run on (the last one)")
    parser.add_argument("--unpinned", action="store_true", help="let everything run where the system puts it")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of a table")
    parser.add_argument("--output", type=Path, metavar="FILE.json", help="also save it")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="put the table into this page, too")
    return parser


if __name__ == "__main__":
    unwind_on_sigterm()
    sys.exit(main())
