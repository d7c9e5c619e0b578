"""The family of functions that a basis is for: normalised waveforms of a prior on the thinned grid."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from bnserve_inference._workers import ModelSource
from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._frequency_grid import FrequencyGrid
from bnserve_inference.roq._interpolant import Alignment, AnyArray, FloatArray, Term, evaluate_term
from bnserve_inference.roq._interpolation import interpolation_errors, projection_errors, squared_norms
from bnserve_inference.roq._sampling import Draws, Prior
from bnserve_protocol import ParameterBatch


@dataclass(frozen=True)
class Family:
    """Normalised waveforms, or their squared moduli, on a thinned grid.

    The norm is the paper's: the sum of squared moduli over the full grid, without the weight of a noise curve.
    """

    source: ModelSource
    term: Term
    prior: Prior
    grid: FrequencyGrid
    alignment: Alignment

    def raw(self, binaries: ParameterBatch) -> AnyArray:
        """The functions as the model gives them, ``(N, M)``."""
        return evaluate_term(self.source.model, self.grid.frequencies, binaries, self.term, self.alignment)

    def normalised(self, binaries: ParameterBatch) -> AnyArray:
        """The functions with norm 1, ``(N, M)``."""
        return normalised(self.raw(binaries), self.grid.weights)


def normalised(values: AnyArray, weights: FloatArray) -> AnyArray:
    """Divide by the norm.

    Raises
    ------
    ConstructionFailed
        A waveform vanishes or is not finite.
    """
    norms = np.sqrt(squared_norms(values, weights))
    if not (np.isfinite(norms).all() and (norms > 0.0).all()):
        raise ConstructionFailed("The model gave a waveform that is zero or not finite; check its range and the band.")
    values /= norms[:, None]
    return values


@dataclass(frozen=True)
class ProjectionTask:
    """Squared distances of a chunk of draws from the span of ``orthonormal`` rows."""

    family: Family
    draws: Draws
    orthonormal: AnyArray

    def __call__(self, chunk: int) -> FloatArray:
        """The errors of chunk number ``chunk``."""
        values = self.family.normalised(self.draws.chunk(chunk))
        return projection_errors(values * np.sqrt(self.family.grid.weights), self.orthonormal)


@dataclass(frozen=True)
class InterpolationTask:
    """Interpolation errors of a chunk of draws."""

    family: Family
    draws: Draws
    interpolant: AnyArray
    nodes: Any

    def __call__(self, chunk: int) -> FloatArray:
        """The errors of chunk number ``chunk``."""
        values = self.family.normalised(self.draws.chunk(chunk))
        return interpolation_errors(values, self.interpolant, self.nodes, self.family.grid.weights)
