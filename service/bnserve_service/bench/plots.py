"""Pictures of a measurement."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from bnserve_service.bench.report import duration

INK, PALE = "#1b2733", "#7a8694"
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00")  # Okabe and Ito's
STYLE: dict[Any, Any] = {
    "font.size": 13,
    "axes.titlesize": 14,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6eaee",
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": False,
    "lines.linewidth": 2.0,
    "savefig.dpi": 140,
}


def save_plots(document: dict[str, Any], folder: Path) -> list[Path]:
    """Draw every part that was measured into a folder; the files."""
    folder.mkdir(parents=True, exist_ok=True)
    saved = []
    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(STYLE)
        for part, draw in _DRAWERS.items():
            if document.get(part) is not None:
                figure = Figure(figsize=(8.4, 5.0), layout="constrained")
                draw(document[part], figure.subplots())
                saved.append(folder / f"bench-{part}.png")
                figure.savefig(saved[-1])
    return saved


def time_axis(axis: Any) -> None:
    """A logarithmic axis with times in the units that suit them."""
    axis.set_major_formatter(FuncFormatter(lambda value, _: duration(value).replace(".00", "").replace(".0 ", " ")))
    axis.set_minor_formatter(NullFormatter())


def number_axis(axis: Any) -> None:
    """A logarithmic axis with plain numbers."""
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    axis.set_minor_formatter(NullFormatter())


def _single(found: dict[str, Any], axes: Axes) -> None:
    points, low_high = np.array(found["points"]), np.array(found["quartiles"]).T
    axes.set_title("One waveform")
    axes.fill_between(points, *low_high, color=COLOURS[0], alpha=0.2, linewidth=0, label="quartiles")
    axes.loglog(points, found["seconds"], "o", color=COLOURS[0], markersize=5, label="median")
    overhead, per_point = duration(found["overhead_seconds"]), 1e9 * found["per_point_seconds"]
    axes.loglog(points, found["fit_seconds"], color=INK, linewidth=1.3, label=f"{overhead} + {per_point:.2f} ns N")
    axes.set(xlabel="points of the grid, N", ylabel="time of one call")
    time_axis(axes.yaxis)
    number_axis(axes.xaxis)
    axes.legend(loc="upper left")


def _breakdown(found: dict[str, Any], axes: Axes) -> None:
    axes.set_title(f"One waveform on {found['points']:,} points: {duration(found['total'])}")
    names, seconds = list(found["parts"])[::-1], list(found["parts"].values())[::-1]
    bars = axes.barh(names, 1e6 * np.array(seconds), color=COLOURS[0], height=0.6)
    labels = [f"{duration(each)}  ({each / found['total']:.0%})" for each in seconds]
    axes.bar_label(bars, labels, padding=5, fontsize=11)
    axes.set_xlabel("microseconds")
    axes.set_xlim(0.0, 1.45e6 * max(seconds))
    axes.grid(visible=False, axis="y")
    axes.spines["left"].set_visible(False)
    axes.tick_params(axis="y", length=0)


def _batches(found: list[dict[str, Any]], axes: Axes) -> None:
    axes.set_title("Batches")
    for colour, points in zip(COLOURS, sorted({each["points"] for each in found}), strict=False):
        chosen = sorted((each for each in found if each["points"] == points), key=lambda each: int(each["rows"]))
        rows, rates = [each["rows"] for each in chosen], [each["rows_per_second"] for each in chosen]
        axes.loglog(rows, rates, "o-", color=colour, markersize=5, label=f"{points:,} points")
    axes.set(xlabel="waveforms in a batch", ylabel="waveforms per second")
    number_axis(axes.xaxis)
    number_axis(axes.yaxis)
    axes.legend(loc="upper left")


def _concurrency(found: list[dict[str, Any]], axes: Axes) -> None:
    axes.set_title(f"Clients that ask for one waveform after another ({found[0]['points']:,} points)")
    clients = [each["clients"] for each in found]
    axes.plot(clients, [each["rows_per_second"] for each in found], "o-", color=COLOURS[0], markersize=6)
    axes.set_xscale("log", base=2)
    axes.set_xticks(clients)
    axes.set(xlabel="clients at the same time", ylabel="waveforms per second", ylim=(0, None))
    number_axis(axes.xaxis)
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))


_DRAWERS: dict[str, Callable[[Any, Axes], None]] = {
    "single": _single,
    "breakdown": _breakdown,
    "batches": _batches,
    "concurrency": _concurrency,
}
