"""Calibration envelopes: cubic splines of amplitude and phase errors through logarithmic nodes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import Calibration


def calibration_nodes(calibration: Calibration) -> NDArray[np.float64]:
    """The frequencies of the nodes in Hz, ``(nodes,)``: logarithmic, both ends included."""
    return np.geomspace(calibration.f_min, calibration.f_max, calibration.nodes)


def calibration_factors(
    calibration: Calibration,
    amplitude: NDArray[np.float64],
    phase: NDArray[np.float64],
    frequencies: NDArray[np.float64],
) -> NDArray[np.complex128]:
    """What errors at the nodes, each ``(..., nodes)``, multiply a signal by: (1 + dA)(2 + i dphi) / (2 - i dphi).

    Complex ``(..., M)`` for ``frequencies`` in Hz, ``(M,)``.
    """
    splines = calibration_splines(calibration, frequencies)
    turned = phase @ splines
    square = np.square(turned)
    size = (1.0 + amplitude @ splines) / (4.0 + square)
    factors = np.empty(turned.shape, dtype=np.complex128)
    factors.real, factors.imag = size * (4.0 - square), size * 4.0 * turned
    return factors


def calibration_splines(calibration: Calibration, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
    """The nodes' cardinal functions, ``(nodes, M)``: errors at the nodes times these are errors at ``frequencies``.

    The spline is cubic in log f, without a knot at the second node from either end (LIGO-T2300140, as in bilby's
    ``CubicSpline``); the end cells extend beyond the ends.

    Parameters
    ----------
    calibration:
        Number and range of the nodes.
    frequencies:
        In Hz, ``(M,)``.
    """
    nodes = calibration.nodes
    log_ends = np.log(calibration.f_min), np.log(calibration.f_max)
    x = (np.log(frequencies) - log_ends[0]) / (log_ends[1] - log_ends[0]) * (nodes - 1)
    cell = np.clip(np.floor(x).astype(np.int64), 0, nodes - 2)
    b = x - cell
    a = 1.0 - b
    curvatures = _curvatures(nodes)
    unit = np.eye(nodes)
    return np.ascontiguousarray(
        a * unit[:, cell]
        + b * unit[:, cell + 1]
        + (a**3 - a) / 6.0 * curvatures[cell].T
        + (b**3 - b) / 6.0 * curvatures[cell + 1].T
    )


def _curvatures(nodes: int) -> NDArray[np.float64]:
    """Second derivatives at the nodes, per unit of node spacing, as a matrix that acts on the values."""
    inner = np.arange(1, nodes - 1)
    left, right = np.zeros((nodes, nodes)), np.zeros((nodes, nodes))
    left[0, :3] = left[-1, -3:] = 1.0, -2.0, 1.0
    for offset, value, difference in ((-1, 1.0 / 6.0, 1.0), (0, 2.0 / 3.0, -2.0), (1, 1.0 / 6.0, 1.0)):
        left[inner, inner + offset] = value
        right[inner, inner + offset] = difference
    return np.asarray(np.linalg.solve(left, right), dtype=np.float64)
