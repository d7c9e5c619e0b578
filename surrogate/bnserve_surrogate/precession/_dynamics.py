"""Precession followed from the reference frequency, eight binaries abreast; see :mod:`._equations`.

Runge-Kutta of fourth order in steps that are equal in 1 / omega, hence in the phase of precession, and become shorter
near the merger. Spins in the plane are turned back by their mean precession, whose error would otherwise add up.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential, sincos
from bnserve_surrogate.kernel._memory import floats_in, load, store
from bnserve_surrogate.kernel._simd import bits_of, fma, from_bits, splat
from bnserve_surrogate.precession._equations import LOG_TERM
from bnserve_surrogate.precession._layout import (
    BEND,
    LANES,
    NODE,
    PLACES,
    STATES,
    Constant,
    Place,
    State,
)

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_SIZE = STATES * LANES
_FIRST_KEPT = State.A_RE * LANES
_KEPT = _SIZE - _FIRST_KEPT
_MANTISSA = 2**52 - 1
_TO_DOUBLE = 0x4330000000000000
"""The bits of 2^52: an integer below it, added to them, stands behind its point."""
_LN2 = float(np.log(2.0))


@njit(inline="always")
def logarithm(x: Any) -> Any:
    """``log(x)`` of a vector of normal numbers >= 1, to 3e-13."""
    bits = bits_of(x)
    exponent = from_bits((bits >> 52) + _TO_DOUBLE) - (2.0**52 + 1023.0)
    mantissa = from_bits((bits & _MANTISSA) + (1023 << 52))
    r = (mantissa - 1.0) / (mantissa + 1.0)
    z = r * r
    # 2 artanh(r) with r <= 1/3
    p = splat(2.0 / 23.0)
    p = fma(z, p, 2.0 / 21.0)
    p = fma(z, p, 2.0 / 19.0)
    p = fma(z, p, 2.0 / 17.0)
    p = fma(z, p, 2.0 / 15.0)
    p = fma(z, p, 2.0 / 13.0)
    p = fma(z, p, 2.0 / 11.0)
    p = fma(z, p, 2.0 / 9.0)
    p = fma(z, p, 2.0 / 7.0)
    p = fma(z, p, 2.0 / 5.0)
    p = fma(z, p, 2.0 / 3.0)
    p = fma(z, p, 2.0)
    return fma(exponent, _LN2, p * r)


@njit(**JIT_OPTIONS)
def _find_place(step: Any, c: Floats, out: Floats) -> None:
    """The :class:`Place` of a step."""
    scale = load(c, Constant.SCALE * LANES)
    inverse = 1.0 / (step + BEND)
    y = scale * step * step * inverse
    log_y = logarithm(y)
    store(out, Place.SLOPE * LANES, scale * step * (step + 2.0 * BEND) * inverse * inverse)
    store(out, Place.V * LANES, exponential(log_y * (-1.0 / 3.0)))
    store(out, Place.LOG * LANES, 0.0 - log_y)
    turned = (load(c, Constant.ORIGIN * LANES) - y) * load(c, Constant.TIME * LANES)
    sine, cosine = sincos(turned * load(c, Constant.RATE_1 * LANES))
    store(out, Place.SIN1 * LANES, sine)
    store(out, Place.COS1 * LANES, cosine)
    sine, cosine = sincos(turned * load(c, Constant.RATE_2 * LANES))
    store(out, Place.SIN2 * LANES, sine)
    store(out, Place.COS2 * LANES, cosine)


@njit(inline="always")
def _order(c: Floats, first: int, z1: Any, z2: Any, value: Any) -> Any:
    """A coefficient of d omega / dt with the share of both spins."""
    return fma(load(c, first * LANES), z1, fma(load(c, (first + 4) * LANES), z2, value))


@njit(inline="always")
def _flux(c: Floats, v: Any, log_omega: Any, z1: Any, z2: Any, product: Any) -> Any:
    """d omega / dt over its leading term; ``product`` is S_1 . S_2."""
    spins = load(c, Constant.SPIN_SPIN * LANES) * product
    spins = fma(load(c, Constant.SPIN_SPIN_ALONG * LANES) * z1, z2, spins)
    spins = fma(load(c, Constant.SQUARE_ALONG_1 * LANES) * z1, z1, spins)
    spins = fma(load(c, Constant.SQUARE_ALONG_2 * LANES) * z2, z2, spins)
    v3 = v * v * v
    f3 = _order(c, Constant.FLUX_3_1, z1, z2, load(c, Constant.FLUX_3 * LANES))
    f5 = _order(c, Constant.FLUX_5_1, z1, z2, load(c, Constant.FLUX_5 * LANES))
    f6 = _order(c, Constant.FLUX_6_1, z1, z2, fma(log_omega, LOG_TERM, load(c, Constant.FLUX_6 * LANES)))
    f7 = _order(c, Constant.FLUX_7_1, z1, z2, load(c, Constant.FLUX_7 * LANES))
    high = fma(v, fma(v3, load(c, Constant.FLUX_10 * LANES), f7), f6)
    middle = fma(v, fma(v, high, f5), load(c, Constant.FLUX_4 * LANES) + spins)
    return fma(v * v, fma(v, fma(v, middle, f3), load(c, Constant.FLUX_2 * LANES)), 1.0)


@njit(inline="always")
def _rate(c: Floats, first: int, v: Any, own: Any, other: Any) -> Any:
    """Precession of a spin about L over v^5; ``own`` and ``other`` are the components along L."""
    square = v * v
    orbit = fma(square, fma(square, load(c, (first + 2) * LANES), load(c, (first + 1) * LANES)), load(c, first * LANES))
    return fma(v * -1.5, fma(load(c, (first + 3) * LANES), own, other), orbit)


@njit(**JIT_OPTIONS)
def _derivative(c: Floats, place: Floats, state: Floats, out: Floats) -> None:
    """d state / d step.

    In the frame of the orbit L moves with velocity u, in the plane, and dS/dt = D - (S . L) u there, dA/dt = u B* / 2,
    dB/dt = -u A* / 2, where D is the precession of the spin seen from afar. As complex numbers.
    """
    v = load(place, Place.V * LANES)
    sine_1, cosine_1 = load(place, Place.SIN1 * LANES), load(place, Place.COS1 * LANES)
    sine_2, cosine_2 = load(place, Place.SIN2 * LANES), load(place, Place.COS2 * LANES)
    x1, y1, z1 = load(state, State.X1 * LANES), load(state, State.Y1 * LANES), load(state, State.Z1 * LANES)
    x2, y2, z2 = load(state, State.X2 * LANES), load(state, State.Y2 * LANES), load(state, State.Z2 * LANES)
    x1, y1 = x1 * cosine_1 - y1 * sine_1, x1 * sine_1 + y1 * cosine_1
    x2, y2 = x2 * cosine_2 - y2 * sine_2, x2 * sine_2 + y2 * cosine_2
    flux = _flux(c, v, load(place, Place.LOG * LANES), z1, z2, fma(x1, x2, fma(y1, y2, z1 * z2)))
    time = (0.0 - load(place, Place.SLOPE * LANES)) * load(c, Constant.TIME * LANES) / flux
    rate_1 = _rate(c, Constant.RATE_1, v, z1, z2)
    rate_2 = _rate(c, Constant.RATE_2, v, z2, z1)
    half = v * 0.5
    ex, ey = half * (z1 * y2 - z2 * y1), half * (z2 * x1 - z1 * x2)
    # dS/dt without the mean precession, and the velocity of L
    w1 = fma(v * v, load(c, Constant.L_SPIN_1 * LANES), 1.0 / load(c, Constant.NU * LANES))
    w2 = fma(v * v, load(c, Constant.L_SPIN_2 * LANES), 1.0 / load(c, Constant.NU * LANES))
    along = fma(load(c, Constant.L_ALONG_1 * LANES), z1, load(c, Constant.L_ALONG_2 * LANES) * z2)
    size = fma(v * v, fma(v, fma(v, load(c, Constant.L_4 * LANES), along), load(c, Constant.L_2 * LANES)), 1.0)
    factor = (0.0 - time) * v / size
    ux = factor * (w1 * (ex - rate_1 * y1) + w2 * (0.0 - (ex + rate_2 * y2)))
    uy = factor * (w1 * (ey + rate_1 * x1) + w2 * (rate_2 * x2 - ey))
    _spins(c, place, time, flux, (x1, y1, z1, x2, y2, z2), (rate_1, rate_2), (ex, ey, half), (ux, uy), out)
    _observer(state, ux * 0.5, uy * 0.5, out)


@njit(inline="always")
def _spins(
    c: Floats, place: Floats, time: Any, flux: Any, spins: Any, rates: Any, exchange: Any, velocity: Any, out: Floats
) -> None:
    """The spins' derivative, turned back."""
    x1, y1, z1, x2, y2, z2 = spins
    ex, ey, half = exchange
    ux, uy = velocity
    own = time * (rates[0] - flux * load(c, Constant.RATE_1 * LANES))
    _turned_back(place, Place.SIN1, time * ex - own * y1 - z1 * ux, time * ey + own * x1 - z1 * uy, out, State.X1)
    own = time * (rates[1] - flux * load(c, Constant.RATE_2 * LANES))
    _turned_back(
        place, Place.SIN2, (0.0 - time) * ex - own * y2 - z2 * ux, own * x2 - time * ey - z2 * uy, out, State.X2
    )
    along = time * half * (x2 * y1 - y2 * x1)
    store(out, State.Z1 * LANES, along + (ux * x1 + uy * y1))
    store(out, State.Z2 * LANES, (ux * x2 + uy * y2) - along)


