"""What the compiled factorisation of whitened derivatives and its caller agree on."""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_surrogate.kernel._layout import LANES, Column

ARMS, ARM = 3, 5
"""Arms of a detector, and numbers of each: unit vector, weight, and length in light seconds. A response tensor is a sum
of squares along its axes: three arms of no length."""
INTRINSIC = 6
"""Parameters that the model differentiates."""
MASS = 5
"""Place of the total mass among them."""
FACTORS = 6
"""Numbers of a mode: what it counts in the plus polarisation and, complex, in the cross polarisation; and the
derivatives of these by the inclination."""
VECTORS = 32
"""Of eight nodes of as many detectors and orders that are folded into a triangle at once; they stay near the
processor."""
POLARIZATIONS = 8
"""Of a group of modes: value, derivative by the inclination, and by what is intrinsic; plus and cross, complex each."""
RESPONSE = 15
"""Vectors of a detector: see :class:`Response`."""


SKY = len(Column)
"""Where the derivatives by the sky begin, in the order of :class:`Sky`: after those by the columns of a batch, among
which the time of coalescence stands for its shift."""
COLUMNS = SKY + 3


class Sky(IntEnum):
    """What else is known of a row."""

    RIGHT_ASCENSION = 0
    DECLINATION = auto()
    POLARIZATION = auto()
    TIME = auto()
    """Arrival at the centre of the Earth, seconds from the trigger."""
    DISTANCE = auto()
    MASS = auto()


class Response(IntEnum):
    """Of a detector at eight nodes: F+ and Fx, complex, with their derivatives by hour angle and declination, and the
    delay with its own, in seconds."""

    PLUS = 0
    CROSS = 2
    PLUS_BY_HOUR = 4
    CROSS_BY_HOUR = 6
    PLUS_BY_DECLINATION = 8
    CROSS_BY_DECLINATION = 10
    DELAY = 12
    DELAY_BY_HOUR = auto()
    DELAY_BY_DECLINATION = auto()


class Argument(IntEnum):
    """What the factorisation is told in one call: a block of 64-bit integers, most of them addresses.

    P panels of eight nodes, of K frequencies; L modes in G groups, one for each order; D detectors.
    """

    MODES = 0
    GROUPS = auto()
    POINTS = auto()
    PANELS = auto()
    DETECTORS = auto()
    MOVES = auto()
    """1 where detectors move while the signal lasts."""
    SIDEREAL = auto()
    """float64 ``(2,)``: sidereal time at the trigger (radians) and its rate."""
    ARMS = auto()
    """float64 ``(D, 3, 5)``."""
    LOCATIONS = auto()
    """float64 ``(D, 3)``, light seconds."""
    WITH = auto()
    """int64 ``(curves, 1 + D)``: how many detectors have a noise curve, and which."""
    GROUP_OF = auto()
    """int64 ``(L,)``."""
    LEADING = auto()
    """int64 ``(G,)``: the mode whose phase says when a group passes the nodes."""
    ORDERS = auto()
    """int64 ``(G,)``: m."""
    FREQUENCIES = auto()
    """float64 ``(P, 8)``, Hz."""
    SCALES = auto()
    """float64 ``(P, 8)``: what whitens."""
    PLACES = auto()
    """int64 ``(P, 8)``: of the nodes among the K frequencies."""
    CURVE = auto()
    """int64 ``(P,)``."""
    APART = auto()
    """int64 ``(P,)``: 1 where groups are rows of their own."""
    SLOPES = auto()
    """float64 ``(P, 8, 8)``: what a phase at each node (first axis) counts in the passing time at each (second)."""
    ROWS = auto()
    STRAIN = auto()
    """complex128 ``(N, L, K)``."""
    DERIVATIVES = auto()
    """complex128 ``(N, L, 6, K)``; 0 for squares alone."""
    PHASES = auto()
    """float64 ``(N, G, K)``: of the leading modes, for squares alone of detectors that move."""
    MODE_FACTORS = auto()
    """float64 ``(N, L, 6)``."""
    SKY = auto()
    """float64 ``(N, 6)``, columns as in :class:`Sky`."""
    STATUS = auto()
    """uint8 ``(N,)``."""
    JACOBIAN = auto()
    """float64 ``(N, 13, 13)``: derivatives of the parameters by the coordinates."""
    PRIORS = auto()
    """Vectors of eight rows below the derivatives."""
    PRIOR_ROWS = auto()
    """float64 ``(13, PRIORS, 8)``."""
    ROOT = auto()
    """float64 ``(N, 13, 13)``."""
    SQUARES = auto()
    """float64 ``(N, D)``: of the signal-to-noise ratios."""
    WHITENED = auto()
    """float64 ``(N, vectors, 13, 8)``: the derivatives themselves, panel by panel, detector by detector, real and
    imaginary parts in turn; or 0."""
    WHITENED_SIZE = auto()
    """Vectors of a row."""
    CAPACITY = auto()
    """Vectors that are folded at once, at most."""
    SCRATCH = auto()


def scratch_size(detectors: int, capacity: int) -> int:
    """Numbers of working memory for one call."""
    vectors = COLUMNS * capacity + 4 * POLARIZATIONS + 2 * INTRINSIC + RESPONSE + detectors + 4
    return vectors * LANES + COLUMNS * COLUMNS
