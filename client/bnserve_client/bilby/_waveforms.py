"""Waveforms of bilby's binaries by a model, with the zero points that were chosen; the last one is kept."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import (
    QUADRUPOLE,
    ByModes,
    by_modes,
    is_single,
    modes_of,
    turned,
)
from bnserve_client._lal_precession import precessing
from bnserve_client.bilby._arguments import Choice
from bnserve_client.bilby._zero_points import ZeroPoints
from bnserve_protocol import convert

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

INTRINSIC = ("mass_1", "mass_2", "a_1", "tilt_1", "a_2", "tilt_2", "lambda_1", "lambda_2")
"""bilby's names of what changes the modes of aligned spins."""
ORIENTATION = ("phi_12", "phi_jl", "theta_jn", "phase")
"""What else changes the waveform of a binary that precesses."""
_GRIDS_KEPT = 4


def binaries(theirs: Mapping[str, Any]) -> dict[str, Floats]:
    """Mass ratio, total mass, spins and tides, each ``(N,)``, of N binaries by the names of bilby's source models.

    Where ``mass_1 < mass_2`` the stars change places, as in LAL. What is no binary, a negative mass or NaN, is left to
    the model to refuse.

    Raises
    ------
    InvalidParameters
        A spin with a component in the orbital plane.
    """
    ours = convert({name: theirs[name] for name in INTRINSIC})
    return dict(zip(ours, np.broadcast_arrays(*map(np.atleast_1d, ours.values())), strict=True))


class _Grid:
    """Frequencies that are asked for together with those of the zero points, and where each are in the answer."""

    def __init__(self, frequencies: Floats, zero_points: ZeroPoints) -> None:
        self.frequencies, self.top = frequencies.copy(), float(frequencies[-1])
        of_zero_points = zero_points.frequencies(self.top)
        self.all = np.union1d(frequencies, of_zero_points)
        self.places = np.searchsorted(self.all, frequencies)
        self.zero_points = np.searchsorted(self.all, of_zero_points)


class Waveforms:
    """A model whose waveforms have the zero points that were chosen; it keeps the last one."""

    def __init__(self, choice: Choice) -> None:
        self._model = choice.find()
        self.modes = modes_of(self._model.description, choice.modes)
        self._zero_points = choice.zero_points
        self._grids: tuple[_Grid, ...] = ()
        self._last: tuple[_Grid, tuple[float, ...], Complex | None] | None = None

    def strain(self, frequencies: Floats, binary: tuple[float, ...]) -> Complex | None:
        """h ``(L, M)`` of the modes at 1 Mpc, at phase zero; of a binary that precesses, which is given with its
        orientation, both polarisations. None outside the model's range."""
        grid, last = self._grid(frequencies), self._last
        if last is None or last[0] is not grid or last[1] != binary:
            named = dict(zip((*INTRINSIC, *ORIENTATION), binary, strict=False))  # the last of them are its orientation
            evaluate = self._aligned if len(binary) == len(INTRINSIC) else self._precessing
            last = grid, binary, evaluate(grid, named)
            self._last = last  # all in one step: threads share it
        return last[2]

    def _grid(self, frequencies: Floats) -> _Grid:
        for known in self._grids:
            if np.array_equal(known.frequencies, frequencies):
                return known
        new = _Grid(frequencies, self._zero_points)
        self._grids = (new, *self._grids[: _GRIDS_KEPT - 1])
        return new

    def _aligned(self, grid: _Grid, binary: dict[str, float]) -> Complex | None:
        found, phase, time = self._with_shifts(grid, binary)
        if not np.isfinite(phase):
            return None
        h = found.h[0, : len(self.modes)][:, grid.places]
        return turned(h, self.modes, phase, time, grid.frequencies)

    def _with_shifts(self, grid: _Grid, binary: dict[str, float]) -> tuple[ByModes, float, float]:
        """The modes of aligned spins, and the phase and time by which they are shifted; NaN outside the range."""
        columns = binaries(binary)
        asked = tuple(dict.fromkeys([*self.modes, *QUADRUPOLE]))  # whose phase is looked at
        reference = self._zero_points.reference_frequency
        found = by_modes(self._model, grid.all, columns, asked, reference, "reference_frequency")
        if found.status[0] != 0:
            return found, np.nan, np.nan
        own = None if is_single(self._model.description) else np.zeros(1)
        of_22 = found.h[:, found.modes.index(QUADRUPOLE[0]), grid.zero_points]
        phase, time = self._zero_points.shifts(of_22, columns, grid.top, own)
        return found, float(phase[0]), float(time[0])

    def _precessing(self, grid: _Grid, binary: dict[str, float]) -> Complex | None:
        """With the zero points of the same binary without its spins in the orbital plane, seen from the same side."""
        reference, turn, time = self._zero_points.reference_frequency, 0.0, 0.0
        if self._zero_points.approximant is not None:
            along = {f"a_{star}": binary[f"a_{star}"] * np.cos(binary[f"tilt_{star}"]) for star in (1, 2)}
            twin = binary | along | {"tilt_1": 0.0, "tilt_2": 0.0}
            _, turn, time = self._with_shifts(_Grid(grid.frequencies[-1:], self._zero_points), twin)
            if not np.isfinite(turn):
                return None
        angles = binary | {"phase": binary["phase"] + 0.5 * turn}
        found = precessing(self._model, grid.frequencies, angles, self.modes, reference, "reference_frequency")
        if found.status[0] != 0:
            return None
        shift: Complex = np.exp(2j * np.pi * time * grid.frequencies)
        return np.stack([found.plus[0], found.cross[0]]) * shift


@functools.lru_cache(maxsize=16)
def waveforms_of(choice: Choice) -> Waveforms:
    """Of a choice; kept, with its connections and its last waveform. Raises as :func:`chosen_model`."""
    return Waveforms(choice)
