"""A fitted reduction and regressor as the tensors of a model."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.training.data.generators import FloatArray
from bnserve_surrogate.training.reduction.reductions import SCALARS, Reduction
from bnserve_surrogate.training.regressors import ExportedRegressor


def model_tensors(
    reduction: Reduction,
    regressor: ExportedRegressor,
    coordinates: CoordinateMap,
    mf_amplitude: FloatArray,
    mf_phase: FloatArray,
) -> dict[str, NDArray[Any]]:
    """The tensors of the (2, 2) mode, as :mod:`bnserve_surrogate._artifact` describes them."""
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
