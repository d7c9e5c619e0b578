"""The regressor's outputs with their derivatives, and everything linear in them."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, LANES, TILE, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._matrices import multiply
from bnserve_surrogate.kernel._memory import at, floats_in, load, padded, store
from bnserve_surrogate.kernel._regression import regress
from bnserve_surrogate.kernel._simd import fma, splat
from bnserve_surrogate.tangents._layout import INTRINSIC
from bnserve_surrogate.tangents._network import add_network

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def synthesise_with_tangents(
    coordinates: Floats, jacobian: Floats, rows: int, contents: Integers, exponents: Integers, weights: Floats,
    width: int, linear: Floats, scratch: Floats,
) -> None:  # fmt: skip
    """What is linear in the outputs of up to eight rows, and its derivatives: ``linear``, ``(6, 8, width)``.

    The first is the value, the others are its derivatives with respect to the five parameters; ``jacobian`` as
    :func:`~bnserve_surrogate.tangents._coordinates.fill_jacobian` fills it.
    """
    per_row = LANES + padded(contents[Entry.OUTPUTS])
    size = LANES * per_row
    outputs = regress(coordinates, rows, contents, exponents, weights, scratch)
    along, rest = floats_in(scratch, size, 5 * size), floats_in(scratch, 6 * size, ANY)
    _along_axes(coordinates, rows, contents, exponents, weights, along, rest)
    synthesis = floats_in(weights, contents[Entry.SYNTHESIS_AT], ANY)
    _synthesise(outputs, rows, contents[Entry.OUTPUTS], per_row, synthesis, width, linear)
    for p in range(INTRINSIC):
        _combine(along, jacobian, p, rows, per_row, rest)
        own = floats_in(linear, (1 + p) * LANES * width, ANY)
        _synthesise(rest, rows, contents[Entry.OUTPUTS], per_row, synthesis, width, own)


@njit(**JIT_OPTIONS)
def _synthesise(
    outputs: Floats, rows: int, count: int, per_row: int, synthesis: Floats, width: int, linear: Floats
) -> None:
    for first in range(0, rows, TILE):
        scalars, own = floats_in(outputs, first * per_row + LANES - 1, ANY), floats_in(linear, first * width, ANY)
        multiply(1 + count, scalars, per_row, 1, synthesis, width, own, width)


@njit(**JIT_OPTIONS)
def _along_axes(
    coordinates: Floats, rows: int, contents: Integers, exponents: Integers, weights: Floats, out: Floats,
    scratch: Floats,
) -> None:  # fmt: skip
    """Derivatives of the outputs with respect to the coordinates: ``out``, ``(5, 8, 8 + K)``, as regress has them."""
    outputs, terms, degree = padded(contents[Entry.OUTPUTS]), contents[Entry.TERMS], contents[Entry.DEGREE]
    width, stride = LANES + outputs, (degree + 1) * LANES
    coefficients = weights[contents[Entry.COEFFICIENTS_AT] :]
    for i in range(5 * LANES * width):
        out[i] = 0.0
    if terms > 0:
        _chebyshev(coordinates, degree, scratch)
    products = floats_in(scratch, 10 * stride, ANY)
    for axis in range(5 if terms > 0 else 0):
        _products(terms, axis, stride, exponents, scratch, products)
        for first in range(0, rows, TILE):
            own = floats_in(out, (axis * LANES + first) * width + LANES, ANY)
            multiply(terms, floats_in(products, first, ANY), 1, LANES, coefficients, outputs, own, width)
    if contents[Entry.LAYERS] > 0:
        layers = floats_in(weights, contents[Entry.NETWORK_AT], ANY)
        add_network(coordinates, rows, contents, layers, scratch, out, width)


@njit(**JIT_OPTIONS)
def _chebyshev(coordinates: Floats, degree: int, out: Floats) -> None:
    """Polynomials of all axes, ``(5, degree + 1, 8)``, and after them their derivatives."""
    stride = (degree + 1) * LANES
    for axis in range(5):
        x = load(coordinates, axis * LANES)
        row, slopes = floats_in(out, axis * stride, stride), floats_in(out, (5 + axis) * stride, stride)
        before, current = splat(1.0), x
        slope_before, slope = splat(0.0), splat(1.0)
        store(row, 0, before)
        store(slopes, 0, slope_before)
        for power in range(1, degree + 1):
            store(row, power * LANES, current)
            store(slopes, power * LANES, slope)
            following = fma(x + x, slope, fma(current, 2.0, splat(0.0) - slope_before))
            slope_before, slope = slope, following
            before, current = current, fma(x + x, current, splat(0.0) - before)


@njit(**JIT_OPTIONS)
def _products(terms: int, axis: int, stride: int, exponents: Integers, table: Floats, products: Floats) -> None:
    """Products of Chebyshev polynomials, one of them the derivative, ``(terms, 8)``."""
    first_at = 5 * stride if axis == 0 else 0
    second_at = stride + (5 * stride if axis == 1 else 0)
    third_at = 2 * stride + (5 * stride if axis == 2 else 0)
    fourth_at = 3 * stride + (5 * stride if axis == 3 else 0)
    fifth_at = 4 * stride + (5 * stride if axis == 4 else 0)
    for term in range(terms):
        first = load(table, first_at + LANES * at(exponents, 5 * term))
        second = load(table, second_at + LANES * at(exponents, 5 * term + 1))
        third = load(table, third_at + LANES * at(exponents, 5 * term + 2))
        fourth = load(table, fourth_at + LANES * at(exponents, 5 * term + 3))
        fifth = load(table, fifth_at + LANES * at(exponents, 5 * term + 4))
        store(products, LANES * term, first * second * (third * fourth) * fifth)


@njit(**JIT_OPTIONS)
def _combine(along: Floats, jacobian: Floats, p: int, rows: int, per_row: int, out: Floats) -> None:
    """The derivatives of the outputs with respect to parameter p, ``(8, 8 + K)``; that of the leading one is zero."""
    size = LANES * per_row
    for i in range(LANES):
        store(out, i * per_row, splat(0.0))
    for i in range(rows):
        s0, s1 = at(jacobian, 5 * p * LANES + i), at(jacobian, (5 * p + 1) * LANES + i)
        s2, s3 = at(jacobian, (5 * p + 2) * LANES + i), at(jacobian, (5 * p + 3) * LANES + i)
        s4 = at(jacobian, (5 * p + 4) * LANES + i)
        for j in range(i * per_row + LANES, (i + 1) * per_row, LANES):
            low = fma(load(along, size + j), s1, load(along, j) * s0)
            high = fma(load(along, 3 * size + j), s3, load(along, 2 * size + j) * s2)
            store(out, j, fma(load(along, 4 * size + j), s4, low + high))
