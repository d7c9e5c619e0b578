"""The Pareto front of the hyper-parameter search: what an error costs."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.figures import style
from benchmarks.figures.drawing import DataMissing, Drawing, table
from benchmarks.figures.workspace import Workspace
from bnserve_surrogate.training.search.hyperparameters import ParetoCollection, ParetoEntry, parse_collection

_LOOKS = ((style.ORANGE, "o"), (style.BLUE, "s"), (style.GREEN, "^"))


def draw(workspace: Workspace) -> Drawing:
    """The front in both costs, and what it means for the mismatch."""
    fronts = _fronts(workspace)
    figure = style.figure(12.0, 6.0)
    front, mismatch = figure.subplots(1, 2)
    for (label, collection), (colour, marker) in zip(fronts.items(), _LOOKS, strict=False):
        entries = sorted(collection.entry, key=lambda entry: entry.cost_seconds)
        look: dict[str, Any] = {"color": colour, "marker": marker, "ms": 7, "lw": 1.4}
        costs, errors = ([getattr(e, name) for e in entries] for name in ("cost_seconds", "reconstruction_error"))
        front.plot(costs, errors, drawstyle="steps-post", label=label, **look)
        counts, medians = ([getattr(e, name) for e in entries] for name in ("waveforms", "median_mismatch"))
        mismatch.plot(counts, medians, ls="", **look)
    front.set(xscale="log", yscale="log", title="The front of the search", ylabel="reconstruction error  [rad²]")
    front.set_xlabel("cost: time for waveforms and training  [s]")
    mismatch.set(xscale="log", yscale="log", title="Mismatch of the same models", ylabel="median mismatch  (ET-D)")
    mismatch.set_xlabel("training waveforms")
    figure.legend(handles=front.lines, loc="outside lower center", ncols=1)
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
