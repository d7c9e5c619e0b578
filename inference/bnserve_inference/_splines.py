"""Uniform cubic B-splines in time, and cardinal cubic splines through uneven nodes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

MARGIN = 12
"""Samples beyond either end that an interpolating spline needs for its ends to be forgotten: 0.27**12 = 1e-7."""


def b_spline_coefficients(samples: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Coefficients of the cubic B-spline that interpolates uniform samples along the first axis.

    Parameters
    ----------
    samples:
        ``(n, ...)``, of which the first and last :data:`MARGIN` serve the ends alone.

    Returns
    -------
    ``(n - 2 MARGIN + 2, ...)``: the coefficients from one before to one after the samples that remain.
    """
    count = len(samples)
    matrix = np.zeros((count, count))
    inner = np.arange(count)
    matrix[inner, inner] = 4.0 / 6.0
    matrix[inner[1:], inner[:-1]] = matrix[inner[:-1], inner[1:]] = 1.0 / 6.0
    matrix[0, 0] = matrix[-1, -1] = 1.0  # straight ends: no curvature there
    matrix[0, 1] = matrix[-1, -2] = 0.0
    flat = samples.reshape(count, -1)
    return np.linalg.solve(matrix, flat)[MARGIN - 1 : count - MARGIN + 1].reshape(-1, *samples.shape[1:])


def b_spline_midpoints(coefficients: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """The spline halfway between its samples: from ``(n, ...)`` coefficients the ``n - 3`` values between samples."""
    c = coefficients
    return (c[:-3] + 23.0 * c[1:-2] + 23.0 * c[2:-1] + c[3:]) / 48.0


def cardinal_spline(nodes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Second derivatives at the nodes of the cubic splines that are one at one node and zero at the others.

    Not-a-knot ends. ``(n, n)``: row i, column j is the second derivative at node i of the function of node j.
    """
    n = len(nodes)
    h = np.diff(nodes)
    left, right = np.zeros((n, n)), np.zeros((n, n))
    for i in range(1, n - 1):
        left[i, i - 1 : i + 2] = h[i - 1] / 6.0, (h[i - 1] + h[i]) / 3.0, h[i] / 6.0
        right[i, i - 1 : i + 2] = 1.0 / h[i - 1], -1.0 / h[i - 1] - 1.0 / h[i], 1.0 / h[i]
    left[0, :3] = -h[1], h[0] + h[1], -h[0]
    left[-1, -3:] = -h[-1], h[-2] + h[-1], -h[-2]
    return np.linalg.solve(left, right)


def cardinal_values(
    nodes: NDArray[np.float64], curvatures: NDArray[np.float64], x: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The cardinal functions of :func:`cardinal_spline` at ``x``: ``(n, len(x))``."""
    cell = np.clip(np.searchsorted(nodes, x, side="right") - 1, 0, len(nodes) - 2)
    width = nodes[cell + 1] - nodes[cell]
    b = (x - nodes[cell]) / width
    a = 1.0 - b
    values = (a**3 - a) * width**2 / 6.0 * curvatures[cell].T + (b**3 - b) * width**2 / 6.0 * curvatures[cell + 1].T
    places = np.arange(len(x))
    values[cell, places] += a
    values[cell + 1, places] += b
    return values
