"""What the compiled contraction and its caller agree on."""

from __future__ import annotations

import enum

LANES = 8
"""Width of a sum; nodes are padded with zero weights to a multiple of it."""

BLOCK = 512
"""Nodes that are worked on at once: their scratch memory stays in the first cache. A multiple of LANES."""


class Sky(enum.IntEnum):
    """The columns that describe where a row's signal comes from."""

    RIGHT_ASCENSION = 0
    DECLINATION = 1
    POLARIZATION = 2
    TIME = 3
    """Arrival at the centre of the Earth, seconds from the trigger."""
    PLUS = 4
    """h_plus is this times the strain of the mode."""
    CROSS_REAL = 5
    CROSS_IMAGINARY = 6
    """h_cross is this complex number times the strain of the mode."""


def scratch_size(detectors: int) -> int:
    """Numbers of working memory for one call."""
    return 3 * detectors + 8 * BLOCK
