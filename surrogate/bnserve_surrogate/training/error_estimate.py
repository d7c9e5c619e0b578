"""A model's own estimate of its mismatch, as a function of the parameters, calibrated on waveforms it never saw.

The logarithm of the measured mismatch is fitted by a low-degree polynomial in the regressor's coordinates, then raised
until no more than half a percent of the waveforms exceed three times it (the promise is one percent, and the waveforms
of the calibration are a finite sample). The polynomial becomes one more output of the regressor, so it costs nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.generators import FloatArray
from bnserve_surrogate.training.regressors import chebyshev_terms, weighted_exponents

PROMISED_FACTOR = 3.0
"""At most one binary in a hundred has a mismatch above this many times the estimate."""
_EXCEEDING = 0.005
_DEGREE = 3.0
_FOLDS = 8


@dataclass(frozen=True)
class ErrorEstimate:
    """The polynomial of log(mismatch).

    Parameters
    ----------
    exponents:
        (T, 5) degrees of the Chebyshev products.
    coefficients:
        (T,) calibration included.
    """

    exponents: NDArray[np.uint8]
    coefficients: FloatArray

    def __call__(self, coordinates: FloatArray) -> FloatArray:
        """Estimated mismatches, (N,), at scaled coordinates (N, 5)."""
        return np.asarray(np.exp(chebyshev_terms(coordinates, self.exponents).T @ self.coefficients))


def fit_error_estimate(coordinates: FloatArray, mismatch: FloatArray, degree: float = _DEGREE) -> ErrorEstimate | None:
    """Fit and calibrate an estimate.

    Parameters
    ----------
    coordinates:
        (N, 5) scaled coordinates of fresh waveforms, from the middle of the box and from its edges.
    mismatch:
        (N,) measured.
    degree:
        Largest total degree; lowered until there are ten waveforms for every term.

    Returns
    -------
    None if there are fewer than 100 waveforms: a calibration at the 99th percentile cannot be had from them.
    """
    if len(mismatch) < 100:
        return None
    exponents = weighted_exponents(degree, (1.0,) * 5)
    while 10 * len(exponents) > len(mismatch):
        degree -= 1.0
        exponents = weighted_exponents(degree, (1.0,) * 5)
    logarithm = np.log(np.maximum(mismatch, 1e-16))
    terms = chebyshev_terms(coordinates, exponents).T
    fold = np.arange(len(mismatch)) % _FOLDS
    residual = np.empty(len(mismatch))
    for number in range(_FOLDS):
        fit = np.linalg.lstsq(terms[fold != number], logarithm[fold != number], rcond=None)[0]
        residual[fold == number] = logarithm[fold == number] - terms[fold == number] @ fit
    coefficients = np.linalg.lstsq(terms, logarithm, rcond=None)[0]
    constant = int(np.flatnonzero(exponents.sum(axis=1) == 0)[0])
    coefficients[constant] += np.quantile(residual, 1.0 - _EXCEEDING) - np.log(PROMISED_FACTOR)
    return ErrorEstimate(exponents, np.asarray(coefficients, dtype=np.float64))


def with_error_estimate(tensors: dict[str, NDArray[Any]], estimate: ErrorEstimate) -> dict[str, NDArray[Any]]:
    """The tensors of a mode with the estimate's logarithm as one more, last output of the regressor."""
    widened = dict(tensors)
    outputs = tensors["22/basis"].shape[0]
    widened["22/basis"] = np.vstack([tensors["22/basis"], np.zeros((1, tensors["22/basis"].shape[1]))])
    widened["22/merger_alignment"] = np.vstack([tensors["22/merger_alignment"], np.zeros((1, 2))])
    for name, array in tensors.items():
        if name.startswith("22/mlp_") and name.removeprefix("22/mlp_").split("_")[1] == str(_last_layer(tensors)):
            widened[name] = np.concatenate([array, np.zeros((*array.shape[:-1], 1))], axis=-1)
    exponents = tensors.get("22/polynomial_exponents", np.zeros((0, 5), np.uint8))
    coefficients = tensors.get("22/polynomial_coefficients", np.zeros((0, outputs)))
    coefficients = np.hstack([coefficients, np.zeros((len(coefficients), 1))])
    position = {tuple(row): number for number, row in enumerate(exponents.tolist())}
    for row, value in zip(estimate.exponents.tolist(), estimate.coefficients, strict=True):
        if tuple(row) in position:
            coefficients[position[tuple(row)], -1] = value
        else:
            exponents = np.vstack([exponents, np.array(row, np.uint8)])
            coefficients = np.vstack([coefficients, np.zeros(outputs + 1)])
            coefficients[-1, -1] = value
    widened["22/polynomial_exponents"] = np.ascontiguousarray(exponents, dtype=np.uint8)
    widened["22/polynomial_coefficients"] = np.ascontiguousarray(coefficients)
    return widened


def _last_layer(tensors: dict[str, NDArray[Any]]) -> int:
    return sum(name.startswith("22/mlp_weights_") for name in tensors) - 1
