"""What the compiled derivatives and their caller agree on.

They are told what the kernel is told, in the same places (:class:`~bnserve_surrogate.kernel._layout.Argument`):
``FIRST`` are modes that were evaluated, complex128 ``(N, L, M)``, and ``SECOND`` is where the derivatives go,
complex128 ``(N, L, 6, M)``; without a plan L is 1, the (2, 2).
"""

from __future__ import annotations

from enum import IntEnum, auto

from bnserve_surrogate.kernel._layout import LANES

INTRINSIC = 5
"""Parameters that the regressor sees, the first columns of a ParameterBatch: q, Lambda_1, Lambda_2, chi_1, chi_2."""
AXES = 5
"""Coordinates that the regressor sees."""
TANGENTS = 6
"""Derivatives of a row: with respect to these, and to the total mass."""
MASS = 5
"""Place of the total mass among them."""
SETS = 7
"""A value and its derivatives."""
BLOCK = 128
"""Frequencies evaluated together: so many buffers of them stay near the processor."""
BUFFER = BLOCK + LANES
SERIES = 36
"""Coefficients of a series: 8 of the amplitude, 16 and 10 of the phase, the amplitude above M f = 0.02."""
WORK = 3 * 16
"""Coefficients of a phase in powers of v and log v."""
OF_PHASE, OF_AMPLITUDE = (2 + INTRINSIC) * WORK, (2 + INTRINSIC) * LANES
"""Floats for the derivatives of the coefficients, and before them for the complex numbers that they are made of."""
TOP = 3 * SETS + 3
"""Numbers of what is known where the band ends: of each set logarithm of the amplitude, phase and its slope."""


class Buffer(IntEnum):
    """What is kept of a block."""

    BARE = 0
    FROZEN = auto()
    MOVING = auto()
    AMPLITUDE = auto()
    PHASE = auto()
    H_REAL = auto()
    H_IMAGINARY = auto()
    RATIO_REAL = auto()
    RATIO_IMAGINARY = auto()
    A = auto()
    """The first of the derivatives of ln A; six of them, then six of the phase."""


BUFFERS = Buffer.A + 2 * TANGENTS


def row_size(amplitude_knots: int, phase_knots: int) -> int:
    """Floats of scratch of a row, for numbers of knots in whole vectors."""
    own = (4 * SETS + 1) * (amplitude_knots + phase_knots)
    return OF_PHASE + OF_AMPLITUDE + own + SETS * SERIES + 10 * LANES + TOP + BUFFERS * BUFFER
