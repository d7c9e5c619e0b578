"""Source of the compiled adjoint: antenna patterns of a detector at a block of nodes, with their derivatives.

A source at hour angle H is seen by a detector that has turned by theta as one at H + theta: derivatives by H are those
by theta.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from bnserve_inference.adjoint_kernel._layout import BLOCK, Buffer, Geometry
from bnserve_inference.kernel._layout import Sky
from bnserve_inference.kernel._source import LIGHT_SPEED
from bnserve_inference.kernel._sums import Floats
from bnserve_inference.moving_kernel._layout import Coefficient
from bnserve_inference.moving_kernel._response import _along, _dot
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_in, load, store
from bnserve_surrogate.kernel._simd import fma, splat

_TWO_PI = 2.0 * np.pi
_SMALL = 1e-6
"""Of the square of an angle: below, what is over it is taken from the first terms of the series."""


@njit(inline="always")
def block_of(buffers: Floats, place: int) -> Floats:
    """One buffer."""
    return floats_in(buffers, place * BLOCK, BLOCK)


@njit(**JIT_OPTIONS)
def fill_geometry(sky: Floats, sidereal: Floats, moves: int, tensor: Floats, place: Floats, out: Floats) -> None:
    """Derivatives by declination of the :class:`Coefficient` of a row in a detector, whose formulas are there."""
    hour_angle = sidereal[0] + sidereal[1] * sky[Sky.TIME] - sky[Sky.RIGHT_ASCENSION]
    sin_h, cos_h = sincos(hour_angle)
    s, c = sincos(sky[Sky.DECLINATION])
    at = (place[0], place[1], place[2])
    out[Geometry.ARRIVAL_DELAY], out[Geometry.ARRIVAL_DELAY + 1] = 0.0, 0.0
    if moves == 1:
        towards, across = cos_h * at[0] - sin_h * at[1], sin_h * at[0] + cos_h * at[1]
        delay = -(c * towards + s * at[2]) / LIGHT_SPEED
        out[Geometry.ARRIVAL_DELAY] = c * across / LIGHT_SPEED
        out[Geometry.ARRIVAL_DELAY + 1] = (s * towards - c * at[2]) / LIGHT_SPEED
        sin_h, cos_h = sincos(hour_angle + sidereal[1] * delay)
    a, b, z = (cos_h, -sin_h, 0.0), (sin_h, cos_h, 0.0), (0.0, 0.0, 1.0)
    out[Geometry.DELAY] = (s * _dot(a, at) - c * at[2]) / LIGHT_SPEED
    out[Geometry.RECEDING] = -s * _dot(a, at) / LIGHT_SPEED
    out[Geometry.SIDEWAYS] = -s * _dot(b, at) / LIGHT_SPEED
    da, db, dz = _along(tensor, a), _along(tensor, b), _along(tensor, z)
    aa, ab, bb = _dot(a, da), _dot(a, db), _dot(b, db)
    az, bz, zz = _dot(a, dz), _dot(b, dz), dz[2]
    mean, half, cos_2d = 0.5 * (aa + bb), 0.5 * (bb - aa), c * c - s * s
    sin_p, cos_p = sincos(2.0 * sky[Sky.POLARIZATION])
    plus = (-2.0 * s * c * (mean - zz), 2.0 * cos_2d * az, -2.0 * cos_2d * bz, 2.0 * s * c * half, 2.0 * s * c * ab)
    cross = (0.0, 2.0 * s * bz, 2.0 * s * az, 2.0 * c * ab, -2.0 * c * half)
    for k in range(5):
        out[Geometry.PLUS + k] = cos_p * plus[k] + sin_p * cross[k]
        out[Geometry.CROSS + k] = cos_p * cross[k] - sin_p * plus[k]
    for k in range(Geometry.HOUR_BAR, Geometry.TIME_BAR + 1):
        out[k] = 0.0


@njit(inline="always")
def _terms(k: Floats, first: int, c1: Any, s1: Any, c2: Any, s2: Any) -> Any:
    """A pattern of five coefficients."""
    value = fma(s1, k[first + 2], fma(c1, k[first + 1], splat(k[first])))
    return fma(s2, k[first + 4], fma(c2, k[first + 3], value))


@njit(inline="always")
def _slopes(k: Floats, first: int, c1: Any, s1: Any, c2: Any, s2: Any) -> Any:
    """Its derivative by theta."""
    value = fma(c1, k[first + 2], s1 * (0.0 - k[first + 1]))
    return fma(c2, 2.0 * k[first + 4], fma(s2, -2.0 * k[first + 3], value))


@njit(**JIT_OPTIONS)
def short_patterns(k: Floats, geometry: Floats, size: int, own: Floats) -> None:
    """Patterns of short arms, which are real, into the buffers ``own`` of a group."""
    cosine, sine = block_of(own, Buffer.COSINE), block_of(own, Buffer.COSINE + 1)
    for j in range(0, size, LANES):
        c1, s1 = load(cosine, j), load(sine, j)
        c2, s2 = c1 * c1 - s1 * s1, c1 * s1 * 2.0
        store(block_of(own, Buffer.PATTERN), j, _terms(k, Coefficient.PLUS, c1, s1, c2, s2))
        store(block_of(own, Buffer.PATTERN + 2), j, _terms(k, Coefficient.CROSS, c1, s1, c2, s2))
        store(block_of(own, Buffer.PATTERN + 4), j, _slopes(k, Coefficient.PLUS, c1, s1, c2, s2))
        store(block_of(own, Buffer.PATTERN + 6), j, _slopes(k, Coefficient.CROSS, c1, s1, c2, s2))
        store(block_of(own, Buffer.PATTERN + 8), j, _terms(geometry, Geometry.PLUS, c1, s1, c2, s2))
        store(block_of(own, Buffer.PATTERN + 10), j, _terms(geometry, Geometry.CROSS, c1, s1, c2, s2))
        for part in range(6):
            store(block_of(own, Buffer.PATTERN + 2 * part + 1), j, splat(0.0))


@njit(inline="always")
def _sinc(x: float) -> tuple[float, float]:
    """sin x / x, and its derivative."""
    z = x * x
    sine, cosine = sincos(x)
    if z < _SMALL:
        return 1.0 - z / 6.0, x * (-1.0 / 3.0 + z / 30.0)
    return sine / x, (cosine - sine / x) / x


@njit(inline="always")
def _transfer(phase: float, mu: float) -> tuple[float, float, float, float]:
    """What an arm makes of a wave, as in ``one_arm``, and its derivative by the cosine mu, both complex."""
    one, one_slope = _sinc(phase * (1.0 + mu))
    other, other_slope = _sinc(phase * (1.0 - mu))
    sine, cosine = sincos(phase)
    a, b = 0.5 * cosine * (one + other), 0.5 * sine * (one - other)
    da, db = 0.5 * cosine * phase * (one_slope - other_slope), 0.5 * sine * phase * (one_slope + other_slope)
    sine, cosine = sincos(-phase * mu)
    tr, ti = a * cosine - b * sine, a * sine + b * cosine
    return tr, ti, da * cosine - db * sine + phase * ti, da * sine + db * cosine - phase * tr


@njit(**JIT_OPTIONS)
def clear_patterns(own: Floats) -> None:
    """Nothing, to which arms are added."""
    for part in range(12):
        block_of(own, Buffer.PATTERN + part)[:] = 0.0


@njit(**JIT_OPTIONS)
def add_arm(k: Floats, first: int, sign: float, f: Floats, size: int, own: Floats) -> None:
    """Add the patterns of an arm of any length, ``sign`` times."""
    along_a, along_b, along_z, length = k[first], k[first + 1], k[first + 2], k[first + 3]
    cos_p, sin_p = k[Coefficient.COS_POLARIZATION], k[Coefficient.SIN_POLARIZATION]
    cos_d, sin_d = k[Coefficient.COS_DECLINATION], k[Coefficient.SIN_DECLINATION]
    cosine, sine = block_of(own, Buffer.COSINE), block_of(own, Buffer.COSINE + 1)
    for j in range(size):
        towards, across = along_a * cosine[j] - along_b * sine[j], along_b * cosine[j] + along_a * sine[j]
        u, v = -across, cos_d * along_z - sin_d * towards
        mu = -(cos_d * towards + sin_d * along_z)
        tr, ti, dr, di = _transfer(0.5 * _TWO_PI * f[j] * length, mu)
        p, q = 0.5 * (u * u - v * v), u * v
        tr, ti, dr, di = sign * tr, sign * ti, sign * dr, sign * di
        _add(own, 0, j, tr, ti, p, q, cos_p, sin_p)
        du, dv, tilt = -towards, sin_d * across, cos_d * across  # by hour angle
        _add(own, 1, j, dr * tilt, di * tilt, p, q, cos_p, sin_p)
        _add(own, 1, j, tr, ti, u * du - v * dv, du * v + u * dv, cos_p, sin_p)
        _add(own, 2, j, -dr * v, -di * v, p, q, cos_p, sin_p)  # by declination: v changes by mu, and mu by -v
        _add(own, 2, j, tr, ti, -v * mu, u * mu, cos_p, sin_p)


@njit(inline="always")
def _add(own: Floats, part: int, j: int, gr: float, gi: float, p: float, q: float, cos_p: float, sin_p: float) -> None:
    """Add a complex number times both patterns at a polarisation."""
    plus, cross = cos_p * p + sin_p * q, cos_p * q - sin_p * p
    at = Buffer.PATTERN + 4 * part
    block_of(own, at)[j] += gr * plus
    block_of(own, at + 1)[j] += gi * plus
    block_of(own, at + 2)[j] += gr * cross
    block_of(own, at + 3)[j] += gi * cross
