"""Source of the compiled integrals over phase and distance: see :mod:`.build`.

A row is evaluated by the same sequence of operations wherever it stands in a batch.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from bnserve_inference.kernel._lanes import root
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.marginal_kernel._circle import over_circle
from bnserve_inference.marginal_kernel._distance import over_distances
from bnserve_inference.marginal_kernel._functions import logarithm
from bnserve_inference.marginal_kernel._layout import ROOM, Argument, Phase, Prior
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at

_NUMBERS = len(Prior)


@njit(**JIT_OPTIONS)
def _at_once(row: int, arguments: Integers, prior: Floats, room: Floats) -> None:
    """As :func:`over_circle`, of one phase, or over all of it with Bessel's function."""
    rows, bessel = arguments[Argument.ROWS], arguments[Argument.PHASE] == Phase.BESSEL
    product = floats_at(arguments[Argument.PRODUCTS] + 16 * row, 2)
    n = floats_at(arguments[Argument.NORMS], rows)[row]
    size = root(product[0] * product[0] + product[1] * product[1]) if bessel else product[0]
    exponent, factor, firsts, squares = np.nan, 1.0, np.nan, np.nan
    if -np.inf < size < np.inf and -np.inf < n < np.inf:
        exponent, factor, firsts, squares = over_distances(size, n, arguments, prior, room)
    floats_at(arguments[Argument.VALUES], rows)[row] = exponent + logarithm(factor) - prior[Prior.LOG_NORM]
    if arguments[Argument.BY_PRODUCTS] != 0:
        by_size = firsts / factor
        turned = floats_at(arguments[Argument.BY_PRODUCTS] + 16 * row, 2)
        turned[0], turned[1] = by_size, 0.0
        if bessel:
            scale = by_size / size if size > 0.0 else by_size
            turned[0], turned[1] = scale * product[0], -scale * product[1]
        floats_at(arguments[Argument.BY_NORMS], rows)[row] = -0.5 * squares / factor


@njit(**JIT_OPTIONS)
def integrate(arguments: Integers) -> int:
    """ln of the integral of every row: see :class:`Argument`; returns 0."""
    prior = floats_at(arguments[Argument.PRIOR], _NUMBERS)
    scratch = floats_at(arguments[Argument.SCRATCH], ROOM)
    for row in range(arguments[Argument.ROWS]):
        if arguments[Argument.PHASE] == Phase.CIRCLE:
            over_circle(row, arguments, prior, scratch)
        else:
            _at_once(row, arguments, prior, scratch)
    return 0
