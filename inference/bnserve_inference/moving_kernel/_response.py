"""Source of the compiled contraction: the response of a detector that the Earth turns, at a block of nodes.

With theta the angle of the Earth since the coalescence, the antenna patterns of a detector with short arms are exactly
sums of 1, cos theta, sin theta, cos 2 theta and sin 2 theta, and its delay of the first three: see ``coefficients``.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from bnserve_inference.kernel._layout import Sky
from bnserve_inference.kernel._source import LIGHT_SPEED
from bnserve_inference.kernel._sums import Floats
from bnserve_inference.moving_kernel._layout import Coefficient
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos

_TWO_PI = 2.0 * np.pi
_SMALL = 1e-6
"""Of the square of an angle: below, its sine over it is taken from the first terms of the series, to 1e-14."""


@njit(inline="always")
def _along(tensor: Floats, v: tuple[float, float, float]) -> tuple[float, float, float]:
    return (
        tensor[0] * v[0] + tensor[1] * v[1] + tensor[2] * v[2],
        tensor[3] * v[0] + tensor[4] * v[1] + tensor[5] * v[2],
        tensor[6] * v[0] + tensor[7] * v[1] + tensor[8] * v[2],
    )


@njit(inline="always")
def _dot(u: tuple[float, float, float], v: tuple[float, float, float]) -> float:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


@njit(**JIT_OPTIONS)
def coefficients(
    sky: Floats, sidereal: Floats, moves: int, tensor: Floats, place: Floats, arms: Floats, out: Floats
) -> None:
    """The :class:`Coefficient` of one row in one detector.

    A source at hour angle H and declination delta, seen along the axes of the equator a = (cos H, -sin H, 0), towards
    it, and b = (sin H, cos H, 0), has the polarisation vectors u = -b and v = -sin delta a + cos delta z, turned by the
    polarisation angle. The Earth turns a to a cos theta - b sin theta and b to b cos theta + a sin theta. H is that at
    which the coalescence arrives at a detector that moves.
    """
    hour_angle = sidereal[0] + sidereal[1] * sky[Sky.TIME] - sky[Sky.RIGHT_ASCENSION]
    sin_h, cos_h = sincos(hour_angle)
    s, c = sincos(sky[Sky.DECLINATION])
    at = (place[0], place[1], place[2])
    if moves == 1:
        delay = -(c * (cos_h * at[0] - sin_h * at[1]) + s * at[2]) / LIGHT_SPEED
        sin_h, cos_h = sincos(hour_angle + sidereal[1] * delay)
    a, b, z = (cos_h, -sin_h, 0.0), (sin_h, cos_h, 0.0), (0.0, 0.0, 1.0)
    out[Coefficient.DELAY] = -(c * _dot(a, at) + s * at[2]) / LIGHT_SPEED
    out[Coefficient.RECEDING] = c * _dot(a, at) / LIGHT_SPEED
    out[Coefficient.SIDEWAYS] = c * _dot(b, at) / LIGHT_SPEED
    da, db, dz = _along(tensor, a), _along(tensor, b), _along(tensor, z)
    aa, ab, bb = _dot(a, da), _dot(a, db), _dot(b, db)
    az, bz, zz = _dot(a, dz), _dot(b, dz), dz[2]
    mean, half = 0.5 * (aa + bb), 0.5 * (bb - aa)
    sin_p, cos_p = sincos(2.0 * sky[Sky.POLARIZATION])
    plus = (mean * c * c - c * c * zz, 2.0 * s * c * az, -2.0 * s * c * bz, (1.0 + s * s) * half, (1.0 + s * s) * ab)
    cross = (0.0, -2.0 * c * bz, -2.0 * c * az, 2.0 * s * ab, -2.0 * s * half)
    for k in range(5):
        out[Coefficient.PLUS + k] = cos_p * plus[k] + sin_p * cross[k]
        out[Coefficient.CROSS + k] = cos_p * cross[k] - sin_p * plus[k]
    out[Coefficient.COS_POLARIZATION], out[Coefficient.SIN_POLARIZATION] = cos_p, sin_p
    out[Coefficient.COS_DECLINATION], out[Coefficient.SIN_DECLINATION] = c, s
    for k in range(2):
        arm = (arms[3 * k], arms[3 * k + 1], arms[3 * k + 2])
        length = np.sqrt(_dot(arm, arm))
        first = Coefficient.X_ARM if k == 0 else Coefficient.Y_ARM
        scale = 1.0 / length if length > 0.0 else 0.0
        out[first], out[first + 1] = _dot(a, arm) * scale, _dot(b, arm) * scale
        out[first + 2], out[first + 3] = arm[2] * scale, length / LIGHT_SPEED


@njit(**JIT_OPTIONS)
def short_arms(
    k: Floats, c: Floats, s: Floats, pr: Floats, pi: Floats, xr: Floats, xi: Floats, hr: Floats, hi: Floats
) -> None:
    """Strain of plus and cross polarisation in a detector, not yet delayed; ``k`` are its coefficients."""
    p0, p1, p2 = k[Coefficient.PLUS], k[Coefficient.PLUS + 1], k[Coefficient.PLUS + 2]
    p3, p4 = k[Coefficient.PLUS + 3], k[Coefficient.PLUS + 4]
    x0, x1, x2 = k[Coefficient.CROSS], k[Coefficient.CROSS + 1], k[Coefficient.CROSS + 2]
    x3, x4 = k[Coefficient.CROSS + 3], k[Coefficient.CROSS + 4]
    for j in range(c.shape[0]):
        c1, s1 = c[j], s[j]
        c2, s2 = c1 * c1 - s1 * s1, 2.0 * c1 * s1
        plus = p0 + p1 * c1 + p2 * s1 + p3 * c2 + p4 * s2
        cross = x0 + x1 * c1 + x2 * s1 + x3 * c2 + x4 * s2
        hr[j] = plus * pr[j] + cross * xr[j]
        hi[j] = plus * pi[j] + cross * xi[j]


@njit(**JIT_OPTIONS)
def delay(k: Floats, f: Floats, c: Floats, s: Floats, hr: Floats, hi: Floats) -> None:
    """Turn strain by what its delay differs from that of the coalescence."""
    receding, sideways = -_TWO_PI * k[Coefficient.RECEDING], -_TWO_PI * k[Coefficient.SIDEWAYS]
    for j in range(c.shape[0]):
        sine, cosine = sincos(f[j] * (receding * (1.0 - c[j]) + sideways * s[j]))
        a, b = hr[j], hi[j]
        hr[j] = a * cosine - b * sine
        hi[j] = a * sine + b * cosine


@njit(inline="always")
def _sinc(x: float) -> float:
    z = x * x
    sine, _ = sincos(x)
    return 1.0 - z / 6.0 if z < _SMALL else sine / x


@njit(**JIT_OPTIONS)
def one_arm(
    k: Floats, first: int, sign: float, f: Floats, c: Floats, s: Floats, pr: Floats, pi: Floats, xr: Floats, xi: Floats,
    hr: Floats, hi: Floats,
) -> None:  # fmt: skip
    """Add the strain that an arm of any length sees, ``sign`` times, not yet delayed.

    Its transfer function is that of LAL's ComputeDetArmTransferFunction (Rakhmanov, LIGO-T060237; Whelan,
    LIGO-T070172), relative to the middle of the light's way.
    """
    along_a, along_b, along_z, length = k[first], k[first + 1], k[first + 2], k[first + 3]
    cos_p, sin_p = k[Coefficient.COS_POLARIZATION], k[Coefficient.SIN_POLARIZATION]
    cos_d, sin_d = k[Coefficient.COS_DECLINATION], k[Coefficient.SIN_DECLINATION]
    for j in range(c.shape[0]):
        towards, across = along_a * c[j] - along_b * s[j], along_b * c[j] + along_a * s[j]
        u, v = -across, cos_d * along_z - sin_d * towards
        p, q = 0.5 * sign * (u * u - v * v), sign * u * v
        plus, cross = cos_p * p + sin_p * q, cos_p * q - sin_p * p
        mu = -(cos_d * towards + sin_d * along_z)
        phase = 0.5 * _TWO_PI * f[j] * length
        one, other = _sinc(phase * (1.0 + mu)), _sinc(phase * (1.0 - mu))
        sine, cosine = sincos(phase)
        a, b = 0.5 * cosine * (one + other), 0.5 * sine * (one - other)
        sine, cosine = sincos(-phase * mu)
        tr, ti = a * cosine - b * sine, a * sine + b * cosine
        er, ei = plus * pr[j] + cross * xr[j], plus * pi[j] + cross * xi[j]
        hr[j] += tr * er - ti * ei
        hi[j] += tr * ei + ti * er
