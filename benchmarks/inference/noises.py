"""Noise of today's detectors and of the Einstein Telescope, as likelihoods are measured with."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import interpolate_asd, read_asd

ET_NOISE = Path(__file__).parents[2] / "surrogate" / "bnserve_surrogate" / "data" / "ET_D_psd.txt"
EVENT_NOISE = Path(__file__).parents[1] / "data" / "gw170817" / "asd.npz"
_LONGEST_OF_TODAY = 1000.0
"""Seconds; longer data are the Einstein Telescope's."""


def asds(detectors: Sequence[str], duration: float, f_max: float) -> list[NDArray[np.float64]]:
    """Of each detector, on the grid of data of this duration (s) up to ``f_max`` (Hz)."""
    points = round(f_max * duration) + 1
    if duration > _LONGEST_OF_TODAY:
        return [read_asd(ET_NOISE, duration, points, psd=True)] * len(detectors)
    with np.load(EVENT_NOISE, allow_pickle=False) as file:
        f = (int(file["first_bin"]) + np.arange(len(file["H1"]))) * float(file["delta_f"])
        return [interpolate_asd(f, 1e-23 * file[name].astype(float), duration, points) for name in detectors]
