"""What the compiled integrals over phase and distance and their caller agree on."""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_surrogate.kernel._layout import LANES

PHASES = 32
"""Phases of a row at which the integral over the distance is done together."""
MOST_NODES = 64
"""Of a rule."""
ROOM = 5 * MOST_NODES
"""Numbers that a rule works with."""
CELL = 6
"""Numbers of a cell of the prior's table."""
ROWS_OF_WAITING = 11 + CELL
"""Arrays of phases that wait for their integral over the distance."""
STACK = 32
"""Blocks of phases that wait, of which there are no more than one for each halving of the circle, and one."""


class Phase(IntEnum):
    """What becomes of the orbital phase."""

    KEPT = 0
    BESSEL = auto()
    """Integrated over, of modes of one order."""
    CIRCLE = auto()
    """Integrated over, of modes of several orders."""


class Prior(IntEnum):
    """What is known of the prior of the distance: numbers in float64."""

    POWER = 0
    """Of u = reference / distance, negative: what the prior is times du, beside its table."""
    LEAST = auto()
    """Of u."""
    MOST = auto()
    DEPTH = auto()
    """Where the likelihood is below its maximum by the exponential of that much, nothing is left to integrate."""
    LOG_NORM = auto()
    NARROW = auto()
    """Relative width of a normal distribution in u below which the rule for narrow ones is enough."""
    WIDE = auto()
    """The same of the rule for wide ones."""
    FIRST = auto()
    """ln of the distance of the first entry of the table, in units of the reference."""
    PER_CELL = auto()
    """Of ln of the distance, between two entries."""


class Argument(IntEnum):
    """What is told in one call: a block of 64-bit integers, most of them addresses.

    K rows have products <d|h> of G groups of modes, and C terms of the series of <h|h> in the orbital phase; without
    integral over the circle there is one of both.
    """

    PHASE = 0
    """A :class:`Phase`."""
    GROUPS = auto()
    ORDERS = auto()
    """int64 ``(G,)``: multiples of the phase by which the groups turn."""
    TERMS = auto()
    DIFFERENCES = auto()
    """int64 ``(C,)``: the same of the terms of the series."""
    CELLS = auto()
    """Of the circle, at which it is looked at first: whole lanes."""
    HAS_DISTANCE = auto()
    """1 where it is integrated over; 0 where it is as it is."""
    PRIOR = auto()
    """float64, places as in :class:`Prior`; of a distance that is as it is, u lies between one and one."""
    TABLE_CELLS = auto()
    """Between the entries of the prior's table, or 0."""
    TABLE = auto()
    """float64 ``(TABLE_CELLS, CELL)``: the spline's coefficients of 1, b, b^2, b^3, of b from 0 to 1 in a cell, and of
    (b - 1)^3 and (-b)^3, which it has beside them in the cells to its right and its left."""
    NARROW_RULE = auto()
    """float64 ``(2, LANES)``: places in standard deviations, and weights of exp of what is no normal distribution."""
    WIDE_RULE = auto()
    """float64 ``(2, 2 LANES)``: likewise."""
    PART_NODES = auto()
    """Whole lanes."""
    PART_RULE = auto()
    """float64 ``(2, PART_NODES)``: places in [-1, 1], and weights."""
    GAUSS_RULE = auto()
    """float64 ``(2, MOST_NODES)``: likewise."""
    LARGE_BESSEL = auto()
    """float64 ``(LARGE_COUNT,)``: Chebyshev coefficients of sqrt(x) exp(-x) I0(x) for x >= 8."""
    LARGE_COUNT = auto()
    SMALL_BESSEL = auto()
    """float64 ``(SMALL_COUNT,)``: Taylor coefficients of I0 in x^2 / 4."""
    SMALL_COUNT = auto()
    ROWS = auto()
    """K."""
    PRODUCTS = auto()
    """complex128 ``(G, K)``."""
    NORMS = auto()
    """complex128 ``(C, K)``, or float64 ``(1, K)`` without integral over the circle."""
    VALUES = auto()
    """float64 ``(K,)``."""
    BY_PRODUCTS = auto()
    """complex128 ``(G, K)``: what ln L changes by with the products, by the real part of this times what they change
    by; or 0."""
    BY_NORMS = auto()
    """As the norms: likewise; or 0."""
    SCRATCH = auto()


def scratch_size(most: int) -> int:
    """Numbers of working memory for one call, of multiples of the phase up to ``most``."""
    return 8 * (most + 1) + 12 * LANES + ROOM + 2 * ROWS_OF_WAITING * PHASES + (LANES + 2) * STACK
