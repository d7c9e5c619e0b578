"""The mismatch of the shipped model across its parameters, two at a time."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from numpy.typing import NDArray

from benchmarks.figures import style
from benchmarks.figures.drawing import LEVELS, Drawing, quantile_row, quantiles, rounded, table
from benchmarks.figures.workspace import Workspace

Rows = NDArray[np.float64]
_LABELS = ("$q$", r"$\chi_1$", r"$\chi_2$", r"$\Lambda_1$", r"$\Lambda_2$")
_NAMES = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")


def draw(workspace: Workspace) -> Drawing:
    """Medians in cells of every pair, and the distribution in the corner."""
    inside = workspace.validation(workspace.waveforms("uniform", workspace.count(workspace.fresh, 32)))
    edges = workspace.validation(workspace.waveforms("edges", workspace.count(max(32, workspace.fresh // 4), 32)))
    low, high = np.quantile(inside.mismatch, [0.05, 0.95])
    norm = LogNorm(max(low, 1e-16), max(high, 1e-15))
    figure = style.figure(11.0, 9.5)
    grid = figure.subplots(4, 4, sharex="col", sharey="row")
    for first, second in combinations(range(5), 2):
        axis = grid[second - 1, first]
        cells = _cells(axis, inside.theta[:, first], inside.theta[:, second], inside.mismatch, norm)
        if second == 4:
            axis.set_xlabel(_LABELS[first])
        if first == 0:
            axis.set_ylabel(_LABELS[second])
    for row, column in combinations(range(4), 2):
        grid[row, column].remove()
    figure.align_labels()
    corner = figure.add_axes((0.60, 0.69, 0.37, 0.24))
    corner.set_in_layout(False)
    _distribution(corner, {"uniform": inside.mismatch, "faces, edges, corners": edges.mismatch})
    _colour_bar(figure, cells)
    figure.suptitle(
        f"Mismatch of {workspace.model_name}: median in each cell", x=0.01, ha="left", fontsize=16, fontweight="bold"
    )
    numbers: dict[str, Any] = {"uniform": quantiles(inside.mismatch), "edges": quantiles(edges.mismatch)}
    worst = {kind: v.theta[int(np.argmax(v.mismatch))] for kind, v in (("uniform", inside), ("edges", edges))}
    numbers["worst"] = {kind: dict(zip(_NAMES, map(rounded, theta), strict=True)) for kind, theta in worst.items()}
    rows = [
        quantile_row(f"uniform, {inside.mismatch.size}", inside.mismatch),
        quantile_row(f"faces, edges, corners, {edges.mismatch.size}", edges.mismatch),
    ]
    return Drawing(figure, numbers, table(["mismatch", *LEVELS], rows))


def _cells(axis: Axes, x: Rows, y: Rows, mismatch: Rows, norm: LogNorm) -> Any:
    size = max(4, int(np.sqrt(x.size / 20.0)))
    options: dict[str, Any] = {"gridsize": (size, int(0.7 * size)), "reduce_C_function": np.median}
    cells = axis.hexbin(x, y, C=mismatch, norm=norm, cmap=style.SEQUENTIAL, linewidths=0.1, **options)
    axis.grid(False)
    return cells


def _distribution(axis: Axes, values: dict[str, Rows]) -> None:
    everything = np.log10(np.maximum(np.concatenate(list(values.values())), 1e-16))
    bins = np.logspace(np.floor(everything.min()), np.ceil(everything.max()), 60).tolist()
    for (label, mismatch), colour in zip(values.items(), (style.BLUE, style.ORANGE), strict=True):
        weights = np.full(mismatch.size, 1.0 / mismatch.size)
        axis.hist(mismatch, bins, weights=weights, histtype="stepfilled", color=colour, alpha=0.35, label=label)
        axis.hist(mismatch, bins, weights=weights, histtype="step", color=colour, lw=1.6)
    axis.set(xscale="log", xlabel="mismatch  (ET-D)", ylabel="fraction")
    axis.legend(loc="upper left", bbox_to_anchor=(0.0, 1.22), ncols=2, columnspacing=1.0, handlelength=1.2)


def _colour_bar(figure: Figure, cells: Any) -> None:
    axis = figure.add_axes((0.60, 0.57, 0.37, 0.02))
    axis.set_in_layout(False)
    bar = figure.colorbar(cells, cax=axis, orientation="horizontal", label="median mismatch", extend="both")
    powers = range(int(np.floor(np.log10(cells.norm.vmin))), int(np.ceil(np.log10(cells.norm.vmax))))
    factors = {1.0: "", 3.0: r"3\times "}
    ticks = {f * 10.0**p: f"${text}10^{{{p}}}$" for p in powers for f, text in factors.items()}
    shown = {tick: label for tick, label in ticks.items() if cells.norm.vmin <= tick <= cells.norm.vmax}
    bar.set_ticks(list(shown), labels=list(shown.values()))
    bar.minorticks_off()
