"""From a grown basis to the interpolant that is kept."""

from __future__ import annotations

from typing import Any

import numpy as np

from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._family import Family
from bnserve_inference.roq._growth import Elements, Growth
from bnserve_inference.roq._interpolant import AnyArray, WaveformInterpolant
from bnserve_inference.roq._interpolation import lebesgue_constant, squared_norms
from bnserve_inference.roq._orthonormal import orthogonality_loss
from bnserve_protocol import ParameterBatch

_LARGEST_CONDITION = 1e12
"""Four digits are left of the coefficients."""


def finished_interpolant(
    family: Family, growth: Growth, elements: Elements
) -> tuple[WaveformInterpolant, dict[str, float]]:
    """The interpolant B = V^-1 E with its nodes in order, and how well conditioned that was.

    Returns
    -------
    The interpolant, and ``condition_number`` of the matrix V of the elements at the nodes, ``orthogonality_loss``,
    ``lebesgue_constant``, ``node_error`` (how far the rows are from one and zero at the nodes).

    Raises
    ------
    ConstructionFailed
        The matrix is singular to working precision.
    """
    binaries = ParameterBatch(growth.binaries)
    order = np.argsort(growth.nodes)
    nodes = growth.nodes[order]
    coefficients, condition = element_coefficients(growth, family.grid.weights, nodes, elements)
    if not condition < _LARGEST_CONDITION:
        raise ConstructionFailed(
            f"The matrix of the {family.term} basis at its nodes has a condition number of {condition:.1e}. Ask for a "
            "larger tolerance" + (', or for elements = "orthonormal".' if elements == "waveforms" else ".")
        )
    raw = family.raw(binaries)
    coefficients = coefficients / np.sqrt(squared_norms(raw, family.grid.weights))[:, None]
    rows = coefficients.T @ raw
    interpolant = WaveformInterpolant(family.term, family.grid.frequencies[nodes], binaries, coefficients)
    return interpolant, {
        "elements": len(growth),
        "condition_number": condition,
        "orthogonality_loss": orthogonality_loss(growth.orthonormal),
        "lebesgue_constant": lebesgue_constant(rows),
        "node_error": float(np.abs(rows[:, nodes] - np.eye(len(nodes))).max()),
    }


def element_coefficients(growth: Growth, weights: Any, nodes: Any, elements: Elements) -> tuple[AnyArray, float]:
    """C with B_j = sum_k waveform_k C[k, j], and the condition number of the matrix that was inverted for it.

    With waveforms as elements, V^T C = 1 for V = waveforms at the nodes. With orthonormal elements Q, waveforms = L Q
    for a lower triangular L, and C = L^-T (V_Q^T)^-1.
    """
    if elements == "waveforms":
        matrix = growth.waveforms[:, nodes]
        return np.linalg.inv(matrix.T), float(np.linalg.cond(matrix))
    root = np.sqrt(weights)
    matrix = growth.orthonormal[:, nodes] / root[nodes]
    lower = (growth.waveforms * root) @ growth.orthonormal.conj().T
    return np.linalg.solve(np.tril(lower).T, np.linalg.inv(matrix.T)), float(np.linalg.cond(matrix))
