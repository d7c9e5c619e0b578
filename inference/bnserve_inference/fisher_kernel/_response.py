"""Source of the compiled factorisation: the response of a detector at eight nodes, and its derivatives.

With F+ + i Fx = exp(-2 i psi) times the sum over the arms of weight * T * (u + i v)^2, where u and v are what the arm
is along the polarisation axes of psi = 0 and T is its transfer function, 1 for one that is short.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_inference.fisher_kernel._layout import ARM, ARMS, Response
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_in, load, store
from bnserve_surrogate.kernel._simd import fma, splat

Floats = NDArray[np.float64]

_TINY = 1e-200
"""Added to an angle: its sine over it is then 1 where it is nothing."""


@njit(inline="always")
def add(out: Floats, place: int, value: Any) -> None:
    """Add to a vector of the working memory."""
    store(out, LANES * place, load(out, LANES * place) + value)


@njit(inline="always")
def _sinc(x: Any) -> tuple[Any, Any, Any, Any]:
    """sin x, cos x, sin x / x and the derivative of that."""
    away = x + _TINY
    sine, cosine = sincos(away)
    over = splat(1.0) / away
    value = sine * over
    return sine, cosine, value, (cosine - value) * over


@njit(inline="always")
def _transfer(phase: Any, mu: Any) -> tuple[Any, Any, Any, Any]:
    """T of an arm and its derivative by mu, the cosine to the way that the wave goes; ``phase`` is pi f L / c.

    That of :func:`bnserve_inference._response.arm_transfer`.
    """
    x, y = phase * (splat(1.0) + mu), phase * (splat(1.0) - mu)
    sin_x, cos_x, one, one_slope = _sinc(x)
    sin_y, cos_y, other, other_slope = _sinc(y)
    real = (cos_y * one + cos_x * other) * 0.5
    imaginary = (sin_y * one - sin_x * other) * 0.5
    half = phase * 0.5
    steep = half * (cos_y * one_slope + sin_y * one - cos_x * other_slope - sin_x * other)
    steep_imaginary = half * (sin_y * one_slope - cos_y * one + sin_x * other_slope - cos_x * other)
    return real, imaginary, steep, steep_imaginary


@njit(inline="always")
def _add_long(
    out: Floats, transfer: tuple[Any, Any, Any, Any], place: int, square: Any, change: Any, tilt: Any
) -> None:
    """Of an arm of any length, T times a change of its square, and what its tilt changes in T."""
    real, imaginary, steep, steep_imaginary = transfer
    own = square * tilt
    add(out, place, fma(real, change, steep * own))
    add(out, place + 1, fma(imaginary, change, steep_imaginary * own))


@njit(**JIT_OPTIONS)
def _add_arm(arm: Floats, sin_d: float, cos_d: float, f: Any, sin_h: Any, cos_h: Any, out: Floats) -> None:
    """What an arm counts, at psi = 0: squares in the places of F+ and Fx."""
    x, y, z, weight, length = arm[0], arm[1], arm[2], arm[3], arm[4]
    towards, across = cos_h * x - sin_h * y, sin_h * x + cos_h * y
    u, v = splat(0.0) - across, splat(cos_d * z) - towards * sin_d
    mu = splat(-sin_d * z) - towards * cos_d
    u_hour, v_hour = splat(0.0) - towards, across * sin_d
    twice = 2.0 * weight
    p, q = (u * u - v * v) * weight, u * v * twice
    p_hour, q_hour = (u * u_hour - v * v_hour) * twice, (u_hour * v + u * v_hour) * twice
    p_declination, q_declination = v * mu * (-twice), u * mu * twice
    if length > 0.0:
        found = _transfer(f * (np.pi * length), mu)
        none, by_hour, by_declination = splat(0.0), across * cos_d, splat(0.0) - v
        _add_long(out, found, Response.PLUS, p, p, none)
        _add_long(out, found, Response.CROSS, q, q, none)
        _add_long(out, found, Response.PLUS_BY_HOUR, p, p_hour, by_hour)
        _add_long(out, found, Response.CROSS_BY_HOUR, q, q_hour, by_hour)
        _add_long(out, found, Response.PLUS_BY_DECLINATION, p, p_declination, by_declination)
        _add_long(out, found, Response.CROSS_BY_DECLINATION, q, q_declination, by_declination)
    else:
        add(out, Response.PLUS, p)
        add(out, Response.CROSS, q)
        add(out, Response.PLUS_BY_HOUR, p_hour)
        add(out, Response.CROSS_BY_HOUR, q_hour)
        add(out, Response.PLUS_BY_DECLINATION, p_declination)
        add(out, Response.CROSS_BY_DECLINATION, q_declination)


@njit(**JIT_OPTIONS)
def respond(
    arms: Floats, location: Floats, declination: tuple[float, float], polarization: tuple[float, float], f: Any,
    sin_h: Any, cos_h: Any, out: Floats,
) -> None:  # fmt: skip
    """The :class:`Response` of a detector at eight hour angles; sines and cosines of the declination and of twice the
    polarisation angle."""
    sin_d, cos_d = declination
    sin_p, cos_p = polarization
    for k in range(Response.DELAY):
        store(out, LANES * k, splat(0.0))
    for k in range(ARMS):
        if arms[ARM * k + 3] != 0.0:
            _add_arm(floats_in(arms, ARM * k, ARM), sin_d, cos_d, f, sin_h, cos_h, out)
    for first in range(0, Response.DELAY, 4):
        for k in range(first, first + 2):
            p, q = load(out, LANES * k), load(out, LANES * (k + 2))
            store(out, LANES * k, fma(p, cos_p, q * sin_p))
            store(out, LANES * (k + 2), fma(q, cos_p, p * (-sin_p)))
    x, y, z = location[0], location[1], location[2]
    towards, across = cos_h * x - sin_h * y, sin_h * x + cos_h * y
    store(out, LANES * Response.DELAY, splat(-sin_d * z) - towards * cos_d)
    store(out, LANES * Response.DELAY_BY_HOUR, across * cos_d)
    store(out, LANES * Response.DELAY_BY_DECLINATION, fma(towards, sin_d, splat(-cos_d * z)))
