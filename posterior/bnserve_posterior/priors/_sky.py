"""The sky as two detectors see it: angles to the line between them, which fix the delay from one to the other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import Detector, sidereal_time

Floats = NDArray[np.float64]
_LIGHT_SPEED = 299792458.0
"""Metres per second."""


class PairFrame:
    """Of two detectors at different places; directions are unit vectors.

    Parameters
    ----------
    first, second
        The detectors.
    trigger_time
        GPS seconds, at which the Earth's turn counts.
    """

    def __init__(self, first: Detector, second: Detector, trigger_time: float) -> None:
        axis = second.location - first.location
        axis = axis / np.linalg.norm(axis)
        other = np.cross(axis, [0.0, 0.0, 1.0])
        other /= np.linalg.norm(other)
        self._axes = np.array([other, np.cross(axis, other), axis])
        self._location = first.location
        self._sidereal = sidereal_time(trigger_time)[0]

    def angles(self, right_ascension: Floats, declination: Floats) -> tuple[Floats, Floats, Floats]:
        """Cosine of the angle to the line, azimuth about it in [0, 2 pi), and how much later (s) than at the centre of
        the Earth a signal from there is at the first detector."""
        hour = right_ascension - self._sidereal
        flat = np.cos(declination)
        direction = np.stack([flat * np.cos(hour), flat * np.sin(hour), np.sin(declination)], axis=-1)
        local = direction @ self._axes.T
        azimuth = np.mod(np.arctan2(local[:, 1], local[:, 0]), 2.0 * np.pi)
        return np.clip(local[:, 2], -1.0, 1.0), azimuth, -(direction @ self._location) / _LIGHT_SPEED

    def place(self, cosine: Floats, azimuth: Floats) -> tuple[Floats, Floats, Floats]:
        """The way back: right ascension in [0, 2 pi), declination, and the same delay."""
        sine = np.sqrt(np.maximum(0.0, 1.0 - cosine**2))
        direction = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1) @ self._axes
        right_ascension = np.mod(np.arctan2(direction[:, 1], direction[:, 0]) + self._sidereal, 2.0 * np.pi)
        delay = -(direction @ self._location) / _LIGHT_SPEED
        return right_ascension, np.arcsin(np.clip(direction[:, 2], -1.0, 1.0)), delay
