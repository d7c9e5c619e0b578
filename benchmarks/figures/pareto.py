"""The Pareto front of the hyper-parameter search: what an error costs."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes

from benchmarks.figures import style
from benchmarks.figures.drawing import DataMissing, Drawing, table
from benchmarks.figures.workspace import Workspace
from bnserve_surrogate.training.search_pareto import ParetoCollection, ParetoEntry, parse_collection

_LOOKS = ((style.ORANGE, "o"), (style.BLUE, "s"), (style.GREEN, "^"))


def draw(workspace: Workspace) -> Drawing:
    """Error of the reconstruction, and mismatch, against the number of waveforms and against the cost."""
    fronts = _fronts(workspace)
    figure = style.figure()
    axes = figure.subplots(2, 2, sharex="col", sharey="row")
    for (label, collection), (colour, marker) in zip(fronts.items(), _LOOKS, strict=False):
        entries = sorted(collection.entry, key=lambda entry: entry.cost_seconds)
        for row, error in enumerate(("reconstruction_error", "median_mismatch")):
            _points(axes[row, 0], entries, "waveforms", error, colour, marker, label)
            _points(axes[row, 1], entries, "cost_seconds", error, colour, marker, label, joined=row == 0)
    axes[0, 0].set_ylabel("reconstruction error  [rad²]")
    axes[1, 0].set_ylabel("median mismatch  (ET-D)")
    axes[1, 0].set_xlabel("training waveforms")
    axes[1, 1].set_xlabel("cost: waveforms and training  [s]")
    axes[0, 1].legend(loc="upper right", handlelength=1.0)
    axes[0, 0].set_title("Front of the hyper-parameter search")
    numbers = {label: [_plain(entry) for entry in collection.entry] for label, collection in fronts.items()}
    return Drawing(figure, numbers, _summary(fronts))


def _fronts(workspace: Workspace) -> dict[str, ParetoCollection]:
    files = sorted(workspace.pareto.glob("pareto_*.toml"))
    if not files:
        raise DataMissing(
            f"There is no Pareto collection (pareto_*.toml) in {workspace.pareto}. Make one with bnserve search."
        )
    collections = [parse_collection(file.read_text(encoding="utf-8"), file.name) for file in files]
    return {_label(collection): collection for collection in collections}


def _label(collection: ParetoCollection) -> str:
    setup = collection.setup
    return f"{setup.regressor}, {setup.coordinates} coordinates, {setup.reduction} PCA ({setup.trials} trials)"


def _points(
    axis: Axes, entries: list[ParetoEntry], x: str, y: str, colour: str, marker: str, label: str, joined: bool = False
) -> None:
    line = "-" if joined else ""
    xs, ys = ([getattr(entry, name) for entry in entries] for name in (x, y))
    axis.plot(xs, ys, ls=line, drawstyle="steps-post", color=colour, marker=marker, ms=6, lw=1.2, label=label)
    axis.set(xscale="log", yscale="log")


def _plain(entry: ParetoEntry) -> dict[str, Any]:
    names = ("waveforms", "reconstruction_error", "median_mismatch", "training_seconds", "cost_seconds")
    return {name: getattr(entry, name) for name in names}


def _summary(fronts: dict[str, ParetoCollection]) -> list[str]:
    header = ["", "waveforms", "error", "median mismatch", "cost [s]"]
    rows = []
    for label, collection in fronts.items():
        by_cost = sorted(collection.entry, key=lambda entry: entry.cost_seconds)
        for i in np.unique(np.linspace(0, len(by_cost) - 1, 4).round().astype(int)):
            e = by_cost[i]
            figures = (f"{e.reconstruction_error:.1e}", f"{e.median_mismatch:.1e}", f"{e.cost_seconds:.0f}")
            rows.append([label, str(e.waveforms), *figures])
    return table(header, rows)
