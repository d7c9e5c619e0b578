"""The trained regressor inside the kernel: coordinates, Chebyshev products, a small network, synthesis.

Eight rows are evaluated together, each in a lane of its own; every sum runs over its terms in one order, so a row's
bits do not depend on its neighbours.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import transform_physical, transform_symmetric
from bnserve_surrogate.kernel._layout import ACTIVATIONS, ANY, COORDINATES, LANES, TILE, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential
from bnserve_surrogate.kernel._matrices import Floats, multiply
from bnserve_surrogate.kernel._memory import at, floats_in, load, padded, store
from bnserve_surrogate.kernel._simd import bits_of, fma, from_bits, smaller, splat

Integers = NDArray[np.int64]

_TANH, _RELU = ACTIVATIONS["tanh"], ACTIVATIONS["relu"]
_PHYSICAL, _SYMMETRIC = COORDINATES["physical"], COORDINATES["symmetric"]
_MAGNITUDE = 2**63 - 1


@njit(**JIT_OPTIONS)
def regress(
    coordinates: Floats, rows: int, contents: Integers, exponents: Integers, weights: Floats, scratch: Floats
) -> Floats:
    """The regressor's outputs for up to eight rows.

    Parameters
    ----------
    coordinates
        ``(5, 8)``, see :func:`fill_coordinates`.
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
def synthesise(
    coordinates: Floats, rows: int, contents: Integers, exponents: Integers, weights: Floats, width: int,
    linear: Floats, scratch: Floats,
) -> Floats:  # fmt: skip
    """Everything linear in the outputs of up to eight rows, ``(8, width)``; returns the outputs as :func:`regress`."""
    outputs = regress(coordinates, rows, contents, exponents, weights, scratch)
    per_row = LANES + padded(contents[Entry.OUTPUTS])
    synthesis = floats_in(weights, contents[Entry.SYNTHESIS_AT], ANY)
    for first in range(0, rows, TILE):
        scalars = floats_in(outputs, first * per_row + LANES - 1, ANY)
        own = floats_in(linear, first * width, ANY)
        multiply(1 + contents[Entry.OUTPUTS], scalars, per_row, 1, synthesis, width, own, width)
    return outputs


@njit(**JIT_OPTIONS)
def fill_coordinates(parameters: Floats, contents: Integers, scaling: Floats, scratch: Floats, out: Floats) -> None:
    """The five coordinates of eight rows, ``(5, 8)``; tides weaker than the least trained ones count as these.

    ``parameters``, ``(8, 5)``: mass ratio, spins and tidal deformabilities of each row.
    """
    one, kind, least = scratch[:5], contents[Entry.COORDINATES], scaling[10]
    for lane in range(LANES):
        row = parameters[5 * lane : 5 * lane + 5]
        lambda_1, lambda_2 = max(row[3], least), max(row[4], least)
        if kind == _PHYSICAL:
            transform_physical(row[0], row[1], row[2], lambda_1, lambda_2, one)
        elif kind == _SYMMETRIC:
            transform_symmetric(row[0], row[1], row[2], lambda_1, lambda_2, one)
        else:
            one[0], one[1], one[2], one[3], one[4] = row[0], row[1], row[2], lambda_1, lambda_2
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
