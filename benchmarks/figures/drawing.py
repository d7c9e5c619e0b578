"""What a figure hands back: the picture, its numbers, and the lines that sum them up."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from bnserve_protocol import BnserveError
from bnserve_surrogate.training.validation.report import write_text

LEVELS = {"median": 0.5, "90 %": 0.9, "99 %": 0.99, "max": 1.0}


class DataMissing(BnserveError):
    """What a figure shows was not made yet."""

    code = "data-missing"
    title = "Nothing to draw"


@dataclass(frozen=True)
class Drawing:
    """A finished figure.

    Parameters
    ----------
    figure:
        Ready to be saved.
    numbers:
        What is drawn, as plain values for JSON.
    summary:
        Lines for the terminal and for the page that shows the figure.
    """

    figure: Figure
    numbers: dict[str, Any]
    summary: Sequence[str]


def save(drawing: Drawing, name: str, folder: Path, setup: dict[str, Any]) -> tuple[Path, Path]:
    """Write ``name.png`` and ``name.json`` into a folder; returns both paths.

    Raises
    ------
    DatasetUnwritable
        The folder cannot be written.
    """
    record = {"figure": name, "setup": setup, "summary": list(drawing.summary), "numbers": drawing.numbers}
    numbers = folder / f"{name}.json"
    write_text(numbers, json.dumps(record, indent=1, sort_keys=True) + "\n")
    picture = folder / f"{name}.png"
    drawing.figure.savefig(picture, metadata={"Software": ""})
    return picture, numbers


def quantiles(values: Any) -> dict[str, float]:
    """Median, 90 %, 99 % and maximum, to three digits."""
    return {name: rounded(np.quantile(values, level)) for name, level in LEVELS.items()}


def rounded(value: Any, digits: int = 3) -> float:
    """A number to a few significant digits, so that the JSON can be read."""
    return float(f"{float(value):.{digits}g}")


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lines of a plain-text table: the first column to the left, the others to the right."""
    widths = [max(len(row[i]) for row in (header, *rows)) for i in range(len(header))]
    return [
        "  ".join(cell.rjust(width) if i else cell.ljust(width) for i, (cell, width) in enumerate(pairs)).rstrip()
        for pairs in (list(zip(row, widths, strict=True)) for row in (header, *rows))
    ]


def quantile_row(label: str, values: Any) -> list[str]:
    """A row for :func:`table` under the header ``["", *LEVELS]``."""
    return [label, *(f"{value:.1e}" for value in quantiles(values).values())]
