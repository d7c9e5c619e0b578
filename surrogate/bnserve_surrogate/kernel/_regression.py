"""The trained regressor inside the kernel: coordinates, Chebyshev products, a small network, synthesis.

Eight rows are evaluated together, each in a lane of its own; every sum runs over its terms in one order, so a row's
bits do not depend on its neighbours.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import transform_physical
from bnserve_surrogate.kernel._layout import ACTIVATIONS, LANES, TILE, WIDE, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential
from bnserve_surrogate.kernel._simd import at, bits_of, floats_in, fma, from_bits, load, padded, smaller, splat, store

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_TANH, _RELU = ACTIVATIONS["tanh"], ACTIVATIONS["relu"]
_MAGNITUDE = 2**63 - 1


@njit(inline="always")
def _store_wide(out: Floats, place: int, v0: Any, v1: Any, v2: Any, v3: Any) -> None:
    store(out, place, v0)
    store(out, place + LANES, v1)
    store(out, place + 2 * LANES, v2)
    store(out, place + 3 * LANES, v3)


@njit(inline="always")
def _multiply_wide(
    count: int, scalars: Floats, row: int, step: int, matrix: Floats, position: int, out: Floats, out_row: int
) -> None:
    """:func:`multiply` for a block of 32 columns that begins at ``position`` of the matrix."""
    a00 = a01 = a02 = a03 = splat(0.0)
    a10 = a11 = a12 = a13 = splat(0.0)
    a20 = a21 = a22 = a23 = splat(0.0)
    a30 = a31 = a32 = a33 = splat(0.0)
    for k in range(count):
        v0, v1 = load(matrix, position), load(matrix, position + LANES)
        v2, v3 = load(matrix, position + 2 * LANES), load(matrix, position + 3 * LANES)
        position += WIDE
        s = at(scalars, k * step)
        a00, a01 = fma(v0, s, a00), fma(v1, s, a01)
        a02, a03 = fma(v2, s, a02), fma(v3, s, a03)
        s = at(scalars, row + k * step)
        a10, a11 = fma(v0, s, a10), fma(v1, s, a11)
        a12, a13 = fma(v2, s, a12), fma(v3, s, a13)
        s = at(scalars, 2 * row + k * step)
        a20, a21 = fma(v0, s, a20), fma(v1, s, a21)
        a22, a23 = fma(v2, s, a22), fma(v3, s, a23)
        s = at(scalars, 3 * row + k * step)
        a30, a31 = fma(v0, s, a30), fma(v1, s, a31)
        a32, a33 = fma(v2, s, a32), fma(v3, s, a33)
    _store_wide(out, 0, a00, a01, a02, a03)
    _store_wide(out, out_row, a10, a11, a12, a13)
    _store_wide(out, 2 * out_row, a20, a21, a22, a23)
    _store_wide(out, 3 * out_row, a30, a31, a32, a33)


@njit(**JIT_OPTIONS)
def multiply(
    count: int, scalars: Floats, row: int, step: int, matrix: Floats, columns: int, out: Floats, out_row: int
) -> None:
    """A product with four rows: ``out[i, j] = sum_k scalars[i, k] * matrix[k, j]``.

    Parameters
    ----------
    count
        Number of terms; every sum runs over them in this order.
    scalars, row, step
        ``scalars[i, k]`` stands at ``i * row + k * step``.
    matrix, columns
        As :func:`bnserve_surrogate.kernel._mode.by_columns` arranges it; ``columns`` are whole vectors.
    out, out_row
        ``out[i, j]`` stands at ``i * out_row + j``.
    """
    position = 0
    for column in range(0, columns // WIDE * WIDE, WIDE):
        _multiply_wide(count, scalars, row, step, matrix, position, floats_in(out, column, WIDE), out_row)
        position += count * WIDE
    for column in range(columns // WIDE * WIDE, columns, LANES):
        b0 = b1 = b2 = b3 = splat(0.0)
        for k in range(count):
            v = load(matrix, position)
            position += LANES
            b0 = fma(v, at(scalars, k * step), b0)
            b1 = fma(v, at(scalars, row + k * step), b1)
            b2 = fma(v, at(scalars, 2 * row + k * step), b2)
            b3 = fma(v, at(scalars, 3 * row + k * step), b3)
        store(out, column, b0)
        store(out, out_row + column, b1)
        store(out, 2 * out_row + column, b2)
        store(out, 3 * out_row + column, b3)


@njit(**JIT_OPTIONS)
def regress(
    parameters: Floats, rows: int, contents: Integers, exponents: Integers, weights: Floats, scratch: Floats
) -> Floats:
    """The regressor's outputs for up to eight rows.

    Parameters
    ----------
    parameters
        ``(8 * 5,)``: mass ratio, spins and tidal deformabilities of each row.
    rows
        How many of them are wanted.
    contents, exponents, weights
        A :class:`KernelModel`'s.
    scratch
        Working memory; what is returned is its beginning.

    Returns
    -------
    ``(8, 8 + K)``, K in whole vectors: for every row seven places of no meaning, a one, and the outputs.
    """
    outputs = padded(contents[Entry.OUTPUTS])
    width = LANES + outputs
    out, rest = scratch[: LANES * width], scratch[LANES * width :]
    coordinates, rest = rest[: 5 * LANES], rest[5 * LANES :]
    _coordinates(parameters, contents, weights[contents[Entry.COORDINATES_AT] :], rest, coordinates)
    for i in range(LANES * width):
        out[i] = 0.0
    for i in range(LANES):
        out[i * width + LANES - 1] = 1.0
    if contents[Entry.TERMS] > 0:
        products = _products(coordinates, contents[Entry.TERMS], contents[Entry.DEGREE], exponents, rest)
        coefficients = weights[contents[Entry.COEFFICIENTS_AT] :]
        for first in range(0, rows, TILE):
            own = out[first * width + LANES :]
            multiply(contents[Entry.TERMS], products[first:], 1, LANES, coefficients, outputs, own, width)
    if contents[Entry.LAYERS] > 0:
        _add_network(coordinates, rows, contents, weights[contents[Entry.NETWORK_AT] :], rest, out[LANES:], width)
    return out


@njit(**JIT_OPTIONS)
def _coordinates(parameters: Floats, contents: Integers, scaling: Floats, scratch: Floats, out: Floats) -> None:
    """The five coordinates of eight rows, ``(5, 8)``."""
    one = scratch[:5]
    for lane in range(LANES):
        row = parameters[5 * lane : 5 * lane + 5]
        if contents[Entry.PHYSICAL_COORDINATES] != 0:
            transform_physical(row[0], row[1], row[2], row[3], row[4], one)
        else:
            for axis in range(5):
                one[axis] = row[axis]
        for axis in range(5):
            out[axis * LANES + lane] = (one[axis] - scaling[axis]) * scaling[5 + axis]


@njit(**JIT_OPTIONS)
def _products(coordinates: Floats, terms: int, degree: int, exponents: Integers, scratch: Floats) -> Floats:
    """Products of Chebyshev polynomials, ``(terms, 8)``."""
    stride = (degree + 1) * LANES
    products = scratch[5 * stride :]
    for axis in range(5):
        x = load(coordinates, axis * LANES)
        row = scratch[axis * stride : (axis + 1) * stride]
        before, current = splat(1.0), x
        store(row, 0, before)
        for power in range(1, degree + 1):
            store(row, power * LANES, current)
            before, current = current, fma(x + x, current, splat(0.0) - before)
    for term in range(terms):
        first = load(scratch, LANES * at(exponents, 5 * term))
        second = load(scratch, stride + LANES * at(exponents, 5 * term + 1))
        third = load(scratch, 2 * stride + LANES * at(exponents, 5 * term + 2))
        fourth = load(scratch, 3 * stride + LANES * at(exponents, 5 * term + 3))
        fifth = load(scratch, 4 * stride + LANES * at(exponents, 5 * term + 4))
        store(products, LANES * term, first * second * (third * fourth) * fifth)
    return products


@njit(**JIT_OPTIONS)
def _add_network(
    coordinates: Floats, rows: int, contents: Integers, layers: Floats, scratch: Floats, out: Floats, out_row: int
) -> None:
    """Add a network's outputs; its layers stand in memory as ``out`` does, each row after a leading one."""
    row = LANES + padded(contents[Entry.WIDEST])
    current, following = scratch[: LANES * row], scratch[LANES * row : 2 * LANES * row]
    for i in range(LANES):
        current[i * row + LANES - 1] = following[i * row + LANES - 1] = 1.0
        for axis in range(5):
            current[i * row + LANES + axis] = coordinates[axis * LANES + i]
    last = contents[Entry.LAYERS] - 1
    position = 0
    for layer in range(last + 1):
        count = 1 + contents[Entry.LAYER_SIZES + layer]
        columns = padded(contents[Entry.LAYER_SIZES + layer + 1])
        for first in range(0, rows, TILE):
            inputs, sums = current[first * row + LANES - 1 :], following[first * row + LANES :]
            multiply(count, inputs, row, 1, layers[position:], columns, sums, row)
        position += count * columns
        if layer < last:
            for i in range(rows):
                for j in range(i * row + LANES, i * row + LANES + columns, LANES):
                    store(following, j, _activate(load(following, j), contents[Entry.ACTIVATION]))
        current, following = following, current
    for i in range(rows):
        for j in range(0, columns, LANES):
            place = i * out_row + j
            store(out, place, load(out, place) + load(current, i * row + LANES + j))


@njit(**JIT_OPTIONS)
def _activate(x, activation):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
    magnitude = from_bits(bits_of(x) & _MAGNITUDE)
    if activation == _RELU:
        return (x + magnitude) * 0.5
    # Beyond 350 both functions are constant to the last bit; the exponential knows no more than 700.
    bounded = smaller(magnitude, 350.0)
    if activation == _TANH:
        decay = exponential(bounded * -2.0)
        value = (splat(1.0) - decay) / (decay + 1.0)
        return from_bits(bits_of(value) ^ (bits_of(x) ^ bits_of(magnitude)))
    decay = exponential(splat(0.0) - bounded)
    positive = splat(1.0) / (decay + 1.0)
    # 1 - positive for negative arguments, without cancellation.
    negative = decay / (decay + 1.0)
    side = 0 - ((bits_of(x) >> 63) & 1)
    return from_bits((bits_of(positive) & (side ^ -1)) ^ (bits_of(negative) & side))
