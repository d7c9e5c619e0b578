"""The trained regressor inside the kernel: coordinates, Chebyshev products, a small network.

Everything here is written with plain loops over one-dimensional arrays: that is what compiles in a second rather than
in a minute, and what the compiler turns into vector instructions.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import transform_physical
from bnserve_surrogate.kernel._layout import ACTIVATIONS, MAX_WIDTH, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_TANH, _RELU = ACTIVATIONS["tanh"], ACTIVATIONS["relu"]
_PHYSICAL, _TERMS, _DEGREE = int(Entry.PHYSICAL_COORDINATES), int(Entry.TERMS), int(Entry.DEGREE)
_LAYERS, _LAYER_SIZES, _ACTIVATION = int(Entry.LAYERS), int(Entry.LAYER_SIZES), int(Entry.ACTIVATION)
_COORDINATES_AT, _COEFFICIENTS_AT = int(Entry.COORDINATES_AT), int(Entry.COEFFICIENTS_AT)
_NETWORK_AT = int(Entry.NETWORK_AT)


@njit(**JIT_OPTIONS)
def regress(
    mass_ratio: float,
    chi_1: float,
    chi_2: float,
    lambda_1: float,
    lambda_2: float,
    contents: Integers,
    exponents: Integers,
    weights: Floats,
    scratch: Floats,
    out: Floats,
) -> None:
    """Outputs of the regressor for one binary, into ``out`` of shape ``(K,)``."""
    coordinates = scratch[:5]
    if contents[_PHYSICAL] != 0:
        transform_physical(mass_ratio, chi_1, chi_2, lambda_1, lambda_2, coordinates)
    else:
        coordinates[0] = mass_ratio
        coordinates[1] = chi_1
        coordinates[2] = chi_2
        coordinates[3] = lambda_1
        coordinates[4] = lambda_2
    scaling = weights[contents[_COORDINATES_AT] :]
    for axis in range(5):
        coordinates[axis] = (coordinates[axis] - scaling[axis]) * scaling[5 + axis]
    for output in range(out.shape[0]):
        out[output] = 0.0
    if contents[_TERMS] > 0:
        coefficients = weights[contents[_COEFFICIENTS_AT] :]
        _add_polynomial(coordinates, contents[_TERMS], contents[_DEGREE], exponents, coefficients, scratch[5:], out)
    if contents[_LAYERS] > 0:
        _add_network(coordinates, contents, weights[contents[_NETWORK_AT] :], scratch[5:], out)


@njit(**JIT_OPTIONS)
def _add_polynomial(
    coordinates: Floats,
    terms: int,
    degree: int,
    exponents: Integers,
    coefficients: Floats,
    chebyshev: Floats,
    out: Floats,
) -> None:
    stride = degree + 1
    for axis in range(5):
        x = coordinates[axis]
        row = chebyshev[axis * stride :]
        row[0] = 1.0
        if degree > 0:
            row[1] = x
        for power in range(2, stride):
            row[power] = 2.0 * x * row[power - 1] - row[power - 2]
    width = out.shape[0]
    for term in range(terms):
        value = chebyshev[exponents[5 * term]]
        for axis in range(1, 5):
            value *= chebyshev[axis * stride + exponents[5 * term + axis]]
        row = coefficients[term * width : (term + 1) * width]
        for output in range(width):
            out[output] += value * row[output]


@njit(**JIT_OPTIONS)
def _add_network(coordinates: Floats, contents: Integers, layers: Floats, scratch: Floats, out: Floats) -> None:
    current = scratch[:MAX_WIDTH]
    following = scratch[MAX_WIDTH : 2 * MAX_WIDTH]
    for axis in range(5):
        current[axis] = coordinates[axis]
    at = 0
    last = contents[_LAYERS] - 1
    for layer in range(last + 1):
        inputs, outputs = contents[_LAYER_SIZES + layer], contents[_LAYER_SIZES + layer + 1]
        biases = layers[at + inputs * outputs :]
        for j in range(outputs):
            following[j] = biases[j]
        for i in range(inputs):
            row = layers[at + i * outputs :]
            x = current[i]
            for j in range(outputs):
                following[j] += x * row[j]
        if layer < last:
            for j in range(outputs):
                following[j] = _activate(following[j], contents[_ACTIVATION])
        at += (inputs + 1) * outputs
        current, following = following, current
    for output in range(out.shape[0]):
        out[output] += current[output]


@njit(**JIT_OPTIONS)
def _activate(x: float, activation: int) -> float:
    if activation == _TANH:
        return np.tanh(x)
    if activation == _RELU:
        return max(x, 0.0)
    return 1.0 / (1.0 + np.exp(-x))
