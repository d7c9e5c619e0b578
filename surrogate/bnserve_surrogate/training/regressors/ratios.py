"""Modes beside (2, 2): their ratios in the metric of the mismatch, reduced, and learnt.

An error of a ratio adds to the mismatch of the whole waveform half the integral of its square, weighted with what
(2, 2) has there, :math:`\\tfrac12 \\int |A_{22} v^p \\Delta R|^2 / S_n(m x / 2) \\, \\tfrac m2 dx`, over the
noise-weighted square of (2, 2). In that metric the components of a ratio are those of largest variance.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generators import FloatArray
from bnserve_surrogate.training.data.modes import ModeNodes
from bnserve_surrogate.training.reduction.metric import node_weights
from bnserve_surrogate.training.reduction.reductions import PrincipalComponents
from bnserve_surrogate.training.reduction.weights import mean_carrier, ratio_weights
from bnserve_surrogate.training.regressors.exported import export_regressor
from bnserve_surrogate.training.regressors.polynomial import ChebyshevPolynomial
from bnserve_surrogate.training.sections import ModeSection, TrainingConfiguration

_FLOOR = 1e-7
"""Least weight of a node, of the largest: where the detector sees nothing a ratio is still kept, and evaluated."""


@dataclass(frozen=True)
class TrainedRatio:
    """A mode's ratio: ``mean`` (2 n,), ``basis`` (K, 2 n), real parts at the nodes, then imaginary; its regressor."""

    mode: tuple[int, int]
    mx: FloatArray
    mean: FloatArray
    basis: FloatArray
    regressor: ChebyshevPolynomial

    def __call__(self, coordinates: FloatArray) -> NDArray[np.complex128]:
        """R at the nodes, (N, n), of scaled coordinates (N, 5)."""
        both = self.mean + self.regressor.predict(coordinates) @ self.basis
        return both[:, : len(self.mx)] + 1j * both[:, len(self.mx) :]

    @property
    def tensors(self) -> dict[str, NDArray[Any]]:
        """As :mod:`bnserve_surrogate._artifact` describes them."""
        prefix = f"{self.mode[0]}{self.mode[1]}"
        own = {"nodes": self.mx, "mean": self.mean, "basis": self.basis, **export_regressor(self.regressor).arrays}
        return {f"{prefix}/{name}": np.ascontiguousarray(tensor) for name, tensor in own.items()}


def train_ratios(
    configuration: TrainingConfiguration, dataset: ResidualDataset, coordinates: CoordinateMap
) -> list[TrainedRatio]:
    """Fit every mode of a data set."""
    mx, square = mean_carrier(dataset, configuration)
    inputs = coordinates(dataset.theta)
    return [
        _train_ratio(
            configuration.modes[f"{mode[0]}{mode[1]}"],
            mode,
            dataset.modes,
            ratio_weights(mode, mx, square, configuration),
            mx,
            inputs,
            dataset.ratios[:, number],
        )
        for number, mode in enumerate(dataset.modes.modes)
    ]


def _train_ratio(
    section: ModeSection,
    mode: tuple[int, int],
    nodes: ModeNodes,
    weights: FloatArray,
    mx: FloatArray,
    inputs: FloatArray,
    ratios: NDArray[np.complex128],
) -> TrainedRatio:
    own = node_weights(nodes.mx, mx, weights + _FLOOR * weights.max()) * weights.sum()
    scale = np.tile(np.sqrt(0.5 * own), 2)
    vectors = np.hstack([ratios.real, ratios.imag]) * scale
    odd = mode[1] % 2 == 1
    # What is odd under exchange of the labels has no mean: every sample stands for its mirror image, too.
    components = PrincipalComponents(section.components).fit(np.vstack([vectors, -vectors]) if odd else vectors)
    mean = np.zeros(len(scale)) if odd else components.mean_
    targets = (vectors - mean) @ components.components_.T
    regressor = ChebyshevPolynomial(section.degree, section.weights, section.terms, parity=mode[1] % 2)
    regressor.fit(inputs, targets)
    return TrainedRatio(mode, nodes.mx, mean / scale, components.components_ / scale, regressor)
