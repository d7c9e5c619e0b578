r"""The paper's nodes: a multibanded grid that follows the chirp, and the greedy choice of some of its points.

All in units of the total mass: frequencies are M f, times are t / M. At Newtonian order a binary of symmetric mass
ratio nu lasts :math:`T(f) = \frac{5}{256 \nu} (\pi f)^{-8/3}` from the frequency f on.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from bnserve_surrogate.training.data.generators import FloatArray, mass_seconds

_ROWS_AT_ONCE = 8
"""Waveforms interpolated together: shares the search of the spline cell and keeps the work in the cache."""
PIVOT_HZ = 40.0
"""Above this frequency, at the reference mass, the spacing stays what it is there."""


def newtonian_duration(mf: float, mass_ratio: float) -> float:
    """Time to merger from dimensionless frequency ``mf``, in units of M, at Newtonian order."""
    return 5.0 * (1.0 + mass_ratio) ** 2 / (256.0 * mass_ratio) * float(np.pi * mf) ** (-8.0 / 3.0)


def multibanded_grid(mf_min: float, mf_max: float, largest_mass_ratio: float) -> FloatArray:
    r"""A grid of spacing 1 / T(f), varying continuously below the pivot and uniform above it.

    Below the pivot the point of number i solves di/df = T(f) exactly:
    :math:`f_i = (f_0^{-5/3} - i / \kappa)^{-3/5}`, :math:`\kappa = \frac{3}{256 \nu} \pi^{-8/3}`.

    Parameters
    ----------
    mf_min, mf_max
        First and last point, dimensionless.
    largest_mass_ratio
        The binary that lasts longest, hence needs the finest grid.

    Returns
    -------
    (n,) increasing dimensionless frequencies from exactly ``mf_min`` to exactly ``mf_max``.

    Raises
    ------
    ValueError
        The two do not increase, or are not positive.
    """
    if not 0.0 < mf_min < mf_max:
        raise ValueError(f"A grid needs 0 < mf_min < mf_max; got {mf_min}, {mf_max}.")
    pivot = min(max(PIVOT_HZ * mass_seconds(), mf_min), mf_max)
    kappa = 0.6 * newtonian_duration(1.0, largest_mass_ratio)
    below = np.arange(int(np.floor(kappa * (mf_min ** (-5 / 3) - pivot ** (-5 / 3)))) + 1)
    chirping = (mf_min ** (-5 / 3) - below / kappa) ** (-3 / 5)
    spacing = 1.0 / newtonian_duration(pivot, largest_mass_ratio)
    uniform = np.arange(chirping[-1] + spacing, mf_max, spacing)
    grid = np.concatenate([chirping, uniform])
    grid[0] = mf_min
    return np.append(grid[grid < mf_max - 1e-3 * spacing], mf_max)


def greedy_downsampling(frequencies: FloatArray, values: FloatArray, tolerance: float = 1e-5) -> NDArray[np.intp]:
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

    Returns
    -------
    Positions in the grid, (m,), unique and increasing; the first and the last point are always among them.

    Raises
    ------
    ValueError
        The frequencies do not increase, or are not those of the values.
    """
    rows = np.atleast_2d(np.asarray(values, dtype=np.float64))
    count = frequencies.size
    if rows.shape[1] != count or count < 2 or not (np.diff(frequencies) > 0).all():
        raise ValueError(f"greedy_downsampling needs increasing frequencies (n,) and values (N, n); got {rows.shape}.")
    indices = np.array([0, count - 1], dtype=np.intp)
    error = reconstruction_error(frequencies, rows, indices)
    while not error.max() <= tolerance and indices.size < count:
        indices = np.union1d(indices, _worst_of_each_segment(error, indices, tolerance))
        error = reconstruction_error(frequencies, rows, indices)
    return indices


def reconstruction_error(frequencies: FloatArray, values: FloatArray, indices: NDArray[np.intp]) -> FloatArray:
    """Largest absolute error over the rows of ``values`` of cubic splines through the nodes, (n,)."""
    largest = np.zeros(frequencies.size)
    for start in range(0, values.shape[0], _ROWS_AT_ONCE):
        rows = values[start : start + _ROWS_AT_ONCE]
        reconstructed = CubicSpline(frequencies[indices], rows[:, indices].T)(frequencies)
        np.maximum(largest, np.abs(reconstructed - rows.T).max(axis=1), out=largest)
    largest[indices] = 0.0
    return largest


def _worst_of_each_segment(error: FloatArray, indices: NDArray[np.intp], tolerance: float) -> NDArray[np.intp]:
    """The position of the largest error between each two neighbouring nodes, where it exceeds the tolerance."""
    worst = np.maximum.reduceat(error, indices[:-1])
    segments = np.flatnonzero(worst > tolerance)
    return np.array([indices[s] + int(np.argmax(error[indices[s] : indices[s + 1]])) for s in segments], dtype=np.intp)
