"""From whitened derivatives to what they say: covariances, errors, areas of the sky."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

LARGEST_CONDITION = 1e14
"""Of a matrix with a unit diagonal; beyond it a direction is not measured, and its covariance is rounding."""


def condition(root: Floats) -> Floats:
    """Condition number of the squares of R with a unit diagonal, ``(N,)``."""
    with np.errstate(over="ignore"):
        scale = np.sqrt((root**2).sum(axis=1))
    good = (scale > 0.0).all(axis=1) & np.isfinite(scale).all(axis=1)
    regular = np.where(good[:, None, None], root, np.eye(root.shape[1])) / np.where(good[:, None], scale, 1.0)[:, None]
    values = np.linalg.svd(regular, compute_uv=False)
    with np.errstate(divide="ignore"):
        found = (values[:, 0] / values[:, -1]) ** 2
    return np.asarray(np.where(good, found, np.inf))
