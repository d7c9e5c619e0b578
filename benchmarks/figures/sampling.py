"""Where the four ways to sample a waveform put their points: uniform, multibanded, greedy on waveforms or residuals."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from benchmarks.figures import style
from benchmarks.figures.drawing import Drawing, table
from benchmarks.figures.workspace import Arrays, Workspace
from benchmarks.sampling_counts import sampling_counts, uniform_count
from bnserve_surrogate.training.data.generation import make_generator
from bnserve_surrogate.training.data.generators import mass_seconds
from bnserve_surrogate.training.data.sampling import ParameterRanges
from bnserve_surrogate.training.reduction.greedy import multibanded_grid, newtonian_duration
from bnserve_surrogate.training.reduction.nodes import smooth_nodes

F_MIN, F_MAX, LARGEST_MASS_RATIO, TOLERANCE = 5.0, 2926.0, 2.0, 1e-5  # the paper's
_PAPER = {"uniform": "2e7", "multibanded": "2e5", "greedy on waveforms": "3e3", "greedy on residuals": "1e3"}
_COLOURS = (style.GREY, style.SKY, style.ORANGE, style.BLUE, style.GREEN)


def draw(workspace: Workspace) -> Drawing:
    """Histograms in the logarithm of the frequency, for the amplitude and for the phase."""
    waveforms, f_min = workspace.count(128, 4), F_MIN if not workspace.short else 20.0
    band = f_min * mass_seconds(), F_MAX * mass_seconds()
    grid = multibanded_grid(*band, LARGEST_MASS_RATIO)
    nodes = _nodes(workspace, f_min, waveforms)
    ours = smooth_nodes(f_min, F_MAX, workspace.recipe.nodes.count)
    edges = np.geomspace(f_min, F_MAX, 41)
    uniform = np.diff(edges) * mass_seconds() * newtonian_duration(band[0], LARGEST_MASS_RATIO)
    counts = {"uniform": [uniform_count(*band, LARGEST_MASS_RATIO)] * 2, "multibanded": [grid.size] * 2}
    figure = style.figure(12.0, 6.2)
    for position, (axis, quantity) in enumerate(zip(figure.subplots(1, 2, sharey=True), nodes, strict=True)):
        points = {"multibanded": grid, **{f"greedy on {on}": grid[i] for on, i in nodes[quantity].items()}}
        points["smooth nodes, used here"] = ours
        for label in list(points)[1:]:
            counts.setdefault(label, [0, 0])[position] = points[label].size
        histograms = {"uniform": uniform}
        for label, mf in points.items():
            histograms[label] = np.histogram(mf / mass_seconds(), edges)[0]
        _panel(axis, edges, histograms, {label: pair[position] for label, pair in counts.items()})
        axis.set_title(quantity.capitalize())
        style.frequency_axis(axis)
    figure.axes[0].set_ylabel("points per bin")
    rows = [[label, f"{pair[0]:,}", f"{pair[1]:,}", _PAPER.get(label, "")] for label, pair in counts.items()]
    summary = table(["points per waveform", "amplitude", "phase", "paper"], rows)
    named = {label: {"amplitude": pair[0], "phase": pair[1]} for label, pair in counts.items()}
    setup = {"waveforms": waveforms, "f_min_hz": f_min, "f_max_hz": F_MAX, "tolerance": TOLERANCE}
    return Drawing(figure, {"points": named, **setup, "largest_mass_ratio": LARGEST_MASS_RATIO}, summary)


def _nodes(workspace: Workspace, f_min: float, waveforms: int) -> dict[str, Arrays]:
    """Positions in the multibanded grid that the greedy algorithm chose, by quantity and by what it restores."""
    section = workspace.recipe.generator
    setup = {"f_min": f_min, "f_max": F_MAX, "waveforms": waveforms, "tolerance": TOLERANCE}

    def compute() -> Arrays:
        generator = make_generator(section.name, **section.options)
        ranges = ParameterRanges(mass_ratio=(1.0, LARGEST_MASS_RATIO))
        counted = sampling_counts(generator, ranges, **setup, n_jobs=workspace.jobs)  # type: ignore[arg-type]
        return {
            f"{on} {quantity}": getattr(counted, f"{on[:-1]}_{quantity}")
            for on in ("waveforms", "residuals")
            for quantity in ("amplitude", "phase")
        }

    chosen = workspace.kept("sampling", {"generator": msgspec.to_builtins(section), **setup}, compute)
    return {
        quantity: {on: chosen[f"{on} {quantity}"] for on in ("waveforms", "residuals")}
        for quantity in ("amplitude", "phase")
    }


def _panel(axis: Axes, edges: NDArray[Any], histograms: dict[str, NDArray[Any]], totals: dict[str, int]) -> None:
    for (label, histogram), colour in zip(histograms.items(), _COLOURS, strict=True):
        axis.stairs(histogram, edges, color=colour, lw=2.2, label=f"{label}: {totals[label]:,}", baseline=None)
    axis.set_yscale("log")
    axis.set_ylim(0.7, histograms["uniform"].max() ** 1.55)  # room for the legend
    axis.legend(loc="upper left", labelspacing=0.25)
