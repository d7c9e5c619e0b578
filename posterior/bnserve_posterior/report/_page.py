"""The page of a run."""

from __future__ import annotations

import html
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_posterior.events import EventInvalid
from bnserve_posterior.report._figures import all_figures
from bnserve_posterior.running import Outcome, describe
from bnserve_store import replacing, report_figure, report_page, report_table

_INTERVAL = (5.0, 50.0, 95.0)


def write_page(outcome: Outcome, path: Path) -> None:
    """Write the page, whole or not at all.

    Raises
    ------
    EventInvalid
        It cannot be written; the result is not affected.
    PackageMissing
        corner or matplotlib is not installed.
    """
    summary = describe(outcome)
    plain = [(name, _written(value)) for name, value in summary.items() if _plain(value)]
    parts = [
        f"<p>{html.escape(_lead(summary))}</p>",
        report_table(plain),
        _list("What is doubtful", outcome.prepared.doubts),
        *(report_figure(caption, figure, bbox_inches="tight") for caption, figure in all_figures(outcome)),
        "<h2>Parameters</h2>",
        report_table(_intervals(outcome), ("parameter", "5 %", "median", "95 %")),
        _list("What was done", outcome.prepared.facts),
        "<h2>Versions</h2>",
        report_table((name, str(value)) for name, value in summary["versions"].items()),
        "<h2>Digests (SHA-256)</h2>",
        report_table((name, str(value)) for name, value in summary["digests"].items()),
    ]
    page = report_page(path.stem, "".join(parts))
    try:
        with replacing(path) as temporary:
            temporary.write_text(page, encoding="utf-8")
    except OSError as error:
        raise EventInvalid(f"The page cannot be written to {path}: {error.strerror}. Make room.") from error


def _lead(summary: dict[str, Any]) -> str:
    check = summary["check"]
    exact = (
        "The full likelihood was not looked at."
        if check is None
        else f"At {check['samples']} samples ln L differs from that on the full grid by at most {check['largest']:.2g}."
    )
    return (
        f"ln of the evidence ratio {summary['log_evidence']:.2f} +- {summary['log_evidence_error']:.2f}, "
        f"{summary['effective_samples']} effective samples, k-hat {summary['k_hat']:.2f}. {exact}"
    )


def _plain(value: Any) -> bool:
    return isinstance(value, int | float | str)


def _written(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _intervals(outcome: Outcome) -> list[tuple[str, ...]]:
    rows = []
    for name, values in outcome.samples.values.items():
        if np.iscomplexobj(values) or not np.ptp(values) > 0.0:
            continue
        numbers = np.percentile(values, _INTERVAL)
        digits = 14 if name == "geocent_time" else 6
        rows.append((name, *(f"{number:.{digits}g}" for number in numbers)))
    return rows


def _list(title: str, sentences: list[str]) -> str:
    if not sentences:
        return ""
    return f"<h2>{title}</h2><ul>{''.join(f'<li>{html.escape(one)}</li>' for one in sentences)}</ul>"
