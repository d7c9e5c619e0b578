"""The page of a run."""

from __future__ import annotations

import base64
import html
import io
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_posterior.events import EventInvalid
from bnserve_posterior.report._figures import all_figures
from bnserve_posterior.running import Outcome, describe
from bnserve_store import replacing

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
    images = "".join(_image(caption, figure) for caption, figure in all_figures(outcome))
    summary = describe(outcome)
    page = _PAGE.format(
        title=html.escape(path.stem),
        lead=html.escape(_lead(summary)),
        summary=_table(("", ""), [(name, _written(value)) for name, value in summary.items() if _plain(value)]),
        doubts=_list("What is doubtful", outcome.prepared.doubts),
        parameters=_table(("parameter", "5 %", "median", "95 %"), _intervals(outcome)),
        facts=_list("What was done", outcome.prepared.facts),
        versions=_table(("", ""), [(name, str(value)) for name, value in summary["versions"].items()]),
        digests=_table(("", "SHA-256"), [(name, str(value)) for name, value in summary["digests"].items()]),
        images=images,
    )
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


def _image(caption: str, figure: Any) -> str:
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", bbox_inches="tight", metadata={"Software": None})
    encoded = base64.b64encode(buffer.getvalue()).decode()
    text = html.escape(caption)
    return f'<figure><img src="data:image/png;base64,{encoded}" alt="{text}"><figcaption>{text}</figcaption></figure>'


def _table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    first = "".join(f"<th>{html.escape(cell)}</th>" for cell in head)
    body = "".join(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f"<div class=wide><table><tr>{first}</tr>{body}</table></div>"


def _list(title: str, sentences: list[str]) -> str:
    if not sentences:
        return ""
    return f"<h2>{title}</h2><ul>{''.join(f'<li>{html.escape(one)}</li>' for one in sentences)}</ul>"


_PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title>
<style>body{{font:16px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#1b2733}}
img{{width:100%}}figure{{margin:2rem 0}}figcaption{{color:#5a6b7b}}h2{{margin-top:2.5rem}}
table{{border-collapse:collapse;font-size:14px}}td,th{{text-align:left;padding:.2rem 1rem .2rem 0;
border-bottom:1px solid #e6eaee;overflow-wrap:anywhere}}.wide{{overflow-x:auto}}</style>
<h1>{title}</h1><p>{lead}</p>{summary}{doubts}{images}<h2>Parameters</h2>{parameters}{facts}
<h2>Versions</h2>{versions}<h2>Digests</h2>{digests}</html>
"""
