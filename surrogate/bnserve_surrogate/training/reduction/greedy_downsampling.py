"""The paper's greedy choice of nodes from which cubic splines reconstruct every waveform of a set."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import require
from bnserve_surrogate.training.data.generators import FloatArray

_ROWS_AT_ONCE = 8
"""Waveforms interpolated together: shares the search of the spline cell and keeps the work in the cache."""


@dataclass(frozen=True)
class GreedyNodes:
    """The nodes chosen and how it went.

    Parameters
    ----------
    indices
        Positions in the grid, (m,), unique and increasing; the first and the last point are always among them.
    largest_error
        Largest reconstruction error over all waveforms and frequencies, with these nodes.
    counts, errors
        Number of nodes and largest error at each iteration.
    tolerance
        What was asked for.
    """

    indices: NDArray[np.intp]
    largest_error: float
    counts: tuple[int, ...]
    errors: tuple[float, ...]
    tolerance: float


def greedy_downsampling(
    frequencies: FloatArray, values: FloatArray, tolerance: float = 1e-5, max_nodes: int | None = None
) -> GreedyNodes:
    """Choose nodes until cubic splines through them reconstruct all rows of ``values`` within ``tolerance``.

    Starts from the two end points. Every iteration interpolates all rows through the nodes (not-a-knot cubic splines),
    and in every segment between two nodes where some row is off by more than the tolerance adds the point where it is
    off most. No randomness: the same input gives the same nodes.

    Parameters
    ----------
    frequencies
        (n,) increasing.
    values
        (N, n): amplitudes, or phases, or residuals of either. Not changed.
    tolerance
        Largest absolute error, in the units of ``values``.
    max_nodes
        Stop as soon as there are this many nodes; by default only the grid limits their number.

    Returns
    -------
    :class:`GreedyNodes`.
    """
    rows = np.atleast_2d(np.asarray(values, dtype=np.float64))
    count = frequencies.size
    if rows.shape[1] != count or count < 2 or not (np.diff(frequencies) > 0).all():
        raise ValueError(f"greedy_downsampling needs increasing frequencies (n,) and values (N, n); got {rows.shape}.")
    indices = np.array([0, count - 1], dtype=np.intp)
    counts: list[int] = []
    errors: list[float] = []
    while True:
        error = reconstruction_error(frequencies, rows, indices)
        counts.append(indices.size)
        errors.append(float(error.max()))
        done = errors[-1] <= tolerance or indices.size >= min(max_nodes or count, count)
        if done:
            return GreedyNodes(indices, errors[-1], tuple(counts), tuple(errors), tolerance)
        indices = np.union1d(indices, _worst_of_each_segment(error, indices, tolerance))


def reconstruction_error(frequencies: FloatArray, values: FloatArray, indices: NDArray[np.intp]) -> FloatArray:
    """Largest absolute error over the rows of ``values`` of cubic splines through the nodes, (n,)."""
    spline = require("scipy.interpolate", "Training", "train").CubicSpline
    largest = np.zeros(frequencies.size)
    for start in range(0, values.shape[0], _ROWS_AT_ONCE):
        rows = values[start : start + _ROWS_AT_ONCE]
        reconstructed = spline(frequencies[indices], rows[:, indices].T)(frequencies)
        np.maximum(largest, np.abs(reconstructed - rows.T).max(axis=1), out=largest)
    largest[indices] = 0.0
    return largest


def _worst_of_each_segment(error: FloatArray, indices: NDArray[np.intp], tolerance: float) -> NDArray[np.intp]:
    """The position of the largest error between each two neighbouring nodes, where it exceeds the tolerance."""
    worst = np.maximum.reduceat(error, indices[:-1])
    segments = np.flatnonzero(worst > tolerance)
    return np.array([indices[s] + int(np.argmax(error[indices[s] : indices[s + 1]])) for s in segments], dtype=np.intp)
