"""Source of the compiled contraction: from strain at the nodes to inner products with the data. See :mod:`.build`.

A row is evaluated by the same sequence of operations wherever it stands in a batch, so its bits depend on the row and
the analysis alone. Sums run over lanes of fixed width; plain loops, no allocation.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_inference.kernel._layout import BLOCK, LANES, Sky
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos

Floats = NDArray[np.float64]

LIGHT_SPEED = 299792458.0
_TWO_PI = 2.0 * np.pi
_RIGHT_ASCENSION, _DECLINATION, _POLARIZATION = int(Sky.RIGHT_ASCENSION), int(Sky.DECLINATION), int(Sky.POLARIZATION)
_TIME, _PLUS = int(Sky.TIME), int(Sky.PLUS)
_CROSS_REAL, _CROSS_IMAGINARY = int(Sky.CROSS_REAL), int(Sky.CROSS_IMAGINARY)
_COLUMNS = len(Sky)


@njit(**JIT_OPTIONS)
def _geometry(sky: Floats, sidereal: Floats, responses: Floats, locations: Floats, factors: Floats) -> None:
    """Per detector: real and imaginary part of F+ plus + Fx cross, and the delay to the centre of the Earth (s).

    The antenna patterns are those of LAL's ComputeDetAMResponse (Anderson et al. 2001, eqs. B4 to B7), the delay that
    of its TimeDelayFromEarthCenter.
    """
    hour_angle = sidereal[0] + sidereal[1] * sky[_TIME] - sky[_RIGHT_ASCENSION]
    sin_h, cos_h = sincos(hour_angle)
    sin_d, cos_d = sincos(sky[_DECLINATION])
    sin_p, cos_p = sincos(sky[_POLARIZATION])
    x0 = -cos_p * sin_h - sin_p * cos_h * sin_d
    x1 = -cos_p * cos_h + sin_p * sin_h * sin_d
    x2 = sin_p * cos_d
    y0 = sin_p * sin_h - cos_p * cos_h * sin_d
    y1 = sin_p * cos_h + cos_p * sin_h * sin_d
    y2 = cos_p * cos_d
    n0 = cos_d * cos_h
    n1 = -cos_d * sin_h
    for d in range(factors.shape[0] // 3):
        r = responses[9 * d : 9 * d + 9]
        u0 = r[0] * x0 + r[1] * x1 + r[2] * x2
        u1 = r[3] * x0 + r[4] * x1 + r[5] * x2
        u2 = r[6] * x0 + r[7] * x1 + r[8] * x2
        v0 = r[0] * y0 + r[1] * y1 + r[2] * y2
        v1 = r[3] * y0 + r[4] * y1 + r[5] * y2
        v2 = r[6] * y0 + r[7] * y1 + r[8] * y2
        plus = (x0 * u0 + x1 * u1 + x2 * u2) - (y0 * v0 + y1 * v1 + y2 * v2)
        cross = (x0 * v0 + x1 * v1 + x2 * v2) + (y0 * u0 + y1 * u1 + y2 * u2)
        place = locations[3 * d : 3 * d + 3]
        factors[3 * d] = plus * sky[_PLUS] + cross * sky[_CROSS_REAL]
        factors[3 * d + 1] = cross * sky[_CROSS_IMAGINARY]
        factors[3 * d + 2] = -(n0 * place[0] + n1 * place[1] + sin_d * place[2]) / LIGHT_SPEED


@njit(**JIT_OPTIONS)
def _lane_sum(values: Floats) -> float:
    """Sum of whole lanes, in a fixed order that the compiler can vectorise."""
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = 0.0
    for j in range(values.shape[0] // LANES):
        at = LANES * j
        s0 += values[at]
        s1 += values[at + 1]
        s2 += values[at + 2]
        s3 += values[at + 3]
        s4 += values[at + 4]
        s5 += values[at + 5]
        s6 += values[at + 6]
        s7 += values[at + 7]
    return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7))


@njit(**JIT_OPTIONS)
def _errors_at(nodes: Floats, spline: Floats, stride: int, first: int, out: Floats) -> None:
    """A calibration spline at some frequencies: values at its nodes times the nodes' cardinal functions."""
    count = out.shape[0]
    for j in range(count):
        out[j] = 0.0
    for k in range(nodes.shape[0]):
        row = spline[k * stride + first : k * stride + first + count]
        value = nodes[k]
        for j in range(count):
            out[j] += value * row[j]