@njit(inline="always")
def _turned_back(place: Floats, first: int, dx: Any, dy: Any, out: Floats, at: int) -> None:
    sine, cosine = load(place, first * LANES), load(place, (first + 1) * LANES)
    store(out, at * LANES, dx * cosine + dy * sine)
    store(out, (at + 1) * LANES, dy * cosine - dx * sine)


@njit(inline="always")
def _observer(state: Floats, ux: Any, uy: Any, out: Floats) -> None:
    """The spinor's derivative; ``ux`` and ``uy`` are half the velocity of L."""
    a, b = load(state, State.A_RE * LANES), load(state, State.A_IM * LANES)
    p, q = load(state, State.B_RE * LANES), load(state, State.B_IM * LANES)
    store(out, State.A_RE * LANES, ux * p + uy * q)
    store(out, State.A_IM * LANES, uy * p - ux * q)
    store(out, State.B_RE * LANES, (0.0 - ux) * a - uy * b)
    store(out, State.B_IM * LANES, ux * b - uy * a)


@njit(inline="always")
def _advanced(state: Floats, factor: Any, slope: Floats, out: Floats) -> None:
    for k in range(0, _SIZE, LANES):
        store(out, k, fma(factor, load(slope, k), load(state, k)))


@njit(**JIT_OPTIONS)
def follow(steps: Integers, which: int, c: Floats, initial: Floats, work: Floats, table: Floats, middle: int) -> None:
    """Take each lane's steps towards the merger (``which`` 0) or away from it (1), and keep the spinor of each.

    Parameters
    ----------
    steps
        ``(8, 2)``; a lane that has taken its own stands still until all have.
    table
        One node after the other, each with ``NODE`` numbers of eight lanes; the reference frequency is that number
        ``middle``.
    """
    direction = -1 if which == 0 else 1
    size = PLACES * LANES
    here, between, there = floats_in(work, 0, size), floats_in(work, size, size), floats_in(work, 2 * size, size)
    state, slope = floats_in(work, 3 * size, _SIZE), floats_in(work, 3 * size + _SIZE, _SIZE)
    trial, total = floats_in(work, 3 * size + 2 * _SIZE, _SIZE), floats_in(work, 3 * size + 3 * _SIZE, _SIZE)
    stride = floats_in(work, 3 * size + 4 * _SIZE, LANES)
    most = 0
    for lane in range(LANES):
        most = max(most, steps[2 * lane + which])
    for k in range(_SIZE):
        state[k] = initial[k]
    step = load(c, Constant.FIRST * LANES)
    _find_place(step, c, here)
    _derivative(c, here, state, slope)
    _keep(state, slope, table, middle)
    for count in range(most):
        for lane in range(LANES):
            stride[lane] = float(direction) if count < steps[2 * lane + which] else 0.0
        h = load(stride, 0)
        _find_place(fma(h, 0.5, step), c, between)
        step = step + h
        _find_place(step, c, there)
        _take_step(c, h, between, there, state, slope, trial, total)
        _derivative(c, there, state, slope)
        _keep(state, slope, table, middle + direction * (count + 1))


@njit(inline="always")
def _take_step(
    c: Floats, h: Any, between: Floats, there: Floats, state: Floats, slope: Floats, trial: Floats, total: Floats
) -> None:
    """One step of Runge and Kutta's; ``slope`` is that at its beginning."""
    half = h * 0.5
    _advanced(state, h * (1.0 / 6.0), slope, total)
    _advanced(state, half, slope, trial)
    _derivative(c, between, trial, slope)
    _advanced(total, h * (1.0 / 3.0), slope, total)
    _advanced(state, half, slope, trial)
    _derivative(c, between, trial, slope)
    _advanced(total, h * (1.0 / 3.0), slope, total)
    _advanced(state, h, slope, trial)
    _derivative(c, there, trial, slope)
    _advanced(total, h * (1.0 / 6.0), slope, state)


@njit(inline="always")
def _keep(state: Floats, slope: Floats, table: Floats, node: int) -> None:
    at = node * (NODE * LANES)
    for k in range(0, _KEPT, LANES):
        store(table, at + k, load(state, _FIRST_KEPT + k))
        store(table, at + _KEPT + k, load(slope, _FIRST_KEPT + k))
