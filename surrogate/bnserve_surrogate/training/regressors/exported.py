"""A fitted regressor as plain arrays: what a model file holds and the evaluation kernel reads.

==========================  =========================================================================================
``polynomial_exponents``    uint8 (T, D): degrees of the Chebyshev factors of every term
``polynomial_coefficients`` float64 (T, K)
``mlp_weights_{i}``         float64 (n_i, n_{i+1}), i = 0 ... L: layer i maps a row x to ``x @ weights + biases``
``mlp_biases_{i}``          float64 (n_{i+1},)
==========================  =========================================================================================

Either part may be missing; the output is the sum of those present. The inputs are the regressor's coordinates: input
and output scalings are folded into the first and last layers. The activation, applied after every layer but the last,
is named in the metadata.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.neural_network import MLPRegressor

from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.reduction.reductions import SCALARS, Reduction

FloatArray: TypeAlias = NDArray[np.float64]

ACTIVATIONS = ("logistic", "relu", "tanh")
"""Activations that can be exported, by scikit-learn's names."""


class NotExportable(TrainingError):
    """A regressor that is no polynomial, multilayer perceptron, or sum of one of each."""

    code = "regressor-not-exportable"
    title = "Regressor cannot be exported"


@dataclass(frozen=True)
class ExportedRegressor:
    """C-contiguous ``arrays`` by name; ``metadata`` is ``{"mlp_activation": ...}`` if there is a network."""

    arrays: dict[str, NDArray[Any]]
    metadata: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of_polynomial(cls, exponents: NDArray[np.uint8], coefficients: FloatArray) -> "ExportedRegressor":
        """From exponents (T, D) and coefficients (T, K)."""
        return cls(
            {
                "polynomial_exponents": np.ascontiguousarray(exponents, dtype=np.uint8),
                "polynomial_coefficients": np.ascontiguousarray(coefficients, dtype=np.float64),
            }
        )

    @classmethod
    def of_network(
        cls, weights: Sequence[ArrayLike], biases: Sequence[ArrayLike], activation: str
    ) -> "ExportedRegressor":
        """From the layers' matrices (inputs, outputs) and biases.

        Raises
        ------
        NotExportable
            The kernel does not have the activation.
        """
        if activation not in ACTIVATIONS:
            raise NotExportable(f"Activation '{activation}' cannot be exported; known are {', '.join(ACTIVATIONS)}.")
        arrays = {f"mlp_weights_{i}": np.ascontiguousarray(w, dtype=np.float64) for i, w in enumerate(weights)}
        arrays |= {f"mlp_biases_{i}": np.ascontiguousarray(b, dtype=np.float64) for i, b in enumerate(biases)}
        return cls(arrays, {"mlp_activation": activation})

    @property
    def n_layers(self) -> int:
        """Number of layers of the network, 0 if there is none."""
        return sum(name.startswith("mlp_weights_") for name in self.arrays)

    def scaled(self, factor: float) -> "ExportedRegressor":
        """The same regressor with its outputs multiplied by ``factor``."""
        last = self.n_layers - 1
        outputs = ("polynomial_coefficients", f"mlp_weights_{last}", f"mlp_biases_{last}")
        arrays = {name: array * factor if name in outputs else array for name, array in self.arrays.items()}
        return ExportedRegressor(arrays, dict(self.metadata))

    def plus(self, other: "ExportedRegressor") -> "ExportedRegressor":
        """The sum of two regressors.

        Raises
        ------
        NotExportable
            Both have a network.
        """
        if self.n_layers and other.n_layers:
            raise NotExportable("The sum of two networks cannot be exported; export a polynomial plus one network.")
        arrays = {**self.arrays, **other.arrays}
        for name in ("polynomial_exponents", "polynomial_coefficients"):
            if name in self.arrays and name in other.arrays:
                arrays[name] = np.concatenate([self.arrays[name], other.arrays[name]])
        return ExportedRegressor(arrays, {**self.metadata, **other.metadata})


def export_regressor(estimator: Any) -> ExportedRegressor:
    """Plain arrays of a fitted estimator.

    Understood are this package's regressors (anything with an ``export`` method that returns an
    :class:`ExportedRegressor`) and scikit-learn's ``MLPRegressor``.

    Raises
    ------
    NotExportable
        For any other estimator: it can be trained and validated, and not served.
    """
    if hasattr(estimator, "export"):
        exported = estimator.export()
        if isinstance(exported, ExportedRegressor):
            return exported
    if isinstance(estimator, MLPRegressor):
        return ExportedRegressor.of_network(estimator.coefs_, estimator.intercepts_, estimator.activation)
    raise NotExportable(
        f"A {type(estimator).__name__} cannot be exported to a model file: only polynomials, multilayer perceptrons"
        " and a sum of one of each can. Use ChebyshevPolynomial, MLP or Sum, or give your estimator an export() method"
        " that returns an ExportedRegressor made of those."
    )


def model_tensors(
    reduction: Reduction,
    regressor: ExportedRegressor,
    coordinates: CoordinateMap,
    mf_amplitude: FloatArray,
    mf_phase: FloatArray,
) -> dict[str, NDArray[Any]]:
    """The tensors of the (2, 2) mode, as :mod:`bnserve_surrogate._artifact` describes them."""
    mean, vectors = reduction.node_basis()
    components = len(vectors)
    basis = np.zeros((components + len(SCALARS), len(mean)))
    basis[:components] = vectors
    basis[components, : len(mf_amplitude)] = 1.0
    merger_alignment = np.zeros((components + len(SCALARS) + 1, 2))
    merger_alignment[-2, 1] = 1.0
    merger_alignment[-1, 0] = 1.0
    tensors = {
        "amplitude_nodes": mf_amplitude,
        "phase_nodes": mf_phase,
        "mean": mean,
        "basis": basis,
        "merger_alignment": merger_alignment,
        "coordinate_offset": coordinates.offset,
        "coordinate_scale": coordinates.scale,
        **regressor.arrays,
    }
    return {f"22/{name}": np.ascontiguousarray(tensor) for name, tensor in tensors.items()}
