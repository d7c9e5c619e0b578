"""One regressor for the bulk, another for what it leaves over."""

from typing import Any, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, RegressorMixin, clone

from bnserve_surrogate.training.regressors.exported import ExportedRegressor
from bnserve_surrogate.training.regressors.exporting import export_regressor

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
