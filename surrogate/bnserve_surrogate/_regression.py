"""The trained regressor inside the kernel: coordinates, Chebyshev products, a small network.

Everything here is written with plain loops over one-dimensional arrays: that is what compiles in a second rather than
in a minute, and what the compiler turns into vector instructions.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import transform_physical
from bnserve_surrogate._kernel_model import ACTIVATION_RELU, ACTIVATION_TANH, KernelModel
from bnserve_surrogate._math import JIT_OPTIONS

Floats = NDArray[np.float64]
MAX_DEGREE = 64
"""Highest degree of a Chebyshev polynomial in a model."""
MAX_WIDTH = 1024
"""Widest layer of a network in a model."""
SCRATCH = 5 + 5 * (MAX_DEGREE + 1) + 2 * MAX_WIDTH
"""Floats of scratch that :func:`regress` needs."""


@njit(**JIT_OPTIONS)
def regress(
    mass_ratio: float,
    chi_1: float,
    chi_2: float,
    lambda_1: float,
    lambda_2: float,
    model: KernelModel,
    scratch: Floats,
    out: Floats,
) -> None:
    """Outputs of the regressor for one binary, into ``out`` of shape ``(K,)``."""
    coordinates = scratch[:5]
    if model.physical_coordinates:
        transform_physical(mass_ratio, chi_1, chi_2, lambda_1, lambda_2, coordinates)
    else:
        coordinates[0] = mass_ratio
        coordinates[1] = chi_1
        coordinates[2] = chi_2
        coordinates[3] = lambda_1
        coordinates[4] = lambda_2
    for axis in range(5):
        coordinates[axis] = (coordinates[axis] - model.coordinate_offset[axis]) * model.coordinate_scale[axis]
    for output in range(out.shape[0]):
        out[output] = 0.0
    if model.exponents.shape[0] > 0:
        _add_polynomial(coordinates, model, scratch[5:], out)
    if model.layer_sizes.shape[0] > 1:
        _add_network(coordinates, model, scratch[5:], out)


@njit(**JIT_OPTIONS)
def _add_polynomial(coordinates: Floats, model: KernelModel, chebyshev: Floats, out: Floats) -> None:
    stride = model.degree + 1
    for axis in range(5):
        x = coordinates[axis]
        row = chebyshev[axis * stride : (axis + 1) * stride]
        row[0] = 1.0
        if model.degree > 0:
            row[1] = x
        for power in range(2, stride):
            row[power] = 2.0 * x * row[power - 1] - row[power - 2]
    width = out.shape[0]
    exponents = model.exponents
    for term in range(exponents.shape[0]):
        value = chebyshev[exponents[term, 0]]
        for axis in range(1, 5):
            value *= chebyshev[axis * stride + exponents[term, axis]]
        row = model.coefficients[term * width : (term + 1) * width]
        for output in range(width):
            out[output] += value * row[output]


@njit(**JIT_OPTIONS)
def _add_network(coordinates: Floats, model: KernelModel, scratch: Floats, out: Floats) -> None:
    sizes = model.layer_sizes
    current = scratch[:MAX_WIDTH]
    following = scratch[MAX_WIDTH : 2 * MAX_WIDTH]
    for axis in range(5):
        current[axis] = coordinates[axis]
    weights, biases = 0, 0
    last = sizes.shape[0] - 2
    for layer in range(last + 1):
        inputs, outputs = sizes[layer], sizes[layer + 1]
        for j in range(outputs):
            following[j] = model.network_biases[biases + j]
        for i in range(inputs):
            row = model.network_weights[weights + i * outputs : weights + (i + 1) * outputs]
            for j in range(outputs):
                following[j] += current[i] * row[j]
        if layer < last:
            for j in range(outputs):
                following[j] = _activate(following[j], model.activation)
        weights += inputs * outputs
        biases += outputs
        current, following = following, current
    for output in range(out.shape[0]):
        out[output] += current[output]


@njit(**JIT_OPTIONS)
def _activate(x: float, activation: int) -> float:
    if activation == ACTIVATION_TANH:
        return np.tanh(x)
    if activation == ACTIVATION_RELU:
        return max(x, 0.0)
    return 1.0 / (1.0 + np.exp(-x))
