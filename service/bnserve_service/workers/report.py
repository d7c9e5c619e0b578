"""What the supervisor tells whoever reads the metrics, in the form of ``shared.metrics``.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from bnserve_service.shared.folder import REPORT
from bnserve_service.workers.roster import Worker

REASONS = ("killed", "ended", "hung", "silent", "slow", "stopped", "stuck", "unready")


def write_report(shared: Path, workers: Sequence[Worker], restarts: Mapping[str, int]) -> None:
    """Replace the report: how many workers there are, which places they have, and how often which kind of end came."""
    alive = [worker for worker in workers if not worker.killed]
    families = [
        _family("bnserve_workers", "gauge", "Worker processes", [({}, sum(not worker.greets for worker in alive))]),
        _family(
            "bnserve_workers_serving", "gauge", "Worker processes that are ready and wanted",
            [({}, sum(worker.serves for worker in alive))],
        ),
        _family(
            "bnserve_worker_restarts", "counter", "Worker processes that ended and were replaced, by reason",
            [({"reason": reason}, restarts.get(reason, 0)) for reason in REASONS],
        ),
    ]  # fmt: skip
    report = {"places": [worker.slot for worker in alive], "families": families}
    fresh = shared / f"{REPORT}.new"
    try:
        fresh.write_text(json.dumps(report))
        fresh.replace(shared / REPORT)
    except OSError:  # no room, or the folder is gone: supervising counts more
        return


def _family(
    name: str, kind: str, description: str, samples: Sequence[tuple[dict[str, str], float]]
) -> dict[str, object]:
    suffix = "_total" if kind == "counter" else ""
    return {
        "name": name,
        "kind": kind,
        "description": description,
        "samples": [[name + suffix, labels, float(value)] for labels, value in samples],
    }
