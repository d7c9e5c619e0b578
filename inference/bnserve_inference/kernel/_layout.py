"""What the compiled contraction and its caller agree on."""

from __future__ import annotations

from enum import IntEnum, auto

BLOCK = 512
"""Nodes that are worked on at once: their scratch memory stays in the first cache. A multiple of the lanes of a sum."""


class Sky(IntEnum):
    """The columns that describe where a row's signal comes from."""

    RIGHT_ASCENSION = 0
    DECLINATION = auto()
    POLARIZATION = auto()
    TIME = auto()
    """Arrival at the centre of the Earth, seconds from the trigger."""
    PLUS = auto()
    """h_plus is this times the strain of the mode."""
    CROSS_REAL = auto()
    CROSS_IMAGINARY = auto()
    """h_cross is this complex number times the strain of the mode."""


class Argument(IntEnum):
    """What the contraction is told in one call: a block of 64-bit integers, most of them addresses.

    Those of the analysis come first and stay, for D detectors, L linear and Q quadratic nodes, padded with zero
    weights to whole lanes where the array says so.
    """

    DETECTORS = 0
    POINTS = auto()
    """Frequencies on which the strain is given."""
    LINEAR = auto()
    QUADRATIC = auto()
    KNOTS = auto()
    """Rows of a detector's table of linear weights: one, or one for each knot of a spline in time."""
    TIME_GRID = auto()
    """float64 ``(2,)``: time of the first knot and between knots, seconds."""
    SIDEREAL = auto()
    """float64 ``(2,)``: sidereal time at the trigger (radians) and its rate."""
    RESPONSES = auto()
    """float64 ``(D, 3, 3)``."""
    LOCATIONS = auto()
    """float64 ``(D, 3)``, metres."""
    NODES = auto()
    """float64, padded: frequencies of the linear nodes, Hz."""
    LINEAR_AT = auto()
    """int64 ``(L,)``: their places among the strain's frequencies."""
    QUADRATIC_AT = auto()
    LINEAR_WEIGHTS = auto()
    """float64 ``(D, KNOTS, 2, padded L)``: real parts, then imaginary parts."""
    QUADRATIC_WEIGHTS = auto()
    """float64 ``(D, padded Q)``."""
    LINEAR_SPLINES = auto()
    """float64 ``(CALIBRATION_NODES, padded L)``."""
    QUADRATIC_SPLINES = auto()
    ROWS = auto()
    STRAIN = auto()
    """complex128 ``(ROWS, POINTS)``."""
    SKY = auto()
    """float64 ``(ROWS, 7)``, columns as in :class:`Sky`."""
    CALIBRATION_NODES = auto()
    """0 for no errors."""
    AMPLITUDE_ERRORS = auto()
    """float64 ``(ROWS, D, CALIBRATION_NODES)``."""
    PHASE_ERRORS = auto()
    TIMES = auto()
    STEP = auto()
    """The bits of a float64: seconds between times of arrival."""
    PRODUCTS = auto()
    """complex128 ``(ROWS, TIMES)``: <d|h>."""
    NORMS = auto()
    """float64 ``(ROWS,)``: <h|h>."""
    SPECTRUM = auto()
    """complex128 ``(ROWS, L)``: terms of the sum over nodes at the last time; or 0."""
    SCRATCH = auto()


def scratch_size(detectors: int) -> int:
    """Numbers of working memory for one call."""
    return 3 * detectors + 8 * BLOCK
