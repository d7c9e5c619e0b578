"""Strain from the HDF5 files of the Gravitational Wave Open Science Center."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._units import in_units
from bnserve_protocol import AnalysisInvalid

ROLL_OFF = 0.4
"""Seconds of each half of the Tukey window's flanks, as in bilby and in the LIGO-Virgo catalogues."""


def read_gwosc(path: str | Path) -> tuple[NDArray[np.float64], float, float]:
    """All of a file: strain ``(n,)``, GPS start time, and sampling interval in seconds.

    Raises
    ------
    AnalysisInvalid
        Not such a file.
    """
    try:
        with h5py.File(path, "r") as file:
            dataset = file["strain/Strain"]
            strain = np.asarray(dataset, dtype=np.float64)
            interval = float(dataset.attrs["Xspacing"])
            start = float(dataset.attrs["Xstart"]) if "Xstart" in dataset.attrs else float(file["meta/GPSstart"][()])
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise AnalysisInvalid(
            f"{Path(path).name} is not a GWOSC strain file (HDF5 with 'strain/Strain' and its attribute 'Xspacing')."
        ) from error
    if strain.ndim != 1 or not interval > 0.0:
        raise AnalysisInvalid(f"The strain in {Path(path).name} must be a vector with a positive sampling interval.")
    return strain, start, interval


@in_units(strain="1", interval="s", roll_off="s")
def fourier_strain(strain: NDArray[np.float64], interval: float, roll_off: float = ROLL_OFF) -> NDArray[np.complex128]:
    """Fourier transform of windowed strain, ``(n // 2 + 1,)`` in 1/Hz: ``rfft(window * strain) * interval``.

    Parameters
    ----------
    strain:
        Samples of the analysed segment, ``(n,)``.
    interval:
        Seconds between them.
    roll_off:
        Seconds over which the Tukey window rises and falls.

    Raises
    ------
    AnalysisInvalid
        NaN in the samples: a gap in the data.
    """
    if not np.isfinite(strain).all():
        raise AnalysisInvalid(
            f"{int((~np.isfinite(strain)).sum())} samples of the strain are not finite: the segment has a gap. Choose "
            "another segment."
        )
    return np.fft.rfft(strain * tukey_window(len(strain), roll_off / interval)) * interval


def tukey_window(samples: int, flank: float) -> NDArray[np.float64]:
    """A window that rises and falls as half a cosine over ``flank`` samples, ``(samples,)``."""
    place = np.arange(samples)
    distance = np.minimum(place, samples - 1 - place)
    if flank <= 0.0:
        return np.ones(samples)
    return np.where(distance < flank, 0.5 * (1.0 - np.cos(np.pi * np.minimum(distance / flank, 1.0))), 1.0)


@in_units(start_time="s", duration="s", roll_off="s")
def gwosc_segment(
    path: str | Path, start_time: float, duration: float, roll_off: float = ROLL_OFF
) -> NDArray[np.complex128]:
    """The Fourier transform of ``duration`` seconds from ``start_time`` (GPS) of a file, as :func:`fourier_strain`.

    Raises
    ------
    AnalysisInvalid
        The file does not contain the segment, or there is a gap in it.
    """
    strain, start, interval = read_gwosc(path)
    first, samples = round((start_time - start) / interval), round(duration / interval)
    if first < 0 or first + samples > len(strain):
        raise AnalysisInvalid(
            f"{Path(path).name} holds GPS {start} to {start + len(strain) * interval}; the segment from {start_time} "
            f"lasting {duration} s is not inside."
        )
    return fourier_strain(strain[first : first + samples], interval, roll_off)
