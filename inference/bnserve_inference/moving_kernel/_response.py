"""Source of the compiled contraction: the response of a detector that the Earth turns, at a block of nodes.

With theta the angle of the Earth since the coalescence, the antenna patterns of a detector with short arms are exactly
sums of 1, cos theta, sin theta, cos 2 theta and sin 2 theta, and its delay of the first three: see ``coefficients``.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from bnserve_inference.kernel._lanes import larger, size_of, times
from bnserve_inference.kernel._layout import Sky
from bnserve_inference.kernel._source import LIGHT_SPEED
from bnserve_inference.kernel._sums import Floats
from bnserve_inference.moving_kernel._layout import Coefficient
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import load, store
from bnserve_surrogate.kernel._simd import fma

_TWO_PI = 2.0 * np.pi
_SMALL = 1e-9
"""An angle below which its sine over it is one."""


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


@njit(inline="always")
def _pattern(k: Floats, first: int, c1: Any, s1: Any, c2: Any, s2: Any) -> Any:
    return fma(c1, k[first + 1], fma(s1, k[first + 2], fma(c2, k[first + 3], fma(s2, k[first + 4], k[first]))))


@njit(**JIT_OPTIONS)
def short_arms(
    k: Floats, c: Floats, s: Floats, pr: Floats, pi: Floats, xr: Floats, xi: Floats, hr: Floats, hi: Floats
) -> None:
    """Strain of plus and cross polarisation in a detector, not yet delayed; ``k`` are its coefficients."""
    for j in range(0, c.shape[0], LANES):
        c1, s1 = load(c, j), load(s, j)
        c2, s2 = fma(c1, c1, 0.0 - s1 * s1), 2.0 * c1 * s1
        plus, cross = _pattern(k, Coefficient.PLUS, c1, s1, c2, s2), _pattern(k, Coefficient.CROSS, c1, s1, c2, s2)
        store(hr, j, fma(plus, load(pr, j), cross * load(xr, j)))
        store(hi, j, fma(plus, load(pi, j), cross * load(xi, j)))


@njit(**JIT_OPTIONS)
def delay(k: Floats, f: Floats, c: Floats, s: Floats, hr: Floats, hi: Floats) -> None:
    """Turn strain by what its delay differs from that of the coalescence."""
    receding, sideways = -_TWO_PI * k[Coefficient.RECEDING], -_TWO_PI * k[Coefficient.SIDEWAYS]
    for j in range(0, c.shape[0], LANES):
        sine, cosine = sincos(load(f, j) * fma(load(s, j), sideways, receding * (1.0 - load(c, j))))
        a, b = times(load(hr, j), load(hi, j), cosine, sine)
        store(hr, j, a)
        store(hi, j, b)


@njit(inline="always")
def _sinc(x: Any) -> Any:
    size = larger(size_of(x), _SMALL)
    sine, _ = sincos(size)
    return sine / size


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
    for j in range(0, c.shape[0], LANES):
        c1, s1 = load(c, j), load(s, j)
        towards, across = fma(c1, along_a, s1 * -along_b), fma(c1, along_b, s1 * along_a)
        u, v = 0.0 - across, cos_d * along_z - sin_d * towards
        p, q = 0.5 * sign * fma(u, u, 0.0 - v * v), sign * u * v
        plus, cross = fma(p, cos_p, q * sin_p), fma(q, cos_p, p * -sin_p)
        mu = -sin_d * along_z - cos_d * towards
        phase = (0.5 * _TWO_PI * length) * load(f, j)
        one, other = _sinc(phase * (1.0 + mu)), _sinc(phase * (1.0 - mu))
        sine, cosine = sincos(phase)
        a, b = 0.5 * cosine * (one + other), 0.5 * sine * (one - other)
        sine, cosine = sincos(0.0 - phase * mu)
        tr, ti = times(a, b, cosine, sine)
        er, ei = (
            fma(plus, load(pr, j), cross * load(xr, j)), fma(plus, load(pi, j), cross * load(xi, j)),
        )  # fmt: skip
        a, b = times(tr, ti, er, ei)
        store(hr, j, load(hr, j) + a)
        store(hi, j, load(hi, j) + b)
