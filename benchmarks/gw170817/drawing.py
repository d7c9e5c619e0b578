"""The corner plot of posteriors, one over the other."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from benchmarks.figures.style import BLUE, GREEN, GREY, ORANGE, figure, talk

Floats = NDArray[np.float64]
_BINS = 30
_STYLES = ((BLUE, "-"), (ORANGE, "--"), (GREEN, ":"))


Columns = Mapping[str, Floats]


def draw_corner(posteriors: Mapping[str, Columns], truth: Mapping[str, float], path: Path) -> None:
    """Histograms of parameters and pairs; contours hold 50 and 90 percent; grey lines are the injection."""
    names = list(next(iter(posteriors.values())))
    ends = {name: _ends([columns[name] for columns in posteriors.values()]) for name in names}
    with talk():
        page = figure(15.0, 15.0)
        axes = page.subplots(len(names), len(names))
        for row, below in enumerate(names):
            for column, across in enumerate(names):
                axis = axes[row, column]
                axis.grid(False)
                if column > row:
                    axis.axis("off")
                    continue
                for columns, (colour, line) in zip(posteriors.values(), _STYLES, strict=False):
                    _draw(axis, columns, across, below, ends, colour, line)
                _mark(axis, across, below, truth)
                axis.set_xlim(ends[across])
                if row != column:
                    axis.set_ylim(ends[below])
                axis.set_xlabel(across if row == len(names) - 1 else "", fontsize=12)
                axis.set_ylabel(below if column == 0 and row else "", fontsize=12)
                axis.tick_params(labelsize=8, labelbottom=row == len(names) - 1, labelleft=column == 0 and row > 0)
        lines = [Line2D([], [], color=colour, ls=line, lw=2.5) for colour, line in _STYLES[: len(posteriors)]]
        page.legend(lines, list(posteriors), loc="upper right", fontsize=20)
        page.savefig(path, dpi=80)


def _ends(columns: list[Floats]) -> tuple[float, float]:
    """But for a thousandth to either side."""
    quantiles = np.quantile(np.concatenate(columns), (0.001, 0.999))
    return float(quantiles[0]), float(quantiles[1])


def _draw(
    axis: Axes,
    columns: Columns,
    across: str,
    below: str,
    ends: Mapping[str, tuple[float, float]],
    colour: str,
    line: str,
) -> None:
    x, y = columns[across], columns[below]
    if across == below:
        axis.hist(
            x, bins=_BINS, range=ends[across], histtype="step", color=colour, ls=line, lw=1.5,
            density=True,
        )  # fmt: skip
        axis.set_yticks([])
        return
    counts, xs, ys = np.histogram2d(x, y, bins=_BINS, range=(ends[across], ends[below]))
    counts = gaussian_filter(counts, 1.0)
    order = np.sort(counts.ravel())[::-1]
    held = np.cumsum(order) / order.sum()
    levels = sorted({float(order[np.searchsorted(held, part)]) for part in (0.9, 0.5)})
    middles = 0.5 * (xs[1:] + xs[:-1]), 0.5 * (ys[1:] + ys[:-1])
    axis.contour(*middles, counts.T, levels=levels, colors=colour, linestyles=line, linewidths=1.3)


def _mark(axis: Axes, across: str, below: str, true: Mapping[str, float]) -> None:
    if across in true:
        axis.axvline(true[across], color=GREY, lw=1.2)
    if below in true and across != below:
        axis.axhline(true[below], color=GREY, lw=1.2)
