"""What the kernel is told in one call: a block of integers, most of them addresses."""

from __future__ import annotations

from enum import IntEnum, auto


class Argument(IntEnum):
    """What stands at each place of the block."""

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
    """float64 ``(N,)``: (1 + cos^2 iota) / 2."""
    CROSS = auto()
    """complex128 ``(N,)``: -i cos iota."""
    STATUS = auto()
    """uint8 ``(N,)``, a RowStatus each."""
    ESTIMATES = auto()
    """float64 ``(N,)``, or 0."""
    COUNT = auto()


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


OTHER_GRID = -1
"""What the kernel returns when the caller's frequencies are not the prepared ones; otherwise the number of bad rows."""
