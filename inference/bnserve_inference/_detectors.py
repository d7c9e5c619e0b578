"""Detectors and the rotation of the Earth, from LAL (the extra ``detectors``).

LAL and not astropy, because its detectors are the ones that every published analysis uses, to the bit, and
because it has both them and the sidereal time; astropy knows no gravitational-wave detector and wants tables from the
network. Only building an analysis comes here: an analysis carries the tensors, places and sidereal time that evaluating
it needs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._units import in_units, real
from bnserve_protocol import AnalysisInvalid, FieldError, check_location, require

_LEAST_RADIUS = 6.25e6
"""Metres; the poles are at 6.357e6."""


@dataclass(frozen=True, eq=False)
class Detector:
    """Name, response tensor ``(3, 3)`` and location ``(3,)`` in metres, in the Earth-fixed frame of LAL.

    Raises
    ------
    AnalysisInvalid
        Other shapes, numbers that are not finite, or a place that is neither on the Earth nor its centre.
    """

    name: str
    response: NDArray[np.float64]
    location: NDArray[np.float64]

    def __post_init__(self) -> None:
        for name, shape, unit in (("response", (3, 3), "1"), ("location", (3,), "m")):
            array = np.asarray(real(name, getattr(self, name), unit))
            if array.shape != shape or not np.isfinite(array).all():
                raise AnalysisInvalid(f"The {name} of {self.name} must be finite numbers of shape {shape}.")
            object.__setattr__(self, name, array)
        check_location(self.name, self.location)
        radius = math.hypot(*self.location.tolist())
        if 0.0 < radius < _LEAST_RADIUS:
            raise AnalysisInvalid(
                f"The detector {self.name} is {radius:.7g} m from the centre of the Earth, far below its surface; give "
                "its location in metres.",
                errors=[FieldError(reason="not on Earth", parameter="location", value=radius)],
            )

    @classmethod
    def named(cls, name: str) -> Detector:
        """A detector by LAL's two-character prefix, such as ``"H1"``.

        Raises
        ------
        AnalysisInvalid
            LAL knows no such detector.
        PackageMissing
            LAL is not installed.
        """
        known = _lal().cached_detector_by_prefix
        if name not in known:
            raise AnalysisInvalid(
                f"LAL knows no detector '{name[:32]}'; known are {', '.join(sorted(known))}. Give another one's "
                "response and location as a Detector.",
                errors=[FieldError(reason="unknown detector", parameter="detector", value=name[:32])],
            )
        # LAL keeps its tensors in single precision: these are the ones that all analyses use.
        response = np.array(known[name].response, dtype=np.float64)
        return cls(name=name, response=response, location=np.array(known[name].location, dtype=np.float64))


@in_units(gps="s")
def sidereal_time(gps: float) -> tuple[float, float]:
    """Greenwich mean sidereal time at a GPS time in radians, within [0, 2 pi), and its rate in radians per second.

    Over the seconds around a trigger the time is linear to a part in 10^15.
    """
    lal = _lal()
    half = 32.0
    before, after = (lal.GreenwichMeanSiderealTime(lal.LIGOTimeGPS(gps + offset)) for offset in (-half, half))
    now = lal.GreenwichMeanSiderealTime(lal.LIGOTimeGPS(gps))
    return math.fmod(now, 2.0 * math.pi) % (2.0 * math.pi), (after - before) / (2.0 * half)


def _lal() -> Any:
    return require("lal", "Building an analysis (detectors and sidereal time)", "detectors")
