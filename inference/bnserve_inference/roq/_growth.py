"""A basis while it grows: its elements, its interpolant, what has been measured; and the interpolant that is kept."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._family import Family
from bnserve_inference.roq._interpolant import AnyArray, FloatArray, WaveformInterpolant
from bnserve_inference.roq._interpolation import (
    DEPENDENT,
    lebesgue_constant,
    orthogonality_loss,
    orthonormalised,
    squared_norms,
    with_node,
)
from bnserve_protocol import ParameterBatch

Elements = Literal["orthonormal", "waveforms"]
PRESELECTION, SWEEP_COLUMNS = -1, 4
_LARGEST_CONDITION = 1e12
"""Four digits are left of the coefficients."""


@dataclass(frozen=True, eq=False)
class Growth:
    """Everything that continuing needs, as arrays; n elements on a grid of M points.

    Parameters
    ----------
    binaries
        Of the elements, ``(n, 10)``.
    waveforms
        Their functions of norm 1, ``(n, M)``.
    orthonormal
        The same after Gram-Schmidt, times the square roots of the grid's weights, ``(n, M)``.
    interpolant, nodes
        Cardinal rows ``(n, M)`` and indices in the grid ``(n,)``.
    preselection_errors
        Largest squared projection error met at each step.
    sweeps
        A row for every sweep over a cycle: cycle, elements, outliers, worst error.
    cycle
        The cycle to go on with; ``PRESELECTION`` before the first.
    swept
        Errors of an unfinished sweep.
    """

    binaries: FloatArray
    waveforms: AnyArray
    orthonormal: AnyArray
    interpolant: AnyArray
    nodes: NDArray[np.int64]
    preselection_errors: FloatArray
    sweeps: FloatArray
    cycle: int
    swept: FloatArray

    def __len__(self) -> int:
        return len(self.nodes)

    @classmethod
    def empty(cls, family: Family) -> Growth:
        """No element yet."""
        nothing = np.zeros((0, len(family.grid)), dtype=np.complex128 if family.term == "linear" else np.float64)
        return cls(
            binaries=np.zeros((0, 10)),
            waveforms=nothing,
            orthonormal=nothing,
            interpolant=nothing,
            nodes=np.zeros(0, dtype=np.int64),
            preselection_errors=np.zeros(0),
            sweeps=np.zeros((0, SWEEP_COLUMNS)),
            cycle=PRESELECTION,
            swept=np.zeros(0),
        )

    @classmethod
    def from_arrays(cls, arrays: dict[str, Any]) -> Growth:
        """From what :meth:`arrays` gave."""
        return cls(**{**{field.name: arrays[field.name] for field in fields(cls)}, "cycle": int(arrays["cycle"])})

    def arrays(self) -> dict[str, Any]:
        """Everything, by name."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def with_element(self, family: Family, binary: ParameterBatch, elements: Elements) -> Growth:
        """Add the waveform of one binary.

        Parameters
        ----------
        elements
            What empirical interpolation is given: the Gram-Schmidt residual, or the waveform itself.

        Raises
        ------
        ConstructionFailed
            It is a combination of the others.
        """
        (waveform,) = family.normalised(binary)
        root = np.sqrt(family.grid.weights)
        direction, distance = orthonormalised(waveform * root, self.orthonormal)
        if distance < DEPENDENT:
            raise ConstructionFailed(
                f"Waveform {len(self) + 1} of the basis is a combination of the others up to rounding: the tolerance "
                "is below what double precision allows. Ask for a larger one."
            )
        element = direction / root if elements == "orthonormal" else waveform
        interpolant, nodes = with_node(self.interpolant, self.nodes, element)
        return replace(
            self,
            binaries=np.vstack([self.binaries, binary.values]),
            waveforms=np.vstack([self.waveforms, waveform]),
            orthonormal=np.vstack([self.orthonormal, direction]),
            interpolant=interpolant,
            nodes=nodes,
        )


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
