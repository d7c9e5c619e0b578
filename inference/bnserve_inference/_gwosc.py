"""Strain from the HDF5 files of the Gravitational Wave Open Science Center."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._units import in_units
from bnserve_protocol import AnalysisInvalid, FieldError

ROLL_OFF = 0.4
"""Seconds of each flank of the Tukey window: what bilby_pipe takes by default (bilby itself takes 0.2)."""


def read_gwosc(path: str | Path) -> tuple[NDArray[np.float64], float, float]:
    """All of a file: strain ``(n,)``, GPS start time, and sampling interval in seconds.

    Raises
    ------
    AnalysisInvalid
        No such file, or a file of another kind.
    """
    try:
        with h5py.File(path, "r") as file:
            dataset = file["strain/Strain"]
            strain = np.asarray(dataset, dtype=np.float64)
            interval = float(dataset.attrs["Xspacing"])
            start = float(dataset.attrs["Xstart"]) if "Xstart" in dataset.attrs else float(file["meta/GPSstart"][()])
    except FileNotFoundError as error:
        raise AnalysisInvalid(f"There is no file {path}; look at its name and folder.") from error
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise AnalysisInvalid(
            f"{Path(path).name} is not a GWOSC strain file (HDF5 with 'strain/Strain' and its attribute 'Xspacing')."
        ) from error
    if strain.ndim != 1 or len(strain) == 0 or not (np.isfinite(start) and np.isfinite(interval) and interval > 0.0):
        raise AnalysisInvalid(
            f"The strain in {Path(path).name} must be a vector with a start time and a positive sampling interval."
        )
    return strain, start, interval


@in_units(strain="1", interval="s", roll_off="s")
def fourier_strain(strain: NDArray[np.float64], interval: float, roll_off: float = ROLL_OFF) -> NDArray[np.complex128]:
    """Fourier transform of windowed strain, ``(n // 2 + 1,)`` in 1/Hz: ``rfft(window * strain) * interval``.

    With the same ``roll_off`` the window is bilby's (``scipy.signal.windows.tukey``).

    Parameters
    ----------
    strain
        Samples of the analysed segment, ``(n,)``.
    interval
        Seconds between them.
    roll_off
        Seconds over which the Tukey window rises and falls; none for 0.

    Raises
    ------
    AnalysisInvalid
        No samples, NaN in the samples (a gap in the data), no sampling interval, or flanks longer than the segment.
    """
    if np.ndim(strain) != 1 or len(strain) < 2:
        raise AnalysisInvalid(f"The strain must be a vector of at least two samples; got shape {np.shape(strain)}.")
    if not (np.isfinite(interval) and interval > 0.0):
        raise AnalysisInvalid(f"The sampling interval must be a positive number of seconds; got {interval!r}.")
    if not 0.0 <= 2.0 * roll_off <= len(strain) * interval:
        raise AnalysisInvalid(
            f"The window cannot rise and fall within {roll_off!r} s each in a segment of {len(strain) * interval:g} s; "
            "give a roll-off of at most half of the segment.",
            errors=[FieldError(reason="longer than the segment", parameter="roll_off", value=str(roll_off))],
        )
    if not np.isfinite(strain).all():
        raise AnalysisInvalid(
            f"{int((~np.isfinite(strain)).sum())} samples of the strain are not finite: the segment has a gap. Choose "
            "another segment."
        )
    return np.fft.rfft(strain * tukey_window(len(strain), roll_off / interval)) * interval


def tukey_window(samples: int, flank: float) -> NDArray[np.float64]:
    """A window that rises and falls as half a cosine over ``flank`` samples, ``(samples,)``.

    SciPy's, whose flanks are shorter by a part in ``samples``: they are a fraction of the distance between the first
    and the last sample.
    """
    place = np.arange(samples)
    distance = np.minimum(place, samples - 1 - place)
    if flank <= 0.0:
        return np.ones(samples)
    flank = flank * (samples - 1) / samples
    return np.where(distance < flank, 0.5 * (1.0 - np.cos(np.pi * np.minimum(distance / flank, 1.0))), 1.0)


@in_units(start_time="s", duration="s", roll_off="s")
def gwosc_segment(
    path: str | Path, start_time: float, duration: float, roll_off: float = ROLL_OFF
) -> NDArray[np.complex128]:
    """The Fourier transform of ``duration`` seconds from ``start_time`` (GPS) of a file, as :func:`fourier_strain`.

    Its time zero is ``start_time``, which must be the time of a sample: nothing is rounded, because an analysis that
    takes samples to be some microseconds earlier than they are has another likelihood.

    Raises
    ------
    AnalysisInvalid
        As :func:`read_gwosc` and :func:`fourier_strain`; a start or a duration between samples; the file does not
        contain the segment.
    """
    strain, start, interval = read_gwosc(path)
    if not (np.isfinite(start_time) and np.isfinite(duration) and duration > 0.0):
        raise AnalysisInvalid(
            f"A segment has a start (GPS seconds) and a positive duration; got {start_time!r} and {duration!r}."
        )
    first = whole_samples("start_time", start_time - start, interval, float(np.spacing(start_time)), start)
    samples = whole_samples("duration", duration, interval, 1e-9 * duration, 0.0)
    if first < 0 or first + samples > len(strain):
        raise AnalysisInvalid(
            f"{Path(path).name} holds GPS {start} to {start + len(strain) * interval}; the segment from {start_time} "
            f"lasting {duration} s is not inside."
        )
    return fourier_strain(strain[first : first + samples], interval, roll_off)


def whole_samples(name: str, seconds: float, interval: float, slack: float, origin: float) -> int:
    """How many samples a time is, which must be a whole number of them to within rounding."""
    places = seconds / interval
    if abs(places - np.round(places)) * interval > slack:
        before, after = (origin + interval * float(round_(places)) for round_ in (np.floor, np.ceil))
        raise AnalysisInvalid(
            f"'{name}' ({origin + seconds!r} s) is between two samples, {interval!r} s apart: give {before!r} or "
            f"{after!r}, and the same to DetectorData.",
            errors=[FieldError(reason="between two samples", parameter=name, value=origin + seconds)],
        )
    return round(places)
