"""What the higher modes are worth, and how well they are reproduced: mismatch by inclination and mass ratio."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
from matplotlib.colors import LogNorm
from numpy.typing import NDArray

from benchmarks.figures import style
from benchmarks.figures.drawing import DataMissing, Drawing, quantile_row, quantiles, table
from benchmarks.figures.workspace import Workspace
from benchmarks.whole_waveform.rows import measured_whole

_DEGREES = np.array([0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0])
_LEVELS = (0.5, 0.99)


def draw(workspace: Workspace) -> Drawing:
    """Left, mismatch against inclination with and without the higher modes; right, without, over inclination and q."""
    if len(workspace.metadata.modes) < 2:
        raise DataMissing(f"{workspace.model_name} has the (2, 2) mode alone; take one with more (--model).")
    count = workspace.count(workspace.fresh, 64)
    found = measured_whole(workspace.artifact, "uniform", count, workspace.seed, workspace.directory, workspace.jobs)
    tilt = np.degrees(np.minimum(found["inclination"], np.pi - found["inclination"]))
    figure = style.figure(13.0, 6.0)
    left, right = figure.subplots(1, 2)
    kinds = {"without": "(2, 2) alone, and perfect", "maximised": f"all modes of {workspace.model_name}"}
    for (name, label), colour in zip(kinds.items(), (style.ORANGE, style.BLUE), strict=True):
        left.scatter(tilt, found[name], s=4, color=colour, alpha=0.25, linewidths=0)
        for level, line in zip(_LEVELS, ("-", ":"), strict=True):
            middle, values = _by_tilt(tilt, found[name], level)
            left.plot(middle, values, line, color=colour, label=f"{label}: {'median' if level == 0.5 else '99 %'}")
    left.set(yscale="log", xlabel="inclination to the orbital axis  [degrees]", ylabel="mismatch  (ET-D)")
    left.set_ylim(1e-12, 0.3)
    left.legend(loc="center right", fontsize=11, bbox_to_anchor=(1.0, 0.52))
    cells: Any = right.hexbin(
        tilt, found["mass_ratio"], C=found["without"], reduce_C_function=np.median, gridsize=(16, 10),
        norm=LogNorm(1e-5, 1e-2), cmap=style.SEQUENTIAL, linewidths=0.1,
    )  # fmt: skip
    right.grid(False)
    right.set(xlabel="inclination to the orbital axis  [degrees]", ylabel="mass ratio")
    figure.colorbar(cells, ax=right, label="median mismatch of (2, 2) alone", extend="both")
    rows = [quantile_row(f"{label}, {tilt.size} binaries", found[name]) for name, label in kinds.items()]
    for low, high in itertools.pairwise(_DEGREES):
        part = (tilt >= low) & (tilt < high)
        if part.any():
            rows += [quantile_row(f"{name}, {low:g} to {high:g} degrees", found[name][part]) for name in kinds]
    numbers = {name: quantiles(found[name]) for name in kinds}
    return Drawing(figure, numbers, table(["mismatch", "median", "90 %", "99 %", "max"], rows))


def _by_tilt(
    tilt: NDArray[np.float64], values: NDArray[np.float64], level: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Quantiles in bins of equal numbers of binaries."""
    order = np.argsort(tilt)
    parts = np.array_split(order, max(1, min(20, len(order) // 16)))
    return np.array([tilt[part].mean() for part in parts]), np.array(
        [np.quantile(values[part], level) for part in parts]
    )
