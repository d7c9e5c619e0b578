"""Differences of 100 reconstructed waveforms to the generator's, after the best shift of time and phase."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from numpy.typing import NDArray

from benchmarks.figures import style
from benchmarks.figures.drawing import Drawing, quantiles, rounded, table
from benchmarks.figures.workspace import Workspace

Rows = NDArray[np.float64]
_MARKED_HZ = (10.0, 100.0, 1000.0, 2900.0)


def draw(workspace: Workspace) -> Drawing:
    """Moduli for the shipped model, coloured by mismatch, with their median and 95 %."""
    count = workspace.count(100, 20)
    dataset = workspace.waveforms("uniform", 32 * -(-count // 32)).subset(np.arange(count))
    validation = workspace.validation(dataset)
    f, mismatch = validation.frequencies, np.maximum(validation.mismatch, 1e-16)
    norm = LogNorm(mismatch.min(), mismatch.max())
    figure = style.figure()
    axes = figure.subplots(2, 1, sharex=True)
    quantities = {"log_amplitude": validation.log_amplitude, "phase_radians": validation.phase}
    labels = {"log_amplitude": r"$|\log\,(A / A_{\rm TEOB})|$", "phase_radians": r"$|\Delta\phi|$  [rad]"}
    for axis, (name, rows) in zip(axes, quantities.items(), strict=True):
        lines = _panel(axis, f, rows, mismatch, norm, labels[name])
    style.frequency_axis(axes[1])
    axes[0].set_title(f"{count} waveforms of the model {workspace.model_name}, and TEOBResumSPA's")
    figure.colorbar(lines, ax=axes, label="mismatch  (ET-D)", aspect=40, pad=0.01)
    numbers: dict[str, Any] = {name: _by_frequency(f, rows) for name, rows in quantities.items()}
    numbers |= {"mismatch": quantiles(validation.mismatch), "waveforms": count}
    return Drawing(figure, numbers, _summary(numbers))


def _panel(axis: Axes, f: Rows, rows: Rows, mismatch: Rows, norm: LogNorm, label: str) -> Any:
    size = np.abs(rows)
    axis.set_yscale("log")
    lines = style.bundle(axis, f, size, mismatch, norm, alpha=0.4)
    for level, look in {0.95: "--", 0.5: "-"}.items():
        curve = np.quantile(size, level, axis=0)
        axis.plot(
            f, curve, color=style.ORANGE, ls=look, lw=2.4, label="median" if level == 0.5 else f"{100 * level:.0f} %"
        )
    axis.set_ylim(0.1 * np.quantile(size, 0.1, axis=0).min(), 2.0 * size.max())
    axis.set_ylabel(label)
    axis.legend(loc="upper left", ncols=2)
    return lines


def _by_frequency(f: Rows, rows: Rows) -> dict[str, dict[str, float]]:
    at = {f"{hertz:.0f} Hz": int(np.argmin(np.abs(f - hertz))) for hertz in _MARKED_HZ}
    size = np.abs(rows)
    return {
        "median": {label: rounded(np.median(size[:, i])) for label, i in at.items()},
        "largest": {label: rounded(size[:, i].max()) for label, i in at.items()},
    }


def _summary(numbers: dict[str, Any]) -> list[str]:
    header = [f"modulus, {numbers['waveforms']} waveforms", *numbers["phase_radians"]["median"]]
    rows = [
        [f"{label}, {which}", *(f"{value:.1e}" for value in numbers[name][which].values())]
        for name, label in {"log_amplitude": "log-amplitude", "phase_radians": "phase [rad]"}.items()
        for which in ("median", "largest")
    ]
    return table(header, rows)
