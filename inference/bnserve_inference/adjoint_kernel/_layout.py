"""What the compiled adjoint of the contraction and its caller agree on, beyond the contraction of moving detectors."""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_inference.moving_kernel import _layout as moving_kernel
from bnserve_surrogate.kernel._layout import LANES

BLOCK = 128
"""Nodes that are worked on at once, all of whose buffers stay near the processor."""


class Argument(IntEnum):
    """What follows the block of :class:`bnserve_inference.moving_kernel._layout.Argument`.

    Written with a bar is the derivative of ln L with respect to something: of a complex z the number b for which ln L
    changes by Re(b dz).
    """

    PRODUCTS_BAR = moving_kernel.ARGUMENTS
    """complex128 ``(ROWS, G, TIMES)``, of <d|h>; or ``(ROWS, G, J)``, of its terms at the nodes."""
    BY_NODE = auto()
    """1 for the second."""
    PAIRS_BAR = auto()
    """complex128 ``(ROWS, P)``, of <h|h'>."""
    WAVES_BAR = auto()
    """complex128 ``(ROWS, MODES, padded J)``, of the strain, conjugated: by its real and by its imaginary part."""
    ADD = auto()
    """1 where they are added to what is there."""
    SUMS = auto()
    """float64 ``(ROWS, SUMS)``: what was asked for. See :class:`Sum`."""
    FACTORS_BAR = auto()
    """complex128 ``(ROWS, MODES, 2)``, of what each mode counts in plus and cross polarisation."""
    PASSING_BAR = auto()
    """float64 ``(ROWS, G, padded J)``, of when groups pass nodes; or 0."""
    AMPLITUDE_BAR = auto()
    """float64 ``(ROWS, D, CALIBRATION_NODES)``, of errors there."""
    PHASE_BAR = auto()


ARGUMENTS = moving_kernel.ARGUMENTS + len(Argument)


class Sum(IntEnum):
    """Derivatives of ln L, by row."""

    RIGHT_ASCENSION = 0
    DECLINATION = auto()
    POLARIZATION = auto()
    TIME = auto()


SUMS = 4


class Buffer(IntEnum):
    """Of each group, what is kept of a block: real and imaginary parts in turn."""

    PLUS = 0
    CROSS = 2
    COSINE = 4
    """And sine, of the Earth's turn."""
    STRAIN = 6
    """In the detector, calibrated."""
    DELAY = 8
    """What the delay's change turns it by."""
    PATTERN = 10
    """Of plus and cross polarisation, and of both their derivatives by hour angle and by declination."""
    PLUS_BAR = 22
    CROSS_BAR = 24
    TURN_BAR = 26
    """Of the Earth's turn, real."""


class Shared(IntEnum):
    """What all groups share."""

    CALIBRATION = 0
    ERRORS = 2
    """Of amplitude and phase."""
    ERRORS_BAR = 4
    STRAIN_BAR = 6
    SLOPE_BAR = 8
    """Of the time of arrival, over the strain."""
    WAVE = 10
    """Of one mode; twice as long."""
    WORK = 12


GROUP_BUFFERS, SHARED_BUFFERS = 27, 14


class Geometry(IntEnum):
    """Of a row and a detector, beside its coefficients: derivatives by declination, and what is summed up."""

    PLUS = 0
    """Five coefficients, as in ``Coefficient``."""
    CROSS = 5
    DELAY = 10
    RECEDING = auto()
    SIDEWAYS = auto()
    ARRIVAL_DELAY = auto()
    """Of the delay that moves the detector, derivatives by hour angle and by declination, in seconds."""
    HOUR_BAR = 15
    DECLINATION_BAR = auto()
    POLARIZATION_BAR = auto()
    TIME_BAR = auto()


GEOMETRY = 19


def scratch_size(detectors: int, groups: int) -> int:
    """Numbers of working memory for one call."""
    own = (moving_kernel.COEFFICIENTS + GEOMETRY) * detectors
    return own + (GROUP_BUFFERS * groups + SHARED_BUFFERS) * BLOCK + 4 * LANES
