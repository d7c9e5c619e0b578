"""Source of the compiled adjoint: from the bar of a strain in a detector to those of what it is made of."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from bnserve_inference.adjoint_kernel._layout import Argument, Buffer, Geometry, Shared
from bnserve_inference.adjoint_kernel._response import block_of
from bnserve_inference.adjoint_kernel._sums import dot, times
from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.moving_kernel._layout import Coefficient
from bnserve_surrogate.adjoint._sums import across, load_complex, split
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, load, padded, store, store_complex
from bnserve_surrogate.kernel._simd import fma, splat

_TWO_PI = 2.0 * np.pi


@njit(**JIT_OPTIONS)
def pull_back(f: Floats, k: Floats, geometry: Floats, size: int, shared: Floats, own: Floats, lanes: Floats) -> None:
    """Bars of the polarisations and of the Earth's turn, by node, and of the place in the sky, summed in ``geometry``.

    Of a group in a detector, whose strain has the bar ``Shared.STRAIN_BAR``.
    """
    receding, sideways = k[Coefficient.RECEDING], k[Coefficient.SIDEWAYS]
    by_hour, by_declination, by_polarization, by_time = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
    for j in range(0, size, LANES):
        zr, zi = load(block_of(shared, Shared.STRAIN_BAR), j), load(block_of(shared, Shared.STRAIN_BAR + 1), j)
        sr, si = load(block_of(own, Buffer.STRAIN), j), load(block_of(own, Buffer.STRAIN + 1), j)
        vr, vi = load(block_of(shared, Shared.SLOPE_BAR), j), load(block_of(shared, Shared.SLOPE_BAR + 1), j)
        by_time = by_time + (vr * sr - vi * si)
        late = fma(zr, si, zi * sr) * (load(f, j) * _TWO_PI)
        c, s = load(block_of(own, Buffer.COSINE), j), load(block_of(own, Buffer.COSINE + 1), j)
        kr, ki = load(block_of(shared, Shared.CALIBRATION), j), load(block_of(shared, Shared.CALIBRATION + 1), j)
        ar, ai = times(zr, zi, kr, ki)
        ar, ai = times(ar, ai, load(block_of(own, Buffer.DELAY), j), load(block_of(own, Buffer.DELAY + 1), j))
        pr, pi, xr, xi = _through_patterns(ar, ai, j, own)
        hour = _real_of(own, 1, j, pr, pi, xr, xi)
        away = splat(1.0) - c
        by_hour = by_hour + fma(late, s * receding - away * sideways, hour)
        turn = load(block_of(own, Buffer.TURN_BAR), j)
        store(block_of(own, Buffer.TURN_BAR), j, turn + fma(late, s * receding + c * sideways, hour))
        own_declination = _real_of(own, 2, j, pr, pi, xr, xi)
        change = away * geometry[Geometry.RECEDING] + s * geometry[Geometry.SIDEWAYS]
        by_declination = by_declination + fma(late, change, own_declination)
        by_polarization = by_polarization + _turned(own, j, pr, pi, xr, xi)
    geometry[Geometry.HOUR_BAR] += across(by_hour, lanes)
    geometry[Geometry.DECLINATION_BAR] += across(by_declination, lanes)
    geometry[Geometry.POLARIZATION_BAR] += across(by_polarization, lanes)
    geometry[Geometry.TIME_BAR] += across(by_time, lanes)


@njit(inline="always")
def _through_patterns(ar: Any, ai: Any, j: int, own: Floats) -> Any:
    """Add to the bars of both polarisations; their strains times the bar of what the detector sees."""
    for part in range(2):
        at = Buffer.PATTERN + 2 * part
        br, bi = times(ar, ai, load(block_of(own, at), j), load(block_of(own, at + 1), j))
        real, imaginary = block_of(own, Buffer.PLUS_BAR + 2 * part), block_of(own, Buffer.PLUS_BAR + 2 * part + 1)
        store(real, j, load(real, j) + br)
        store(imaginary, j, load(imaginary, j) + bi)
    pr, pi = times(ar, ai, load(block_of(own, Buffer.PLUS), j), load(block_of(own, Buffer.PLUS + 1), j))
    xr, xi = times(ar, ai, load(block_of(own, Buffer.CROSS), j), load(block_of(own, Buffer.CROSS + 1), j))
    return pr, pi, xr, xi


@njit(inline="always")
def _real_of(own: Floats, part: int, j: int, pr: Any, pi: Any, xr: Any, xi: Any) -> Any:
    """The real part of a derivative of the patterns times the polarisations."""
    at = Buffer.PATTERN + 4 * part
    plus = load(block_of(own, at), j) * pr - load(block_of(own, at + 1), j) * pi
    return plus + (load(block_of(own, at + 2), j) * xr - load(block_of(own, at + 3), j) * xi)


@njit(inline="always")
def _turned(own: Floats, j: int, pr: Any, pi: Any, xr: Any, xi: Any) -> Any:
    """The same by the polarisation angle, which turns F+ to 2 Fx and Fx to -2 F+."""
    at = Buffer.PATTERN
    plus = load(block_of(own, at + 2), j) * pr - load(block_of(own, at + 3), j) * pi
    return (plus - (load(block_of(own, at), j) * xr - load(block_of(own, at + 1), j) * xi)) * 2.0


@njit(**JIT_OPTIONS)
def errors_back(size: int, shared: Floats, own: Floats) -> None:
    """Add to the bars of the calibration errors at the nodes of a block, of a group in a detector."""
    amplitude, phase = block_of(shared, Shared.ERRORS), block_of(shared, Shared.ERRORS + 1)
    amplitude_bar, phase_bar = block_of(shared, Shared.ERRORS_BAR), block_of(shared, Shared.ERRORS_BAR + 1)
    for j in range(0, size, LANES):
        zr, zi = load(block_of(shared, Shared.STRAIN_BAR), j), load(block_of(shared, Shared.STRAIN_BAR + 1), j)
        sr, si = load(block_of(own, Buffer.STRAIN), j), load(block_of(own, Buffer.STRAIN + 1), j)
        yr, yi = times(zr, zi, sr, si)
        store(amplitude_bar, j, load(amplitude_bar, j) + yr / (load(amplitude, j) + 1.0))
        p = load(phase, j)
        store(phase_bar, j, load(phase_bar, j) - yi * 4.0 / fma(p, p, 4.0))


@njit(**JIT_OPTIONS)
def errors_to_nodes(row: int, d: int, first: int, size: int, arguments: Integers, shared: Floats) -> None:
    """Add the errors' bars at a block to those at the calibration nodes."""
    nodes, width = arguments[Common.CALIBRATION_NODES], padded(arguments[Common.POINTS])
    lanes = block_of(shared, Shared.WORK)
    place = 8 * nodes * (row * arguments[Common.DETECTORS] + d)
    splines = floats_at(arguments[Common.LINEAR_SPLINES], nodes * width)
    for part in range(2):
        out = floats_at(arguments[Argument.AMPLITUDE_BAR + part] + place, nodes)
        bars = block_of(shared, Shared.ERRORS_BAR + part)
        for node in range(nodes):
            out[node] += dot(bars, floats_in(splines, node * width + first, size), size, lanes)


