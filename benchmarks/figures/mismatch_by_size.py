"""Distributions of the mismatch by number of training waveforms: the paper's recipe, ours, and the baseline alone."""

from __future__ import annotations

import sys
import warnings
from functools import partial
from typing import Any

import msgspec
import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from numpy.typing import NDArray
from scipy.stats import gaussian_kde
from sklearn.exceptions import ConvergenceWarning

from benchmarks.figures import style
from benchmarks.figures.drawing import LEVELS, Drawing, quantile_row, quantiles, table
from benchmarks.figures.workspace import VALIDATION_SEED, Arrays, Workspace
from bnserve_surrogate.training.pipeline import train
from bnserve_surrogate.training.regressors import weighted_exponents
from bnserve_surrogate.training.sections import TrainingConfiguration, ValidationSection
from bnserve_surrogate.training.validation.measurement import validate

_BASELINE = "baseline alone"
_SMALLEST = 2**9


def draw(workspace: Workspace) -> Drawing:
    """Train each recipe on ever larger parts of its data set, and measure all models on the same waveforms."""
    recipes = {"paper": workspace.paper, workspace.recipe.name: workspace.recipe}
    most = {"paper": workspace.paper_largest, workspace.recipe.name: workspace.largest}
    curves: dict[str, dict[int, NDArray[Any]]] = {}
    for label, recipe in recipes.items():
        sizes = _sizes(workspace, min(recipe.dataset.count, most[label]))
        curves[label] = {size: _mismatches(workspace, of_size(recipe, size)) for size in sizes}
    baseline = _baseline(workspace)
    figure = style.figure()
    axes = figure.subplots(2, 1, sharex=True, sharey=True)
    largest = max(max(sizes) for sizes in curves.values())
    for axis, (label, by_size) in zip(axes, curves.items(), strict=True):
        _panel(axis, by_size, baseline, largest)
        axis.set_title("The paper's recipe" if label == "paper" else f"The recipe of the model {label}")
    axes[1].set_ylim(bottom=0.0)  # shared; after both are drawn
    axes[1].set_xlabel(f"mismatch to TEOBResumSPA  (ET-D, $M = 2.8\\,M_\\odot$, {baseline.size} waveforms)")
    figure.supylabel("density per decade", fontsize=15)
    rows = [quantile_row(_BASELINE, baseline)]
    rows += [
        quantile_row(f"{label}, N = {size}", values)
        for label, sizes in curves.items()
        for size, values in sizes.items()
    ]
    numbers = {label: {str(n): quantiles(values) for n, values in sizes.items()} for label, sizes in curves.items()}
    numbers[_BASELINE] = {"0": quantiles(baseline)}
    return Drawing(figure, {"mismatch": numbers, "waveforms": int(baseline.size)}, table(["mismatch", *LEVELS], rows))


def of_size(recipe: TrainingConfiguration, size: int) -> TrainingConfiguration:
    """The recipe for ``size`` waveforms in all, an eighth of them on faces and edges if it has such.

    A polynomial keeps at least two of them for every term it starts from.
    """
    edges = size // 8 if recipe.dataset.edge_count else 0
    options = recipe.regressor.polynomial
    degrees = np.arange(1.0, options.degree + 0.5)
    possible = [degree for degree in degrees if 2 * len(weighted_exponents(degree, options.weights)) <= size]
    smaller = msgspec.structs.replace(options, degree=float(max(possible, default=1.0)))
    return msgspec.structs.replace(
        recipe,
        dataset=msgspec.structs.replace(recipe.dataset, count=size - edges, edge_count=edges),
        regressor=msgspec.structs.replace(recipe.regressor, polynomial=smaller),
    )


def _sizes(workspace: Workspace, most: int) -> list[int]:
    sizes = [2**power for power in range(7, 18) if 2**power <= most]
    return sizes[:2] if workspace.short else [size for size in sizes if size >= _SMALLEST]


def _mismatches(workspace: Workspace, recipe: TrainingConfiguration) -> NDArray[Any]:
    """Of one training, on the waveforms of ``bnserve validate``; kept, for a network takes minutes."""
    whole = msgspec.structs.replace(recipe, validation=ValidationSection(count=32, edge_count=0))
    plain = msgspec.to_builtins(msgspec.structs.replace(whole, labels=(), citation=""))
    inputs = {"configuration": plain, "waveforms": _fresh(workspace), "seed": VALIDATION_SEED}
    return workspace.kept("mismatch", inputs, partial(_trained, workspace, whole))["mismatch"]


def _trained(workspace: Workspace, recipe: TrainingConfiguration) -> Arrays:
    waveforms = recipe.dataset.count + recipe.dataset.edge_count
    print(f"training {recipe.name} on {waveforms} waveforms", file=sys.stderr)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)  # the paper's number of epochs is the paper's
        trained = train(recipe, workspace.directory, n_jobs=workspace.jobs, say=lambda line: None)
    fresh = workspace.waveforms("uniform", _fresh(workspace), recipe)
    return {"mismatch": validate(trained.model, trained.metadata, fresh).mismatch}


def _baseline(workspace: Workspace) -> NDArray[Any]:
    """Of the baseline alone on the same waveforms, whatever the model."""

    def measured() -> Arrays:
        return {"mismatch": workspace.validation(workspace.waveforms("uniform", count)).baseline_mismatch}

    count = _fresh(workspace)
    inputs = {"recipe": msgspec.to_builtins(workspace.recipe.ranges), "waveforms": count}
    return workspace.kept("baseline", inputs, measured)["mismatch"]


def _fresh(workspace: Workspace) -> int:
    return workspace.count(workspace.fresh, 32)


def _panel(axis: Axes, by_size: dict[int, NDArray[Any]], baseline: NDArray[Any], largest: int) -> None:
    colours = colormaps[style.SEQUENTIAL]
    _curve(axis, baseline, style.INK, "baseline alone", dashed=True)
    for size, values in by_size.items():
        power = int(np.log2(size))
        first, last = int(np.log2(min(_SMALLEST, *by_size))), int(np.log2(largest))
        _curve(axis, values, colours(0.92 * (1.0 - (power - first) / max(1, last - first))), f"$N = 2^{{{power}}}$")
    axis.set_xscale("log")
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), labelspacing=0.3)


def _curve(axis: Axes, values: NDArray[Any], colour: Any, label: str, dashed: bool = False) -> None:
    """A kernel density estimate in the logarithm."""
    logarithm = np.log10(np.maximum(values, 1e-16))
    x = np.linspace(logarithm.min() - 0.5, logarithm.max() + 0.5, 400)
    density = gaussian_kde(logarithm)(x)
    axis.plot(10.0**x, density, color=colour, label=label, ls="--" if dashed else "-")
    if not dashed:
        axis.fill_between(10.0**x, density, color=colour, alpha=0.12, lw=0)
