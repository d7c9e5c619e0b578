"""What the compiled contraction of moving detectors and its caller agree on, beyond that of several modes."""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_inference.kernel._layout import BLOCK
from bnserve_inference.kernel._layout import Argument as Common
from bnserve_inference.modes_kernel import _layout as modes_kernel

GROUP_BLOCKS = modes_kernel.GROUP_BLOCKS + 6
"""Beyond its strain, of each group: plus and cross polarisation, complex, and cosine and sine of the Earth's turn."""
SHARED_BLOCKS = modes_kernel.SHARED_BLOCKS


class Coefficient(IntEnum):
    """Of a row and a detector: what its response at the Earth's turn theta since the coalescence is made of."""

    DELAY = 0
    """At theta = 0, seconds."""
    PLUS = 1
    """Of 1, cos theta, sin theta, cos 2 theta and sin 2 theta in F+."""
    CROSS = 6
    RECEDING = 11
    """Of 1 - cos theta in the delay, seconds."""
    SIDEWAYS = auto()
    """Of sin theta."""
    COS_POLARIZATION = auto()
    """Of twice the angle."""
    SIN_POLARIZATION = auto()
    COS_DECLINATION = auto()
    SIN_DECLINATION = auto()
    X_ARM = 17
    """The first arm: its unit vector along the axes that the source's hour angle gives the equator (towards the source,
    and at a right angle to it) and along the Earth's axis; and its length in light seconds, zero if it is short."""
    Y_ARM = 21


COEFFICIENTS = 25


class Argument(IntEnum):
    """What follows :class:`bnserve_inference.kernel._layout.Argument` in the block of one call."""

    ARMS = len(Common)
    """float64 ``(D, 2, 3)``, metres; zeros where they are short."""
    REFERENCE = auto()
    """float64 ``(G, 2, padded J)``: cosine and sine of the phase of the waveform that each group is compared with."""
    REFERENCE_TIMES = auto()
    """float64 ``(G, padded J)``: when it passes the nodes, in seconds from the coalescence."""
    SLOPES = auto()
    """float64 ``(2, padded J)``: seconds for each radian by which the ratio to it turns from the node before to this
    one, and from this one to the next."""
    MOVES = auto()
    """1 where detectors move, and are where they are as a signal arrives at them; 0 where they stand as at the
    coalescence at the centre of the Earth."""
    PASSING_STRIDE = auto()
    """Numbers from the times of a row to those of the next. 0: they are found for each row by comparison."""
    PASSING = auto()
    """float64 ``(ROWS, G, padded J)``: when each group passes the nodes, in seconds from the coalescence; of one row,
    and of one group more, where they are found."""


ARGUMENTS = len(Common) + len(Argument)


def scratch_size(detectors: int, groups: int) -> int:
    """Numbers of working memory for one call."""
    return COEFFICIENTS * detectors + (GROUP_BLOCKS * groups + SHARED_BLOCKS) * BLOCK
