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
    """What a contraction is told in one call: a block of 64-bit integers, most of them addresses.

    Those of the analysis come first and stay, for D detectors, L linear and Q quadratic nodes, padded with zero
    weights to whole lanes where the array says so. With one mode G, for groups, is 1. Several modes come in G groups,
    and those of one are summed in each detector before they meet weights; there are P = G (G + 1) / 2 pairs of groups,
    (0, 0), (0, 1), ..., (1, 1), ..., and one list of nodes, linear and quadratic.
    """

    DETECTORS = 0
    POINTS = auto()
    """Frequencies on which the strain is given."""
    KNOTS = auto()
    """Rows of a table of linear weights: one, or one for each knot of a spline in time."""
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
    LINEAR_WEIGHTS = auto()
    """float64 ``(D, G, KNOTS, 2, padded L)``: real parts, then imaginary parts; 1 for G where they are shared."""
    QUADRATIC_WEIGHTS = auto()
    """float64 ``(D, padded Q)``: what conj(h) h is multiplied with, and conj(h) h' where weights are shared; else
    ``(D, P, 2, padded Q)``, real parts, then imaginary parts."""
    LINEAR_SPLINES = auto()
    """float64 ``(CALIBRATION_NODES, padded L)``."""
    # Of one mode.
    LINEAR = auto()
    QUADRATIC = auto()
    LINEAR_AT = auto()
    """int64 ``(L,)``: their places among the strain's frequencies."""
    QUADRATIC_AT = auto()
    QUADRATIC_SPLINES = auto()
    # Of several modes.
    MODES = auto()
    GROUPS = auto()
    SHARED = auto()
    """1 where all groups have the same linear weights, and all pairs the same real ones; 0 where each has its own."""
    GROUP_OF = auto()
    """int64 ``(MODES,)``."""
    # Of a call.
    ROWS = auto()
    STRAIN = auto()
    """complex128 ``(ROWS, POINTS)``, of several modes ``(ROWS, MODES, POINTS)``."""
    SKY = auto()
    """float64 ``(ROWS, 7)``, columns as in :class:`Sky`. Of several modes, its factors of the strain are those of a
    plus polarisation that counts as the real part and a cross polarisation as the imaginary part."""
    CALIBRATION_NODES = auto()
    """0 for no errors."""
    AMPLITUDE_ERRORS = auto()
    """float64 ``(ROWS, D, CALIBRATION_NODES)``."""
    PHASE_ERRORS = auto()
    TIMES = auto()
    STEP = auto()
    """The bits of a float64: seconds between times of arrival."""
    PRODUCTS = auto()
    """complex128 ``(ROWS, G, TIMES)``: <d|h> of each group."""
    NORMS = auto()
    """float64 ``(ROWS,)``: <h|h>; of several modes complex128 ``(ROWS, P)``: <h|h'> of each pair of groups."""
    SPECTRUM = auto()
    """complex128 ``(ROWS, G, L)``: terms of the sum over nodes at the last time; or 0."""
    SCRATCH = auto()
    PLUS = auto()
    """float64 ``(ROWS, MODES)``, of several modes: h_plus is the sum of this times the strain."""
    CROSS = auto()
    """complex128 ``(ROWS, MODES)``, likewise."""


def scratch_size(detectors: int) -> int:
    """Numbers of working memory for one call."""
    return 3 * detectors + 8 * BLOCK