@njit(**JIT_OPTIONS)
def _calibrate(amplitude: Floats, phase: Floats, hr: Floats, hi: Floats, kr: Floats, ki: Floats) -> None:
    """Strain times (1 + dA) (2 + i dphi) / (2 - i dphi)."""
    for j in range(hr.shape[0]):
        p = phase[j]
        scale = (1.0 + amplitude[j]) / (4.0 + p * p)
        c = scale * (4.0 - p * p)
        s = scale * (4.0 * p)
        kr[j] = hr[j] * c - hi[j] * s
        ki[j] = hr[j] * s + hi[j] * c


@njit(**JIT_OPTIONS)
def _products(
    f: Floats, time: float, kr: Floats, ki: Floats, weights: Floats, rows: Any, spline: Any, pr: Floats, pi: Floats
) -> None:
    """Strain, moved to ``time``, times the weights at that time: a sum of six rows of B-spline coefficients.

    ``rows``: where the first row of real parts begins, how far it is to the next row, and to its imaginary parts.
    """
    n = f.shape[0]
    first, row, imaginary = rows
    b0, b1, b2, b3, b4, b5 = spline
    r0, i0 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r1, i1 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r2, i2 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r3, i3 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r4, i4 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    first += row
    r5, i5 = weights[first : first + n], weights[first + imaginary : first + imaginary + n]
    turn = -_TWO_PI * time
    for j in range(n):
        s, c = sincos(f[j] * turn)
        hr = kr[j] * c - ki[j] * s
        hi = kr[j] * s + ki[j] * c
        wr = b0 * r0[j] + b1 * r1[j] + b2 * r2[j] + b3 * r3[j] + b4 * r4[j] + b5 * r5[j]
        wi = b0 * i0[j] + b1 * i1[j] + b2 * i2[j] + b3 * i3[j] + b4 * i4[j] + b5 * i5[j]
        pr[j] = wr * hr - wi * hi
        pi[j] = wr * hi + wi * hr


@njit(**JIT_OPTIONS)
def _fixed_products(
    f: Floats, time: float, kr: Floats, ki: Floats, wr: Floats, wi: Floats, pr: Floats, pi: Floats
) -> None:
    """As :func:`_products`, of weights that do not depend on time."""
    turn = -_TWO_PI * time
    for j in range(f.shape[0]):
        s, c = sincos(f[j] * turn)
        hr = kr[j] * c - ki[j] * s
        hi = kr[j] * s + ki[j] * c
        pr[j] = wr[j] * hr - wi[j] * hi
        pi[j] = wr[j] * hi + wi[j] * hr


@njit(**JIT_OPTIONS)
def _knots(time: float, knots: Floats, rows: int, width: int, first: int) -> Any:
    """Which six coefficient rows, and the values of the six quintic B-splines, at a time."""
    u = (time - knots[0]) / knots[1]
    cell = int(np.floor(u))
    cell = min(max(cell, 2), rows - 4)
    x = u - cell
    y = 1.0 - x
    spline = (
        y * y * y * y * y / 120.0,
        (26.0 + x * (-50.0 + x * (20.0 + x * (20.0 + x * (-20.0 + 5.0 * x))))) / 120.0,
        (66.0 + x * x * (-60.0 + x * x * (30.0 - 10.0 * x))) / 120.0,
        (66.0 + y * y * (-60.0 + y * y * (30.0 - 10.0 * y))) / 120.0,
        (26.0 + y * (-50.0 + y * (20.0 + y * (20.0 + y * (-20.0 + 5.0 * y))))) / 120.0,
        x * x * x * x * x / 120.0,
    )
    return (2 * width * (cell - 2) + first, 2 * width, width), spline


