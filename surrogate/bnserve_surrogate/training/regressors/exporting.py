"""From any fitted estimator to plain arrays, or a clear refusal."""

from typing import Any

from sklearn.neural_network import MLPRegressor

from bnserve_surrogate.training.regressors.exported import ExportedRegressor, NotExportable


def export_regressor(estimator: Any) -> ExportedRegressor:
    """Plain arrays of a fitted estimator.

    Understood are this package's regressors (anything with an ``export`` method that returns an
    :class:`~bnserve_surrogate.training.regressors.exported.ExportedRegressor`) and scikit-learn's ``MLPRegressor``.

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
