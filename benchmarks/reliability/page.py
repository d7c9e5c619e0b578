"""The page of promises and the README's table, from the results that are kept."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Any

from benchmarks.page import fill
from benchmarks.reliability.outcome import Promise, find, in_present_names, names, promise_of
from benchmarks.reliability.record import read
from benchmarks.workers import ROOT

PAGE = ROOT / "docs" / "explanations" / "reliability.md"
README = ROOT / "README.md"
FIRST = ("kill", "overload", "drain", "digests", "soak")
"""The promises that the README shows; the page has all."""


def write_pages(results: Path, page: Path, readme: Path) -> None:
    """Fill the marked places of the page (``promises``) and of the README (``reliability``)."""
    found = [(name, find(name), read(results / f"{name}.json")) for name in names()]
    fill(page, "promises", [line for each in found for line in _section(*each)])
    rows = [_row(*each) for each in found if each[0] in FIRST]
    fill(readme, "reliability", ["| Promise | Figure | Command |", "|---|---|---|", *rows])


def _section(name: str, promise: Promise, record: dict[str, Any] | None) -> list[str]:
    return [
        "",
        f"## {promise_of(promise)}",
        "",
        *textwrap.wrap(promise.MECHANISM, 120),
        "",
        f"- bar: {promise.BAR}",
        *_measured(name, record),
        *_seen_to_fail(promise, record),
    ]


def _measured(name: str, record: dict[str, Any] | None) -> list[str]:
    if record is None or "summary" not in record:
        return [f"- not measured yet: `python -m benchmarks.reliability {name}`"]
    verdict = "" if record["passed"] else " (**the bar is missed**)"
    return [
        in_present_names(f"- measured: **{record['summary']}**{verdict}"),
        f"- command: `{in_present_names(record['command'])}`, "
        f"{record['date']}, {record['machine']}{_circumstances(record)}",
    ]


def _circumstances(record: dict[str, Any]) -> str:
    if "seconds" not in record:
        return ""
    stolen = 100 * record["stolen"]
    return f"; {record['seconds']:,} s, while {stolen:.0f} % of the processors' time went to other machines"


def _seen_to_fail(promise: Promise, record: dict[str, Any] | None) -> list[str]:
    seen: dict[str, dict[str, Any]] = record["injected"] if record else {}
    lines = []
    for injected, effect in promise.INJECTED_FAULTS.items():
        run = seen.get(injected)
        if run is None:
            lines.append(f"- with `--inject {injected}` ({effect}): not run yet")
        else:
            verdict = "NOT seen to fail" if run["passed"] else "seen to fail"
            lines.append(f"- {verdict} with `{in_present_names(run['command'])}` ({effect}): {run['summary']}")
    return lines


def _row(name: str, promise: Promise, record: dict[str, Any] | None) -> str:
    figure = "not measured yet"
    if record is not None and "summary" in record:
        figure = record["summary"] if record["passed"] else f"{record['summary']} (bar missed: {promise.BAR})"
    return f"| {promise_of(promise)} | {figure} | `python -m benchmarks.reliability {name}` |"
