"""What a catalogue's forecasts are in a few numbers, and in a picture."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import InvalidRequest, RowStatus, require
from bnserve_store import replacing

_LOUD = (8.0, 12.0, 100.0)
_PANELS = {
    "snr": "signal-to-noise ratio",
    "error/log_distance": "error of ln distance",
    "sky_area_90": "area of the sky (90 %), square degrees",
    "error/lambda_tilde": "error of Lambda-tilde",
}


def summary(found: Mapping[str, NDArray[Any]]) -> dict[str, float]:
    """Counts, and medians of the binaries that a network hears (signal-to-noise ratio above 12), by what they are.

    ``found`` is as :func:`forecast_catalogue` returns it. Errors are in the units of their coordinates, areas in square
    degrees.
    """
    fine = found["status"] == RowStatus.OK
    numbers: dict[str, float] = {"binaries": len(fine), "not evaluated": int((~fine).sum())}
    for level in _LOUD:
        numbers[f"snr above {level:g}"] = int((found["snr"] > level).sum())
    heard = fine & (found["snr"] > _LOUD[1])
    those = f"above {_LOUD[1]:g}, "
    numbers[f"{those}not measured (singular)"] = int((heard & found["singular"]).sum())
    if not heard.any():
        return numbers
    for name in ("snr", "sky_area_90", *(key for key in found if key.startswith("error/"))):
        own = found[name][heard & np.isfinite(found[name])]
        if len(own):
            error = "error of " if "/" in name else ""
            numbers[f"{those}median {error}{name.removeprefix('error/')}"] = float(np.median(own))
    return numbers


def check_picture(path: Path) -> None:
    """Whether a picture can have this name.

    Raises
    ------
    InvalidRequest
        Its ending is none of a picture that matplotlib draws.
    PackageMissing
        matplotlib is not installed.
    """
    known = _figure().canvas.get_supported_filetypes()
    if path.suffix.removeprefix(".").lower() not in known:
        raise InvalidRequest(f"A picture cannot be named '{path.name}': its name ends in {', '.join(sorted(known))}.")


def _figure() -> Any:
    return require("matplotlib.figure", "A picture of forecasts", "roq").Figure(
        figsize=(9.0, 6.5), layout="constrained"
    )


def draw_forecasts(found: Mapping[str, NDArray[Any]], path: Path) -> None:
    """How many binaries are louder than so much, and how many of those that the network hears have smaller errors of
    distance and tides, and smaller areas of the sky.

    Parameters
    ----------
    found
        As :func:`forecast_catalogue` returns it.
    path
        Of the picture, whose folders are made if need be; written whole or not at all.

    Raises
    ------
    InvalidRequest, PackageMissing
        As :func:`check_picture`.
    """
    check_picture(path)
    panels = {name: text for name, text in _PANELS.items() if name in found}
    figure = _figure()
    heard = found["snr"] > _LOUD[1]
    for axes, (name, label) in zip(figure.subplots(2, 2).ravel(), panels.items(), strict=False):
        values = np.sort(found[name][np.isfinite(found[name]) & (heard | (name == "snr"))])
        if not len(values):
            continue
        ranks = np.arange(1, len(values) + 1)
        axes.step(values, ranks[::-1] if name == "snr" else ranks, where="post", color="#1f6feb")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(label)
        axes.set_ylabel("binaries that are louder" if name == "snr" else f"of those above {_LOUD[1]:g}, with less")
        axes.grid(visible=True, alpha=0.3)
    path.parent.mkdir(parents=True, exist_ok=True)
    with replacing(path) as temporary:
        figure.savefig(temporary, format=path.suffix.removeprefix(".") or "png", dpi=120)
