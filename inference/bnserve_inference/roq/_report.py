"""The report of a construction: a page with plots."""

from __future__ import annotations

import html
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_inference.roq._build import BuiltBasis
from bnserve_inference.roq._diagnostics import describe
from bnserve_inference.roq._interpolant import AnyArray, Term, WaveformInterpolant, evaluate_term
from bnserve_inference.roq._sampling import Prior
from bnserve_inference.roq._storage import replacing
from bnserve_protocol import ParameterBatch, WaveformModel, require
from bnserve_store import report_figure, report_page

_COLOURS: dict[Term, str] = {"linear": "#0072b2", "quadratic": "#d55e00"}
_GREY = "#8a97a5"
_STYLE = {
    "font.size": 11,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6eaee",
    "legend.frameon": False,
    "savefig.dpi": 130,
}
_DRAWN_POINTS = 4000
_NEEDED = "The report of a basis", "roq"


def write_roq_report(path: Path | str, title: str, built: BuiltBasis, model: WaveformModel) -> None:
    """Write a self-contained page: what was built, how it grew, how good it is.

    Raises
    ------
    BasisUnwritable
        The page cannot be written; the basis is not affected.
    PackageMissing
        matplotlib is not installed.
    """
    seconds = "\n".join(f"{name:12}{value:8.1f} s" for name, value in built.seconds.items())
    text = html.escape(f"{describe(built.quadrature)}\n\n{seconds}")
    images = [report_figure(caption, figure) for caption, figure in all_figures(built, model)]
    page = report_page(title, f"<pre>{text}</pre>{''.join(images)}")
    with replacing(Path(path)) as temporary:
        temporary.write_text(page, encoding="utf-8")


def all_figures(built: BuiltBasis, model: WaveformModel) -> Iterator[tuple[str, Any]]:
    """Captions and figures, one after the other.

    Raises
    ------
    PackageMissing
        matplotlib is not installed.
    """
    with _style():
        yield "The nodes, on the amplitude of the waveform in the middle of the prior", nodes_figure(built, model)
        yield "Decay of the errors while the bases grew", decay_figure(built)
        yield "Binaries above tolerance in every sweep of the enrichment cycles", outliers_figure(built)
        yield "Interpolation errors of fresh binaries", validation_figure(built)
        yield "The waveform in the middle of the prior, and what interpolation misses", waveform_figure(built, model)


def nodes_figure(built: BuiltBasis, model: WaveformModel) -> Any:
    """Where the nodes are."""
    figure, (axis,) = _figure(1, 4.0)
    frequencies = _drawn(built)
    (h,) = _values(built, model, "linear", frequencies)
    axis.plot(frequencies, np.abs(h), color=_GREY, lw=1.5)
    for term in _COLOURS:
        nodes = _interpolant(built, term).nodes
        heights = (1.0 if term == "linear" else 0.5) * np.interp(nodes, frequencies, np.abs(h))
        axis.plot(nodes, heights, "|", ms=14, color=_COLOURS[term], label=f"{len(nodes)} {term} nodes")
    axis.set(xscale="log", yscale="log", xlabel="frequency [Hz]", ylabel="amplitude at 1 Mpc [1/Hz]")
    axis.legend()
    return figure


def decay_figure(built: BuiltBasis) -> Any:
    """Largest projection error of the pre-selection, and worst interpolation error of every sweep, by basis size."""
    figure, (axis,) = _figure(1, 4.0)
    for term, colour in _COLOURS.items():
        growth, tolerance = built.growth[term], built.quadrature.diagnostics[term]["tolerance"]
        errors = growth.preselection_errors
        axis.plot(2 + np.arange(len(errors)), errors, color=colour, lw=1.5, label=f"{term}: projection")
        axis.plot(growth.sweeps[:, 1], growth.sweeps[:, 3], "o", ms=5, color=colour, label=f"{term}: interpolation")
        axis.axhline(tolerance, color=colour, ls=":", lw=1.0)
    axis.set(yscale="log", xlabel="elements", ylabel="largest squared error")
    axis.legend()
    return figure


