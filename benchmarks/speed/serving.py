"""bnserve against model servers that serve the same model."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from benchmarks.serving.contestants import CONTESTANTS, MODEL_SERVERS
from benchmarks.serving.measuring import measure
from benchmarks.speed.setup import Setup

TRITON = "PyTriton"


def serving_figures(setup: Setup) -> dict[str, dict[str, Any]]:
    """The rows about model servers; without any of them, nothing, and a note."""
    if setup.serving is None:
        setup.notes.append("model servers: name the folder of their environments with --serving DIR or $SERVING")
        return {}
    os.sched_setaffinity(0, setup.cpus)
    try:
        chosen = [each for each in CONTESTANTS if each.name in MODEL_SERVERS]
        rows = measure(chosen, setup.serving, setup.cpus, short=setup.epochs <= 5)
    finally:
        os.sched_setaffinity(0, setup.all_cpus)
    setup.notes.extend(f"{row['name']}: {row['error']}" for row in rows if "error" in row)
    measured = {row["name"]: row for row in rows if "ratio" in row}
    figures = {}
    if TRITON in measured:
        figures["clients_32"] = _figure(measured, TRITON, "clients_32")
    if len(measured) == len(MODEL_SERVERS):  # "the best of them" is none of a few
        for key in ("rows_277", "rows_10000"):
            best = min(measured, key=lambda name: float(measured[name]["ratio"][key]))
            figures[key] = _figure(measured, best, key)
    return figures


def _figure(measured: Mapping[str, Any], name: str, key: str) -> dict[str, Any]:
    row = measured[name]
    return {
        "value": row["ratio"][key],
        "ours": row["ours"][key],
        "unit": "rows/s",
        "peers": {name: row["theirs"][key]},
        "all": {other: each["theirs"][key] for other, each in measured.items()},
    }
