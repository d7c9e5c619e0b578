"""The continuous phase of a mode whose strain is known: that of its carrier, and that of its ratio to it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import PARAMETER_NAMES, SOLAR_MASS_SECONDS, ParameterBatch

Floats = NDArray[np.float64]
_PLACES = 256
"""Frequencies on which a ratio's phase is followed: where a mode's sign changes, it turns by pi between a few nodes."""
_DISTANCE, _TOTAL_MASS, _PHASE, _TIME = (
    PARAMETER_NAMES.index(name) for name in ("distance_mpc", "total_mass", "reference_phase", "time_shift")
)


class ModePhases(NamedTuple):
    """How a mode is evaluated.

    Parameters
    ----------
    carrier
        Its phase without that of the ratio, ``(N, M)``, of frequencies in Hz and N binaries.
    strain
        The mode itself, likewise.
    band
        The first M f at which the ratio varies, and the end of the band.
    mass
        Solar masses at which ratios are followed: one for all, so that nothing depends on it.
    """

    carrier: Callable[[Floats, ParameterBatch], Floats]
    strain: Callable[[Floats, ParameterBatch], NDArray[np.complex128]]
    band: tuple[float, float]
    mass: float

    def continuous(self, f: Floats, batch: ParameterBatch, h: NDArray[np.complex128]) -> Floats:
        """The phase of ``h``, ``(N, M)``, at frequencies ``f`` in Hz, up to no multiple of 2 pi.

        What it is at a frequency does not depend on the other frequencies. Above the band, where ``h`` is zero, it is
        that of the carrier, and the ratio's stays.
        """
        carrier = self.carrier(f, batch)
        own = np.angle(h * np.exp(-1j * carrier))
        known, turned = self._followed(batch)
        with np.errstate(divide="ignore", invalid="ignore"):  # rows that are flagged have any mass
            places = np.log(f * (batch.values[:, _TOTAL_MASS, None] * SOLAR_MASS_SECONDS))
        for row, near in enumerate(turned):
            expected = np.interp(places[row], known, near)
            turns = np.round((expected - own[row]) / (2.0 * np.pi))
            own[row] = np.where(h[row] == 0.0, expected, own[row] + 2.0 * np.pi * turns)
        return carrier + own

    def _followed(self, batch: ParameterBatch) -> tuple[Floats, Floats]:
        """The phase of the ratio in the band: log(M f), ``(K,)``, and phases, ``(N, K)``."""
        values = batch.values.copy()
        values[:, [_PHASE, _TIME]] = 0.0
        values[:, _DISTANCE], values[:, _TOTAL_MASS] = 1.0, self.mass
        mf = np.geomspace(*self.band, _PLACES)
        f, binaries = mf / (self.mass * SOLAR_MASS_SECONDS), ParameterBatch(values)
        ratio = self.strain(f, binaries) * np.exp(-1j * self.carrier(f, binaries))
        return np.log(mf), np.unwrap(np.angle(ratio), axis=1)
