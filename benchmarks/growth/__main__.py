"""``python -m benchmarks.growth``: how cost grows with batch, grid, clients and models, up to the service's limits."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from benchmarks.growth.axes import grow_batch, grow_clients, grow_grid, grow_models
from benchmarks.growth.turning import cost_rises, memory_takes_over, saturates
from benchmarks.page import fill
from benchmarks.speed.setup import processor_name
from benchmarks.workers import unwind_on_sigterm
from bnserve_protocol import BnserveError
from bnserve_service.bench.report import duration


def main(arguments: list[str] | None = None) -> int:
    """Measure, print, draw; returns the exit status."""
    options = _parser().parse_args(arguments)
    try:
        found = measure(options.short)
    except BnserveError as error:
        print(error.detail, file=sys.stderr)
        return 1
    lines = report(found)
    print(json.dumps(found) if options.json else "\n".join(lines))
    if options.output:
        options.output.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    if options.image:
        from benchmarks.growth.drawing import draw

        draw(found, options.image)
    if options.page:
        command = "$ python -m benchmarks.growth" + (" --short" if options.short else "")
        fill(options.page, "growth", ["```text", command, *lines, "```"])
    return 0


def measure(short: bool) -> dict[str, Any]:
    """Everything, up to 4,096 rows and 2^20 frequencies, which are the default limits of a service."""
    step, epochs = (16, 2) if short else (4, 7)
    rows = [step**k for k in range(1 + (3 if short else 6))]
    points = [4**k for k in range(2, 11, 2 if short else 1)]
    clients = (1, 8, 64) if short else (1, 2, 4, 8, 16, 32, 64, 128)
    models = (1, 8) if short else (1, 2, 4, 8, 16, 32, 64)
    loaded = grow_models(models, 3 if short else 10)  # first: what the other measurements leave behind is no model's
    return {
        "processor": processor_name(),
        "grid": grow_grid(points, epochs),
        "batch": grow_batch(rows, epochs),
        "clients": grow_clients(clients, 0.5 if short else 2.0),
        "models": loaded,
    }


def report(found: dict[str, Any]) -> list[str]:
    """Aligned lines, and what the curves turn at."""
    lines = [found["processor"]]
    for key, what in (("grid", "points, one waveform"), ("batch", "waveforms on 277 points")):
        rows = found[key]
        lines += ["", f"{what:>24}{'time':>11}{'a sample':>11}{'writing alone':>15}"]
        for row in rows:
            each, alone = row["seconds"] / row["samples"], row["seconds_to_write"] / row["samples"]
            lines.append(f"{row['size']:>24,}{duration(row['seconds']):>11}{duration(each):>11}{duration(alone):>15}")
        lines.append(f"a sample costs half as much again as the cheapest: {_from(cost_rises(rows))}; ")
        lines[-1] += f"writing fresh memory is half of the time: {_from(memory_takes_over(rows))}"
    lines += ["", f"{'clients, one waveform':>24}{'rows/s':>11}{'an answer':>11}{'server':>15}"]
    for row in found["clients"]:
        memory = f"{row['megabytes']:.0f} MB"
        lines.append(f"{row['size']:>24,}{row['rows_per_second']:>11,.0f}{duration(row['seconds']):>11}{memory:>15}")
    lines.append(f"nine tenths of the most: from {saturates(found['clients'])} clients on")
    lines += ["", f"{'models, one waveform':>24}{'time':>11}{'':>11}{'process':>15}"]
    for row in found["models"]:
        lines.append(f"{row['size']:>24,}{duration(row['seconds']):>11}{'':>11}{f'''{row['megabytes']:.0f} MB''':>15}")
    return lines


def _from(size: int | None) -> str:
    return "nowhere" if size is None else f"from {size:,} on"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.growth", description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true", help="half a minute: few sizes, few repetitions")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of tables")
    parser.add_argument("--output", type=Path, metavar="FILE.json", help="also save it")
    parser.add_argument("--image", type=Path, metavar="FILE.png", help="draw the curves")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="put the tables into this page, too")
    return parser


if __name__ == "__main__":
    unwind_on_sigterm()
    sys.exit(main())
