"""A model's own estimate of its mismatch, as a function of the parameters, calibrated on waveforms it never saw.

The logarithm of the measured mismatch is fitted by a low-degree polynomial in the regressor's coordinates, then raised
until one can be confident that at most one binary in a hundred exceeds three times it: of those in the middle of the
box, and of those on its edges, each by themselves. What is compared with each waveform is a fit that has not seen it,
nor its like: a corner is drawn again and again. The polynomial becomes one more output of the regressor, so it costs
nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.stats import binom

from bnserve_surrogate._artifact import CARRIER
from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.training.data.generators import FloatArray
from bnserve_surrogate.training.regressors import chebyshev_terms, weighted_exponents, with_parity
from bnserve_surrogate.training.validation.measurement import Validation

PROMISED_FACTOR = 3.0
"""At most one binary in a hundred has a mismatch above this many times the estimate."""
PROMISED_FRACTION = 0.01
_CONFIDENCE = 0.95
"""That the promise holds for all binaries, not only for the sample at hand."""
_DEGREE = 3.0
_FOLDS = 8


@dataclass(frozen=True)
class ErrorEstimate:
    """The polynomial of log(mismatch).

    Parameters
    ----------
    exponents
        (T, 5) degrees of the Chebyshev products.
    coefficients
        (T,) calibration included.
    """

    exponents: NDArray[np.uint8]
    coefficients: FloatArray

    def __call__(self, coordinates: FloatArray) -> FloatArray:
        """Estimated mismatches, (N,), at scaled coordinates (N, 5)."""
        return np.asarray(np.exp(chebyshev_terms(coordinates, self.exponents).T @ self.coefficients))


def fit_error_estimate(
    coordinates: FloatArray,
    mismatch: FloatArray,
    kinds: NDArray[np.int64],
    degree: float = _DEGREE,
    parity: int | None = None,
) -> ErrorEstimate | None:
    """Fit and calibrate an estimate.

    Parameters
    ----------
    coordinates
        (N, 5) scaled coordinates of fresh waveforms, from the middle of the box and from its edges.
    mismatch
        (N,) measured.
    kinds
        (N,) from where each is: the promise is kept for every kind.
    degree
        Largest total degree; lowered until there are ten waveforms for every term.
    parity
        0 in symmetric coordinates, in which an estimate does not depend on the labels.

    Returns
    -------
    None if there are fewer than 100 waveforms: a calibration at the 99th percentile cannot be had from them.
    """
    if len(mismatch) < 100:
        return None
    exponents = with_parity(weighted_exponents(degree, (1.0,) * 5), parity)
    while 10 * len(exponents) > len(mismatch):
        degree -= 1.0
        exponents = with_parity(weighted_exponents(degree, (1.0,) * 5), parity)
    logarithm = np.log(np.maximum(mismatch, 1e-16))
    terms = chebyshev_terms(coordinates, exponents).T
    unseen = _unseen_residuals(terms, logarithm, _folds(coordinates))
    raised = max(_upper_limit(unseen[kinds == kind]) for kind in np.unique(kinds))
    coefficients = np.linalg.lstsq(terms, logarithm, rcond=None)[0]
    constant = int(np.flatnonzero(exponents.sum(axis=1) == 0)[0])
    coefficients[constant] += raised - np.log(PROMISED_FACTOR)
    return ErrorEstimate(exponents, np.asarray(coefficients, dtype=np.float64))


def estimates_from(validations: dict[str, Validation], coordinates: CoordinateMap) -> dict[str, ErrorEstimate]:
    """Of every mode; fitted to all waveforms of the validation, calibrated for the middle and for the edges each.

    Empty if there are too few.
    """
    parts = list(validations.values())
    theta = coordinates(np.concatenate([validation.theta for validation in parts]))
    kinds = np.concatenate([np.full(len(validation.mismatch), kind) for kind, validation in enumerate(parts)])
    errors = {CARRIER: [validation.mismatch for validation in parts]}
    errors |= {name: [validation.modes[name] for validation in parts] for name in parts[0].modes}
    parity = 0 if coordinates.kind == "symmetric" else None
    found = {
        name: fit_error_estimate(theta, np.concatenate(error), kinds, parity=parity) for name, error in errors.items()
    }
    return {name: estimate for name, estimate in found.items() if estimate is not None}


def _folds(coordinates: FloatArray) -> NDArray[np.int64]:
    """One of ``_FOLDS`` for every waveform, the same for those at the same place."""
    _, place = np.unique(np.round(coordinates, 9), axis=0, return_inverse=True)
    first = np.full(place.max() + 1, len(place))
    np.minimum.at(first, place.ravel(), np.arange(len(place)))
    return np.asarray(first[place.ravel()] % _FOLDS)


def _unseen_residuals(terms: FloatArray, logarithm: FloatArray, fold: NDArray[np.int64]) -> FloatArray:
    """What a fit to the other folds leaves of each waveform, (N,)."""
    residual = np.empty(len(logarithm))
    for number in range(_FOLDS):
        out = fold == number
        fit = np.linalg.lstsq(terms[~out], logarithm[~out], rcond=None)[0]
        residual[out] = logarithm[out] - terms[out] @ fit
    return residual


def _upper_limit(residual: FloatArray) -> float:
    """What no more than the promised fraction of all residuals exceed, with confidence: one of the largest seen.

    If more than a fraction p of all exceed a limit, then k or fewer of n do with a probability of at most that of a
    binomial variable; k is the most for which it is below 1 - confidence. From few waveforms there is no such k: the
    largest residual is the best one can say.
    """
    allowed = int(binom.ppf(1.0 - _CONFIDENCE, len(residual), PROMISED_FRACTION)) - 1
    return float(np.sort(residual)[-1 - max(allowed, 0)])


def with_error_estimate(
    tensors: dict[str, NDArray[Any]], estimate: ErrorEstimate, mode: str = CARRIER
) -> dict[str, NDArray[Any]]:
    """The tensors with the estimate's logarithm as one more, last output of a mode's regressor."""
    widened = dict(tensors)
    own = {name.removeprefix(f"{mode}/"): array for name, array in tensors.items() if name.startswith(f"{mode}/")}
    outputs = own["basis"].shape[0]
    for name in ("basis", "merger_alignment"):
        if name in own:
            widened[f"{mode}/{name}"] = np.vstack([own[name], np.zeros((1, own[name].shape[1]))])
    for name, array in own.items():
        if name.startswith("mlp_") and name.removeprefix("mlp_").split("_")[1] == str(_last_layer(own)):
            widened[f"{mode}/{name}"] = np.concatenate([array, np.zeros((*array.shape[:-1], 1))], axis=-1)
    exponents = own.get("polynomial_exponents", np.zeros((0, 5), np.uint8))
    coefficients = own.get("polynomial_coefficients", np.zeros((0, outputs)))
    coefficients = np.hstack([coefficients, np.zeros((len(coefficients), 1))])
    position = {tuple(row): number for number, row in enumerate(exponents.tolist())}
    for row, value in zip(estimate.exponents.tolist(), estimate.coefficients, strict=True):
        if tuple(row) in position:
            coefficients[position[tuple(row)], -1] = value
        else:
            exponents = np.vstack([exponents, np.array(row, np.uint8)])
            coefficients = np.vstack([coefficients, np.zeros(outputs + 1)])
            coefficients[-1, -1] = value
    widened[f"{mode}/polynomial_exponents"] = np.ascontiguousarray(exponents, dtype=np.uint8)
    widened[f"{mode}/polynomial_coefficients"] = np.ascontiguousarray(coefficients)
    return widened


def _last_layer(own: dict[str, NDArray[Any]]) -> int:
    return sum(name.startswith("mlp_weights_") for name in own) - 1