@njit(**JIT_OPTIONS)
def contract(
    strain: Any, sky: Floats, detectors: Any, nodes: Any, weights: Any, calibration: Any, times: Any, outputs: Any,
    scratch: Floats,
) -> None:  # fmt: skip
    """Inner products of every row; the arrays are laid out as ``_contraction.py`` says."""
    h, points = strain
    sidereal, responses, locations = detectors
    f, linear_at, quadratic_at = nodes
    linear, quadratic, knots = weights
    amplitude, phase, linear_spline, quadratic_spline = calibration
    n_times, step = times
    data_products, norms, spectrum = outputs
    n_detectors = responses.shape[0] // 9
    width, q_width = f.shape[0], quadratic.shape[0] // n_detectors
    n_linear, n_quadratic = linear_at.shape[0], quadratic_at.shape[0]
    knot_rows = linear.shape[0] // (2 * width * n_detectors)
    n_nodes = linear_spline.shape[0] // width if width > 0 else 0
    factors = scratch[: 3 * n_detectors]
    at = 3 * n_detectors
    hr, hi = scratch[at : at + BLOCK], scratch[at + BLOCK : at + 2 * BLOCK]
    kr, ki = scratch[at + 2 * BLOCK : at + 3 * BLOCK], scratch[at + 3 * BLOCK : at + 4 * BLOCK]
    pr, pi = scratch[at + 4 * BLOCK : at + 5 * BLOCK], scratch[at + 5 * BLOCK : at + 6 * BLOCK]
    da, dp = scratch[at + 6 * BLOCK : at + 7 * BLOCK], scratch[at + 7 * BLOCK : at + 8 * BLOCK]
    for row in range(norms.shape[0]):
        place = sky[_COLUMNS * row : _COLUMNS * (row + 1)]
        _geometry(place, sidereal, responses, locations, factors)
        out = data_products[2 * n_times * row : 2 * n_times * (row + 1)]
        for k in range(2 * n_times):
            out[k] = 0.0
        wave = h[2 * points * row : 2 * points * (row + 1)]
        for first in range(0, width, BLOCK):
            size = min(BLOCK, width - first)
            filled = min(size, n_linear - first)
            for j in range(filled):
                hr[j] = wave[2 * linear_at[first + j]]
                hi[j] = wave[2 * linear_at[first + j] + 1]
            for j in range(filled, size):
                hr[j] = 0.0
                hi[j] = 0.0
            for d in range(n_detectors):
                if n_nodes > 0:
                    at_d = n_nodes * (row * n_detectors + d)
                    _errors_at(amplitude[at_d : at_d + n_nodes], linear_spline, width, first, da[:size])
                    _errors_at(phase[at_d : at_d + n_nodes], linear_spline, width, first, dp[:size])
                    _calibrate(da[:size], dp[:size], hr[:size], hi[:size], kr[:size], ki[:size])
                    sr, si = kr[:size], ki[:size]
                else:
                    sr, si = hr[:size], hi[:size]
                table = linear[2 * width * knot_rows * d : 2 * width * knot_rows * (d + 1)]
                cr, ci = factors[3 * d], factors[3 * d + 1]
                for k in range(n_times):
                    time = (place[_TIME] + k * step) + factors[3 * d + 2]
                    if knot_rows == 1:
                        wr, wi = table[first : first + size], table[width + first : width + first + size]
                        _fixed_products(f[first : first + size], time, sr, si, wr, wi, pr[:size], pi[:size])
                    else:
                        rows, spline = _knots(time, knots, knot_rows, width, first)
                        _products(f[first : first + size], time, sr, si, table, rows, spline, pr[:size], pi[:size])
                    zr, zi = _lane_sum(pr[:size]), _lane_sum(pi[:size])
                    out[2 * k] += cr * zr - ci * zi
                    out[2 * k + 1] += cr * zi + ci * zr
                if spectrum.shape[0] > 0:
                    line = spectrum[2 * (row * n_linear + first) : 2 * (row * n_linear + first + filled)]
                    if d == 0:
                        for j in range(2 * filled):
                            line[j] = 0.0
                    for j in range(filled):
                        line[2 * j] += cr * pr[j] - ci * pi[j]
                        line[2 * j + 1] += cr * pi[j] + ci * pr[j]
        norm = 0.0
        for first in range(0, q_width, BLOCK):
            size = min(BLOCK, q_width - first)
            filled = min(size, n_quadratic - first)
            for j in range(filled):
                a, b = wave[2 * quadratic_at[first + j]], wave[2 * quadratic_at[first + j] + 1]
                hr[j] = a * a + b * b
            for j in range(filled, size):
                hr[j] = 0.0
            for d in range(n_detectors):
                q = quadratic[q_width * d + first : q_width * d + first + size]
                if n_nodes > 0:
                    at_d = n_nodes * (row * n_detectors + d)
                    _errors_at(amplitude[at_d : at_d + n_nodes], quadratic_spline, q_width, first, da[:size])
                    for j in range(size):
                        pr[j] = hr[j] * q[j] * ((1.0 + da[j]) * (1.0 + da[j]))
                else:
                    for j in range(size):
                        pr[j] = hr[j] * q[j]
                cr, ci = factors[3 * d], factors[3 * d + 1]
                norm += (cr * cr + ci * ci) * _lane_sum(pr[:size])
        norms[row] = norm
