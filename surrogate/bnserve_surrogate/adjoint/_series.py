"""From the sums over the frequencies of one order back to the coefficients of the post-Newtonian series."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.adjoint._layout import SERIES, Place, Series
from bnserve_surrogate.adjoint._sums import across
from bnserve_surrogate.baseline import AMPLITUDE_POWERS, PHASE_POWERS
from bnserve_surrogate.kernel._layout import LANES, Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_in, load
from bnserve_surrogate.tangents._layout import MASS
from bnserve_surrogate.tangents._series import FROZEN, LOGARITHMIC, PLAIN, SLOPE, log_nu_slope

Floats = NDArray[np.float64]

_LOGARITHMS = 7


@njit(**JIT_OPTIONS)
def gather(sums: Floats, lanes: Floats) -> Floats:
    """The sums over the lanes, which are cleared."""
    own = floats_in(sums, Place.IN_ALL, SERIES)
    for k in range(SERIES):
        own[k] = across(load(sums, Place.IN_LANES + LANES * k), lanes)
    for k in range(SERIES * LANES):
        sums[Place.IN_LANES + k] = 0.0
    return own


@njit(**JIT_OPTIONS)
def along_mass(own: Floats, series: Floats, over_mass: float) -> float:
    """The derivative with respect to the total mass: the sums times its ``series``."""
    found = own[Series.FROZEN] * series[FROZEN] + own[Series.MOVING] * over_mass
    for k in range(AMPLITUDE_POWERS):
        found += own[Series.BARE + k] * series[k]
    for k in range(PHASE_POWERS):
        found += own[Series.PLAIN + k] * series[PLAIN + k]
    for k in range(_LOGARITHMS + 1):
        found += own[Series.LOGARITHMIC + k] * series[LOGARITHMIC + k]
    return found - own[Series.PLAIN + 8] * series[SLOPE]


@njit(**JIT_OPTIONS)
def add_phase_at(own: Floats, there: float, value: float, slope: float) -> None:
    """Add bars of what is taken off the phase at one frequency, ``value``, and of its f d/df, ``slope``."""
    u, x = np.cbrt(there), np.log(there)
    power = u**-5
    for k in range(PHASE_POWERS):
        own[Series.PLAIN + k] += power * (value + slope * ((k - 5) / 3.0))
        if 5 <= k <= 11:
            own[Series.LOGARITHMIC + k - 5] += power * (x * value + slope * (1.0 + x * ((k - 5) / 3.0)))
        power *= u
    own[Series.LOGARITHMIC + _LOGARITHMS] += there * x * (x * value + slope * (x + 2.0))


@njit(**JIT_OPTIONS)
def series_back(
    own: Floats, row: Floats, unit: float, band: Floats, alignment: int, value: Floats, sums: Floats
) -> None:
    """Add the bars of the coefficients of both series, and of what the alignment takes off: see
    :func:`~bnserve_surrogate.tangents._series.fill_tangent_series`."""
    scale, power = (np.pi * unit) ** (1.0 / 3.0), value[0]
    for k in range(AMPLITUDE_POWERS):
        sums[Place.AMPLITUDE + k] += power * own[Series.BARE + k]
        power *= scale
    sums[Place.OWN + Column.MASS_RATIO] += own[Series.FROZEN] * value[FROZEN] * log_nu_slope(row[Column.MASS_RATIO])
    out, log_scale = floats_in(sums, Place.PHASE, (3, PHASE_POWERS)), np.log(scale)
    power = 1.0 / (scale * scale * scale * scale * scale)
    for k in range(PHASE_POWERS):
        plain, logarithmic = power * own[Series.PLAIN + k], 0.0
        if 5 <= k <= 11:
            logarithmic = power * own[Series.LOGARITHMIC + k - 5] / 3.0
        out[0, k] += plain
        out[1, k] += log_scale * plain + logarithmic
        out[2, k] += log_scale * (log_scale * plain + 2.0 * logarithmic)
        power *= scale
    out[2, 8] += np.pi * unit * own[Series.LOGARITHMIC + _LOGARITHMS] / 9.0
    # The constant and the slope of a phase, from which the series are taken off.
    constant, slope = 0.0 - own[Series.PLAIN + 5], 0.0 - own[Series.PLAIN + 8]
    sums[Place.GAUGE + 2 * alignment] -= constant
    sums[Place.GAUGE + 2 * alignment + 1] -= unit * slope
    if alignment == 1 and band[2] > 0.0:
        _legendre_back(band[2], constant, out)


@njit(**JIT_OPTIONS)
def _legendre_back(mf: float, bar: float, out: Floats) -> None:
    """Add the bars of a phase's coefficients of that of :func:`~bnserve_surrogate.kernel._series.legendre`."""
    v = (np.pi * mf) ** (1.0 / 3.0)
    log_v = np.log(v)
    power = bar * v**-5
    for k in range(PHASE_POWERS):
        rest = 1.0 - (k - 5) / 3.0
        out[0, k] += power * rest
        out[1, k] += power * (rest * log_v - 1.0 / 3.0)
        out[2, k] += power * log_v * (rest * log_v - 2.0 / 3.0)
        power *= v


@njit(**JIT_OPTIONS)
def add_coefficients(sums: Floats, phase: Floats, amplitude: Floats) -> None:
    """Add the bars of all coefficients times their derivatives, ``(5, 3, 16)`` and ``(5, 8)``."""
    for p in range(MASS):
        found = 0.0
        for k in range(3 * PHASE_POWERS):
            found += sums[Place.PHASE + k] * phase[3 * PHASE_POWERS * p + k]
        for k in range(AMPLITUDE_POWERS):
            found += sums[Place.AMPLITUDE + k] * amplitude[AMPLITUDE_POWERS * p + k]
        sums[Place.OWN + p] += found
