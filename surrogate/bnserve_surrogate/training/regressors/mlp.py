"""The paper's regressor: scikit-learn's multilayer perceptron, trained with Adam."""

from collections.abc import Sequence
from typing import Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, RegressorMixin
from sklearn.neural_network import MLPRegressor

from bnserve_surrogate.training.regressors.exported import ExportedRegressor

FloatArray: TypeAlias = NDArray[np.float64]


class MLP(RegressorMixin, BaseEstimator):
    """``sklearn.neural_network.MLPRegressor`` on standardised inputs, by default with the paper's hyper-parameters.

    The parameters are scikit-learn's, under its names; the defaults are those of the paper's appendix
    "Hyperparameters used".

    Parameters
    ----------
    hidden_layer_sizes, activation
        The network.
    alpha
        L2 regularisation; not the exponent of the eigenvalues, which belongs to the reduction.
    batch_size, learning_rate_init, max_iter
        Adam. ``max_iter`` counts epochs.
    validation_fraction, tol, n_iter_no_change
        Training stops when the score on this fraction of the samples has not improved by ``tol`` for that many epochs.
    random_state
        Seed of the initial weights, the split and the batches.

    Attributes
    ----------
    network_ : MLPRegressor
    mean_, deviation_ : ndarray, shape (D,)
        Of the inputs; the deviation of an input that does not vary counts as one.
    """

    def __init__(
        self,
        hidden_layer_sizes: Sequence[int] = (82, 95),
        activation: str = "tanh",
        alpha: float = 1e-4,
        batch_size: int = 162,
        learning_rate_init: float = 1.2e-3,
        max_iter: int = 1000,
        validation_fraction: float = 0.075,
        tol: float = 2e-15,
        n_iter_no_change: int = 91,
        random_state: int | None = 0,
    ) -> None:
        self.hidden_layer_sizes = hidden_layer_sizes
        self.activation = activation
        self.alpha = alpha
        self.batch_size = batch_size
        self.learning_rate_init = learning_rate_init
        self.max_iter = max_iter
        self.validation_fraction = validation_fraction
        self.tol = tol
        self.n_iter_no_change = n_iter_no_change
        self.random_state = random_state

    def fit(self, X: ArrayLike, Y: ArrayLike) -> Self:  # noqa: N803 (scikit-learn's names)
        """Fit to inputs (N, D) and outputs (N, K) or (N,).

        Warns
        -----
        sklearn.exceptions.ConvergenceWarning
            If ``max_iter`` epochs were not enough.
        """
        inputs, outputs = np.asarray(X, dtype=np.float64), np.asarray(Y, dtype=np.float64)
        self.mean_ = inputs.mean(axis=0)
        deviation = inputs.std(axis=0)
        self.deviation_ = np.where(deviation > 0.0, deviation, 1.0)
        # scikit-learn warns about a column where it wants a vector, and returns one.
        self._column_output = outputs.ndim == 2 and outputs.shape[1] == 1
        self.network_ = MLPRegressor(early_stopping=True, **self.get_params())
        self.network_.fit(self._standardised(inputs), outputs[:, 0] if self._column_output else outputs)
        self.n_features_in_ = inputs.shape[1]
        return self

    def predict(self, X: ArrayLike) -> FloatArray:  # noqa: N803
        """Outputs (N, K), or (N,) if fitted to a vector."""
        outputs = np.asarray(self.network_.predict(self._standardised(np.asarray(X, dtype=np.float64))))
        return outputs[:, None] if self._column_output else outputs

    def export(self) -> ExportedRegressor:
        """``mlp_weights_*`` and ``mlp_biases_*``, with the standardisation folded into the first layer."""
        first, *others = self.network_.coefs_
        first_bias, *other_biases = self.network_.intercepts_
        folded = first / self.deviation_[:, None]
        return ExportedRegressor.of_network(
            [folded, *others], [first_bias - self.mean_ @ folded, *other_biases], self.network_.activation
        )

    def _standardised(self, inputs: FloatArray) -> FloatArray:
        return (inputs - self.mean_) / self.deviation_
