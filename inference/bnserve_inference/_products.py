"""Inner products of data and signals in each detector, of the signals that samples describe."""

from __future__ import annotations

import msgspec
import numpy as np

from bnserve_inference._modes import modes_of
from bnserve_inference._rows import check_batch, row_statuses
from bnserve_inference._signals import signals_of
from bnserve_protocol import Analysis, DetectorProducts, LikelihoodBatch, RowStatus, WaveformModel, nothing_integrated

_TILE_POINTS = 2**16
_MOST_ROWS = 256


def of_detector(analysis: Analysis, name: str) -> Analysis:
    """The same analysis of one of its detectors, with nothing integrated."""
    arrays = {key: array for key, array in analysis.arrays.items() if "/" not in key or key.endswith(f"/{name}")}
    settings = msgspec.structs.replace(nothing_integrated(analysis.settings), detectors=(name,))
    return Analysis(settings=settings, arrays=arrays)


class ProductsByDetector:
    """Evaluates :class:`DetectorProducts`; a row's bits depend on the row, the analysis and the model alone.

    Each detector is an analysis of its own: the model is asked once for each, which makes a sample cost about twice as
    much as its likelihood does.

    Parameters
    ----------
    model, analysis
        Of the likelihood; what the analysis integrates over has to be given.

    Attributes
    ----------
    settings
        Of the analysis that samples are evaluated as: nothing is integrated.
    """

    def __init__(self, model: WaveformModel, analysis: Analysis) -> None:
        self.settings, self._description = nothing_integrated(analysis.settings), model.description
        self._signals = [signals_of(model, of_detector(analysis, name), None) for name in self.settings.detectors]
        modes = len(modes_of(self.settings, model.description))
        self._tile = min(_MOST_ROWS, max(1, _TILE_POINTS // (len(self._signals[0].frequencies) * modes)))

    def __call__(self, batch: LikelihoodBatch) -> DetectorProducts:
        """Those of N samples.

        Raises
        ------
        InvalidParameters
            Something is left out, or calibration errors that the analysis has no nodes for.
        """
        check_batch(batch, self.settings)
        status = row_statuses(batch, self.settings, self._description)
        shape = len(batch), len(self._signals)
        data, norms = np.full(shape, complex(np.nan, np.nan)), np.full(shape, np.nan)
        good = np.flatnonzero(status == RowStatus.OK)
        for start in range(0, len(good), self._tile):
            rows = good[start : start + self._tile]
            part = batch.rows(rows)
            for place, signals in enumerate(self._signals):
                tile = signals.tile(part, {})
                with np.errstate(invalid="ignore", over="ignore"):
                    inner = tile.contract(tile.sky, 1, 0.0, False)
                data[rows, place], norms[rows, place] = inner.data[:, 0, 0], inner.norms[0]
            found = np.array(tile.status)
            found[tile.empty & (found == RowStatus.OK)] = RowStatus.OUT_OF_BAND
            status[rows] = found
        finite = np.isfinite(data).all(axis=1) & np.isfinite(norms).all(axis=1)
        status[(status == RowStatus.OK) & ~finite] = RowStatus.NOT_FINITE
        bad = status != RowStatus.OK
        data[bad], norms[bad] = complex(np.nan, np.nan), np.nan
        return DetectorProducts(self.settings.detectors, data, norms, status)
