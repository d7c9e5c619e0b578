"""``python -m benchmarks.peers``: the paper's two benchmark figures, with all peers and bnserve.

Every peer runs in its own environment as a process that waits for its turn; all grids, parameters and peers are timed
in shuffled epochs on one processor. ``--install`` makes the environments from what each script says.
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
from benchmarks.peers.candidates import candidates
from benchmarks.peers.measuring import QUOTED, Effort, measure, save
from benchmarks.speed.setup import one_cpu, processor_name
from benchmarks.workers import ROOT, unwind_on_sigterm
from bnserve_protocol import BnserveError
from bnserve_service.bench.report import duration


def main(arguments: list[str] | None = None) -> int:
    """Measure, print, save, draw; returns the exit status."""
    options = _parser().parse_args(arguments)
    starts = [float(each) for each in (options.f_min or ["5", "15"])]
    if options.install:
        return 0 if _install(starts, options.peers) else 1
    everywhere = os.sched_getaffinity(0)
    cpus = everywhere if options.unpinned else {options.cpu} if options.cpu is not None else one_cpu()
    setup = {"processor": processor_name(), "pinned_to": None if options.unpinned else sorted(cpus)}
    effort = Effort(8, 3, 2) if options.short else Effort(options.grids, options.draws, options.epochs)
    try:
        for f_min in starts:
            found = _saved(f_min, options) if options.redraw else measure(f_min, options.peers, cpus, effort)
            if not options.redraw:
                save(found, options.results, setup)
            _publish(found, setup, options)
    except BnserveError as error:
        print(error.detail, file=sys.stderr)
        return 1
    return 0


def _publish(found: dict[str, Any], setup: dict[str, Any], options: argparse.Namespace) -> None:
    lines = table(found)
    print(json.dumps(found | {"setup": setup}) if options.json else "\n".join(lines), flush=True)
    if options.images:
        from benchmarks.peers.drawing import draw

        draw(found, options.images / f"speed_from_{found['f_min']:g}_hz.png")
    if options.page:
        effort = Effort(found["grids"], found["draws"], found["epochs"])
        command = f"$ python -m benchmarks.peers --f-min {found['f_min']:g}{effort.options}"
        fill(options.page, f"peers from {found['f_min']:g} Hz", ["```text", command, *lines, "```"])


def _install(starts: list[float], folder: Path | None) -> bool:
    if folder is None:
        print("Name a folder for the environments with --peers DIR or $PEERS.", file=sys.stderr)
        return False
    scripts = {entry.environment: entry.path for f_min in starts for entry in candidates(f_min) if entry.environment}
    done = [install(script, "PEERS", folder, ROOT) for script in scripts.values()]
    return all(done)


def _saved(f_min: float, options: argparse.Namespace) -> dict[str, Any]:
    """What an earlier run saved."""
    whole = json.loads((options.results / f"from-{f_min:g}-hz.json").read_text(encoding="utf-8"))
    rows = []
    for entry in candidates(f_min):
        path = options.results / f"from-{f_min:g}-hz-{entry.name.lower().replace(' ', '-')}.json"
        if path.exists() and entry.name not in whole["missing"]:
            rows.append(json.loads(path.read_text(encoding="utf-8")))
    return whole | {"peers": rows}


def table(found: dict[str, Any]) -> list[str]:
    """Aligned lines."""
    start = f"from {found['f_min']:g} Hz"
    head = f"{start:<30}{'overhead':>10}{'per point':>11}" + "".join(f"{f'{points:,} pts':>13}" for points in QUOTED)
    lines = [f"{head}   batches of 256 x 277 / 256 x 1,000 / 16 x 10,000"]
    for row in found["peers"]:
        times = dict(zip(row["points"], row["seconds"], strict=True))
        line = f"{row['name']:<30}{duration(row['overhead_seconds']):>10}{1e9 * row['per_point_seconds']:>8.2f} ns"
        line += "".join(f"{duration(times[points]):>13}" for points in QUOTED)
        batches = " / ".join(duration(batch["seconds_per_waveform"]) for batch in row["batches"])
        lines.append(f"{line}   {batches}".rstrip())
    return [*lines, *(f"{name}: {why}" for name, why in found["missing"].items())]


def _parser() -> argparse.ArgumentParser:
    here = ROOT / "benchmarks" / "peers" / "results"
    parser = argparse.ArgumentParser(prog="python -m benchmarks.peers", description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--f-min", action="append", choices=["5", "15"], help="Hz: one of the two figures (both)")
    add("--peers", type=Path, default=folder_from_environment("PEERS"), metavar="DIR", help="environments ($PEERS)")
    add("--install", action="store_true", help="make the environments, and end")
    add("--short", action="store_true", help="a minute or two: 8 grids, 3 draws, 2 epochs")
    usual = Effort()
    add("--grids", type=int, default=usual.grids, metavar="N", help=f"sizes ({usual.grids}, as in the paper)")
    add("--draws", type=int, default=usual.draws, metavar="N", help=f"binaries ({usual.draws}, as in the paper)")
    add("--epochs", type=int, default=usual.epochs, metavar="N", help=f"({usual.epochs}, as in the paper)")
    add("--redraw", action="store_true", help="draw and print what an earlier run saved")
    add("--cpu", type=int, metavar="N", help="the processor to run on (the last one)")
    add("--unpinned", action="store_true", help="let everything run where the system puts it")
    add("--json", action="store_true", help="print JSON objects instead of tables")
    add("--results", type=Path, default=here, metavar="DIR", help="where results go (benchmarks/peers/results)")
    add("--images", type=Path, metavar="DIR", help="draw the figures into this folder")
    add("--page", type=Path, metavar="FILE.md", help="put the tables into this page, too")
    return parser


if __name__ == "__main__":
    unwind_on_sigterm()
    sys.exit(main())
