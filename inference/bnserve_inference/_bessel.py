"""Bessel's function I0, of which a likelihood integrated over the phase is made."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def _bessel_series() -> Floats:
    """The coefficients of :data:`SERIES`, to rounding."""
    count = 32
    angles = np.pi * (np.arange(count) + 0.5) / count
    t = 4.0 * (np.cos(angles) + 1.0) / 8.0  # 8 / x within (0, 1)
    x = 8.0 / t
    # I0(x) exp(-x) = 1 / pi integral of exp(x (cos u - 1)) du over [0, pi]; u = v / sqrt(x) keeps its width, and the
    # trapezoidal rule converges geometrically because the integrand vanishes, or is even, at both ends.
    values = np.empty(count)
    for i, at in enumerate(x):
        end = min(np.pi * np.sqrt(at), 13.0)
        v = np.linspace(0.0, end, 2049)
        integrand = np.exp(-2.0 * at * np.sin(0.5 * v / np.sqrt(at)) ** 2)
        values[i] = (integrand.sum() - 0.5 * (integrand[0] + integrand[-1])) * (v[1] - v[0]) / np.pi
    coefficients = (2.0 / count) * np.cos(np.arange(count)[:, None] * angles) @ values
    coefficients[0] *= 0.5
    return coefficients[:18]  # beyond them is rounding


SERIES = _bessel_series()
"""Chebyshev coefficients in 16 / x - 1 of sqrt(x) exp(-x) I0(x), for x >= 8."""
SMALL_SERIES = np.cumprod(np.concatenate([[1.0], 1.0 / np.arange(1.0, 30.0) ** 2]))
"""Taylor coefficients of I0 in x^2 / 4; at x = 8 the next is below 1e-26 of it."""


def log_bessel_i0(x: Floats) -> Floats:
    """ln I0(x) for x >= 0, to a few units in the last place of max(1, x)."""
    large = np.maximum(x, 8.0)
    scaled = np.polynomial.chebyshev.chebval(16.0 / large - 1.0, SERIES)
    result = large + np.log(scaled) - 0.5 * np.log(large)
    small = x <= 8.0
    if small.any():
        result[small] = np.log(np.i0(x[small]))
    return np.asarray(result)
