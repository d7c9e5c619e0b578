"""What the compiled contraction of several modes and its caller agree on."""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_inference.kernel._layout import BLOCK

GROUP_BLOCKS = 2
"""Blocks of nodes that each group needs: its strain's real and imaginary parts."""
SHARED_BLOCKS = 4
"""Calibration errors, or products; and oscillations at a time: two each."""


class Argument(IntEnum):
    """What the contraction is told in one call: a block of 64-bit integers, most of them addresses.

    Modes come in G groups, and the modes of one are summed in each detector before they meet weights. There are J nodes
    of D detectors, padded with zero weights to whole lanes where the array says so, and P = G (G + 1) / 2 pairs of
    groups: (0, 0), (0, 1), ..., (1, 1), ...
    """

    DETECTORS = 0
    MODES = auto()
    GROUPS = auto()
    POINTS = auto()
    """J: all nodes, on which the strain is given."""
    KNOTS = auto()
    """Rows of a table of linear weights: one, or one for each knot of a spline in time."""
    SHARED = auto()
    """1 where all groups have the same linear weights, and all pairs the same real ones; 0 where each has its own."""
    TIME_GRID = auto()
    """float64 ``(2,)``: time of the first knot and between knots, seconds."""
    SIDEREAL = auto()
    """float64 ``(2,)``: sidereal time at the trigger (radians) and its rate."""
    RESPONSES = auto()
    """float64 ``(D, 3, 3)``."""
    LOCATIONS = auto()
    """float64 ``(D, 3)``, metres."""
    NODES = auto()
    """float64, padded: their frequencies, Hz."""
    GROUP_OF = auto()
    """int64 ``(MODES,)``."""
    LINEAR_WEIGHTS = auto()
    """float64 ``(D, G, KNOTS, 2, padded J)``: real parts, then imaginary parts; 1 for G where they are shared."""
    PAIR_WEIGHTS = auto()
    """What conj(h) h' is multiplied with, float64: ``(D, P, 2, padded J)``, real parts, then imaginary parts; or
    ``(D, padded J)`` where they are shared."""
    SPLINES = auto()
    """float64 ``(CALIBRATION_NODES, padded J)``."""
    ROWS = auto()
    STRAIN = auto()
    """complex128 ``(ROWS, MODES, POINTS)``."""
    PLUS = auto()
    """float64 ``(ROWS, MODES)``: h_plus is the sum of this times the strain."""
    CROSS = auto()
    """complex128 ``(ROWS, MODES)``, likewise."""
    SKY = auto()
    """float64 ``(ROWS, 7)``, columns as in :class:`bnserve_inference.kernel.Sky`; its factors of the strain are those
    of a plus polarisation that counts as the real part and a cross polarisation as the imaginary part."""
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
    PAIRS = auto()
    """complex128 ``(ROWS, P)``: <h|h'> of each pair of groups."""
    SPECTRUM = auto()
    """complex128 ``(ROWS, G, J)``: terms of the sum over nodes at the last time; or 0."""
    SCRATCH = auto()


def scratch_size(detectors: int, modes: int, groups: int) -> int:
    """Numbers of working memory for one call."""
    return 3 * detectors + 2 * detectors * modes + (GROUP_BLOCKS * groups + SHARED_BLOCKS) * BLOCK
