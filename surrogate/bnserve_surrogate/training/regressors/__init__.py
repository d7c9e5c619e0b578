"""The replaceable part of a surrogate: from coordinates to principal components.

A regressor is anything with scikit-learn's ``fit(X, Y)`` and ``predict(X)``. To be served it must also export to plain
arrays; these do:

* :class:`ChebyshevPolynomial`: least squares, deterministic, seconds;
* :class:`MLP`: the paper's neural network;
* :class:`Sum`: one of them on the residuals of the other;
* :class:`Beside`: one of them for some of the outputs, another for the rest.
"""

from bnserve_surrogate.training.regressors.combined import Beside, Sum
from bnserve_surrogate.training.regressors.configured import check_regressor, coordinate_map, make_regressor
from bnserve_surrogate.training.regressors.exported import (
    ExportedRegressor,
    NotExportable,
    export_regressor,
)
from bnserve_surrogate.training.regressors.mlp import MLP
from bnserve_surrogate.training.regressors.polynomial import (
    ChebyshevPolynomial,
    chebyshev_terms,
    weighted_exponents,
    with_parity,
)

__all__ = [
    "MLP", "Beside", "ChebyshevPolynomial", "ExportedRegressor", "NotExportable", "Sum", "chebyshev_terms",
    "check_regressor", "coordinate_map", "export_regressor", "make_regressor", "weighted_exponents", "with_parity",
]  # fmt: skip  # each has a line of its own above
