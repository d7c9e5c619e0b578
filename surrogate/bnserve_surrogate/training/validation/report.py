"""The report of a training: a table for the terminal, and a page with plots."""

from __future__ import annotations

import html
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_protocol import require
from bnserve_store import report_figure, report_page, report_table
from bnserve_surrogate.training.data.chunks import write_whole
from bnserve_surrogate.training.errors import DatasetUnwritable
from bnserve_surrogate.training.validation.measurement import QUANTILES, Validation, quantiles

REPORT_FILE = "report.html"
"""Its name, beside the manifest of the model. It is for people: no part of the artifact, and of no digest."""
_LEAST_MISMATCH = 1e-16
"""Drawn for what is less, on axes that are logarithmic: rounding."""
_ROWS = {
    "mismatch": lambda v: v.mismatch,
    "mismatch of the baseline alone": lambda v: v.baseline_mismatch,
    "merger time error [us]": lambda v: 1e6 * np.abs(v.merger_time),
    "merger phase error [rad]": lambda v: np.abs(v.merger_phase),
}


def table(validations: dict[str, Validation]) -> str:
    """Quantiles of every figure, as plain text."""
    header = f"{'':62}" + "".join(f"{name:>11}" for name in QUANTILES)
    lines = [header]
    for kind, validation in validations.items():
        rows = {label: values(validation) for label, values in _ROWS.items()}
        rows |= {f"error of ({name[0]}, {name[1]}), of (2, 2)": error for name, error in validation.modes.items()}
        for label, values in rows.items():
            name = f"{kind}, {len(validation.mismatch)} waveforms: {label}"
            lines.append(f"{name:62}" + "".join(f"{x:>11.3g}" for x in quantiles(values).values()))
        if validation.above_estimate is not None:
            lines.append(f"{kind}: above three times the model's own estimate: {validation.above_estimate:.2%}")
    return "\n".join(lines)


def as_json(validation: Validation) -> dict[str, Any]:
    """A validation as plain values: the quantiles and the figures of every waveform."""
    return {
        **validation.summary(),
        "theta": validation.theta.tolist(),
        "mismatches": validation.mismatch.tolist(),
        "baseline_mismatches": validation.baseline_mismatch.tolist(),
        **(
            {"mode_errors": {name: error.tolist() for name, error in validation.modes.items()}}
            if validation.modes
            else {}
        ),
    }


def page(title: str, digest: str, origin: dict[str, Any], validations: dict[str, Validation]) -> str:
    """A self-contained page in HTML: where it comes from (its ``provenance``), the table, the plots."""
    figures = {
        "Mismatch on fresh waveforms, and of the baseline alone": _mismatch_figure(validations),
        "Differences of 100 waveforms to the generator's": _residual_figure(next(iter(validations.values()))),
        "Mismatch across the parameters": _parameter_figure(validations),
    }
    facts = {
        "digest": digest,
        "generator": f"{origin['generator']['name']} {origin['generator']['version']}",
        "waveforms": f"{origin['waveforms']} ({origin['failed_waveforms']} failed and left out)",
        "regressor": f"{origin['regressor_multiply_adds']} multiply-adds",
        "time": f"{origin['seconds']} s",
    }
    parts = [
        report_table((name, str(value)) for name, value in facts.items()),
        f"<pre>{html.escape(table(validations))}</pre>",
        *(report_figure(caption, figure) for caption, figure in figures.items()),
    ]
    return report_page(title, "".join(parts))


def write_text(path: Path, text: str) -> None:
    """As :func:`write_file`, in UTF-8."""
    write_file(path, text.encode())


def write_file(path: Path, data: bytes) -> None:
    """Write a file whole or not at all; its folder is made.

    Raises
    ------
    DatasetUnwritable
        It cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, data)
    except OSError as error:
        raise DatasetUnwritable(f"Cannot write {path}: {error.strerror}. Make room or choose another place.") from error


def _figure(rows: int, columns: int, size: tuple[float, float]) -> Any:
    drawing = require("matplotlib.figure", "The report of a training", "train")
    figure = drawing.Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False)


def _mismatch_figure(validations: dict[str, Validation]) -> Any:
    figure, axes = _figure(1, 1, (9, 4.2))
    axis = axes[0, 0]
    everything = np.concatenate([np.r_[v.mismatch, v.baseline_mismatch] for v in validations.values()])
    low, high = (np.log10(max(value, _LEAST_MISMATCH)) for value in (everything.min(), everything.max()))
    bins = np.logspace(np.floor(low), max(np.ceil(high), np.floor(low) + 1.0), 90)
    for number, (kind, validation) in enumerate(validations.items()):
        for who, values, style in (
            ("model", validation.mismatch, "-"),
            ("baseline", validation.baseline_mismatch, ":"),
        ):
            shown = np.maximum(values, bins[0])
            axis.hist(shown, bins, histtype="step", lw=2, ls=style, color=f"C{number}", label=f"{who}, {kind}")
    axis.set(xscale="log", xlabel="mismatch", ylabel="waveforms")
    axis.legend(frameon=False)
    return figure


def _residual_figure(validation: Validation) -> Any:
    figure, axes = _figure(2, 1, (9, 6))
    for axis, values, label in (
        (axes[0, 0], validation.log_amplitude, "log amplitude"),
        (axes[1, 0], validation.phase, "phase [rad]"),
    ):
        axis.plot(validation.frequencies, values[:100].T, lw=0.6, alpha=0.5, color="C0")
        axis.set(xscale="log", ylabel=f"difference of {label}")
    axes[1, 0].set_xlabel("frequency at the reference mass [Hz]")
    return figure


def _parameter_figure(validations: dict[str, Validation]) -> Any:
    figure, axes = _figure(1, 5, (13, 3.4))
    names = ("mass ratio", "chi 1", "chi 2", "Lambda 1", "Lambda 2")
    for column, (axis, name) in enumerate(zip(axes[0], names, strict=True)):
        for kind, validation in validations.items():
            shown = np.maximum(validation.mismatch, _LEAST_MISMATCH)
            axis.plot(validation.theta[:, column], shown, ".", ms=3, alpha=0.6, label=kind)
        axis.set(yscale="log", xlabel=name)
    axes[0, 0].set_ylabel("mismatch")
    axes[0, 0].legend(frameon=False)
    return figure
