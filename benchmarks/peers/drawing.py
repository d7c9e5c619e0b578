"""The paper's figures of evaluation times, with all peers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from benchmarks.figures import style
from benchmarks.peers.candidates import OWN, Entry, candidates
from bnserve_service.bench.plots import number_axis, time_axis
from bnserve_service.bench.report import duration

LABEL_DECADES = 0.27
"""Height of a label of two lines on the logarithmic axis."""


def draw(found: dict[str, Any], path: Path) -> None:
    """Times against points with their fits, and the speed of bnserve over each peer."""
    with style.talk():
        figure = style.figure(13.0, 7.6)
        axes, ratios = figure.subplots(1, 2, width_ratios=(1.75, 1.0))
        entries = {entry.name: entry for entry in candidates(found["f_min"])}
        rows = [(entries[row["name"]], row) for row in found["peers"]]
        for entry, row in rows:
            _curve(axes, entry, row)
        axes.set_title(f"One waveform from {found['f_min']:g} Hz")
        axes.set(xlabel="points of a uniform grid up to 2048 Hz", ylabel="time, one core", xscale="log", yscale="log")
        time_axis(axes.yaxis)
        number_axis(axes.xaxis)
        _names(axes, rows)
        _ratios(ratios, rows)
        figure.savefig(path)


def _curve(axes: Axes, entry: Entry, row: dict[str, Any]) -> None:
    points, own = np.array(row["points"]), entry.name.startswith(OWN)
    fit = row["overhead_seconds"] + row["per_point_seconds"] * points
    axes.plot(points, fit, color=entry.colour, linewidth=2.8 if own else 1.4, alpha=1.0 if own else 0.75)
    axes.plot(points, row["seconds"], entry.marker, color=entry.colour, markersize=5.5 if own else 4.0,
              markeredgewidth=0.0, alpha=0.9)  # fmt: skip


def _names(axes: Axes, rows: list[tuple[Entry, dict[str, Any]]]) -> None:
    """Names at the left ends of the curves, moved apart where they would overlap."""
    ordered = sorted(rows, key=lambda pair: float(pair[1]["seconds"][0]))
    low = np.log10([row["seconds"][0] for _, row in ordered])
    places = low.copy()
    for index in range(1, len(places)):
        places[index] = max(places[index], places[index - 1] + LABEL_DECADES)
    places -= max(0.0, (places - low).mean())
    for place, (entry, row) in zip(places, ordered, strict=True):
        own = entry.name.startswith(OWN)
        text = f"{entry.name}\n{duration(row['overhead_seconds'])} + {1e9 * row['per_point_seconds']:.1f} ns N"
        axes.annotate(
            text, (row["points"][0], row["seconds"][0]), (7.2, 10.0**place), color=entry.colour, fontsize=9.5,
            ha="right", va="center", weight="bold" if own else "normal", annotation_clip=False, linespacing=1.05,
        )  # fmt: skip
    axes.set_xlim(row["points"][0] * 0.8, None)
    axes.yaxis.tick_right()
    axes.yaxis.set_label_position("right")
    axes.spines["left"].set_visible(False)


def _ratios(axes: Axes, rows: list[tuple[Entry, dict[str, Any]]]) -> None:
    own = np.array(next(row["seconds"] for entry, row in rows if entry.name.startswith(OWN)))
    for entry, row in rows:
        if not entry.name.startswith(OWN):
            axes.plot(row["points"], np.array(row["seconds"]) / own, color=entry.colour, linewidth=1.8)
    axes.axhline(1.0, color=style.INK, linewidth=1.0)
    axes.set_title(f"In units of {OWN}'s time")
    axes.set(xscale="log", yscale="log", xlabel="points")
    axes.set_xticks([10, 1_000, 100_000])
    number_axis(axes.xaxis)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}x")
