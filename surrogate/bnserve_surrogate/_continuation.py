"""Phases above the trained band, where the strain is zero: straight lines, so that no difference sees an edge."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import PARAMETER_NAMES, SOLAR_MASS_SECONDS, MergerStencil, ParameterBatch

_EDGE = 1e-9
"""The kernel's: the relative width by which a frequency may miss the band's top through rounding."""
_TOTAL_MASS, _PHASE, _TIME = (PARAMETER_NAMES.index(name) for name in ("total_mass", "reference_phase", "time_shift"))

Phases = Callable[[NDArray[np.float64], ParameterBatch], NDArray[np.float64]]
"""Frequencies in Hz (n,) and N binaries to continuous phases in radians (N, n)."""


def continue_above(
    phase: NDArray[np.float64],
    frequencies: NDArray[np.float64],
    batch: ParameterBatch,
    evaluated: NDArray[np.bool_],
    mf_top: float,
    mass: float,
    phases: Phases,
) -> None:
    """Write into ``phase`` what stands above the band: the line with the phase's value and slope at its top.

    What is written at a frequency does not depend on the other frequencies. The line is found at one mass,
    at one place for all rows, because a phase is a function of total mass times frequency but for its shifts.

    Parameters
    ----------
    phase:
        (N, M) radians, overwritten above the band.
    frequencies:
        (M,) increasing, in Hz.
    batch:
        The N binaries.
    evaluated:
        (N,) whether the row has values; others are left as they are.
    mf_top:
        The top of the band in M f (dimensionless).
    mass:
        A total mass in the model's range, in solar masses.
    phases:
        Evaluates phases with the alignment of ``phase``.
    """
    top = mf_top / (mass * SOLAR_MASS_SECONDS)
    if frequencies[-1] * batch.values[:, _TOTAL_MASS].max(initial=0.0) <= top * mass:  # nearly always, and quick
        return
    scale = batch.values[:, _TOTAL_MASS] / mass
    rows = np.flatnonzero(evaluated & (frequencies[-1] * scale > top * (1.0 + _EDGE)))
    if not len(rows):
        return
    stencil = MergerStencil(top, from_below=True)
    unshifted = batch.values[rows]
    unshifted[:, _TOTAL_MASS] = mass
    unshifted[:, [_PHASE, _TIME]] = 0.0
    below = phases(stencil.frequencies, ParameterBatch(unshifted))
    slope, own = stencil.slope(below), batch.values[rows]
    constant = below[:, -1] - slope * top + own[:, _PHASE]
    gradient = slope * scale[rows] + 2.0 * np.pi * own[:, _TIME]
    firsts = np.searchsorted(frequencies, top * (1.0 + _EDGE) / scale[rows], side="right")
    for row, first, offset, factor in zip(rows, firsts, constant, gradient, strict=True):
        line = np.multiply(frequencies[first:], factor, out=phase[row, first:])
        line += offset
