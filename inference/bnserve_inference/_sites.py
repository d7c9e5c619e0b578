"""Where the arms of detectors point, and how long they are: those of LAL, and those of detectors that are planned."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

_EQUATORIAL, _POLAR = 6378137.0, 6356752.314
"""Metres: half axes of the ellipsoid of WGS 84, as LAL has them (LAL_REARTH_SI and the one in CreateDetector.c)."""


Geometry: TypeAlias = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Location ``(3,)`` and arms ``(2, 3)`` in metres in the Earth-fixed frame."""


class Arms(NamedTuple):
    """Place and arms of a detector as LAL's ``FrDetector`` has them: radians, clockwise from north, and metres."""

    longitude: float
    latitude: float
    elevation: float
    x_altitude: float
    x_azimuth: float
    y_altitude: float
    y_azimuth: float
    length: float
    """Of both arms: the mean, where they differ."""


LAL_ARMS: dict[str, Arms] = {
    "T1": Arms(2.43536359469, 0.62267336022, 90.0, 0.0, 4.71238899230957, 0.0, 3.1415927410125732, 300.0),
    "V1": Arms(
        0.18333805213, 0.76151183984, 51.88399887084961, 0.0, 0.3391628563404083, 0.0, 5.051551818847656, 3000.0
    ),
    "G1": Arms(
        0.17116780435, 0.91184982752, 114.42500305175781, 0.0, 1.1936010122299194, 0.0, 5.830392837524414, 600.0
    ),
    "H2": Arms(
        -2.08405676917, 0.81079526383, 142.5540008544922, -0.0006195000023581088, 5.654877185821533,
        1.249999968422344e-05, 4.084080696105957, 2009.0,
    ),
    "H1": Arms(
        -2.08405676917, 0.81079526383, 142.5540008544922, -0.0006195000023581088, 5.654877185821533,
        1.249999968422344e-05, 4.084080696105957, 3995.06396484375,
    ),
    "L1": Arms(
        -1.58430937078, 0.53342313506, -6.573999881744385, -0.00031209998996928334, 4.403177738189697,
        -0.000610699993558228, 2.8323814868927, 3995.14990234375,
    ),
    "C1": Arms(-2.06175744538, 0.59637900541, 0.0, 0.0, 3.1415927410125732, 0.0, 1.5707963705062866, 38.25),
    "K1": Arms(
        2.396441015, 0.6355068497, 414.1809997558594, 0.0031413999386131763, 1.0541130304336548,
        -0.0036269999109208584, -0.5166798233985901, 3024.864501953125,
    ),
    "I1": Arms(1.34444215058, 0.34231676739, 440.0, 0.0, 5.801201343536377, 0.0, 4.230390548706055, 4000.0),
    "E1": Arms(
        0.18333805213, 0.76151183984, 51.88399887084961, 0.0, 0.3391628563404083, 0.0, 5.575150489807129, 10000.0
    ),
    "E2": Arms(
        0.1840585887, 0.7629930799, 59.73500061035156, -0.0007836215663701296, 4.528450965881348,
        -0.0015702445525676012, 3.481253147125244, 10000.0,
    ),
    "E3": Arms(
        0.1819299673, 0.76270463257, 59.72700119018555, -0.0015685210237279534, 2.4325857162475586,
        -0.0007818980957381427, 1.385387659072876, 10000.0,
    ),
}  # fmt: skip
"""LALDetectors.h, in single precision where LAL has that; twice the mean distance of the arms' midpoints."""


def earth_fixed(arms: Arms) -> Geometry:
    """Of a detector by its coordinates, as LAL's ``CreateDetector`` makes it.

    Anderson, Brady, Creighton, Flanagan (2001), eqs. B11 to B17.
    """
    sin_b, cos_b = math.sin(arms.latitude), math.cos(arms.latitude)
    sin_l, cos_l = math.sin(arms.longitude), math.cos(arms.longitude)
    curvature = _EQUATORIAL**2 / math.hypot(_EQUATORIAL * cos_b, _POLAR * sin_b)
    out = curvature + arms.elevation
    up = np.array([cos_b * cos_l, cos_b * sin_l, sin_b])
    north = np.array([-sin_b * cos_l, -sin_b * sin_l, cos_b])
    east = np.array([-sin_l, cos_l, 0.0])
    place = np.array(
        [out * cos_b * cos_l, out * cos_b * sin_l, ((_POLAR / _EQUATORIAL) ** 2 * curvature + arms.elevation) * sin_b]
    )
    vectors = [
        arms.length
        * (math.cos(altitude) * (math.cos(azimuth) * north + math.sin(azimuth) * east) + math.sin(altitude) * up)
        for altitude, azimuth in ((arms.x_altitude, arms.x_azimuth), (arms.y_altitude, arms.y_azimuth))
    ]
    return place, np.array(vectors)


def _place(latitude: float, longitude: float, x_arm: float, y_arm: float, length: float) -> Arms:
    """From degrees, on the ellipsoid, the arms counted counterclockwise from east."""
    x_azimuth, y_azimuth = math.radians(90.0 - x_arm), math.radians(90.0 - y_arm)
    return Arms(math.radians(longitude), math.radians(latitude), 0.0, 0.0, x_azimuth, 0.0, y_azimuth, length)


def _bisected(latitude: float, longitude: float, bisector: float, length: float) -> Geometry:
    """An L by the angle of its arms' bisector, in degrees counterclockwise from east."""
    return earth_fixed(_place(latitude, longitude, bisector - 45.0, bisector + 45.0, length))


def _triangle(latitude: float, longitude: float, length: float) -> list[Geometry]:
    """The three detectors of a triangle, which is flat; the arms of the first, at the place given, open to the east."""
    corner, arms = earth_fixed(_place(latitude, longitude, -30.0, 30.0, length))
    corners = corner, corner + arms[0], corner + arms[1]
    return [
        (there, np.array([one - there, other - there]))
        for there, one, other in zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True)
    ]


_SARDINIA = 40.0 + 31.0 / 60.0, 9.0 + 25.0 / 60.0
_MEUSE_RHINE = 50.0 + 43.0 / 60.0 + 23.0 / 3600.0, 5.0 + 55.0 / 60.0 + 14.0 / 3600.0
PLANNED: dict[str, Geometry] = {
    "CE40": _bisected(43.827, -112.825, -45.0, 40000.0),
    "CE20": _bisected(33.160, -106.480, -105.0, 20000.0),
    **dict(zip(("ETS1", "ETS2", "ETS3"), _triangle(*_SARDINIA, 10000.0), strict=True)),
    **dict(zip(("ETM1", "ETM2", "ETM3"), _triangle(*_MEUSE_RHINE, 10000.0), strict=True)),
    "ETSL": _bisected(*_SARDINIA, 45.0, 15000.0),
    "ETML": _bisected(*_MEUSE_RHINE, 90.0, 15000.0),
}
"""Cosmic Explorer in Idaho and New Mexico, and the Einstein Telescope as a triangle of 10 km or as two L of 15 km whose
arms are 45 degrees apart, in Sardinia and the Meuse-Rhine Euroregion. No site is decided: these are those of studies
(Borhanian and Sathyaprakash, arXiv:2202.11048; Branchesi et al., J. Cosmol. Astropart. Phys. 07 (2023) 068), as the
program gwfast has them (Iacovelli et al., Astrophys. J. Suppl. 263, 2 (2022))."""
