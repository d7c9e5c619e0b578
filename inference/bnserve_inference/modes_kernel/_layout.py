"""What the compiled contraction of several modes and its caller agree on, beyond the arguments of any contraction."""

from __future__ import annotations

from bnserve_inference.kernel._layout import BLOCK

GROUP_BLOCKS = 2
"""Blocks of nodes that each group needs: its strain's real and imaginary parts."""
SHARED_BLOCKS = 4
"""Calibration errors, or products; and oscillations at a time: two each."""


def scratch_size(detectors: int, modes: int, groups: int) -> int:
    """Numbers of working memory for one call."""
    return 3 * detectors + 2 * detectors * modes + (GROUP_BLOCKS * groups + SHARED_BLOCKS) * BLOCK
