"""A detector: its response and its place.

Only building an analysis comes here: it carries the tensors, places and sidereal time that evaluating it needs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._earth import SITES
from bnserve_inference._sites import LAL_ARMS, PLANNED, Arms, Geometry, earth_fixed
from bnserve_inference._units import in_units, real
from bnserve_protocol import AnalysisInvalid, FieldError, check_arms, check_location

_SINGLE_PRECISION = 1e-5
"""Of responses that come from LAL, and some more."""
_LEAST_RADIUS = 6.25e6
"""Metres; the poles are at 6.357e6."""


@dataclass(frozen=True, eq=False)
class Detector:
    """A detector in the Earth-fixed frame of LAL.

    Parameters
    ----------
    name
        Of at most 32 letters, digits, '-' and '_'.
    response
        Its tensor, ``(3, 3)``, half of the difference of its arms' unit vectors times themselves.
    location
        Of its vertex, ``(3,)`` in metres.
    arms
        The vectors of its arms, ``(2, 3)`` in metres, where their length is to count: the response then depends on the
        frequency (``docs/explanations/response.md``), and ``response`` is that at low frequencies. None: they are short
        compared with the waves, as every published analysis to date takes them.

    Raises
    ------
    AnalysisInvalid
        Other shapes, numbers that are not finite, a response that hears nothing, arms that are none, or a place that is
        neither on the Earth nor its centre.
    """

    name: str
    response: NDArray[np.float64]
    location: NDArray[np.float64]
    arms: NDArray[np.float64] | None = None

    def __post_init__(self) -> None:
        for name, shape, unit in (("response", (3, 3), "1"), ("location", (3,), "m"), ("arms", (2, 3), "m")):
            if getattr(self, name) is None and name == "arms":
                continue
            array = np.asarray(real(name, getattr(self, name), unit))
            if array.shape != shape or not np.isfinite(array).all():
                raise AnalysisInvalid(f"The {name} of {self.name} must be finite numbers of shape {shape}.")
            object.__setattr__(self, name, array)
        check_location(self.name, self.location)
        if self.arms is not None:
            check_arms(self.name, self.arms, self.response)
        radius = math.hypot(*self.location.tolist())
        if 0.0 < radius < _LEAST_RADIUS:
            raise AnalysisInvalid(
                f"The detector {self.name} is {radius:.7g} m from the centre of the Earth, far below its surface; give "
                "its location in metres.",
                errors=[FieldError(reason="not on Earth", parameter="location", value=radius)],
            )
        _check_response(self.name, self.response)

    @classmethod
    def named(cls, name: str, *, finite_arms: bool = False) -> Detector:
        """A detector by LAL's two-character prefix, such as ``"H1"``, or one that is planned, such as ``"CE40"``.

        Parameters
        ----------
        name
            Detectors of LAL have its response and location to the bit. The others are ``"CE40"`` and ``"CE20"``, and of
            the Einstein Telescope the triangle in Sardinia (``"ETS1"``, ``"ETS2"``, ``"ETS3"``) and in the
            Meuse-Rhine Euroregion (``"ETM1"``, ``"ETM2"``, ``"ETM3"``), and two L of 15 km there (``"ETSL"``,
            ``"ETML"``).
        finite_arms
            Whether the length of its arms counts.

        Raises
        ------
        AnalysisInvalid
            There is no such detector, or it has no arms in LAL.
        """
        if name in PLANNED:
            return cls._with(name, PLANNED[name], finite_arms)
        if name not in SITES:
            raise AnalysisInvalid(
                f"There is no detector '{name[:32]}'; known are {', '.join(sorted([*SITES, *PLANNED]))}. Give another "
                "one's response and location as a Detector, or make it with Detector.at.",
                errors=[FieldError(reason="unknown detector", parameter="detector", value=name[:32])],
            )
        location, (xx, xy, xz, yy, yz, zz) = SITES[name]
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], np.float32)
        arms = None
        if finite_arms:
            if name not in LAL_ARMS:
                raise AnalysisInvalid(f"LAL has no arms of the detector {name}: leave 'finite_arms' out.")
            arms = earth_fixed(LAL_ARMS[name])[1]
        return cls(name=name, response=tensor.astype(np.float64), location=np.array(location), arms=arms)

    @classmethod
    @in_units(latitude="rad", longitude="rad", elevation="m", x_azimuth="rad", y_azimuth="rad", x_altitude="rad",
              y_altitude="rad", arm_length="m")  # fmt: skip
    def at(
        cls, name: str, *, latitude: float, longitude: float, elevation: float = 0.0, x_azimuth: float,
        y_azimuth: float, x_altitude: float = 0.0, y_altitude: float = 0.0, arm_length: float | None = None,
    ) -> Detector:  # fmt: skip
        """A detector by its coordinates, as those of LAL's ``FrDetector``.

        Parameters
        ----------
        name
            Of the detector.
        latitude, longitude
            Of the vertex, geodetic (WGS 84) in radians; north and east count as positive.
        elevation
            Metres above the ellipsoid.
        x_azimuth, y_azimuth
            Of the arms, in radians clockwise from north. (Some programs count from east, the other way.)
        x_altitude, y_altitude
            Radians by which the arms point above the horizontal.
        arm_length
            Metres, where it is to count; None for short arms.

        Raises
        ------
        AnalysisInvalid
            A place that is not on Earth, or numbers that are not finite.
        """
        arms = Arms(longitude, latitude, elevation, x_altitude, x_azimuth, y_altitude, y_azimuth, arm_length or 1.0)
        if not np.isfinite(arms).all() or abs(latitude) > 0.5 * math.pi:
            raise AnalysisInvalid(
                f"The coordinates of {name} must be finite, and its latitude between -pi / 2 and pi / 2 radians.",
                errors=[FieldError(reason="no place on Earth", parameter="latitude", value=latitude)],
            )
        return cls._with(name, earth_fixed(arms), arm_length is not None)

    @classmethod
    def _with(cls, name: str, geometry: Geometry, finite_arms: bool) -> Detector:
        place, arms = geometry
        x, y = (arm / math.hypot(*arm) for arm in arms)
        return cls(name, 0.5 * (np.outer(x, x) - np.outer(y, y)), place, arms if finite_arms else None)


def _check_response(name: str, response: NDArray[np.float64]) -> None:
    """Refuse a response, ``(3, 3)``, that no pair of arms has: AnalysisInvalid."""
    why = ""
    if (size := float(np.abs(response).max())) > 1.0:
        why = f"has numbers as large as {size:.3g}"
    elif np.abs(response - response.T).max() > _SINGLE_PRECISION:
        why = "is not symmetric"
    elif np.abs(response - np.trace(response) / 3.0 * np.eye(3)).max() < _SINGLE_PRECISION:
        why = "hears no gravitational wave"
    if why:
        raise AnalysisInvalid(
            f"The response of {name} {why}; it is half of the difference of its arms' unit vectors times themselves.",
            errors=[FieldError(reason="no response", parameter="response")],
        )
