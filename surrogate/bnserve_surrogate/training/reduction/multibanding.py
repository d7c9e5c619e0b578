r"""Frequency grids that follow the chirp: the paper's multibanding, and the uniform grid it replaces.

All in units of the total mass: frequencies are M f, times are t / M. At Newtonian order a binary of symmetric mass
ratio nu lasts :math:`T(f) = \frac{5}{256 \nu} (\pi f)^{-8/3}` from the frequency f on.
"""

from __future__ import annotations

import numpy as np

from bnserve_surrogate.training.data.generators import FloatArray, mass_seconds

PIVOT_HZ = 40.0
"""Above this frequency, at the reference mass, the spacing stays what it is there."""


def newtonian_duration(mf: float, mass_ratio: float) -> float:
    """Time to merger from dimensionless frequency ``mf``, in units of M, at Newtonian order."""
    return 5.0 * (1.0 + mass_ratio) ** 2 / (256.0 * mass_ratio) * float(np.pi * mf) ** (-8.0 / 3.0)


def uniform_count(mf_min: float, mf_max: float, mass_ratio: float) -> int:
    """Points of the uniform grid 0, 1/T, 2/T, ... up to ``mf_max``, where T is the duration from ``mf_min``.

    The discrete Fourier transform of a signal of that length has this many; it grows as mf_min**(-8/3).
    """
    return int(np.floor(mf_max * newtonian_duration(mf_min, mass_ratio))) + 1


def multibanded_grid(
    mf_min: float, mf_max: float, largest_mass_ratio: float, mf_pivot: float | None = None
) -> FloatArray:
    r"""A grid of spacing 1 / T(f), varying continuously below the pivot and uniform above it.

    Below the pivot the point of number i solves di/df = T(f) exactly:
    :math:`f_i = (f_0^{-5/3} - i / \kappa)^{-3/5}`, :math:`\kappa = \frac{3}{256 \nu} \pi^{-8/3}`.

    Parameters
    ----------
    mf_min, mf_max
        First and last point, dimensionless.
    largest_mass_ratio
        The binary that lasts longest, hence needs the finest grid.
    mf_pivot
        By default 40 Hz at the reference mass.

    Returns
    -------
    (n,) increasing dimensionless frequencies from exactly ``mf_min`` to exactly ``mf_max``.
    """
    if not 0.0 < mf_min < mf_max:
        raise ValueError(f"A grid needs 0 < mf_min < mf_max; got {mf_min}, {mf_max}.")
    pivot = min(max(PIVOT_HZ * mass_seconds() if mf_pivot is None else mf_pivot, mf_min), mf_max)
    kappa = 0.6 * newtonian_duration(1.0, largest_mass_ratio)
    below = np.arange(int(np.floor(kappa * (mf_min ** (-5 / 3) - pivot ** (-5 / 3)))) + 1)
    chirping = (mf_min ** (-5 / 3) - below / kappa) ** (-3 / 5)
    spacing = 1.0 / newtonian_duration(pivot, largest_mass_ratio)
    uniform = np.arange(chirping[-1] + spacing, mf_max, spacing)
    grid = np.concatenate([chirping, uniform])
    grid[0] = mf_min
    return np.append(grid[grid < mf_max - 1e-3 * spacing], mf_max)
