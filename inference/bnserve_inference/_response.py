"""The response of a detector to a plane wave, in plain numpy: while it stands, and while the Earth turns it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._detectors import Detector
from bnserve_inference._units import in_units

LIGHT_SPEED = 299792458.0
"""Metres per second."""

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]


@in_units(right_ascension="rad", declination="rad", polarization_angle="rad", sidereal="rad")
def antenna_pattern(
    detector: Detector, right_ascension: float, declination: float, polarization_angle: float, sidereal: float
) -> tuple[float, float]:
    """F+ and Fx of a source (angles in radians) at a Greenwich mean sidereal time (radians); as LAL's."""
    hour_angle = sidereal - right_ascension
    sin_h, cos_h = np.sin(hour_angle), np.cos(hour_angle)
    sin_d, cos_d = np.sin(declination), np.cos(declination)
    sin_p, cos_p = np.sin(polarization_angle), np.cos(polarization_angle)
    x = np.array([-cos_p * sin_h - sin_p * cos_h * sin_d, -cos_p * cos_h + sin_p * sin_h * sin_d, sin_p * cos_d])
    y = np.array([sin_p * sin_h - cos_p * cos_h * sin_d, sin_p * cos_h + cos_p * sin_h * sin_d, cos_p * cos_d])
    response = detector.response
    return float(x @ response @ x - y @ response @ y), float(x @ response @ y + y @ response @ x)


@in_units(right_ascension="rad", declination="rad", sidereal="rad")
def time_delay(detector: Detector, right_ascension: float, declination: float, sidereal: float) -> float:
    """Seconds by which a signal arrives later at the detector than at the centre of the Earth."""
    hour_angle = sidereal - right_ascension
    cos_d = np.cos(declination)
    direction = np.array([cos_d * np.cos(hour_angle), -cos_d * np.sin(hour_angle), np.sin(declination)])
    return -float(direction @ detector.location) / LIGHT_SPEED


def arm_transfer(arm_length: float, cosine: Floats, frequencies: Floats) -> Complex:
    """What an arm makes of a wave, relative to one that is short and the middle of the light's way: complex ``(M,)``.

        D = [exp(i pi b (1 - mu)) sinc(b (1 + mu)) + exp(-i pi b (1 + mu)) sinc(b (1 - mu))] / 2,    b = f L / c

    with sinc(x) = sin(pi x) / (pi x): LAL's ``ComputeDetArmTransferFunction`` (Rakhmanov, LIGO-T060237; Whelan,
    LIGO-T070172; Rubbo, Cornish, Poujade, Phys. Rev. D 69, 082003).

    Parameters
    ----------
    arm_length
        L, in metres.
    cosine
        mu, of the angle between the arm and the way that the wave goes, ``(M,)``.
    frequencies
        In Hz, ``(M,)``.
    """
    b = frequencies * (arm_length / LIGHT_SPEED)
    one, other = np.sinc(b * (1.0 + cosine)), np.sinc(b * (1.0 - cosine))
    found: Complex = 0.5 * (
        np.exp(1j * np.pi * b * (1.0 - cosine)) * one + np.exp(-1j * np.pi * b * (1.0 + cosine)) * other
    )
    return found


def patterns(
    detector: Detector, place: tuple[float, float, float], sidereal: Floats, frequencies: Floats
) -> tuple[Complex, Complex]:
    """F+ and Fx at sidereal times (radians), each for one of the ``frequencies`` (Hz), ``(M,)``; of arms of any length.

    ``place`` is right ascension, declination and polarisation angle, in radians.
    """
    x, y, onwards = _wave_frame(place, sidereal)
    if detector.arms is None:
        tensor = detector.response
        xx, yy = (np.einsum("im,ij,jm->m", axis, tensor, axis) for axis in (x, y))
        both = 2.0 * np.einsum("im,ij,jm->m", x, 0.5 * (tensor + tensor.T), y)
        return (xx - yy).astype(np.complex128), both.astype(np.complex128)
    plus, cross = np.zeros(len(sidereal), dtype=np.complex128), np.zeros(len(sidereal), dtype=np.complex128)
    for sign, arm in zip((0.5, -0.5), detector.arms, strict=True):
        length = float(np.linalg.norm(arm))
        along_x, along_y, along = (arm / length @ axis for axis in (x, y, onwards))
        transfer = sign * arm_transfer(length, along, frequencies)
        plus += transfer * (along_x**2 - along_y**2)
        cross += transfer * (2.0 * along_x * along_y)
    return plus, cross


def delays(detector: Detector, place: tuple[float, float, float], sidereal: Floats) -> Floats:
    """As :func:`time_delay` at many sidereal times, ``(M,)``."""
    onwards = _wave_frame(place, sidereal)[2]
    return np.asarray(detector.location @ onwards / LIGHT_SPEED, dtype=np.float64)


def _wave_frame(place: tuple[float, float, float], sidereal: Floats) -> tuple[Floats, Floats, Floats]:
    """Axes of the polarisations, and the way that the wave goes, ``(3, M)`` each."""
    right_ascension, declination, polarization = place
    hour_angle = sidereal - right_ascension
    sin_h, cos_h, zero = np.sin(hour_angle), np.cos(hour_angle), np.zeros_like(hour_angle)
    sin_d, cos_d = np.sin(declination), np.cos(declination)
    sin_p, cos_p = np.sin(polarization), np.cos(polarization)
    u = np.array([-sin_h, -cos_h, zero])
    v = np.array([-cos_h * sin_d, sin_h * sin_d, zero + cos_d])
    onwards = -np.array([cos_h * cos_d, -sin_h * cos_d, zero + sin_d])
    return cos_p * u + sin_p * v, -sin_p * u + cos_p * v, onwards
