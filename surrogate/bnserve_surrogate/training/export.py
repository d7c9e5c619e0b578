"""A fitted reduction and regressor as the tensors of a model."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.training.data.baseline import merger_phase
from bnserve_surrogate.training.data.generators import FloatArray
from bnserve_surrogate.training.reduction.reductions import ReducedResiduals, Reduction
from bnserve_surrogate.training.regressors import ExportedRegressor

SCALARS = ("log_amplitude", "time_shift", "phase_shift")
"""Outputs of the regressor beside the components: what the match does not see."""


def regression_targets(
    reduced: ReducedResiduals, theta: FloatArray, reference_mf: float, start_mf: float
) -> FloatArray:
    """What the regressor learns, (N, k + 3): components, then the scalars of :data:`SCALARS`.

    Parameters
    ----------
    reduced:
        Of N residuals.
    theta:
        Their parameters.
    reference_mf:
        Where ``reduced.phase`` is taken.
    start_mf:
        Where the generator's phase starts from zero, or 0 if it does not.
    """
    intercept = reduced.phase - reduced.phase_slope * reference_mf
    if start_mf > 0.0:
        intercept = intercept + merger_phase(theta, start_mf)
    return np.column_stack([reduced.components, reduced.log_amplitude, reduced.phase_slope, intercept])


def model_tensors(
    reduction: Reduction,
    regressor: ExportedRegressor,
    coordinates: CoordinateMap,
    mf_amplitude: FloatArray,
    mf_phase: FloatArray,
) -> dict[str, NDArray[Any]]:
    """The tensors of the (2, 2) mode, as :mod:`bnserve_surrogate._tensors` describes them."""
    amplitude, phase = reduction.node_bases()
    components = len(amplitude.basis)
    basis = np.zeros((components + len(SCALARS), len(mf_amplitude) + len(mf_phase)))
    basis[:components] = np.hstack([amplitude.basis, phase.basis])
    basis[components, : len(mf_amplitude)] = 1.0
    merger_alignment = np.zeros((components + len(SCALARS) + 1, 2))
    merger_alignment[-2, 1] = 1.0
    merger_alignment[-1, 0] = 1.0
    tensors = {
        "amplitude_nodes": mf_amplitude,
        "phase_nodes": mf_phase,
        "mean": np.concatenate([amplitude.mean, phase.mean]),
        "basis": basis,
        "merger_alignment": merger_alignment,
        "coordinate_offset": coordinates.offset,
        "coordinate_scale": coordinates.scale,
        **regressor.arrays,
    }
    return {f"22/{name}": np.ascontiguousarray(tensor) for name, tensor in tensors.items()}
