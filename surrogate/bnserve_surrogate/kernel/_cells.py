"""Cells of the band in M f, in each of which amplitude and phase of a waveform are polynomials to all that matters.

On a dense grid the post-Newtonian series need not be evaluated at every frequency: they and the residuals are evaluated
at eight Chebyshev nodes of each cell, and polynomials through those values give everything in between. Cells end where
anything has a kink: at the splines' knots, and where the baseline's amplitude begins and ends to freeze.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from bnserve_surrogate._freezing import FREEZING_END, FREEZING_START

LANES = 8
"""Rows evaluated together, and doubles in a vector: sections of the weights are padded to whole vectors."""
PHASE_DEGREE, AMPLITUDE_DEGREE = 6, 5
"""With 0.07 between knots in log f, the phase at 5 Hz, 1e5 radians, is right to 1e-7."""

Floats = NDArray[np.float64]


class Cells(NamedTuple):
    """Cells as the kernel reads them.

    ``numbers`` is, for C cells in whole vectors: the upper edges in log(M f), each padded to whole vectors; twice the
    reciprocal widths in M f; what is to be taken off for a coordinate from -1 to 1; the two matrices, ``(8, 8)`` each,
    that take values at the nodes to coefficients; then ``(5, 8 C)``: M f of the nodes, its logarithm, and its powers
    1/3, -5/3 and -7/6. ``owners`` are the spline's cells in which they lie.
    """

    numbers: Floats
    owners: NDArray[np.int64]


NO_CELLS = Cells(np.zeros(0), np.zeros(0, np.int64))


def padded(count: int) -> int:
    """``count`` rounded up to whole vectors."""
    return -(-count // LANES) * LANES


def arrange_cells(log_knots: Floats) -> Cells:
    """Cells between the knots (in log(M f)) of the splines."""
    breaks = np.log([FREEZING_START, FREEZING_END])
    inside = breaks[(breaks > log_knots[0]) & (breaks < log_knots[-1])]
    log_edges = np.union1d(log_knots, inside)
    owners = np.searchsorted(log_knots, log_edges[:-1], side="right") - 1
    edges = np.exp(log_edges)
    centre, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
    nodes = _nodes()
    mf = (centre[:, None] + half[:, None] * nodes).ravel()
    powers = np.stack([mf, np.log(mf), np.cbrt(mf), mf ** (-5.0 / 3.0), mf ** (-7.0 / 6.0)])
    count = padded(len(owners))
    columns = np.zeros((3, count))
    for row, values in zip(columns, (log_edges[1:], 1.0 / half, centre / half), strict=True):
        row[: len(owners)] = values
    matrices = [_coefficients(degree) for degree in (PHASE_DEGREE, AMPLITUDE_DEGREE)]
    numbers = np.concatenate([columns.ravel(), *(matrix.ravel() for matrix in matrices), powers.ravel()])
    return Cells(numbers, owners.astype(np.int64))


def _nodes() -> Floats:
    """The Chebyshev nodes of the first kind in (-1, 1), increasing."""
    return np.asarray(-np.cos(np.pi * (np.arange(LANES) + 0.5) / LANES))


def _coefficients(degree: int) -> Floats:
    """``(node, power)``: what a value at each node adds to the coefficients of the powers up to ``degree``."""
    angles = np.pi * (np.arange(LANES) + 0.5) / LANES
    series = np.cos(np.outer(np.arange(LANES), angles)) * (2.0 / LANES)
    series[0] *= 0.5
    series[1::2] *= -1.0  # the nodes increase, the angles run the other way
    matrix = np.zeros((LANES, LANES))
    for node in range(LANES):
        plain = chebyshev.cheb2poly(series[: degree + 1, node])
        matrix[node, : len(plain)] = plain
    return matrix
