"""Where bins have to be narrow: what waveforms do beside the fiducial one is measured.

A spline follows a phase of half a radian to a bin to a part in ten thousand, and loses one of more than three.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._fiducial import FiducialBasis, refuse_too_many, spread
from bnserve_inference._modes import QUADRUPOLE
from bnserve_protocol import Calibration, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]

_CELLS = 4096
"""Of a logarithmic grid: a part in a thousand in frequency, where no ratio turns by half a circle."""
_SMOOTHED = 41
"""Cells that are averaged, because splines like neighbours of similar widths: five per cent in frequency."""
_RADIANS, _LOUD = 0.4, 500.0
"""Across a bin, for a signal whose ln L is so large; the error of ln L goes with it and with the fourth power of the
phase across a bin."""
_MISLEADING = 4.0
"""What only has to be seen not to fit may turn so many times further."""
_FAINT = 0.4
"""Of a phase of what is not (2, 2), compared with its: the fourth root of 0.026, which no order has of its ln L."""
_PER_CALIBRATION_CELL = 3.0
_ROWS = 128
"""Of strain on the grid at once: 8 MiB."""


@dataclass(eq=False)
class Bins:
    """Bins around a fiducial waveform that narrow where they are found to be too wide.

    Parameters
    ----------
    basis
        The bins that do not serve.
    model
        Makes waveforms.
    calibration
        Errors that are to be followed, too.
    """

    basis: FiducialBasis
    model: WaveformModel
    calibration: Calibration | None
    _scale: float = field(default=1.0, init=False)
    _grid: Floats = field(init=False)
    _turns: Floats = field(init=False)

    def __post_init__(self) -> None:
        first, top = float(self.basis.linear_nodes[0]), float(self.basis.linear_nodes[-1])
        self._grid = np.geomspace(first, top, _CELLS + 1)
        self._grid[0], self._grid[-1] = first, top
        self._turns = np.diff(spread(self._grid, first, top))

    def see(self, binaries: ParameterBatch, misleading: bool) -> None:
        """Binaries that are to be followed, or told apart from those that fit."""
        for start in range(0, len(binaries), _ROWS):
            turns = self._turning(ParameterBatch(binaries.values[start : start + _ROWS]))
            self._turns = np.maximum(self._turns, turns / (_MISLEADING if misleading else 1.0))

    @property
    def followed(self) -> float:
        """Radians by which what was seen turns, over the whole band."""
        return float(self._turns.sum())

    def narrow(self, excess: float) -> None:
        """Make all of them narrower, because what was seen has errors of ``excess`` times what is allowed."""
        if excess > 1.0:
            self._scale *= min(max(1.1 * excess**0.25, 1.2), 2.0)

    def placed(self, log_likelihood: float) -> FiducialBasis:
        """Bins for all that was seen, in the likelihood of a signal that reaches ``log_likelihood``.

        Raises
        ------
        AnalysisInvalid
            They would be too many.
        """
        radians = min(1.0, _RADIANS * (_LOUD / max(log_likelihood, 1.0)) ** 0.25)
        density = self._turns / radians
        if self.calibration is not None:
            cells = np.log(self.calibration.f_max / self.calibration.f_min) / (self.calibration.nodes - 1)
            density = np.maximum(density, _PER_CALIBRATION_CELL / cells * np.diff(np.log(self._grid)))
        smooth = np.convolve(np.pad(density, _SMOOTHED // 2, "edge"), np.full(_SMOOTHED, 1.0 / _SMOOTHED), "valid")
        total = np.concatenate([[0.0], np.cumsum(self._scale * smooth)])
        bins = max(len(self.basis.linear_nodes) // 2, int(np.ceil(min(total[-1], 1e9))))
        refuse_too_many(
            bins, self.basis.grid.count, "What fits anywhere in the prior", "Narrow the prior, or state one"
        )
        edges = np.interp(np.linspace(0.0, total[-1], bins + 1), total, self._grid)
        edges[0], edges[-1] = self._grid[0], self._grid[-1]
        return self.basis.through(edges)

    def _turning(self, binaries: ParameterBatch) -> Floats:
        """Radians by which the fastest ratio turns in each cell, ``(_CELLS,)``."""
        both = ParameterBatch(np.concatenate([self.basis.fiducial.values, binaries.values]))
        fastest = np.zeros(_CELLS)
        for order in self.basis.orders:
            if order == QUADRUPOLE[1]:
                strain = np.asarray(self.model.predict_factored(self._grid, both, options=self.basis.options).h)
                ratios = strain[1:] * strain[0].conj()
                turns = np.abs(np.angle(ratios[:, 1:] * ratios[:, :-1].conj()))
            else:  # as the (2, 2) mode does that it goes with: an amplitude that changes sign is no phase
                x = 2.0 / order * self._grid
                phases = self.model.predict_amplitude_phase(x, both, options=self.basis.options).phase
                share = _FAINT if len(self.basis.orders) > 1 else 1.0
                turns = 0.5 * order * share * np.abs(np.diff(phases[1:] - phases[0], axis=1))
            fastest = np.maximum(fastest, turns.max(axis=0))
        return fastest
