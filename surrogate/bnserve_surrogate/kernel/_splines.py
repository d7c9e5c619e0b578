"""Cubic splines as linear maps: what depends on the knots alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def second_derivative_operator(knots: NDArray[np.float64]) -> NDArray[np.float64]:
    """The matrix that takes values at the knots to the second derivatives of their not-a-knot cubic spline.

    Parameters
    ----------
    knots:
        Increasing, ``(n,)`` with n >= 4.

    Returns
    -------
    ``(n, n)`` matrix D: the second derivatives at the knots of the spline through values y are ``D @ y``. The same
    spline as ``scipy.interpolate.CubicSpline`` with its default boundary condition.
    """
    n = len(knots)
    widths = np.diff(knots)
    left = np.zeros((n, n))
    right = np.zeros((n, n))
    for i in range(1, n - 1):
        left[i, i - 1], left[i, i], left[i, i + 1] = widths[i - 1], 2.0 * (widths[i - 1] + widths[i]), widths[i]
        right[i, i - 1], right[i, i + 1] = 6.0 / widths[i - 1], 6.0 / widths[i]
        right[i, i] = -right[i, i - 1] - right[i, i + 1]
    # Not-a-knot: the third derivative is continuous at the second and the second-to-last knot.
    left[0, :3] = widths[1], -(widths[0] + widths[1]), widths[0]
    left[-1, -3:] = widths[-1], -(widths[-2] + widths[-1]), widths[-2]
    return np.asarray(np.linalg.solve(left, right), dtype=np.float64)
