"""Where detectors are on the Earth, and how far it has turned: the numbers of LAL, without LAL.

Tensors are those of LALDetectors.h in single precision, as LAL keeps them: every published analysis uses these.
"""

from __future__ import annotations

import math
from bisect import bisect_right

from bnserve_inference._units import in_units
from bnserve_protocol import AnalysisInvalid, FieldError

Place = tuple[float, float, float]
Tensor = tuple[float, float, float, float, float, float]

_HANFORD: tuple[Place, Tensor] = (
    (-2161414.92636, -3834695.17889, 4600350.22664),
    (-0.3926141, -0.07761341, -0.24738905, 0.31952408, 0.22799784, 0.07309003),
)
_CASCINA: tuple[Place, Tensor] = (
    (4546374.099, 842989.697626, 4378576.96241),
    (0.24387404, -0.09908378, -0.23257622, -0.44782585, 0.1878331, 0.2039518),
)
SITES: dict[str, tuple[Place, Tensor]] = {
    "H1": _HANFORD,
    "H2": _HANFORD,
    "L1": (
        (-74276.0447238, -5496283.71971, 3224257.01744),
        (0.41128087, 0.14021027, 0.24729459, -0.10900569, -0.18161564, -0.30227515),
    ),
    "V1": _CASCINA,
    "V0": _CASCINA,
    "K1": (
        (-3777336.024, 3484898.411, 3765313.697),
        (-0.18598965, 0.1531668, -0.32495147, 0.3495183, -0.1708744, -0.16352864),
    ),
    "I1": (
        (1348971.15479, 5857428.26577, 2127569.25209),
        (-0.32945272, -0.054599367, 0.3568008, 0.07645271, -0.17468698, 0.25300002),
    ),
    "G1": (
        (3856309.94926, 666598.956317, 5019641.41725),
        (-0.09682498, -0.36578232, 0.12213729, 0.22296812, 0.24971741, -0.12614314),
    ),
    "T1": (
        (-3946408.99111, 3366259.02802, 3699150.69233),
        (0.11213969, 0.3308421, -0.18021928, 0.21779402, 0.15372577, -0.3299337),
    ),
    "C1": (
        (-2490649.58347, -4658699.68211, 3562064.11403),
        (-0.3537959, 0.27347127, 0.10954579, 0.011521376, 0.20490275, 0.34227452),
    ),
    "E1": (
        (4546374.099, 842989.697626, 4378576.96241),
        (0.16658986, -0.21884947, -0.12996387, -0.24838203, 0.27321497, 0.08179218),
    ),
    "E2": (
        (4539369.51685, 845074.592488, 4385402.57904),
        (-0.19922121, -0.0702238, 0.21890046, 0.4233567, -0.008534697, -0.22413552),
    ),
    "E3": (
        (4542405.95075, 835639.650438, 4384075.19902),
        (0.03263135, 0.2890733, -0.08893658, -0.1749747, -0.26468027, 0.14234334),
    ),
}
"""By LAL's prefix: LIGO Hanford (4 km, 2 km) and Livingston, Virgo, KAGRA, LIGO India, GEO 600, TAMA 300, Caltech's
40 m, and the triangle of the Einstein Telescope at Virgo's site. Place in metres and the tensor's xx, xy, xz, yy, yz,
zz in the Earth-fixed frame."""

_UTC_STEPS = (
    46828801, 78364802, 109900803, 173059204, 252028805, 315187206, 346723207, 393984008, 425520009,
    457056010, 504489611, 551750412, 599184013, 820108814, 914803215, 1025136016, 1119744017, 1167264018,
)  # fmt: skip
"""GPS seconds that a leap second ended at (IERS Bulletin C). There has been none since 2017 and none is announced; each
would turn the Earth by 7e-5 rad against what is computed here."""
LAST_GPS = 3.8e9
"""Seconds; in 2100, until when sidereal time is computed."""
_MILLENNIUM = 630720000
"""Seconds from GPS's beginning to midnight of 2000-01-01, leap seconds not counted."""
_J2000 = 2451545.0
_DAYS_A_CENTURY = 36525.0
_TURNS = (8640184.812866, 3155760000.0)
"""Seconds of sidereal time in a Julian century: beyond the turns of whole days, and these."""


@in_units(gps="s")
def sidereal_time(gps: float) -> tuple[float, float]:
    """Greenwich mean sidereal time at a GPS time in radians, within [0, 2 pi), and its rate in radians per second.

    The formula of 1982 (Aoki et al., Astron. Astrophys. 105, 359) with UTC for UT1, rounded like LAL's, which has whole
    seconds as a Julian day: the bits are the same. Over the seconds around a trigger the time is linear to a part in
    10^15.

    Raises
    ------
    AnalysisInvalid
        The time is not finite, or not between 1980 and 2100.
    """
    if not 0.0 <= gps < LAST_GPS:
        raise AnalysisInvalid(
            f"A GPS time is in seconds from 1980-01-06, and below 3.8e9; got {gps}.",
            errors=[FieldError(reason="not a GPS time", parameter="trigger_time", value=gps)],
        )
    half = 32.0
    rate = (_sidereal_radians(gps + half) - _sidereal_radians(gps - half)) / (2.0 * half)
    return math.fmod(_sidereal_radians(gps), 2.0 * math.pi) % (2.0 * math.pi), rate


def sidereal_rate(gps: float) -> float:
    """Radians of sidereal time per second, by the derivative of the formula.

    That of :func:`sidereal_time` is right over the days of an analysis, and off by the rounding of a Julian day, up to
    5e-7 of it: a year after its trigger that is 5e-4 rad.
    """
    centuries = (gps - _MILLENNIUM) / (86400.0 * _DAYS_A_CENTURY)
    return (sum(_TURNS) + 2.0 * 0.093104 * centuries) / (_DAYS_A_CENTURY * 86400.0) * math.pi / 43200.0


def _sidereal_radians(gps: float) -> float:
    whole = math.floor(gps)
    day, second = divmod(whole - bisect_right(_UTC_STEPS, whole) - _MILLENNIUM, 86400)
    coarse = (day + _J2000 + second / 86400.0 - 0.5 - _J2000) / _DAYS_A_CENTURY
    fine = round((gps - whole) * 1e9) / (1e9 * _DAYS_A_CENTURY * 86400.0)
    centuries = coarse + fine
    seconds = (-6.2e-6 * centuries + 0.093104) * centuries * centuries + 67310.54841
    for part in (fine, coarse):
        for turn in _TURNS:
            seconds += turn * part
    return seconds * math.pi / 43200.0
