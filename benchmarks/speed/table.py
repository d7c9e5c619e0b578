"""The table of a run as text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from benchmarks.speed.bars import Bar

_PLACES = {"us": "{:.1f} us", "ns": "{:.2f} ns", "s": "{:.2f} s", "MB": "{:.0f} MB", "x": "{:.2f}x"}
_PLACES["of floor"] = _PLACES["x"]
_BARS = {unit: text.replace(".2f", "g").replace(".1f", "g") for unit, text in _PLACES.items()}
_PEER_UNITS = {"x": "us", "of floor": "us"}


def verdict(bar: Bar, value: float | None) -> str:
    """``goal``, ``must``, ``MISSED``, or ``not measured``."""
    if value is None:
        return "not measured"
    return "goal" if bar.reached(value, bar.goal) else "must" if bar.reached(value, bar.must) else "MISSED"


def lines_of(bars: Sequence[Bar], figures: dict[str, dict[str, Any]]) -> list[str]:
    """Aligned lines: what, measured, goal, must, which of them is reached, and the others' figures of the same run."""
    width = max(len(bar.what) for bar in bars)
    lines = [f"{'':<{width}}  {'measured':>10}  {'goal':>8}  {'must':>8}  reached       beside it, in the same run"]
    for bar in bars:
        figure = figures.get(bar.key)
        value = figure["value"] if figure else None
        shown = "" if value is None else _PLACES[bar.unit].format(value)
        goal, must = (_BARS[bar.unit].format(each) for each in (bar.goal, bar.must))
        line = f"{bar.what:<{width}}  {shown:>10}  {goal:>8}  {must:>8}  {verdict(bar, value):<12}  "
        lines.append((line + _beside(bar, figure or {})).rstrip())
    return lines


def _beside(bar: Bar, figure: dict[str, Any]) -> str:
    unit = figure.get("unit", _PEER_UNITS.get(bar.unit, bar.unit))
    parts = []
    if "ours" in figure:
        parts.append(f"bnserve {_number(figure['ours'], unit)}")
    parts += [f"{name} {_number(value, unit)}" for name, value in figure.get("peers", {}).items()]
    parts += [f"{name} {value:.2f}x" for name, value in figure.get("others", {}).items()]
    if bar.unit in ("us", "ns", "s"):
        peers = figure.get("peers", {}).values()
        parts = [f"{part} ({value / figure['value']:.1f}x)" for part, value in zip(parts, peers, strict=True)]
    return ", ".join(parts)


def _number(value: float, unit: str) -> str:
    if unit == "rows/s":
        return f"{value:,.0f} rows/s"
    if unit == "us" and value >= 10_000:
        return f"{value / 1e3:,.1f} ms"
    return _PLACES[unit].format(value)
