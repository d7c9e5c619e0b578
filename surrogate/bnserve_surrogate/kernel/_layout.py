"""What the compiled kernel and its caller agree on: where everything stands in memory, and how wide it is."""

from __future__ import annotations

from enum import IntEnum, auto

LANES = 8
"""Rows evaluated together, and doubles in a vector: sections of the weights are padded to whole vectors."""
TILE, WIDE = 4, 4 * LANES
"""Rows and columns of a block of a matrix product that is held in registers."""
BLOCK = 1024
"""Frequencies evaluated together: the scratch of a block stays in the first-level cache."""
CACHE_LINE, STREAMED = 64, 2**22
"""Bytes of a cache line, and of a result from which on it is written past the caches."""
MODE_BLOCK = 256
"""The same where modes are summed, which takes twice as many buffers."""
DENSE = 2048
"""Frequencies from which on a grid is dense: worth polynomials in every cell of the band. For a sum over modes each
frequency counts once for every order m."""
ACTIVATIONS = {"tanh": 0, "relu": 1, "logistic": 2}
COORDINATES = {"raw": 0, "physical": 1, "symmetric": 2}
MAX_DEGREE = 64
"""Highest degree of a Chebyshev polynomial in a model."""
MAX_WIDTH = 1024
"""Widest layer of a network in a model."""
ANY = 1 << 30
"""For parts of the scratch and of the weights whose length nothing asks for."""
EDGE = 1e-9
"""Relative width by which a frequency may miss the band's edge through rounding and still be inside."""
MOST_PHASE = 1e14
"""Radians; doubles of this size are 0.016 apart, and of 1e16 more than a turn."""
LEAST_MF = 1e-9
"""M f below which the post-Newtonian phase exceeds that: 7e-5 Hz at 2.8 solar masses."""
OTHER_GRID = -1
"""What the kernel returns when the caller's frequencies are not the prepared ones; otherwise the number of bad rows."""


def padded(count: int) -> int:
    """``count`` rounded up to whole vectors."""
    return -(-count // LANES) * LANES


class Column(IntEnum):
    """What stands in each column of a batch of parameters."""

    MASS_RATIO = 0
    LAMBDA_1 = auto()
    LAMBDA_2 = auto()
    CHI_1 = auto()
    CHI_2 = auto()
    DISTANCE = auto()
    INCLINATION = auto()
    TOTAL_MASS = auto()
    REFERENCE_PHASE = auto()
    TIME_SHIFT = auto()


COLUMNS = len(Column)


class Argument(IntEnum):
    """What the kernel is told in one call: a block of 64-bit integers, most of them addresses."""

    ROWS = 0
    PARAMETERS = auto()
    """float64 ``(N, 10)``, the columns of a ParameterBatch."""
    POINTS = auto()
    GRID = auto()
    """float64 ``(5, STRIDE)``: f in Hz, log f, f^(1/3), f^(-5/3), f^(-7/6), each with whole vectors beyond its end."""
    STRIDE = auto()
    BINS = auto()
    """Bins of equal width in log f between the first and the last frequency."""
    TABLE = auto()
    """int64 ``(BINS + 1,)``: the first frequency in each bin or after it; then M."""
    GIVEN = auto()
    """The caller's frequencies, to be compared with the prepared ones, or 0."""
    CONTENTS = auto()
    EXPONENTS = auto()
    WEIGHTS = auto()
    ALIGNMENT = auto()
    POLICY = auto()
    """Sum of :class:`Policy`."""
    SCRATCH = auto()
    OUTPUT = auto()
    """An :class:`Output`."""
    FIRST = auto()
    """``(N, M)``: h or h_plus, complex; or the amplitude."""
    SECOND = auto()
    """``(N, M)``: h_cross or the phase; or 0."""
    PLUS = auto()
    """float64 ``(N,)``: (1 + cos^2 iota) / 2; ``(N, L)`` for L modes."""
    CROSS = auto()
    """complex128 ``(N,)``: -i cos iota; ``(N, L)`` for L modes."""
    STATUS = auto()
    """uint8 ``(N,)``, a RowStatus each."""
    ESTIMATES = auto()
    """float64 ``(N,)``, or 0."""
    MODES = auto()
    """A :class:`Plan`, or 0 for the (2, 2) alone. With one ``FIRST`` is ``(N, L, M)`` where strain is asked for."""


class Policy(IntEnum):
    """How rows outside the domain or the band are treated."""

    BELOW_BAND_IS_ERROR = 1
    ABOVE_BAND_IS_ERROR = 2
    STOP_AT_BAD_ROWS = 4


class Output(IntEnum):
    """What is computed."""

    STRAIN = 0
    STRAIN_SINGLE = auto()
    POLARIZATIONS = auto()
    POLARIZATIONS_SINGLE = auto()
    AMPLITUDE_PHASE = auto()


class Plan(IntEnum):
    """Which modes are evaluated: int64, these, then for each mode what stands at the places of :class:`PlanMode`."""

    MODES = 0
    ORDERS = auto()
    """How many different m."""
    NUMBERS = auto()
    """Address of float64: five coefficients of each mode's harmonic, see :mod:`..modes._harmonics`; then the end of the
    band in M f, its coordinate in its cell, and v there."""
    LINEAR = auto()
    """Floats that the linear synthesis of eight rows takes, of all modes but the (2, 2)."""
    TOP_CELL = auto()
    """The cell in which the band ends."""
    SLOWEST = auto()
    """The highest m, or 2: the lowest M f at which there is a phase is half of it times that of the (2, 2)."""


class PlanMode(IntEnum):
    """What is known of a mode; those of one m follow each other."""

    ORDER = 0
    """m."""
    PLACE = auto()
    """Its number in the answer."""
    POWER = auto()
    """Of v in its ratio to the carrier; 0 for the (2, 2), which has no arrays of its own."""
    CONTENTS = auto()
    EXPONENTS = auto()
    WEIGHTS = auto()
    LINEAR_AT = auto()
    ENDS_OF = auto()
    """The first mode that has the same m and knots."""
    ESTIMATES = auto()
    """Whether its last output is the logarithm of an error."""


class Entry(IntEnum):
    """What stands at each place of the table of contents; the ``*_AT`` are positions in the weights."""

    COORDINATES = 0
    TERMS = auto()
    DEGREE = auto()
    OUTPUTS = auto()
    LAYERS = auto()
    WIDEST = auto()
    ACTIVATION = auto()
    AMPLITUDE_NODES = auto()
    PHASE_NODES = auto()
    SHARED_NODES = auto()
    COORDINATES_AT = auto()
    COEFFICIENTS_AT = auto()
    NETWORK_AT = auto()
    SYNTHESIS_AT = auto()
    AMPLITUDE_KNOTS_AT = auto()
    PHASE_KNOTS_AT = auto()
    BAND_AT = auto()
    LIMITS_AT = auto()
    CELLS = auto()
    CELLS_AT = auto()
    OWNERS_AT = auto()
    LAYER_SIZES = auto()
