"""Source of the compiled contraction: from strain at the nodes to inner products with the data. See :mod:`.build`.

A row is evaluated by the same sequence of operations wherever it stands in a batch, so its bits depend on the row and
the analysis alone. Sums run over lanes of fixed width; plain loops, no allocation.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from bnserve_inference.kernel._layout import BLOCK, Argument, Sky
from bnserve_inference.kernel._sums import (
    Floats,
    Integers,
    add_terms,
    calibrate,
    errors_at,
    fixed_products,
    gather,
    lane_sum,
    products_at,
    spline_at,
)
from bnserve_surrogate.kernel._math import JIT_OPTIONS, sincos
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, padded
from bnserve_surrogate.kernel._simd import from_bits

LIGHT_SPEED = 299792458.0
_COLUMNS = len(Sky)


@njit(**JIT_OPTIONS)
def _geometry(sky: Floats, sidereal: Floats, responses: Floats, locations: Floats, factors: Floats) -> None:
    """Per detector: real and imaginary part of F+ plus + Fx cross, and the delay to the centre of the Earth (s).

    The antenna patterns are those of LAL's ComputeDetAMResponse (Anderson et al. 2001, eqs. B4 to B7), the delay that
    of its TimeDelayFromEarthCenter.
    """
    hour_angle = sidereal[0] + sidereal[1] * sky[Sky.TIME] - sky[Sky.RIGHT_ASCENSION]
    sin_h, cos_h = sincos(hour_angle)
    sin_d, cos_d = sincos(sky[Sky.DECLINATION])
    sin_p, cos_p = sincos(sky[Sky.POLARIZATION])
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
        factors[3 * d] = plus * sky[Sky.PLUS] + cross * sky[Sky.CROSS_REAL]
        factors[3 * d + 1] = cross * sky[Sky.CROSS_IMAGINARY]
        factors[3 * d + 2] = -(n0 * place[0] + n1 * place[1] + sin_d * place[2]) / LIGHT_SPEED


@njit(inline="always")
def _views(scratch: Floats, detectors: int) -> Any:
    """Working memory, which ``_layout.scratch_size`` counts: of the detectors, and pairs of blocks of nodes for strain,
    the same with calibration errors, its products with weights, and the errors."""
    first = 3 * detectors
    return (
        floats_in(scratch, 0, first),
        (floats_in(scratch, first, BLOCK), floats_in(scratch, first + BLOCK, BLOCK)),
        (floats_in(scratch, first + 2 * BLOCK, BLOCK), floats_in(scratch, first + 3 * BLOCK, BLOCK)),
        (floats_in(scratch, first + 4 * BLOCK, BLOCK), floats_in(scratch, first + 5 * BLOCK, BLOCK)),
        (floats_in(scratch, first + 6 * BLOCK, BLOCK), floats_in(scratch, first + 7 * BLOCK, BLOCK)),
    )


@njit(inline="always")
def _first_of(pair: Any, size: int) -> Any:
    return floats_in(pair[0], 0, size), floats_in(pair[1], 0, size)


@njit(inline="always")
def _errors_of(arguments: Integers, kind: int, place: int) -> Floats:
    """The errors at the calibration nodes, of one row in one detector."""
    nodes = arguments[Argument.CALIBRATION_NODES]
    return floats_at(arguments[kind] + 8 * nodes * place, nodes)


@njit(inline="always")
def _add_times(
    arguments: Integers, f: Floats, arrival: float, delay: float, strain: Any, table: Floats, width: int, first: int,
    factor: Any, product: Any, out: Floats,
) -> None:  # fmt: skip
    """Add the sums over a block of nodes to the products at all times."""
    knots, size = arguments[Argument.KNOTS], f.shape[0]
    grid = floats_at(arguments[Argument.TIME_GRID], 2)
    step = from_bits(arguments[Argument.STEP])
    for k in range(arguments[Argument.TIMES]):
        time = (arrival + k * step) + delay
        if knots == 1:
            wr, wi = floats_in(table, first, size), floats_in(table, width + first, size)
            fixed_products(f, time, strain[0], strain[1], wr, wi, product[0], product[1])
        else:
            rows, spline = spline_at(time, grid, knots, width, first)
            products_at(f, time, strain[0], strain[1], table, rows, spline, product[0], product[1])
        zr, zi = lane_sum(product[0]), lane_sum(product[1])
        out[2 * k] += factor[0] * zr - factor[1] * zi
        out[2 * k + 1] += factor[0] * zi + factor[1] * zr


@njit(**JIT_OPTIONS)
def _contract_linear(row: int, arguments: Integers, arrival: float, wave: Floats, factors: Floats, views: Any) -> None:
    """<d|h> of one row at all times, and its terms where they are wanted."""
    _, plain, calibrated, products, errors = views
    detectors, n_linear, times = arguments[Argument.DETECTORS], arguments[Argument.LINEAR], arguments[Argument.TIMES]
    width, nodes = padded(n_linear), arguments[Argument.CALIBRATION_NODES]
    f, places = floats_at(arguments[Argument.NODES], width), integers_at(arguments[Argument.LINEAR_AT], n_linear)
    splines, table_size = (
        floats_at(arguments[Argument.LINEAR_SPLINES], nodes * width),
        2 * width * arguments[Argument.KNOTS],
    )
    out = floats_at(arguments[Argument.PRODUCTS] + 16 * times * row, 2 * times)
    out[:] = 0.0
    for first in range(0, width, BLOCK):
        size = min(BLOCK, width - first)
        filled = min(size, n_linear - first)
        h, product = _first_of(plain, size), _first_of(products, size)
        gather(wave, places[first:], filled, h[0], h[1])
        for d in range(detectors):
            strain = h
            if nodes > 0:
                strain, error = _first_of(calibrated, size), _first_of(errors, size)
                at = row * detectors + d
                errors_at(_errors_of(arguments, Argument.AMPLITUDE_ERRORS, at), splines, width, first, error[0])
                errors_at(_errors_of(arguments, Argument.PHASE_ERRORS, at), splines, width, first, error[1])
                calibrate(error[0], error[1], h[0], h[1], strain[0], strain[1])
            table = floats_at(arguments[Argument.LINEAR_WEIGHTS] + 8 * table_size * d, table_size)
            factor, delay = (factors[3 * d], factors[3 * d + 1]), factors[3 * d + 2]
            block = floats_in(f, first, size)
            _add_times(arguments, block, arrival, delay, strain, table, width, first, factor, product, out)
            if arguments[Argument.SPECTRUM] != 0:
                line = floats_at(arguments[Argument.SPECTRUM] + 16 * (row * n_linear + first), 2 * filled)
                if d == 0:
                    line[:] = 0.0
                add_terms(product[0], product[1], factor[0], factor[1], line)


@njit(**JIT_OPTIONS)
def _contract_quadratic(row: int, arguments: Integers, wave: Floats, factors: Floats, views: Any) -> float:
    """<h|h> of one row."""
    _, plain, _, products, errors = views
    detectors, count = arguments[Argument.DETECTORS], arguments[Argument.QUADRATIC]
    width, nodes = padded(count), arguments[Argument.CALIBRATION_NODES]
    places = integers_at(arguments[Argument.QUADRATIC_AT], count)
    splines = floats_at(arguments[Argument.QUADRATIC_SPLINES], nodes * width)
    norm = 0.0
    for first in range(0, width, BLOCK):
        size = min(BLOCK, width - first)
        (power, _), (product, _), (error, _) = (
            _first_of(plain, size),
            _first_of(products, size),
            _first_of(errors, size),
        )
        filled = min(size, count - first)
        for j in range(filled):
            a, b = wave[2 * places[first + j]], wave[2 * places[first + j] + 1]
            power[j] = a * a + b * b
        power[filled:] = 0.0
        for d in range(detectors):
            q = floats_at(arguments[Argument.QUADRATIC_WEIGHTS] + 8 * (width * d + first), size)
            if nodes > 0:
                amplitudes = _errors_of(arguments, Argument.AMPLITUDE_ERRORS, row * detectors + d)
                errors_at(amplitudes, splines, width, first, error)
                for j in range(size):
                    product[j] = power[j] * q[j] * ((1.0 + error[j]) * (1.0 + error[j]))
            else:
                for j in range(size):
                    product[j] = power[j] * q[j]
            cr, ci = factors[3 * d], factors[3 * d + 1]
            norm += (cr * cr + ci * ci) * lane_sum(product)
    return norm


@njit(**JIT_OPTIONS)
def contract(arguments: Integers) -> int:
    """Inner products of every row: see :class:`Argument`; returns 0."""
    detectors, points = arguments[Argument.DETECTORS], arguments[Argument.POINTS]
    sidereal = floats_at(arguments[Argument.SIDEREAL], 2)
    responses = floats_at(arguments[Argument.RESPONSES], 9 * detectors)
    locations = floats_at(arguments[Argument.LOCATIONS], 3 * detectors)
    views = _views(floats_at(arguments[Argument.SCRATCH], 3 * detectors + 8 * BLOCK), detectors)
    factors, norms = views[0], floats_at(arguments[Argument.NORMS], arguments[Argument.ROWS])
    for row in range(arguments[Argument.ROWS]):
        place = floats_at(arguments[Argument.SKY] + 8 * _COLUMNS * row, _COLUMNS)
        _geometry(place, sidereal, responses, locations, factors)
        wave = floats_at(arguments[Argument.STRAIN] + 16 * points * row, 2 * points)
        _contract_linear(row, arguments, place[Sky.TIME], wave, factors, views)
        norms[row] = _contract_quadratic(row, arguments, wave, factors, views)
    return 0
