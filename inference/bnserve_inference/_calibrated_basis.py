"""A basis of waveforms under calibration errors.

The squared moduli of waveforms are so alike that a handful of nodes tells them apart, and far too few to sample the
errors; they are also smooth, so that splines serve instead.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._fiducial import FiducialBasis
from bnserve_protocol import ParameterBatch, WaveformModel

_QUADRATIC_TOLERANCE = 1.0
"""Radians of phase to a cell of the splines: some thirty nodes, dense at both ends of the band."""


@dataclass(frozen=True, eq=False)
class CalibratedBasis:
    """The linear rows of a basis, and splines of squared moduli around one binary of it for the quadratic ones."""

    basis: Any
    smooth: FiducialBasis

    @classmethod
    def around(
        cls, basis: Any, reference: ParameterBatch, frequencies: NDArray[np.float64], model: WaveformModel
    ) -> CalibratedBasis:
        """With splines on the grid ``frequencies`` (Hz), around the binary ``reference``."""
        smooth = FiducialBasis.build(frequencies, reference, model, _QUADRATIC_TOLERANCE, basis.alignment)
        return cls(basis, smooth)

    @property
    def linear_nodes(self) -> NDArray[np.float64]:
        """Those of the basis."""
        nodes: NDArray[np.float64] = self.basis.linear_nodes
        return nodes

    @property
    def quadratic_nodes(self) -> NDArray[np.float64]:
        """Those of the splines."""
        return self.smooth.quadratic_nodes

    def linear_chunks(self, model: WaveformModel) -> Iterator[tuple[slice, NDArray[np.complex128]]]:
        """Those of the basis."""
        yield from self.basis.linear_chunks(model)

    def quadratic_chunks(self, model: WaveformModel) -> Iterator[tuple[slice, NDArray[np.float64]]]:
        """Those of the splines."""
        yield from self.smooth.quadratic_chunks(model)
