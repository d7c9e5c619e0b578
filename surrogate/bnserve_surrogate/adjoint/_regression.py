"""From the bars of everything linear in a regressor's outputs back to the parameters that it sees."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, LANES, WIDE, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_in, load, padded, store
from bnserve_surrogate.kernel._simd import fma, splat
from bnserve_surrogate.tangents._layout import AXES, INTRINSIC, TANGENTS
from bnserve_surrogate.tangents._network import add_network
from bnserve_surrogate.tangents._regression import _chebyshev

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(**JIT_OPTIONS)
def regress_back(
    coordinates: Floats, jacobian: Floats, rows: int, contents: Integers, exponents: Integers, weights: Floats,
    width: int, bars: Floats, scratch: Floats, out: Floats,
) -> None:  # fmt: skip
    """Add to the derivatives of up to eight rows, ``out``, ``(8, 6)``, what ``bars``, ``(width, 8)``, say of them.

    ``coordinates``, ``jacobian`` and ``width`` are those of
    :func:`~bnserve_surrogate.tangents._regression.synthesise_with_tangents`.
    """
    outputs, terms = contents[Entry.OUTPUTS], contents[Entry.TERMS]
    by_output, by_axis = floats_in(scratch, 0, LANES * padded(outputs)), floats_in(scratch, LANES * padded(outputs), 40)
    rest = floats_in(scratch, LANES * padded(outputs) + AXES * LANES, ANY)
    for i in range(LANES * outputs, LANES * padded(outputs)):
        by_output[i] = 0.0
    synthesis = floats_in(weights, contents[Entry.SYNTHESIS_AT], ANY)
    multiply_back(1, outputs, 1 + outputs, synthesis, padded(width), bars, by_output)
    for i in range(AXES * LANES):
        by_axis[i] = 0.0
    if terms > 0:
        degree = contents[Entry.DEGREE]
        stride = (degree + 1) * LANES
        _chebyshev(coordinates, degree, rest)
        products = floats_in(rest, 10 * stride, LANES * terms)
        coefficients = floats_in(weights, contents[Entry.COEFFICIENTS_AT], ANY)
        multiply_back(0, terms, terms, coefficients, padded(outputs), by_output, products)
        _products_back(terms, stride, exponents, rest, products, by_axis)
    if contents[Entry.LAYERS] > 0:
        _network_back(coordinates, rows, contents, weights, by_output, rest, by_axis)
    for p in range(INTRINSIC):
        total = splat(0.0)
        for axis in range(AXES):
            total = fma(load(by_axis, axis * LANES), load(jacobian, (AXES * p + axis) * LANES), total)
        store(rest, 0, total)
        for i in range(rows):
            out[TANGENTS * i + p] += rest[i]


@njit(**JIT_OPTIONS)
def multiply_back(
    first: int, count: int, rows: int, matrix: Floats, columns: int, vectors: Floats, out: Floats
) -> None:
    """The product of :func:`~bnserve_surrogate.kernel._matrices.multiply` backwards, of eight rows in lanes:
    ``out[k, lane] = sum_j matrix[first + k, j] * vectors[j, lane]``, for ``count`` of the ``rows`` of the matrix."""
    k = 0
    while k < count:
        if count >= LANES:
            k = min(k, count - LANES)  # the last ones overlap with those before
            _eight(first + k, rows, matrix, columns, vectors, floats_in(out, LANES * k, LANES * LANES))
            k += LANES
        else:
            _one(first + k, rows, matrix, columns, vectors, floats_in(out, LANES * k, LANES))
            k += 1


@njit(inline="always")
def _blocks(rows: int, columns: int, block: int) -> tuple[int, int, int]:
    """Of a block of a matrix's columns: where it begins, and how many there are, and their first."""
    wide = columns // WIDE
    if block < wide:
        return block * rows * WIDE, WIDE, block * WIDE
    narrow = block - wide
    return wide * rows * WIDE + narrow * rows * LANES, LANES, wide * WIDE + narrow * LANES


