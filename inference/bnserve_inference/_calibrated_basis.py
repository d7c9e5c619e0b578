"""A basis of waveforms under calibration errors.

The squared moduli of waveforms are so alike that a handful of nodes tells them apart, and far too few to sample the
errors; they are also smooth, so that splines serve instead. Whether the linear rows can stand the errors is measured.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._calibration import calibration_splines
from bnserve_inference._fiducial import FiducialBasis
from bnserve_protocol import AnalysisInvalid, Calibration, EvaluationOptions, FieldError, ParameterBatch, WaveformModel

CALIBRATION_TOLERANCE = 3e-3
"""Of the norm of what is missing of a calibrated waveform, as a part of its own, beyond twice what is missing of the
waveform itself; times the signal-to-noise ratio it is an error of ln L."""
_SIZE = 0.03
"""Typical errors: relative in amplitude, radians in phase."""
_DRAWS = 8


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


def calibration_error(
    basis: Any,
    model: WaveformModel,
    reference: ParameterBatch,
    frequencies: NDArray[np.float64],
    density: NDArray[np.float64],
    calibration: Calibration,
) -> tuple[float, float]:
    """Norm of the interpolation error of C h over the norm of h: the largest of some calibrations C, and that without.

    Parameters
    ----------
    basis, model, reference:
        The basis, the model it was built for, and a binary inside it.
    frequencies, density:
        Grid in Hz and 1 / S there, ``(M,)``, in any unit.
    calibration:
        The nodes; errors of 0.03 are drawn at each.
    """
    options = EvaluationOptions(alignment=basis.alignment)
    draw = np.random.default_rng(0).normal(0.0, _SIZE, (2, _DRAWS, calibration.nodes))
    draw[:, 0] = 0.0

    def calibrated(f: NDArray[np.float64], strain: NDArray[np.complex128]) -> NDArray[np.complex128]:
        amplitude, phase = draw @ calibration_splines(calibration, f)
        result: NDArray[np.complex128] = strain * (1.0 + amplitude) * np.exp(1j * phase)
        return result

    nodes = basis.linear_nodes
    at_nodes = calibrated(nodes, model.predict_factored(nodes, reference, options=options).h[0])
    errors, norm = np.zeros(_DRAWS), 0.0
    for place, rows in basis.linear_chunks(model):
        strain = model.predict_factored(frequencies[place], reference, options=options).h[0]
        missing = at_nodes @ rows - calibrated(frequencies[place], strain)
        errors += np.square(np.abs(missing)) @ density[place]
        norm += float(np.square(np.abs(strain)) @ density[place])
    found = np.sqrt(errors / norm)
    return float(found.max()), float(found[0])


def refuse_uncalibrated(error: float, without: float) -> None:
    """Refuse a basis whose :func:`calibration_error` is not within :data:`CALIBRATION_TOLERANCE`.

    Raises
    ------
    AnalysisInvalid
    """
    if error > 2.0 * without + CALIBRATION_TOLERANCE:
        raise AnalysisInvalid(
            f"The basis cannot stand calibration errors: errors of {_SIZE} at the nodes leave {error:.2g} of a "
            f"waveform's norm out, and no errors {without:.2g}: calibrated waveforms are not in its span. Use relative "
            "binning, build the basis with calibrated waveforms, or leave the calibration out.",
            errors=[FieldError(reason="outside of the span of the basis", parameter="calibration", value=error)],
        )
