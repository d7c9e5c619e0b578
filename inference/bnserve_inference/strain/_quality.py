"""Where data may be used: gaps, and the flags that the observatories publish with them.

GWOSC's files have a bit a second for each flag. ``DATA`` and category 1 (``CBC_CAT1``) say that the detector observed
in its nominal state: where they fail there is nothing to analyse. Categories 2 and 3 are known disturbances that
searches leave out and parameter estimation looks at.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.strain._samples import Strain
from bnserve_protocol import AnalysisInvalid, FieldError

NEEDED = ("DATA", "CBC_CAT1")
"""Where one of these fails, there are no data."""
_ANTI_ALIAS = 0.83
"""Of the Nyquist frequency, up to which GWOSC says that its files of 4096 Hz are valid (1700 Hz)."""
_CALIBRATED = 10.0
"""Hz, from which on the observatories calibrate."""


def bad_seconds(strain: Strain, start_time: float, duration: float, names: tuple[str, ...] = NEEDED) -> list[int]:
    """GPS seconds within a time where one of the flags fails; none where the file has no such flags."""
    found: set[int] = set()
    for name in names:
        passes = strain.flags.get(name)
        if passes is None:
            continue
        seconds = strain.start + np.arange(len(passes))
        inside = (seconds + 1.0 > start_time) & (seconds < start_time + duration)
        found.update(int(second) for second in seconds[inside & ~passes])
    return sorted(found)


def refuse_gaps(strain: Strain, detector: str, start_time: float, duration: float) -> None:
    """Refuse a segment with a gap in it.

    Raises
    ------
    AnalysisInvalid
        Samples that are no numbers, or seconds in which the detector did not observe.
    """
    values = strain.piece(start_time, duration)
    gaps = np.flatnonzero(~np.isfinite(values))
    if len(gaps):
        first = start_time + int(gaps[0]) * strain.interval
        raise _gap(detector, f"{strain.source} has no strain at {len(gaps)} samples, the first at GPS {first:.10g}")
    if not values.any():
        raise _gap(detector, f"the strain in {strain.source} is zero throughout")
    if bad := bad_seconds(strain, start_time, duration):
        raise _gap(detector, f"{strain.source} says that there are no data in {len(bad)} s, the first GPS {bad[0]}")


def _gap(detector: str, why: str) -> AnalysisInvalid:
    return AnalysisInvalid(
        f"The segment has a gap in {detector}: {why}. Choose another segment, or leave the detector out.",
        errors=[FieldError(reason="a gap in the data", parameter=f"detectors.{detector}")],
    )


def usable(strain: Strain) -> NDArray[np.bool_]:
    """Which samples may be used for an estimate of the noise, ``(n,)``: no gap, and no injection in the hardware."""
    good = np.isfinite(strain.values)
    for name, passes in strain.flags.items():
        if name in NEEDED or (
            name.startswith("NO_") and name != "NO_CW_HW_INJ"
        ):  # continuous waves are always injected
            second = np.minimum((np.arange(len(good)) * strain.interval).astype(np.intp), len(passes) - 1)
            good &= passes[second]
    return good


def data_doubts(
    strain: Strain, detector: str, start_time: float, duration: float, band: tuple[float, float]
) -> list[str]:
    """What is doubtful about the data of a segment in a band (Hz), a sentence each."""
    return [f"{detector}: {doubt}." for doubt in _doubts(strain, start_time, duration, band)]


def _doubts(strain: Strain, start_time: float, duration: float, band: tuple[float, float]) -> Iterator[str]:
    if band[1] > _ANTI_ALIAS * strain.nyquist:
        yield (
            f"the band ends at {band[1]:g} Hz, and data sampled at {1.0 / strain.interval:g} Hz are falsified by their "
            f"anti-alias filter from about {_ANTI_ALIAS * strain.nyquist:.0f} Hz on; end the band there, or take the "
            "file with more samples"
        )
    if band[0] < _CALIBRATED and strain.flags:
        yield f"the band begins at {band[0]:g} Hz, and the observatories calibrate from {_CALIBRATED:g} Hz on"
    if not strain.flags:
        yield f"{strain.source} has no flags of data quality; gaps are seen only where samples are missing"
    for category in ("CBC_CAT2", "CBC_CAT3"):
        if bad := bad_seconds(strain, start_time, duration, (category,)):
            yield f"{len(bad)} s of the segment fail {category}, the first GPS {bad[0]}: a known disturbance"
    for name in strain.flags:
        if name.startswith("NO_") and name != "NO_CW_HW_INJ" and bad_seconds(strain, start_time, duration, (name,)):
            yield f"the segment has a signal injected into the hardware ({name} fails)"
