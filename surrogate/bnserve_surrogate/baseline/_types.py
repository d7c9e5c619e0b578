"""What the coefficient functions take and fill: a float (compiled by numba), or an array over binaries (numpy)."""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

FloatArray: TypeAlias = NDArray[np.float64]

Scalars: TypeAlias = float | FloatArray
"""A number, or an array of shape (N,) of them."""

Coefficients: TypeAlias = FloatArray
"""Output array: the coefficient axes, followed by (N,) if the arguments are arrays of shape (N,)."""