@njit(**JIT_OPTIONS)
def waves_back(
    row: int, first: int, filled: int, arguments: Integers, shared: Floats, own: Floats, mode: int, waves: Floats
) -> None:
    """The bar of a mode's strain at a block, conjugated, and what is summed of those of its factors; ``waves`` is where
    it goes, or is added to."""
    modes, points = arguments[Common.MODES], arguments[Common.POINTS]
    plus = floats_at(arguments[Common.PLUS] + 8 * (modes * row + mode), 1)[0]
    cross = floats_at(arguments[Common.CROSS] + 16 * (modes * row + mode), 2)
    cr, ci = cross[0], cross[1]
    h = floats_at(arguments[Common.STRAIN] + 16 * ((modes * row + mode) * points + first), 2 * filled)
    out = floats_at(arguments[Argument.FACTORS_BAR] + 32 * (modes * row + mode), 4)
    lanes = block_of(shared, Shared.WORK)
    split(filled, h, block_of(shared, Shared.WAVE), block_of(shared, Shared.WAVE + 1))
    a, b, c, d = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
    for j in range(0, filled, LANES):
        pr, pi = load(block_of(own, Buffer.PLUS_BAR), j), load(block_of(own, Buffer.PLUS_BAR + 1), j)
        xr, xi = load(block_of(own, Buffer.CROSS_BAR), j), load(block_of(own, Buffer.CROSS_BAR + 1), j)
        hr, hi = load(block_of(shared, Shared.WAVE), j), load(block_of(shared, Shared.WAVE + 1), j)
        real, imaginary = fma(pr, plus, fma(xr, cr, xi * -ci)), fma(pi, -plus, fma(xi, -cr, xr * -ci))
        if arguments[Argument.ADD] == 1:
            before = load_complex(waves, j)
            real, imaginary = real + before[0], imaginary + before[1]
        store_complex(waves, j, real, imaginary)
        a, b = a + (pr * hr - pi * hi), b + fma(pr, hi, pi * hr)
        c, d = c + (xr * hr - xi * hi), d + fma(xr, hi, xi * hr)
    out[0] += across(a, lanes)
    out[1] += across(b, lanes)
    out[2] += across(c, lanes)
    out[3] += across(d, lanes)
