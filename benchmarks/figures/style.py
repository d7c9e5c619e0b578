"""One look for all figures: readable on a slide, colour-blind safe, no clutter."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from numpy.typing import NDArray

INK, GREY = "#1b2733", "#8a97a5"
BLUE, ORANGE, GREEN, PINK, SKY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9"  # Okabe and Ito's
SEQUENTIAL = "viridis"

_STYLE: dict[Any, Any] = {
    "font.size": 14,
    "axes.titlesize": 15,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelsize": 15,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.use_mathtext": True,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6eaee",
    "grid.linewidth": 0.8,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": False,
    "legend.fontsize": 13,
    "lines.linewidth": 2.2,
    "savefig.dpi": 150,
}


@contextmanager
def talk() -> Iterator[None]:
    """Draw with this style inside the block, and with the user's own outside."""
    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(_STYLE)
        yield


def figure(width: float = 12.0, height: float = 6.75) -> Figure:
    """An empty figure with the proportions of a slide, laid out without overlaps."""
    return Figure(figsize=(width, height), layout="constrained")


def frequency_axis(axis: Axes, label: bool = True) -> None:
    """A logarithmic frequency axis with plain numbers."""
    axis.set_xscale("log")
    axis.set_xticks([5, 10, 30, 100, 300, 1000, 3000], labels=["5", "10", "30", "100", "300", "1k", "3k"])
    axis.xaxis.minorticks_off()
    if label:
        axis.set_xlabel("frequency for $M = 2.8\\,M_\\odot$  [Hz]")


def bundle(
    axis: Axes, x: NDArray[Any], rows: NDArray[Any], colours: NDArray[Any], norm: Normalize, alpha: float = 0.75
) -> LineCollection:
    """Many thin curves, (N, n), each coloured by a number, (N,)."""
    segments = [np.column_stack([x, row]) for row in rows]
    lines = LineCollection(segments, array=colours, cmap=SEQUENTIAL, norm=norm, linewidths=0.9, alpha=alpha)
    axis.add_collection(lines)
    axis.autoscale_view()
    axis.margins(x=0.0)
    return lines


def power_of_ten(values: NDArray[Any]) -> int:
    """The exponent, a multiple of three, that brings the largest modulus between 1 and 1000; 0 near 1."""
    largest = float(np.abs(values).max())
    return 0 if largest == 0.0 or 1e-2 < largest < 1e4 else 3 * int(np.floor(np.log10(largest) / 3))


def times_ten(exponent: int) -> str:
    """A factor for a label, such as ``" x 10^-6"``; empty for 0."""
    return f"$10^{{{exponent}}}$ " if exponent else ""
