"""Grids, weights and splines on which scalar products between residuals are computed.

Residuals live on some hundred nodes; scalar products are sums over a dense grid of a few thousand frequencies, to which
the cubic spline in log f of the evaluation kernel takes them. It is linear in the values, so it is a matrix here.

Frequencies may be in Hz or dimensionless (M f), as long as one unit is kept; noise curves want Hz.
"""

from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline

from bnserve_surrogate.training.data.noise import NoiseCurve

FloatArray: TypeAlias = NDArray[np.float64]


_DENSE = 4000
"""Points of the grid of a metric, as many as of the mismatch integral of a validation."""


def trapezoid_weights(frequencies: ArrayLike) -> FloatArray:
    """Weights v, shape (J,), such that ``v @ y`` is the trapezoidal integral of y over ``frequencies``, shape (J,)."""
    grid = np.asarray(frequencies, dtype=np.float64)
    if grid.ndim != 1 or len(grid) < 2 or not (np.diff(grid) > 0.0).all():
        raise ValueError("An integration grid must be a vector of at least two strictly increasing frequencies.")
    steps = 0.5 * np.diff(grid)
    return np.concatenate([steps, [0.0]]) + np.concatenate([[0.0], steps])


def noise_weights(frequencies: ArrayLike, amplitude: ArrayLike, noise: NoiseCurve) -> FloatArray:
    r"""Normalised quadrature weights of the noise-weighted scalar product, :math:`|h|^2/S_n \, df`, summing to one.

    Parameters
    ----------
    frequencies
        Hz, shape (J,), increasing.
    amplitude
        :math:`|h|`, any unit, shape (J,) for one waveform or (N, J) for several.
    noise
        Power spectral density as a function of the frequency.

    Returns ------- ndarray of the shape of ``amplitude``; every row sums to one. ``noise_weights(...).mean(axis=0)``
    are the mean weights of a population, each waveform counting the same whatever its loudness.

    Raises
    ------
    ValueError
        If an amplitude is not finite or a waveform vanishes.
    """
    grid, size = np.asarray(frequencies, dtype=np.float64), np.asarray(amplitude, dtype=np.float64)
    weights = size**2 * (trapezoid_weights(grid) / noise(grid))
    total = weights.sum(axis=-1, keepdims=True)
    if not (np.isfinite(total).all() and (total > 0.0).all()):
        raise ValueError("Amplitudes must be finite and not all zero to weigh a scalar product.")
    return np.asarray(weights / total)


def spline_matrix(nodes: ArrayLike, frequencies: ArrayLike) -> FloatArray:
    """Matrix S, (J, n), of not-a-knot cubic splines in log f from ``nodes`` (n,) to ``frequencies`` (J,).

    Raises
    ------
    ValueError
        If a node or frequency is not positive, or a frequency lies outside the nodes by more than rounding: a cubic
        goes wild there.
    """
    knots, grid = np.asarray(nodes, dtype=np.float64), np.asarray(frequencies, dtype=np.float64)
    if not (knots[0] > 0.0 and grid.min() > 0.0):
        raise ValueError("Nodes and frequencies must be positive.")
    if grid.min() < knots[0] * (1.0 - 1e-9) or grid.max() > knots[-1] * (1.0 + 1e-9):
        raise ValueError(
            f"The nodes reach from {knots[0]:g} to {knots[-1]:g}, the frequencies from {grid.min():g} to "
            f"{grid.max():g}; splines must not be extrapolated."
        )
    return np.asarray(CubicSpline(np.log(knots), np.eye(len(knots)))(np.log(grid)))


def dense_grid(nodes: FloatArray) -> FloatArray:
    """The grid on which a metric's weights are given, from the first to the last node."""
    return np.geomspace(nodes[0], nodes[-1], _DENSE)


def has_weight(nodes: FloatArray) -> bool:
    """Whether every node has frequencies of the dense grid between its neighbours, as :func:`node_weights` needs."""
    dense = dense_grid(nodes)
    first, stop = np.searchsorted(dense, nodes[:-2], side="right"), np.searchsorted(dense, nodes[2:], side="left")
    return bool((stop > first).all())


def node_weights(nodes: ArrayLike, frequencies: ArrayLike, weights: ArrayLike) -> FloatArray:
    """Quadrature weights at sparse nodes, shape (n,), all positive and summing to one.

    Where they come out positive, the weights integrate cubic splines exactly against the dense weights; nodes too
    coarse for that get the ones that integrate piecewise linear functions.

    Parameters
    ----------
    nodes
        Shape (n,), increasing.
    frequencies, weights
        Dense grid and its weights, shape (J,), J > n.

    Raises
    ------
    ValueError
        If a node has no dense frequency around it.
    """
    knots, grid = np.asarray(nodes, dtype=np.float64), np.asarray(frequencies, dtype=np.float64)
    dense = np.asarray(weights, dtype=np.float64)
    sparse = dense @ spline_matrix(knots, grid)
    if not (sparse > 0.0).all():
        sparse = np.array([dense @ np.interp(np.log(grid), np.log(knots), hat) for hat in np.eye(len(knots))])
    if not (sparse > 0.0).all():
        raise ValueError("The dense grid must be much finer than the nodes and have weight around every node.")
    return sparse / sparse.sum()
