"""Mismatch of the shipped models on waveforms they never saw: ``python -m benchmarks.accuracy``.

The figures for mlgw_bns were measured with the same TEOBResumSPA, noise and band, on waveforms uniform in its own box.
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.page import fill
from benchmarks.whole_waveform.rows import mismatch_table, whole_rows
from bnserve_protocol import BnserveError, ModelUnknown
from bnserve_store import Artifact, ModelStore
from bnserve_surrogate.training.validation.fresh import validate_artifact
from bnserve_surrogate.training.validation.measurement import Validation

Row = dict[str, Any]
PREDECESSORS: tuple[Row, ...] = (
    {"model": "mlgw_bns 0.12.1 `default`, q <= 2", "where": "uniform", "values": (1.6e-6, 4.2e-6, 1.0e-5, 2.0e-5)},
    {"model": "mlgw_bns 0.12.1 `fast`, q <= 2", "where": "uniform", "values": (3.6e-6, 1.7e-5, 5.9e-5, 2.2e-4)},
    {
        "model": "mlgw_bns 2.0.1, kernel ridge on 8,192 waveforms, q <= 2",
        "where": "uniform",
        "values": (9.9e-9, 2.7e-7, 7.7e-6, 2.2e-5),
    },
)


@dataclass(frozen=True)
class Case:
    """Binaries and a detector."""

    label: str
    options: dict[str, Any]
    edges: bool = False


CASES = (
    Case("M = 2.8, ET-D", {}, edges=True),
    Case("M = 2, ET-D", {"total_mass": 2.0}),
    Case("M = 4, ET-D", {"total_mass": 4.0}),
    Case("M = 2.8, Advanced LIGO from 20 Hz", {"noise": "aLIGO-design", "f_min": 20.0}),
)


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    options = _parser().parse_args(arguments)
    store = ModelStore.default(options.store or ())
    try:
        rows: list[Row] = []
        whole: list[Row] = []
        for named in options.models:
            name, _, version = named.partition("@")
            try:
                artifact = store.load(name, version or "stable")
            except ModelUnknown:
                print(f"There is no model '{name}' in these stores: left out.", file=sys.stderr)
                continue
            whole += whole_rows(artifact, _counts(options), options.seed, options.work, options.jobs)
            rows += [] if options.whole else measured(artifact, options)
        _say(rows, whole, options)
    except BnserveError as error:
        print(error.detail, file=sys.stderr)
        return 1
    return 0 if rows or whole else 1


def _say(rows: list[Row], whole: list[Row], options: argparse.Namespace) -> None:
    tables = {
        "accuracy": table(rows) if rows else [],
        "whole waveforms": mismatch_table(whole, "what") if whole else [],
    }
    if options.json:
        print(json.dumps({"rows": rows, "whole": whole, "predecessors": PREDECESSORS}))
    else:
        print("\n\n".join("\n".join(lines) for lines in tables.values() if lines))
    for place, lines in tables.items():
        if options.page and lines:
            fill(options.page, place, lines)


def _counts(options: argparse.Namespace) -> dict[str, int]:
    return {"uniform": 64, "edges": 32} if options.short else {"uniform": options.count, "edges": options.edges}


def measured(artifact: Artifact, options: argparse.Namespace) -> list[Row]:
    """Every case for one model."""
    name = f"`{artifact.manifest.name}` {artifact.manifest.version}"
    counted, rows = _counts(options), []
    for case in CASES:
        counts = counted if case.edges else {"uniform": counted["uniform"]}
        validations = validate_artifact(
            artifact,
            options.work,
            counts=counts,
            seed=options.seed,
            n_jobs=options.jobs,
            own_function=options.generator,
            **case.options,
        )
        rows += [_row(name, case.label, kind, validation) for kind, validation in validations.items()]
    return rows


def table(rows: list[Row]) -> list[str]:
    """Lines of two tables in Markdown: mismatches, and the alignment of the merger."""
    lines = mismatch_table(rows, "detector")
    for row in PREDECESSORS:
        values = " | ".join(f"{value:.1e}" for value in row["values"])
        lines.append(f"| {row['model']} | {row['where']} | M = 2.8, ET-D | {values} | |")
    lines += ["", "| model, M = 2.8 | binaries | merger time: median, 99 %, max | its phase: median, 99 %, max |"]
    lines.append("|---|---|---|---|")
    for row in rows:
        if row["case"] == CASES[0].label:
            time = ", ".join(f"{1e6 * row['merger_time'][level]:.1f}" for level in ("median", "99 %", "max"))
            phase = ", ".join(f"{row['merger_phase'][level]:.1e}" for level in ("median", "99 %", "max"))
            lines.append(f"| {row['model']} | {row['count']:,} {row['where']} | {time} us | {phase} rad |")
    return lines


def _row(model: str, case: str, kind: str, validation: Validation) -> Row:
    summary = validation.summary(baseline=False)
    return {
        "model": model,
        "case": case,
        "where": {"uniform": "uniform", "edges": "on faces, edges, corners"}[kind],
        "count": summary["count"],
        "mismatch": summary["mismatch"],
        "above_three_times_estimate": summary.get("above_three_times_estimate"),
        "merger_time": summary["merger_time_error_seconds"],
        "merger_phase": summary["merger_phase_error_radians"],
    }


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.accuracy", description=__doc__.splitlines()[0])
    parser.add_argument(
        "models", nargs="*", default=["default", "fast", "paper"], metavar="MODEL[@VERSION]", help="(all shipped)"
    )
    parser.add_argument("--store", type=Path, action="append", metavar="DIR", help="searched before the shipped models")
    parser.add_argument(
        "--generator", metavar="MODULE:FUNCTION", help="of models trained on a function of yours, which is imported"
    )
    parser.add_argument("--work", type=Path, default=Path("runs"), metavar="DIR", help="where data are kept (runs)")
    parser.add_argument("--count", type=int, default=4096, metavar="N", help="waveforms, uniform in the box (4096)")
    parser.add_argument("--edges", type=int, default=1024, metavar="N", help="on faces, edges, corners (1024)")
    parser.add_argument("--seed", type=int, default=2024, metavar="N", help="as bnserve validate's (2024)")
    parser.add_argument("--jobs", type=int, default=-1, metavar="N", help="processes at once (all cores)")
    parser.add_argument("--short", action="store_true", help="64 and 32 waveforms")
    parser.add_argument("--whole", action="store_true", help="of models with several modes, these alone")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of tables")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="put the tables into this page, too")
    return parser


if __name__ == "__main__":
    sys.exit(main())
