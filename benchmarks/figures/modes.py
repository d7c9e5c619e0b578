"""All modes of one binary: their strain, and where they are beside the noise."""

from __future__ import annotations

import numpy as np

from benchmarks.figures import style
from benchmarks.figures.drawing import DataMissing, Drawing, rounded, table
from benchmarks.figures.workspace import Workspace
from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic
from bnserve_surrogate import Model
from bnserve_surrogate.training.data.noise import noise_curve

BINARY = ParametersWithExtrinsic(
    mass_ratio=2.0, lambda_1=200.0, lambda_2=1500.0, chi_1=0.2, chi_2=0.0,
    distance_mpc=100.0, inclination=np.pi / 3.0, total_mass=2.8,
)  # fmt: skip
_MARKS = np.array([10.0, 100.0, 1000.0])
_COLOURS = (style.INK, style.BLUE, style.ORANGE, style.GREEN, style.PINK, style.SKY, style.GREY)


def draw(workspace: Workspace) -> Drawing:
    """Characteristic strain 2 f |h| of every mode as this inclination shows it, and the noise of ET-D."""
    model = Model.from_artifact(workspace.artifact)
    if len(model.description.modes) < 2:
        raise DataMissing(f"{workspace.model_name} has the (2, 2) mode alone; take one with more (--model).")
    low, high = workspace.metadata.training_band
    f = np.geomspace(low * (1.0 + 1e-9), high * (1.0 - 1e-9), 2000)
    options = EvaluationOptions(alignment="merger")
    found = model.predict_modes(f, BINARY, options=options)
    size = np.sqrt(0.5 * (np.abs(found.plus[0]) ** 2 + np.abs(found.cross[0]) ** 2))[:, None] * np.abs(found.h[0])
    noise = noise_curve("ET-D")(f)
    snr = np.sqrt(np.trapezoid(4.0 * size**2 / noise, f, axis=1))
    figure = style.figure()
    axis = figure.subplots()
    for mode, own, colour, ratio in zip(found.modes, size, _COLOURS, snr, strict=True):
        axis.loglog(f, 2.0 * f * own, color=colour, label=f"{mode}: {ratio:.3g}")
    axis.loglog(f, np.sqrt(f * noise), color=style.GREY, ls="--", lw=1.4, label="noise of ET-D")
    style.frequency_axis(axis)
    axis.set_ylabel("characteristic strain")
    axis.set_title(
        f"The modes of {workspace.model_name}: q = 2, {BINARY.distance_mpc:g} Mpc, seen from 60 degrees", fontsize=15
    )
    axis.set_ylim(bottom=1e-27)
    axis.legend(title="mode: signal-to-noise ratio", ncols=2)
    places = np.searchsorted(f, _MARKS)
    rows = [
        [str(mode), *(f"{value:.2e}" for value in 2.0 * f[places] * own[places]), f"{ratio:.3g}"]
        for mode, own, ratio in zip(found.modes, size, snr, strict=True)
    ]
    numbers = {str(mode): rounded(ratio) for mode, ratio in zip(found.modes, snr, strict=True)}
    header = ["2 f abs(h), q = 2", *(f"{mark:g} Hz" for mark in _MARKS), "SNR"]
    return Drawing(figure, {"signal_to_noise_ratio": numbers}, table(header, rows))
