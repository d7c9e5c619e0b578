"""Two regressors together: one on what the other leaves over, or each for outputs of its own."""

from typing import Any, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, RegressorMixin, clone

from bnserve_surrogate.training.regressors.exported import ExportedRegressor, export_regressor

FloatArray: TypeAlias = NDArray[np.float64]


class Sum(RegressorMixin, BaseEstimator):
    """``first``, plus ``second`` fitted to the residuals of ``first``.

    The residuals are divided by their root mean square before ``second`` sees them: one number for all outputs, so
    relative weights stay as they are, and a network's learning rate and regularisation need not know how good
    ``first`` was.

    Parameters
    ----------
    first, second
        Estimators with ``fit`` and ``predict``; they are cloned.

    Attributes
    ----------
    first_, second_
        The fitted estimators.
    residual_scale_ : float
        Root mean square of the residuals of ``first_`` on the training set.
    """

    def __init__(self, first: Any, second: Any) -> None:
        self.first = first
        self.second = second

    def fit(self, X: ArrayLike, Y: ArrayLike) -> Self:  # noqa: N803 (scikit-learn's names)
        """Fit to inputs (N, D) and outputs (N, K) or (N,)."""
        outputs = np.asarray(Y, dtype=np.float64)
        self.first_ = clone(self.first).fit(X, outputs)
        residuals = outputs - self.first_.predict(X)
        self.residual_scale_ = float(np.sqrt(np.mean(residuals**2))) or 1.0
        self.second_ = clone(self.second).fit(X, residuals / self.residual_scale_)
        return self

    def predict(self, X: ArrayLike) -> FloatArray:  # noqa: N803
        """Outputs (N, K), or (N,) if fitted to a vector."""
        return np.asarray(self.first_.predict(X) + self.residual_scale_ * self.second_.predict(X))

    def export(self) -> ExportedRegressor:
        """Both parts together; NotExportable if a part is not, or both are networks."""
        return export_regressor(self.first_).plus(export_regressor(self.second_).scaled(self.residual_scale_))


class Beside(RegressorMixin, BaseEstimator):
    """``first`` for the first ``n_first`` outputs, ``second`` for the others.

    A network minimises one Euclidean distance over all its outputs. A time shift of 1e4 in units of the total mass
    would be all it sees, and the components, which make the mismatch, would go untrained.

    Parameters
    ----------
    first, second
        Estimators with ``fit`` and ``predict``; they are cloned.
    n_first
        How many outputs are the first's.

    Attributes
    ----------
    first_, second_
        The fitted estimators.
    """

    def __init__(self, first: Any, second: Any, n_first: int) -> None:
        self.first = first
        self.second = second
        self.n_first = n_first

    def fit(self, X: ArrayLike, Y: ArrayLike) -> Self:  # noqa: N803 (scikit-learn's names)
        """Fit to inputs (N, D) and outputs (N, K), K > ``n_first``.

        Raises
        ------
        ValueError
            If there are not more outputs than ``n_first``.
        """
        outputs = np.asarray(Y, dtype=np.float64)
        if outputs.ndim != 2 or outputs.shape[1] <= self.n_first:
            raise ValueError(f"Expected more than {self.n_first} outputs in columns; got shape {outputs.shape}.")
        self.first_ = clone(self.first).fit(X, outputs[:, : self.n_first])
        self.second_ = clone(self.second).fit(X, outputs[:, self.n_first :])
        self.n_outputs_ = outputs.shape[1]
        return self

    def predict(self, X: ArrayLike) -> FloatArray:  # noqa: N803
        """Outputs (N, K)."""
        return np.hstack([self.first_.predict(X), self.second_.predict(X)])

    def export(self) -> ExportedRegressor:
        """Both parts, each with zeros for the other's outputs; NotExportable if a part is not, or both are networks."""
        second = export_regressor(self.second_)
        first = export_regressor(self.first_)
        return _padded(first, 0, self.n_outputs_ - self.n_first).plus(_padded(second, self.n_first, 0))


def _padded(exported: ExportedRegressor, before: int, after: int) -> ExportedRegressor:
    """The same regressor with outputs that are always zero before and after its own."""
    last = exported.n_layers - 1
    ends = ("polynomial_coefficients", f"mlp_weights_{last}", f"mlp_biases_{last}")
    arrays = {
        name: np.pad(array, [(0, 0)] * (array.ndim - 1) + [(before, after)]) if name in ends else array
        for name, array in exported.arrays.items()
    }
    return ExportedRegressor(arrays, dict(exported.metadata))
