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
from benchmarks.gw170817.marginals import Shown, physical
from bnserve_protocol import LikelihoodBatch, LikelihoodParameters

Floats = NDArray[np.float64]
_BINS = 30
_STYLES = ((BLUE, "-"), (ORANGE, "--"), (GREEN, ":"))


def draw_corner(posteriors: Mapping[str, Shown], truth: LikelihoodParameters | None, path: Path) -> None:
    """Histograms of parameters and pairs; contours hold 50 and 90 percent; grey lines are the injection."""
    true = None if truth is None else {name: float(x[0]) for name, x in physical(LikelihoodBatch.coerce(truth)).items()}
    names = list(next(iter(posteriors.values())).columns)
    ends = {name: _ends([shown.columns[name] for shown in posteriors.values()]) for name in names}
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
                for shown, (colour, line) in zip(posteriors.values(), _STYLES, strict=False):
                    _draw(axis, shown, across, below, ends, colour, line)
                _mark(axis, across, below, true)
                axis.set_xlabel(across if row == len(names) - 1 else "", fontsize=12)
                axis.set_ylabel(below if column == 0 and row else "", fontsize=12)
                axis.tick_params(labelsize=8, labelbottom=row == len(names) - 1, labelleft=column == 0 and row > 0)
        lines = [Line2D([], [], color=colour, ls=line, lw=2.5) for colour, line in _STYLES[: len(posteriors)]]
        page.legend(lines, [name.replace("_", " ") for name in posteriors], loc="upper right", fontsize=20)
        page.savefig(path, dpi=80)


def _ends(columns: list[Floats]) -> tuple[float, float]:
    low, high = min(values.min() for values in columns), max(values.max() for values in columns)
    return float(low), float(high)


def _draw(
    axis: Axes, shown: Shown, across: str, below: str, ends: Mapping[str, tuple[float, float]], colour: str, line: str
) -> None:
    x, y = shown.columns[across], shown.columns[below]
    if across == below:
        axis.hist(
            x, bins=_BINS, range=ends[across], weights=shown.weights, histtype="step", color=colour, ls=line, lw=1.5,
            density=True,
        )  # fmt: skip
        axis.set_yticks([])
        return
    counts, xs, ys = np.histogram2d(x, y, bins=_BINS, range=(ends[across], ends[below]), weights=shown.weights)
    counts = gaussian_filter(counts, 1.0)
    order = np.sort(counts.ravel())[::-1]
    held = np.cumsum(order) / order.sum()
    levels = sorted({float(order[np.searchsorted(held, part)]) for part in (0.9, 0.5)})
    middles = 0.5 * (xs[1:] + xs[:-1]), 0.5 * (ys[1:] + ys[:-1])
    axis.contour(*middles, counts.T, levels=levels, colors=colour, linestyles=line, linewidths=1.3)


def _mark(axis: Axes, across: str, below: str, true: Mapping[str, float] | None) -> None:
    if true is not None:
        axis.axvline(true[across], color=GREY, lw=1.2)
        if across != below:
            axis.axhline(true[below], color=GREY, lw=1.2)
