"""Uniform quintic B-splines in time, and cardinal cubic splines through uneven nodes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

MARGIN = 48
"""Fine samples taken beyond either end of a range, two to a knot: 0.43**24 = 2e-9 of the ends' errors is left."""
_POLES = (-0.430575347099973, -0.0430962882032647)
"""Of the quintic B-spline's filter (Unser, Aldroubi, Eden 1993): roots of z^4 + 26 z^3 + 66 z^2 + 26 z + 1."""


def b_spline_coefficients(samples: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Coefficients of the quintic B-spline that interpolates uniform samples along the first axis.

    Parameters
    ----------
    samples
        ``(n, L)``; taken to be constant beyond the ends, so that :data:`MARGIN` / 2 of them serve the ends alone.

    Returns
    -------
    ``(n, L)``.
    """
    coefficients = samples.copy()
    for pole in _POLES:
        coefficients *= (1.0 - pole) * (1.0 - 1.0 / pole)
        coefficients[0] /= 1.0 - pole
        for k in range(1, len(coefficients)):
            coefficients[k] += pole * coefficients[k - 1]
        coefficients[-1] *= -pole / (1.0 - pole)
        for k in range(len(coefficients) - 2, -1, -1):
            coefficients[k] = pole * (coefficients[k + 1] - coefficients[k])
    return coefficients


def b_spline_midpoints(coefficients: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """The spline halfway between its samples, where it has six coefficients: ``(n, L)`` to ``(n - 5, L)``."""
    c = coefficients
    outer, middle, inner = c[:-5] + c[5:], c[1:-4] + c[4:-1], c[2:-3] + c[3:-2]
    return (outer + 237.0 * middle + 1682.0 * inner) / 3840.0


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
    return np.asarray(np.linalg.solve(left, right), dtype=np.float64)


def cardinal_values(
    nodes: NDArray[np.float64], curvatures: NDArray[np.float64], x: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The cardinal functions of :func:`cardinal_spline` at ``x``: ``(n, len(x))``."""
    cell, (a, b, left, right) = in_cells(nodes, x)
    values = left * curvatures[cell].T + right * curvatures[cell + 1].T
    places = np.arange(len(x))
    values[cell, places] += a
    values[cell + 1, places] += b
    return np.asarray(values, dtype=np.float64)


def spline_values(
    nodes: NDArray[np.float64], values: NDArray[np.float64], curvatures: NDArray[np.float64], x: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The cubic spline of ``values`` and second derivatives ``curvatures`` at the nodes, ``(n,)`` each, at ``x``."""
    cell, (a, b, left, right) = in_cells(nodes, x)
    bent = left * curvatures[cell] + right * curvatures[cell + 1]
    return np.asarray(a * values[cell] + b * values[cell + 1] + bent, dtype=np.float64)


def in_cells(nodes: NDArray[np.float64], x: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """The cell of every ``x`` ``(n,)``, and what the values and the second derivatives at its two nodes count there,
    ``(4, n)``: of values at the left and right node, of second derivatives at the left and right node."""
    cell = np.clip(np.searchsorted(nodes, x, side="right") - 1, 0, len(nodes) - 2)
    width = nodes[cell + 1] - nodes[cell]
    b = (x - nodes[cell]) / width
    a = 1.0 - b
    return cell, np.stack([a, b, (a**3 - a) * width**2 / 6.0, (b**3 - b) * width**2 / 6.0])
