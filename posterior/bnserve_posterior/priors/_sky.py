"""The sky as detectors see it: angles to an axis.

The axis of two detectors is the line between them, so that one angle fixes the delay from one to the other. That of
detectors at one place is their vertical: places that are each other's images at the horizon look nearly the same there.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import Detector, DetectorData, sidereal_time
from bnserve_protocol import SOLAR_MASS_SECONDS

Floats = NDArray[np.float64]
LIGHT_SPEED = 299792458.0
"""Metres per second."""
_ONE_PLACE = 1e5
"""Metres; detectors that are closer are at one place: light takes 0.3 ms, which hardly is seen beside the antenna
patterns, of triangles for example."""
_FLAT = 0.02
"""Of a tensor's part out of the plane: that the Earth is round is less."""
_NEARLY_POLAR = 0.999
"""Of an axis: azimuths about it do not begin at the pole."""


def sky_axis(detectors: Sequence[Detector]) -> Floats | None:
    """The axis of a network, ``(3,)``; None where there is none: all detectors are at the centre of the Earth."""
    first = detectors[0].location
    lines = [each.location - first for each in detectors]
    for axis in (*lines, first):
        if (size := np.linalg.norm(axis)) > _ONE_PLACE:
            return np.asarray(axis / size)
    return None


class SkyFrame:
    """Of an axis, and of arrival at a place; directions are unit vectors.

    Parameters
    ----------
    axis, location
        ``(3,)`` both, in the frame that turns with the Earth; the second in metres.
    trigger_time
        GPS seconds, at which the Earth's turn counts.
    """

    def __init__(self, axis: Floats, location: Floats, trigger_time: float) -> None:
        other = np.cross(axis, [0.0, 0.0, 1.0] if abs(axis[2]) < _NEARLY_POLAR else [1.0, 0.0, 0.0])
        other /= np.linalg.norm(other)
        self._axes = np.array([other, np.cross(axis, other), axis])
        self._location = location
        self._sidereal = sidereal_time(trigger_time)[0]

    def angles(self, right_ascension: Floats, declination: Floats) -> tuple[Floats, Floats, Floats]:
        """Cosine of the angle to the axis, azimuth about it in [0, 2 pi), and how much later (s) than at the centre of
        the Earth a signal from there is at the place."""
        hour = right_ascension - self._sidereal
        flat = np.cos(declination)
        direction = np.stack([flat * np.cos(hour), flat * np.sin(hour), np.sin(declination)], axis=-1)
        local = direction @ self._axes.T
        azimuth = np.mod(np.arctan2(local[:, 1], local[:, 0]), 2.0 * np.pi)
        return np.clip(local[:, 2], -1.0, 1.0), azimuth, -(direction @ self._location) / LIGHT_SPEED

    def place(self, cosine: Floats, azimuth: Floats) -> tuple[Floats, Floats, Floats]:
        """The way back: right ascension in [0, 2 pi), declination, and the same delay."""
        sine = np.sqrt(np.maximum(0.0, 1.0 - cosine**2))
        direction = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1) @ self._axes
        right_ascension = np.mod(np.arctan2(direction[:, 1], direction[:, 0]) + self._sidereal, 2.0 * np.pi)
        delay = -(direction @ self._location) / LIGHT_SPEED
        return right_ascension, np.arcsin(np.clip(direction[:, 2], -1.0, 1.0)), delay


def common_plane(detectors: Sequence[Detector]) -> Floats | None:
    """The upward normal ``(3,)`` of the plane in which all arms lie; None where there is none, or not one place."""
    first = detectors[0]
    normal = np.linalg.eigh(sum(one.response @ one.response for one in detectors))[1][:, 0]
    if any(
        np.linalg.norm(one.location - first.location) > _ONE_PLACE or np.linalg.norm(one.response @ normal) > _FLAT
        for one in detectors
    ):
        return None
    return np.asarray(normal if normal @ first.location > 0.0 else -normal)


def seconds_before(data: Sequence[DetectorData], f_min: float, f_max: float, chirp_mass: float) -> float:
    """The mean time in seconds from a binary's passing a frequency (Hz) in the data to its coalescence.

    Weighted by the square of the signal-to-noise ratio, with the amplitudes and times of Newtonian binaries of a chirp
    mass in solar masses (Cutler, Flanagan, Phys. Rev. D 49, 2658 (1994), eq. 2.12).
    """
    weight, total = 0.0, 0.0
    for one in data:
        band = one.band(f_min, f_max)
        f = np.arange(band.start, band.stop) / one.duration
        found = one.weighted(band)[1] * f ** (-7.0 / 3.0)
        times = 5.0 / 256.0 * (np.pi * f) ** (-8.0 / 3.0) * (SOLAR_MASS_SECONDS * chirp_mass) ** (-5.0 / 3.0)
        weight, total = weight + float(found @ times), total + float(found.sum())
    return weight / total if total > 0.0 else 0.0


def wave_of(values: dict[str, Floats], sidereal: float) -> tuple[Floats, Floats]:
    """Where a source is, and the first axis of its polarisation: unit vectors ``(N, 3)`` of the Earth's frame."""
    hour = sidereal - values["ra"]
    place, along, across = sky_frame(hour, values["dec"])
    psi = values["psi"][:, None]
    return place, np.cos(psi) * along + np.sin(psi) * across


def sky_frame(hour: Floats, declination: Floats) -> tuple[Floats, Floats, Floats]:
    """Unit vectors ``(N, 3)`` of the Earth's frame: to a place at an hour angle, and to its west and north."""
    sin_h, cos_h, sin_d, cos_d = np.sin(hour), np.cos(hour), np.sin(declination), np.cos(declination)
    place = np.stack([cos_d * cos_h, -cos_d * sin_h, sin_d], axis=1)
    along = np.stack([-sin_h, -cos_h, np.zeros_like(hour)], axis=1)
    across = np.stack([-sin_d * cos_h, sin_d * sin_h, cos_d], axis=1)
    return place, along, across


def angles_of(place: Floats, axis: Floats, sidereal: float) -> dict[str, Floats]:
    """The way back from :func:`wave_of`."""
    hour, declination = np.arctan2(-place[:, 1], place[:, 0]), np.arcsin(np.clip(place[:, 2], -1.0, 1.0))
    _, along, across = sky_frame(hour, declination)
    psi = np.arctan2(np.sum(axis * across, axis=1), np.sum(axis * along, axis=1))
    return {"ra": np.mod(sidereal - hour, 2.0 * np.pi), "dec": declination, "psi": psi}
