"""How fine the bins have to be through which data are seen."""

from __future__ import annotations

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._band import Band
from bnserve_inference._cells import POINTS, Cells
from bnserve_inference._fiducial import FiducialBasis, spread
from bnserve_inference._fine_bins import FineBins
from bnserve_inference._weights import LARGEST_TABLE
from bnserve_protocol import AnalysisInvalid, Calibration, FieldError, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]

MOST_POINTS = 2**16
"""They follow 24,000 radians; bins that may be used follow a third of that, four to a bin of what only has to be told
from the signal."""
_RADIANS = 3.0
"""Across a cell: see :mod:`._cells`."""
_LOG_CELLS, _AVERAGED = 4096, 32
"""Of a logarithmic grid of frequencies, on which it is known how fast ratios turn, and how many of them are averaged
where it is asked whether cells follow."""
_SPREAD = 8.0
"""So many times as far as the phases that place bins, cells follow whatever there may be: 250 radians."""
_MARGIN = 1.25
"""So many times as far as binaries that were seen, cells follow."""


class FineBinning:
    """Fine bins that become finer where what is looked at turns faster than they follow.

    Parameters
    ----------
    band, model, basis
        Of the analysis; the edges of the bins of the basis do not matter.
    times
        Range of arrivals in seconds after the trigger.
    calibration
        Errors that are to be followed, too.
    """

    def __init__(
        self, band: Band, model: WaveformModel, basis: FiducialBasis, times: tuple[float, float],
        calibration: Calibration | None,
    ) -> None:  # fmt: skip
        self._band, self._model, self._basis = band, model, basis
        self._centre, self._width, self._radians = 0.5 * (times[0] + times[1]), times[1] - times[0], _RADIANS
        self._edges = np.geomspace(band.f_min, band.f_max, _LOG_CELLS + 1)
        self._always = np.pi * self._width * np.diff(self._edges)
        if calibration is not None:  # a cell to a cell of its splines
            width = np.log(calibration.f_max / calibration.f_min) / (calibration.nodes - 1)
            self._always += _RADIANS / width * np.diff(np.log(self._edges))
        self._turns = _SPREAD * np.diff(spread(self._edges, band.f_min, band.f_max))
        self._bins: FineBins | None = None

    @property
    def bins(self) -> FineBins:
        """The fine bins; making them goes through all data."""
        if self._bins is None:
            turned = np.concatenate([[0.0], np.cumsum(self._always + self._turns)])
            places = (self._edges - self._band.f_min) * self._band.duration
            cells = Cells.turning(self._band.grid.count, turned, places, self._radians)
            self._refuse_huge(len(cells.points))
            self._bins = FineBins.of(self._band, self._basis, self._model, cells, self._centre)
        return self._bins

    def follow(self, binaries: ParameterBatch) -> bool:
        """Whether cells had to become finer for these; all that there may be follow only so far."""
        turns = self._turning(binaries)
        short = turns.reshape(-1, _AVERAGED).sum(axis=1) > _MARGIN * self._turns.reshape(-1, _AVERAGED).sum(axis=1)
        most = 0.5 * MOST_POINTS / POINTS * self._radians
        if not short.any() or self._turns.sum() >= 0.99 * most:
            return False
        turns = np.maximum(self._turns, _MARGIN * turns)
        self._turns = self._turns + (turns - self._turns) * min(
            1.0, (most - self._turns.sum()) / (turns.sum() - self._turns.sum())
        )
        self._bins = None
        return True

    def narrow(self) -> None:
        """Make all cells finer."""
        self._radians, self._bins = 0.7 * self._radians, None

    def _refuse_huge(self, points: int) -> None:
        groups = len(self._basis.orders)
        if 16 * points * len(self._band.detectors) * groups * (groups + 3) // 2 > LARGEST_TABLE:
            raise AnalysisInvalid(
                f"Arrivals over {self._width:.3g} s take {points} sums over the data of each detector, of more than "
                f"{LARGEST_TABLE // 2**20} MiB: narrow the prior of 'coalescence_time'.",
                errors=[FieldError(reason="too wide", parameter="coalescence_time", value=self._width)],
            )

    def _turning(self, binaries: ParameterBatch) -> Floats:
        """Radians by which the fastest ratio of an order turns in each cell of the logarithmic grid."""
        both = ParameterBatch(np.concatenate([self._basis.fiducial.values, binaries.values]))
        options, fastest = msgspec.structs.replace(self._basis.options, out_of_domain="flag"), np.zeros(_LOG_CELLS)
        for order in self._basis.orders:
            polar = self._model.predict_amplitude_phase(2.0 / order * self._edges, both, options=options)
            phases = np.asarray(polar.phase)[np.asarray(polar.status) == 0]
            turns = 0.5 * order * np.abs(np.diff(phases[1:] - phases[0], axis=1))
            fastest = np.maximum(fastest, turns.max(axis=0, initial=0.0))
        return fastest
