"""One picture of everything that grows."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.axes import Axes

from benchmarks.figures import style
from benchmarks.growth.turning import cost_rises, memory_takes_over, saturates
from bnserve_service.bench.plots import number_axis, time_axis


def draw(found: dict[str, Any], path: Path) -> None:
    """Four panels."""
    with style.talk():
        figure = style.figure(13.5, 9.0)
        panels = figure.subplots(2, 2).ravel()
        _samples(panels[0], found["grid"], "Grid: one waveform", "points")
        _samples(panels[1], found["batch"], "Batch on 277 points", "waveforms in a batch")
        _clients(panels[2], found["clients"])
        _models(panels[3], found["models"])
        figure.savefig(path)


def _samples(axes: Axes, rows: list[dict[str, Any]], title: str, label: str) -> None:
    sizes = [row["size"] for row in rows]
    for key, name, colour in (
        ("seconds", "evaluation", style.BLUE),
        ("seconds_to_write", "writing as many bytes", style.GREY),
    ):
        costs = [1e9 * row[key] / row["samples"] for row in rows]
        axes.loglog(sizes, costs, "o-", color=colour, markersize=5, label=name)
    axes.set_title(title)
    axes.set(xlabel=label, ylabel="ns for each sample of h+ and hx")
    axes.set_xticks([10**k for k in range(8) if sizes[0] <= 10**k < 2 * sizes[-1]][-6::2])
    number_axis(axes.xaxis)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    for turn, text, colour in (
        (cost_rises(rows), "dearer from here", style.ORANGE),
        (memory_takes_over(rows), "memory: half of the time", style.PINK),
    ):
        if turn is not None:
            axes.axvline(turn, color=colour, linewidth=1.4, linestyle=(0, (5, 3)), label=f"{text} ({turn:,})")
    axes.legend(fontsize=11, frameon=True, framealpha=0.95, edgecolor="none")


def _clients(axes: Axes, rows: list[dict[str, Any]]) -> None:
    sizes = [row["size"] for row in rows]
    axes.plot(sizes, [row["rows_per_second"] for row in rows], "o-", color=style.BLUE, markersize=5)
    axes.set_xscale("log", base=2)
    axes.set_xticks(sizes)
    number_axis(axes.xaxis)
    axes.axvline(saturates(rows), color=style.ORANGE, linewidth=1.4, linestyle=(0, (5, 3)), label="nine tenths of most")
    axes.legend(fontsize=11, loc="lower right", frameon=True, framealpha=0.95, edgecolor="none")
    axes.set_title("Clients with single requests")
    axes.set(xlabel="clients at the same time", ylabel="waveforms per second (dots)", ylim=(0, None))
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
    waiting = axes.twinx()
    waiting.plot(sizes, [row["seconds"] for row in rows], "s--", color=style.GREEN, markersize=4, linewidth=1.4)
    waiting.set(yscale="log")
    waiting.set_ylabel("time of an answer (squares)", color=style.GREEN)
    waiting.grid(visible=False)
    time_axis(waiting.yaxis)


def _models(axes: Axes, rows: list[dict[str, Any]]) -> None:
    sizes = [row["size"] for row in rows]
    axes.plot(sizes, [1e6 * row["seconds"] for row in rows], "o-", color=style.BLUE, markersize=5)
    axes.set_xscale("log", base=2)
    axes.set_xticks(sizes)
    number_axis(axes.xaxis)
    axes.set_title("Models in one process, asked in turns")
    axes.set(xlabel="models", ylabel="us for one waveform (dots)", ylim=(0, None))
    memory = axes.twinx()
    memory.plot(sizes, [row["megabytes"] for row in rows], "s--", color=style.GREEN, markersize=4, linewidth=1.4)
    memory.set_ylabel("memory of the process, MB (squares)", color=style.GREEN)
    memory.set_ylim(0, None)
    memory.grid(visible=False)
