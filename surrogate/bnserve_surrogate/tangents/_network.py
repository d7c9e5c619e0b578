"""A network's outputs with their derivatives by its inputs, layer by layer: forward mode."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ACTIVATIONS, LANES, TILE, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._matrices import multiply
from bnserve_surrogate.kernel._memory import floats_in, load, padded, store
from bnserve_surrogate.kernel._regression import _activate
from bnserve_surrogate.kernel._simd import bits_of, from_bits, splat
from bnserve_surrogate.tangents._layout import AXES

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_TANH, _RELU = ACTIVATIONS["tanh"], ACTIVATIONS["relu"]


@njit(**JIT_OPTIONS)
def add_network(
    coordinates: Floats, rows: int, contents: Integers, layers: Floats, scratch: Floats, out: Floats, out_row: int
) -> None:
    """Add the derivatives of a network's outputs by the five coordinates to ``out``, ``(5, 8, out_row)``.

    The value and five derivatives of a layer stand one after the other, each as
    :func:`~bnserve_surrogate.kernel._regression.regress` has a layer: the leading one, which a bias is multiplied with,
    is a zero in the derivatives.
    """
    row = LANES + padded(contents[Entry.WIDEST])
    size = LANES * row
    current, following = (
        floats_in(scratch, 0, (1 + AXES) * size),
        floats_in(scratch, (1 + AXES) * size, (1 + AXES) * size),
    )
    _begin(coordinates, row, current, following)
    last = contents[Entry.LAYERS] - 1
    position, columns = 0, 0
    for layer in range(last + 1):
        count = 1 + contents[Entry.LAYER_SIZES + layer]
        columns = padded(contents[Entry.LAYER_SIZES + layer + 1])
        matrix = floats_in(layers, position, count * columns)
        for which in range(1 + AXES):
            for first in range(0, rows, TILE):
                place = which * size + first * row + LANES
                inputs, sums = floats_in(current, place - 1, TILE * row), floats_in(following, place, TILE * row)
                multiply(count, inputs, row, 1, matrix, columns, sums, row)
        position += count * columns
        if layer < last:
            _bend(rows, row, columns, contents[Entry.ACTIVATION], following)
        current, following = following, current
    for axis in range(AXES):
        for i in range(rows):
            for j in range(0, columns, LANES):
                place = (axis * LANES + i) * out_row + LANES + j
                store(out, place, load(out, place) + load(current, (1 + axis) * size + i * row + LANES + j))


@njit(**JIT_OPTIONS)
def _begin(coordinates: Floats, row: int, current: Floats, following: Floats) -> None:
    """The inputs, and their derivatives by themselves."""
    for which in range(1 + AXES):
        for i in range(LANES):
            start = (which * LANES + i) * row + LANES
            leading = 1.0 if which == 0 else 0.0
            current[start - 1], following[start - 1] = leading, leading
            for axis in range(AXES):
                own = 1.0 if which == 1 + axis else 0.0
                current[start + axis] = coordinates[axis * LANES + i] if which == 0 else own


@njit(**JIT_OPTIONS)
def _bend(rows: int, row: int, columns: int, activation: int, layer: Floats) -> None:
    """Activate a layer, and its derivatives with it."""
    for i in range(rows):
        for j in range(i * row + LANES, i * row + LANES + columns, LANES):
            x = load(layer, j)
            y = _activate(x, activation)
            slope = _slope(x, y, activation)
            store(layer, j, y)
            for axis in range(AXES):
                place = (1 + axis) * LANES * row + j
                store(layer, place, load(layer, place) * slope)


@njit(**JIT_OPTIONS)
def _slope(x, y, activation):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
    """The derivative of an activation at x, where it is y."""
    if activation == _RELU:
        negative = 0 - ((bits_of(x) >> 63) & 1)
        return from_bits(bits_of(splat(1.0)) & (negative ^ -1))
    if activation == _TANH:
        return (splat(1.0) - y) * (y + 1.0)
    return y * (splat(1.0) - y)
