"""The noise of a detector: a curve from a file, one of bilby's, or estimated from strain."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import interpolate_asd, read_asd
from bnserve_inference.strain import Strain, estimate_asd
from bnserve_posterior.events import DetectorSection, EventInvalid

Floats = NDArray[np.float64]
_PIECES = 16
"""Of an estimate by itself: the density is then known to a third at every frequency, and shorter pieces blur lines."""
_SHORTEST = 2.0
"""Seconds of a piece."""


class Noise(NamedTuple):
    """ASD ``(K,)`` in 1/sqrt(Hz) at multiples of 1 / duration, where it comes from, and what is doubtful about it."""

    asd: Floats
    origin: str
    doubts: list[str]


def noise_curve(name: str, detector: str, duration: float, points: int, psd: bool = False) -> Floats:
    """An ASD from a file, ``(points,)`` at multiples of 1 / ``duration`` (s), infinite outside of it.

    Parameters
    ----------
    name
        A text file of two columns, Hz and value; a NumPy archive (``*.npz``) with an array for each detector, in
        1/sqrt(Hz) times ``unit``, ``delta_f`` apart from ``first_bin`` ``delta_f`` on; or one of bilby's noise curves.
    psd
        Whether the values are power spectral densities.

    Raises
    ------
    EventInvalid
        There is no such file or curve.
    AnalysisInvalid
        It holds something else.
    """
    path = Path(name)
    if not path.exists():
        path = _bilbys_curve(name)
    if path.suffix == ".npz":
        return _from_archive(path, detector, duration, points)
    return read_asd(path, duration, points, psd=psd)


def _bilbys_curve(name: str) -> Path:
    import bilby.gw.detector

    folder = Path(bilby.gw.detector.__file__).parent / "noise_curves"
    known = sorted(path.name for path in folder.glob("*.txt") if path.stem.endswith(("_asd", "_psd")))
    if name not in known:
        raise EventInvalid(
            f"There is no file {name}, and bilby has no noise curve of that name: it has {', '.join(known)}."
        )
    return folder / name


def _from_archive(path: Path, detector: str, duration: float, points: int) -> Floats:
    try:
        with np.load(path, allow_pickle=False) as file:
            unit = float(file["unit"]) if "unit" in file else 1.0
            values = unit * np.asarray(file[detector], dtype=np.float64)
            frequencies = (int(file["first_bin"]) + np.arange(len(values))) * float(file["delta_f"])
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise EventInvalid(f"{path.name} has no noise curve of {detector}: {error}.") from error
    return interpolate_asd(frequencies, values, duration, points)


def estimated_noise(
    strain: Strain, section: DetectorSection, detector: str, segment: tuple[float, float], points: int
) -> Noise:
    """From strain: the stretch of the section, or what the file has before the segment, or on both sides of it.

    Parameters
    ----------
    segment
        Start (GPS seconds) and duration of what is analysed.
    points
        Of the result.

    Raises
    ------
    AnalysisInvalid
        Too little strain.
    """
    start, duration = segment
    if section.psd_start is not None and section.psd_duration is not None:
        stretches = [(section.psd_start, section.psd_duration)]
    else:
        stretches = _around(strain, start, duration)
    longest = max(length for _, length in stretches)
    piece = section.psd_segment or _piece(duration, longest)
    begin, length = max(stretches, key=lambda stretch: stretch[1])
    found = estimate_asd(strain, begin, length, piece)
    origin = (
        f"{detector}: noise estimated from {length:g} s of {strain.source} from GPS {begin:.10g}: median of "
        f"{found.pieces} pieces of {piece:g} s" + (f", {found.left_out} with gaps left out" if found.left_out else "")
    )
    doubts = []
    if begin < start + duration and begin + length > start:
        doubts.append(
            f"{detector}: the noise is estimated from data that hold the segment itself, and with it the signal."
        )
    if found.pieces < _PIECES:
        part = 100.0 / np.sqrt(found.pieces)
        doubts.append(
            f"{detector}: the noise is the median of {found.pieces} pieces alone, known to some {part:.0f} %."
        )
    if piece < duration:
        doubts.append(
            f"{detector}: the noise is known every {1.0 / piece:g} Hz, and the data every {1.0 / duration:g} Hz: lines "
            "that are narrower are blurred."
        )
    return Noise(interpolate_asd(found.frequencies, found.asd, duration, points), origin, doubts)


def _around(strain: Strain, start: float, duration: float) -> list[tuple[float, float]]:
    """Stretches without the segment: before it if that is long enough, or either side; or, if need be, the whole."""
    before, after = (strain.start, start - strain.start), (start + duration, strain.end - start - duration)
    long = [stretch for stretch in (before, after) if stretch[1] >= 2.5 * _SHORTEST]  # four pieces that overlap by half
    return long or [(strain.start, strain.end - strain.start)]


def _piece(duration: float, stretch: float) -> float:
    """As long as the segment, or as much shorter, by halves, as leaves enough pieces."""
    piece = duration
    while piece > _SHORTEST and stretch < 0.5 * (_PIECES + 1) * piece:
        piece *= 0.5
    return piece
