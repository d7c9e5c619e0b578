"""What the compiled adjoint of the modes and its caller agree on.

It is told what the derivatives are told (:mod:`bnserve_surrogate.tangents._layout`), with the same working memory after
:data:`SUMS`: where these have a derivative, the adjoint has a bar, which is what the function changes by with a number.
``FIRST`` are modes that were evaluated, complex128 ``(N, L, M)``; ``SECOND`` their bars, complex128 ``(N, L, GIVEN)``,
each with the real part and the imaginary part that the function changes by with those of h; ``PLUS`` is where the
derivatives with respect to the parameters go, float64 ``(N, 6)``.
"""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_surrogate.kernel._layout import LANES, padded
from bnserve_surrogate.tangents._layout import WORK, Buffer

ALPHA, GAMMA, Z_REAL, Z_IMAGINARY, ROOM = (Buffer.A + place for place in range(5))
"""Buffers of a block: bars of ln A, of what is taken off the phase, and of a mode; and the first of four to spare."""


class Series(IntEnum):
    """What is summed over the frequencies of one order, each in eight lanes, and then over these."""

    BARE = 0
    """Eight, of the powers of an amplitude's series."""
    PLAIN = 8
    """Sixteen, of those of a phase's; the sixth and the ninth are of its constant and of its slope, too."""
    LOGARITHMIC = 24
    FROZEN = 32
    MOVING = auto()


SERIES = 34


class Place(IntEnum):
    """Where sums stand."""

    IN_LANES = 0
    """Of one order, ``(34, 8)``."""
    IN_ALL = SERIES * LANES
    """The same over the lanes."""
    PHASE = IN_ALL + SERIES
    """Of a row: bars of a phase's coefficients, ``(3, 16)``."""
    AMPLITUDE = PHASE + WORK
    """Of an amplitude's."""
    GAUGE = AMPLITUDE + LANES
    """Of what the alignments take off."""
    EDGE = GAUGE + 4
    """Of both residuals where the band begins."""
    TOP = EDGE + 2
    """Bars of both splines' last cells that are of the line beyond the band, four of each."""
    OWN = TOP + 8
    """The derivatives, six."""


SUMS = padded(Place.OWN + 6)
"""Floats of them."""
