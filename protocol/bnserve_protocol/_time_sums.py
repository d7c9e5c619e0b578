"""At which coalescence times a likelihood that is integrated over them is evaluated."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bnserve_protocol._analyses import AnalysisSettings

_TIMES_PER_CYCLE = 10.0
"""Of the band's width: <d|h> between the times is then interpolated to a few parts in 10^9 (``bnserve_inference``)."""
_FEWEST_STEPS = 11
"""So many times and one are interpolated together."""
_COUNTLESS = 2.0**53
"""Anything above is refused anyway."""


def time_steps(settings: AnalysisSettings) -> tuple[int, float]:
    """Into how many equal steps the integral over the coalescence time divides its range, and their length in seconds.

    They are as short as the band of the analysis asks for, and shorter where ``time_marginalisation.step`` is.
    """
    times = settings.time_marginalisation
    if times is None:
        return 0, 0.0
    width = times.maximum - times.minimum
    longest = 1.0 / (_TIMES_PER_CYCLE * (settings.f_max - settings.f_min + 1.0 / settings.duration))
    if times.step is not None:
        longest = min(longest, times.step)
    # The slack: a step that was made here stays as it is.
    count = max(_FEWEST_STEPS, math.ceil(min(width / longest, _COUNTLESS) - 1e-6))
    return count, width / count
