"""A basis while it grows: its elements, its interpolant, and what has been measured on the way."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._family import Family
from bnserve_inference.roq._interpolant import AnyArray, FloatArray
from bnserve_inference.roq._interpolation import with_node
from bnserve_inference.roq._orthonormal import DEPENDENT, orthonormalised
from bnserve_protocol import ParameterBatch

Elements = Literal["orthonormal", "waveforms"]
PRESELECTION, SWEEP_COLUMNS = -1, 4


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
