"""A detector: its response and its place.

Only building an analysis comes here: it carries the tensors, places and sidereal time that evaluating it needs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._earth import SITES
from bnserve_inference._units import real
from bnserve_protocol import AnalysisInvalid, FieldError, check_location

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
            There is no such detector.
        """
        if name not in SITES:
            raise AnalysisInvalid(
                f"There is no detector '{name[:32]}'; known are {', '.join(sorted(SITES))}. Give another one's "
                "response and location as a Detector.",
                errors=[FieldError(reason="unknown detector", parameter="detector", value=name[:32])],
            )
        location, (xx, xy, xz, yy, yz, zz) = SITES[name]
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], np.float32)
        return cls(name=name, response=tensor.astype(np.float64), location=np.array(location))