def outliers_figure(built: BuiltBasis) -> Any:
    """Number of outliers by sweep."""
    figure, (axis,) = _figure(1, 3.2)
    for term, colour in _COLOURS.items():
        outliers = built.growth[term].sweeps[:, 2]
        axis.plot(1 + np.arange(len(outliers)), outliers, "o-", ms=5, lw=1.0, color=colour, label=term)
    axis.set(xlabel="sweep", ylabel="above tolerance")
    axis.set_yscale("symlog", linthresh=1.0)
    axis.set_ylim(bottom=0.0)
    axis.legend()
    return figure


def validation_figure(built: BuiltBasis) -> Any:
    """Histograms of the validation errors, with tolerances (dotted) and the limit (dashed)."""
    figure, (axis,) = _figure(1, 4.0)
    validation = built.quadrature.diagnostics["validation"]
    floor = 1e-16
    errors = np.maximum(built.validation_errors, floor)
    bins = np.logspace(np.floor(np.log10(errors.min())), np.ceil(np.log10(errors.max())) + 1e-9, 100)
    for (term, colour), row in zip(_COLOURS.items(), errors, strict=True):
        axis.hist(row, bins, histtype="step", lw=1.8, color=colour, label=term)
        axis.axvline(validation[term]["tolerance"], color=colour, ls=":", lw=1.2)
    axis.axvline(validation["linear"]["limit"], color=_GREY, ls="--", lw=1.2)
    axis.set(xscale="log", yscale="log", xlabel="squared interpolation error", ylabel="binaries")
    axis.legend()
    return figure


def waveform_figure(built: BuiltBasis, model: WaveformModel) -> Any:
    """A reconstructed waveform: moduli of it and of its error."""
    figure, axes = _figure(2, 5.6)
    frequencies = _drawn(built)
    for axis, term in zip(axes, _COLOURS, strict=True):
        interpolant = _interpolant(built, term)
        (values,) = _values(built, model, term, frequencies)
        (at_nodes,) = _values(built, model, term, interpolant.nodes)
        alignment = built.quadrature.alignment
        elements = evaluate_term(model, frequencies, interpolant.binaries, term, alignment)
        missed = values - at_nodes @ (interpolant.coefficients.T @ elements)
        unit = np.abs(values).max()
        label = "h" if term == "linear" else "|h|$^2$"
        axis.plot(frequencies, np.abs(values) / unit, color=_GREY, lw=1.5, label=f"{label} / max")
        axis.plot(frequencies, np.abs(missed) / unit, color=_COLOURS[term], lw=0.8, label="error")
        axis.set(xscale="log", yscale="log")
        axis.legend()
    axes[-1].set_xlabel("frequency [Hz]")
    return figure


@contextmanager
def _style() -> Iterator[None]:
    matplotlib = require("matplotlib", *_NEEDED)
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_STYLE)
        yield


def _figure(rows: int, height: float) -> tuple[Any, Any]:
    figure = require("matplotlib.figure", *_NEEDED).Figure(figsize=(9.0, height), layout="constrained")
    return figure, figure.subplots(rows, 1, squeeze=False, sharex=True)[:, 0]


def _drawn(built: BuiltBasis) -> AnyArray:
    """Some thousand points of the full grid, denser at low frequencies."""
    frequencies = built.quadrature.grid.frequencies()
    wanted = np.geomspace(frequencies[0], frequencies[-1], _DRAWN_POINTS)
    return frequencies[np.unique(np.searchsorted(frequencies, wanted).clip(max=len(frequencies) - 1))]


def _interpolant(built: BuiltBasis, term: Term) -> WaveformInterpolant:
    interpolant = built.quadrature.linear if term == "linear" else built.quadrature.quadratic
    assert isinstance(interpolant, WaveformInterpolant)
    return interpolant


def _values(built: BuiltBasis, model: WaveformModel, term: Term, frequencies: AnyArray) -> AnyArray:
    ranges = built.quadrature.prior
    middle: ParameterBatch = Prior(ranges).binaries(np.array([[0.5 * (low + high) for low, high in ranges.values()]]))
    return evaluate_term(model, frequencies, middle, term, built.quadrature.alignment)
