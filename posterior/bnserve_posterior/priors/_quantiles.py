"""Where in the cube values of a parameter lie, and how dense it is there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.priors._cube import PriorCube

Floats = NDArray[np.float64]
_OUTSIDE = -1.0


def quantiles(cube: PriorCube, name: str, values: Floats) -> Floats:
    """Where in the cube a parameter has these values; outside of it where it cannot."""
    prior = cube.priors[name]
    inside = (values > prior.minimum) & (values < prior.maximum)
    return np.where(inside, prior.cdf(np.where(inside, values, prior.minimum)), _OUTSIDE)


def log_density(cube: PriorCube, name: str, values: Floats) -> Floats:
    """ln of the prior's density, at its nearer end for values beyond."""
    prior = cube.priors[name]
    return np.asarray(np.log(np.maximum(prior.prob(np.clip(values, prior.minimum, prior.maximum)), 1e-300)))
