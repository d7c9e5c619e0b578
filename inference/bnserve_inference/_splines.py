"""Uniform cubic B-splines in time, and cardinal cubic splines through uneven nodes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

MARGIN = 24
"""Fine samples taken beyond either end of a range: knots there let the spline forget its straight ends."""


def b_spline_coefficients(samples: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Coefficients of the cubic B-spline that interpolates uniform samples along the second axis.

    Parameters
    ----------
    samples:
        ``(D, n, L)``; the ends of the spline are straight, so that a few samples at either end serve the ends alone.

    Returns
    -------
    ``(D, n + 2, L)``: the coefficients from one before to one after the samples.
    """
    count = samples.shape[1]
    coefficients = np.empty((samples.shape[0], count + 2, samples.shape[2]), dtype=np.complex128)
    # c[k-1] + 4 c[k] + c[k+1] = 6 s[k]; without curvature at the ends c = s there.
    inner = coefficients[:, 1:-1]
    inner[:] = samples
    ratios = np.zeros(count)
    for k in range(1, count - 1):
        pivot = 4.0 - ratios[k - 1]
        ratios[k] = 1.0 / pivot
        inner[:, k] = (6.0 * samples[:, k] - inner[:, k - 1]) / pivot
    for k in range(count - 2, 0, -1):
        inner[:, k] -= ratios[k] * inner[:, k + 1]
    coefficients[:, 0] = 2.0 * coefficients[:, 1] - coefficients[:, 2]
    coefficients[:, -1] = 2.0 * coefficients[:, -2] - coefficients[:, -3]
    return coefficients


def b_spline_midpoints(coefficients: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """The spline halfway between its samples: from ``(D, n + 2, L)`` coefficients ``(D, n - 1, L)`` values."""
    c = coefficients
    return (c[:, :-3] + 23.0 * c[:, 1:-2] + 23.0 * c[:, 2:-1] + c[:, 3:]) / 48.0


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