@njit(**JIT_OPTIONS)
def _eight(row: int, rows: int, matrix: Floats, columns: int, vectors: Floats, out: Floats) -> None:
    a0, a1, a2, a3 = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
    a4, a5, a6, a7 = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
    for block in range(columns // WIDE + columns % WIDE // LANES):
        start, width, first = _blocks(rows, columns, block)
        place = start + row * width
        for c in range(width):
            v = load(vectors, LANES * (first + c))
            a0, a1 = fma(v, at(matrix, place + c), a0), fma(v, at(matrix, place + width + c), a1)
            a2, a3 = fma(v, at(matrix, place + 2 * width + c), a2), fma(v, at(matrix, place + 3 * width + c), a3)
            a4, a5 = fma(v, at(matrix, place + 4 * width + c), a4), fma(v, at(matrix, place + 5 * width + c), a5)
            a6, a7 = fma(v, at(matrix, place + 6 * width + c), a6), fma(v, at(matrix, place + 7 * width + c), a7)
    store(out, 0, a0)
    store(out, LANES, a1)
    store(out, 2 * LANES, a2)
    store(out, 3 * LANES, a3)
    store(out, 4 * LANES, a4)
    store(out, 5 * LANES, a5)
    store(out, 6 * LANES, a6)
    store(out, 7 * LANES, a7)


@njit(**JIT_OPTIONS)
def _one(row: int, rows: int, matrix: Floats, columns: int, vectors: Floats, out: Floats) -> None:
    total = splat(0.0)
    for block in range(columns // WIDE + columns % WIDE // LANES):
        start, width, first = _blocks(rows, columns, block)
        for c in range(width):
            total = fma(load(vectors, LANES * (first + c)), at(matrix, start + row * width + c), total)
    store(out, 0, total)


@njit(**JIT_OPTIONS)
def _products_back(terms: int, stride: int, exponents: Integers, table: Floats, bars: Floats, by_axis: Floats) -> None:
    """Bars of the coordinates, ``(5, 8)``, of those of the products of Chebyshev polynomials, ``(terms, 8)``."""
    g0, g1, g2, g3, g4 = splat(0.0), splat(0.0), splat(0.0), splat(0.0), splat(0.0)
    slopes = AXES * stride
    for term in range(terms):
        e0, e1 = LANES * at(exponents, 5 * term), stride + LANES * at(exponents, 5 * term + 1)
        e2, e3 = 2 * stride + LANES * at(exponents, 5 * term + 2), 3 * stride + LANES * at(exponents, 5 * term + 3)
        e4 = 4 * stride + LANES * at(exponents, 5 * term + 4)
        t0, t1, t2, t3, t4 = load(table, e0), load(table, e1), load(table, e2), load(table, e3), load(table, e4)
        bar = load(bars, LANES * term)
        first, second = t0 * t1 * bar, t2 * t3
        rest = second * t4 * bar
        g0, g1 = fma(rest * t1, load(table, slopes + e0), g0), fma(rest * t0, load(table, slopes + e1), g1)
        rest = first * t4
        g2, g3 = fma(rest * t3, load(table, slopes + e2), g2), fma(rest * t2, load(table, slopes + e3), g3)
        g4 = fma(first * second, load(table, slopes + e4), g4)
    store(by_axis, 0, g0)
    store(by_axis, LANES, g1)
    store(by_axis, 2 * LANES, g2)
    store(by_axis, 3 * LANES, g3)
    store(by_axis, 4 * LANES, g4)


@njit(**JIT_OPTIONS)
def _network_back(
    coordinates: Floats, rows: int, contents: Integers, weights: Floats, by_output: Floats, scratch: Floats,
    by_axis: Floats,
) -> None:  # fmt: skip
    """Add to the bars of the coordinates those of a network's inputs: it is small, and its derivatives are forward."""
    outputs = contents[Entry.OUTPUTS]
    width = LANES + padded(outputs)
    along, rest = floats_in(scratch, 0, AXES * LANES * width), floats_in(scratch, AXES * LANES * width, ANY)
    for i in range(AXES * LANES * width):
        along[i] = 0.0
    add_network(coordinates, rows, contents, floats_in(weights, contents[Entry.NETWORK_AT], ANY), rest, along, width)
    for axis in range(AXES):
        for i in range(rows):
            own = floats_in(along, (axis * LANES + i) * width + LANES, outputs)
            for k in range(outputs):
                by_axis[axis * LANES + i] += own[k] * by_output[LANES * k + i]
