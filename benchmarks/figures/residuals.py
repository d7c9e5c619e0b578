"""Residuals of 100 waveforms: to the post-Newtonian baseline, and to the trained model."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from numpy.typing import NDArray

from benchmarks.figures import style
from benchmarks.figures.drawing import Drawing, rounded, table
from benchmarks.figures.workspace import Workspace
from bnserve_surrogate.training.data.generators import mass_seconds
from bnserve_surrogate.training.data.residuals import flatten_phase

Rows = NDArray[np.float64]


def draw(workspace: Workspace) -> Drawing:
    """Before and after, with the paper's convention for the phase: its average slope up to 40 Hz is taken off."""
    count = workspace.count(100, 20)
    dataset = workspace.waveforms("uniform", 32 * -(-count // 32)).subset(np.arange(count))
    validation = workspace.validation(dataset)
    f = dataset.mf_phase / mass_seconds()
    before = dataset.log_amplitude_ratio, flatten_phase(dataset.mf_phase, dataset.psi_residual).residual
    after = -validation.log_amplitude, flatten_phase(dataset.mf_phase, -validation.phase).residual
    tide = tidal_deformability(dataset.theta)
    norm = Normalize(0.0, 100.0 * np.ceil(tide.max() / 100.0))
    figure = style.figure()
    axes = figure.subplots(2, 2, sharex=True)
    for column, (amplitude, phase) in enumerate((before, after)):
        _panel(axes[0, column], f, amplitude, tide, norm, r"$\log\,(A / A_{\rm ref})$", "")
        lines = _panel(axes[1, column], f, phase, tide, norm, r"$\Delta\phi$", "rad")
        style.frequency_axis(axes[1, column])
    axes[0, 0].set_title("Before: to the post-Newtonian baseline")
    axes[0, 1].set_title(f"After: to the model {workspace.model_name}")
    figure.colorbar(lines, ax=axes, label=r"tidal deformability  $\tilde\Lambda$", aspect=40, pad=0.01)
    numbers = {"before": _spread(f, *before), "after": _spread(f, *after), "waveforms": count}
    return Drawing(figure, numbers, _summary(numbers))


def tidal_deformability(theta: Rows) -> Rows:
    """Lambda-tilde of binaries (N, 5), (N,)."""
    heavy = theta[:, 0] / (1.0 + theta[:, 0])
    light = 1.0 - heavy
    first = (heavy + 12.0 * light) * heavy**4 * theta[:, 3]
    second = (light + 12.0 * heavy) * light**4 * theta[:, 4]
    return np.asarray(16.0 / 13.0 * (first + second))


def _panel(axis: Axes, f: Rows, rows: Rows, colours: Rows, norm: Normalize, symbol: str, unit: str) -> Any:
    exponent = style.power_of_ten(rows)
    unit = f"{style.times_ten(exponent)}{unit}".strip()
    lines = style.bundle(axis, f, rows / 10.0**exponent, colours, norm)
    axis.set_ylabel(f"{symbol}  [{unit}]" if unit else symbol)
    return lines


def _spread(f: Rows, amplitude: Rows, phase: Rows) -> dict[str, Any]:
    """Largest residuals over the waveforms at a few frequencies, and over all."""
    at = [int(np.argmin(np.abs(f - wanted))) for wanted in (10.0, 100.0, 1000.0, 2900.0)]
    return {
        name: {**{f"{f[i]:.0f} Hz": rounded(np.abs(rows[:, i]).max()) for i in at}, "all": rounded(np.abs(rows).max())}
        for name, rows in {"log_amplitude": amplitude, "phase_radians": phase}.items()
    }


def _summary(numbers: dict[str, Any]) -> list[str]:
    header = [f"largest of {numbers['waveforms']} waveforms", *numbers["before"]["log_amplitude"]]
    rows = [
        [f"{label}, {when}", *(f"{value:.1e}" for value in numbers[when][name].values())]
        for name, label in {"log_amplitude": "log-amplitude", "phase_radians": "phase [rad]"}.items()
        for when in ("before", "after")
    ]
    return table(header, rows)
