"""Source of the compiled integrals over phase and distance: see :mod:`.build`.

A row is evaluated by the same sequence of operations wherever it stands in a batch.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from bnserve_inference.kernel._lanes import root
from bnserve_inference.kernel._sums import Floats, Integers
from bnserve_inference.marginal_kernel._circle import over_circle
from bnserve_inference.marginal_kernel._distance import add_bessel, over_distances, to_ratios
from bnserve_inference.marginal_kernel._functions import logarithm
from bnserve_inference.marginal_kernel._layout import ROOM, Argument, Phase, Prior
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in

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
def _over_phases(first: int, arguments: Integers, room: Floats) -> None:
    """The integral over the phase alone, with Bessel's function, of as many rows as there are lanes."""
    rows = arguments[Argument.ROWS]
    products = floats_at(arguments[Argument.PRODUCTS], 2 * rows)
    norms, values = floats_at(arguments[Argument.NORMS], rows), floats_at(arguments[Argument.VALUES], rows)
    size, log_i0, ratio = floats_in(room, 0, LANES), floats_in(room, LANES, LANES), floats_in(room, 2 * LANES, LANES)
    for j in range(LANES):
        row = min(first + j, rows - 1)
        x = root(products[2 * row] * products[2 * row] + products[2 * row + 1] * products[2 * row + 1])
        size[j], log_i0[j], ratio[j] = (x if x < np.inf else 0.0), 0.0, 1.0
    add_bessel(size, arguments, floats_in(room, 3 * LANES, 2 * LANES), log_i0)
    if arguments[Argument.BY_PRODUCTS] != 0:
        to_ratios(size, ratio, arguments)
    for j in range(min(LANES, rows - first)):
        row = first + j
        a, b = products[2 * row], products[2 * row + 1]
        finite = root(a * a + b * b) < np.inf
        values[row] = (log_i0[j] - 0.5 * norms[row]) + size[j] if finite else np.nan
        if arguments[Argument.BY_PRODUCTS] != 0:
            turned = floats_at(arguments[Argument.BY_PRODUCTS] + 16 * row, 2)
            scale = ratio[j] / size[j] if size[j] > 0.0 else ratio[j]
            turned[0], turned[1] = (scale * a, -scale * b) if finite else (np.nan, np.nan)
            floats_at(arguments[Argument.BY_NORMS], rows)[row] = -0.5


@njit(**JIT_OPTIONS)
def integrate(arguments: Integers) -> int:
    """ln of the integral of every row: see :class:`Argument`; returns 0."""
    prior, phase = floats_at(arguments[Argument.PRIOR], _NUMBERS), arguments[Argument.PHASE]
    scratch = floats_at(arguments[Argument.SCRATCH], ROOM)
    if phase == Phase.BESSEL and arguments[Argument.HAS_DISTANCE] == 0:
        for first in range(0, arguments[Argument.ROWS], LANES):
            _over_phases(first, arguments, scratch)
        return 0
    for row in range(arguments[Argument.ROWS]):
        if phase == Phase.CIRCLE:
            over_circle(row, arguments, prior, scratch)
        else:
            _at_once(row, arguments, prior, scratch)
    return 0
