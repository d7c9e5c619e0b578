"""The picture of the demonstration: strain in time, amplitude against detectors' noise, time-frequency track."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib import style
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from bnserve_protocol import InvalidRequest, ModelDescription
from bnserve_service.demo.chirp import Chirp
from bnserve_service.demo.drawing import INK, PALE, SIGNAL, STYLE, amplitude_panel, strain_panel, track_panel

DOTS_PER_INCH = 160


def check_output(path: Path) -> None:
    """Refuse a picture that could not be saved, before it is worked for.

    Raises
    ------
    InvalidRequest
        The folder is not there, or the format is not known.
    """
    formats = FigureCanvasAgg.get_supported_filetypes()
    if path.suffix.lower().lstrip(".") not in formats:
        raise InvalidRequest(f"'{path}' has no known format of pictures; end its name in .png, .pdf or .svg.")
    if not path.parent.is_dir():
        raise InvalidRequest(f"The folder '{path.parent}' is not there; create it, or choose another --output.")


def save_picture(
    path: Path,
    chirp: Chirp,
    description: ModelDescription,
    title: str = "A binary like GW170817",
    where: str = "over HTTP",
) -> None:
    """Draw one binary, as a model that is described by ``description`` sees it; ``where`` it was evaluated.

    Raises
    ------
    InvalidRequest
        The file cannot be written.
    """
    try:
        with style.context(["default", STYLE]):  # whatever the user's matplotlibrc says
            draw(chirp, description, title, where).savefig(path, dpi=DOTS_PER_INCH)
    except OSError as error:
        raise InvalidRequest(f"The picture '{path}' cannot be written: {error.strerror or error}.") from error


def draw(chirp: Chirp, description: ModelDescription, title: str, where: str) -> Figure:
    """The figure: three panels under a title."""
    figure = Figure(figsize=(10.0, 7.6), layout=ConstrainedLayoutEngine(w_pad=0.12, h_pad=0.1))
    FigureCanvasAgg(figure)
    header, top, bottom = figure.subfigures(3, 1, squeeze=False, height_ratios=[0.62, 3.1, 3.4])[:, 0]
    _title(header.subplots(), chirp, description, title, where)
    strain_panel(top.subplots(), chirp)
    left, right = bottom.subplots(1, 2)
    amplitude_panel(left, chirp)
    track_panel(right, chirp)
    return figure


def _title(axes: Axes, chirp: Chirp, description: ModelDescription, title: str, where: str) -> None:
    binary = chirp.parameters
    mass_1 = binary.total_mass * binary.mass_ratio / (1.0 + binary.mass_ratio)
    axes.set_axis_off()
    axes.text(0.0, 0.62, title, fontsize=17, fontweight="bold", color=INK)
    axes.text(
        0.0, 0.05,
        f"{mass_1:.2f} + {binary.total_mass - mass_1:.2f} M$_\\odot$   "
        f"$\\Lambda$ = {binary.lambda_1:g}, {binary.lambda_2:g}   "
        f"$\\chi$ = {binary.chi_1:g}, {binary.chi_2:g}   "
        f"{binary.distance_mpc:g} Mpc   inclination {np.degrees(binary.inclination):.0f}°",
        fontsize=10.5, color=PALE,
    )  # fmt: skip
    axes.text(1.0, 0.62, "bnserve", fontsize=13, fontweight="bold", color=SIGNAL, ha="right")
    axes.text(
        1.0, 0.05, f"model {description.name} {description.version}, {where}",
        fontsize=10.5, color=PALE, ha="right",
    )  # fmt: skip
