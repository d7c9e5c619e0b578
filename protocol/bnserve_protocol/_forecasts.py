"""What a network of detectors would measure of binaries: how it is asked, and what is found."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._likelihood_batches import LikelihoodBatch, LikelihoodBatchLike
from bnserve_protocol._modes import Mode

Floats = NDArray[np.float64]

_DEGREES = (180.0 / np.pi) ** 2

FORECAST_COORDINATES = (
    "log_chirp_mass", "log_mass_ratio", "lambda_tilde", "delta_lambda_tilde", "chi_1", "chi_2", "log_distance",
    "inclination", "reference_phase", "coalescence_time",
)  # fmt: skip
"""Of a binary, to which :data:`SKY_NAMES` come."""
SKY_NAMES = ("right_ascension", "declination", "polarization_angle")
"""Of its place in the sky, in radians."""


@dataclass(frozen=True)
class ForecastOptions:
    """How forecasts are made.

    Parameters
    ----------
    coordinates
        Ten names of ``bnserve_protocol.COORDINATES``, with ``coalescence_time`` in place of ``time_shift``, to which
        :data:`SKY_NAMES` come.
    priors
        Widths of Gaussian priors by coordinate, in its unit.
    modes
        Of the signals; None for all that the model has.
    alignment
        What the coalescence time is that of, as in ``EvaluationOptions``.
    reference_frequency
        Hz, at which the phase of the (2, 2) is held while other coordinates change: one in the middle of the band,
        or masses and ``reference_phase`` are so alike that rounding shows. Other errors do not depend on it.
    """

    coordinates: Sequence[str] = FORECAST_COORDINATES
    priors: Mapping[str, float] | None = None
    modes: Sequence[Mode] | None = None
    alignment: str = "merger"
    reference_frequency: float = 50.0

    @property
    def names(self) -> tuple[str, ...]:
        """All 13 coordinates, in the order of a matrix."""
        return (*self.coordinates, *SKY_NAMES)


DEFAULT_FORECAST = ForecastOptions()


@dataclass(frozen=True, eq=False)
class Forecast:
    """What a network would measure of N binaries, in the Gaussian approximation (Cutler, Flanagan 1994,
    arXiv:gr-qc/9402014).

    Attributes
    ----------
    names
        Of the P coordinates.
    snr, detector_snr
        Optimal signal-to-noise ratios, ``(N,)`` of the network and ``(N, D)``.
    root
        Upper triangular R, ``(N, P, P)``, of the QR factorisation of the whitened derivatives: the Fisher matrix is its
        square, which is never inverted.
    condition
        Condition number of the Fisher matrix with a unit diagonal, ``(N,)``.
    singular
        Rows, ``(N,)``, whose matrix has a condition beyond 1e14: a direction is not measured, and their covariances are
        NaN. A Gaussian prior on what is not measured makes them regular.
    beyond
        Whether a coordinate's standard deviation leaves the model's range, ``(N, P)``: the error is then the prior's.
    status
        uint8 ``(N,)``, a RowStatus each; rows that are not OK are NaN.
    """

    names: tuple[str, ...]
    snr: Floats
    detector_snr: Floats
    root: Floats
    condition: Floats
    singular: NDArray[np.bool_]
    beyond: NDArray[np.bool_]
    status: NDArray[np.uint8]

    @property
    def matrix(self) -> Floats:
        """The Fisher matrices, ``(N, P, P)``."""
        return np.asarray(self.root.swapaxes(1, 2) @ self.root)

    @property
    def covariance(self) -> Floats:
        """``(N, P, P)``; NaN where the matrix is singular."""
        good = ~self.singular & np.isfinite(self.root).all(axis=(1, 2))
        scale = np.where(good[:, None], np.sqrt((self.root**2).sum(axis=1)), 1.0)
        regular = np.where(good[:, None, None], self.root / scale[:, None], np.eye(len(self.names)))
        inverse = np.linalg.inv(regular) / scale[:, :, None]
        found = inverse @ inverse.swapaxes(1, 2)
        found[~good] = np.nan
        return np.asarray(found)

    def errors(self) -> dict[str, Floats]:
        """Standard deviation of each coordinate in its unit, the others unknown, ``(N,)`` by name, or NaN."""
        sigma = np.sqrt(np.einsum("npp->np", self.covariance))
        return {name: sigma[:, place] for place, name in enumerate(self.names)}

    def sky_area(self, declination: Floats, level: float = 0.9) -> Floats:
        """Square degrees of the ellipse that holds the source with a probability, ``(N,)``.

        -2 pi ln(1 - p) cos(declination) times the root of the determinant of the covariance of both angles (Barack,
        Cutler 2004, arXiv:gr-qc/0310125, eq. 43, for any p).
        """
        places = [self.names.index(name) for name in ("right_ascension", "declination")]
        block = self.covariance[:, places][:, :, places]
        area = np.sqrt(np.maximum(block[:, 0, 0] * block[:, 1, 1] - block[:, 0, 1] ** 2, 0.0))
        return np.asarray(-2.0 * np.pi * np.log1p(-level) * np.cos(declination) * area * _DEGREES)


@dataclass(frozen=True, eq=False)
class SignalToNoise:
    """Optimal signal-to-noise ratios of N binaries in a network of D detectors.

    Attributes
    ----------
    snr, detector_snr
        ``(N,)`` of the network and ``(N, D)``.
    status
        uint8 ``(N,)``, a RowStatus each; rows that are not OK are NaN.
    """

    snr: Floats
    detector_snr: Floats
    status: NDArray[np.uint8]


def forecast_batch(samples: LikelihoodBatchLike) -> LikelihoodBatch:
    """Binaries of a forecast, whole.

    Raises
    ------
    InvalidParameters
        They are none, leave out what a likelihood may integrate over, or have calibration errors.
    """
    batch = LikelihoodBatch.coerce(samples)
    if batch.absent:
        raise InvalidParameters(
            f"A forecast is of whole binaries: give {' and '.join(sorted(batch.absent))}, too.",
            errors=[FieldError(reason="missing", parameter=name) for name in sorted(batch.absent)],
        )
    if batch.calibration_amplitude:
        raise InvalidParameters("A forecast knows no calibration errors: leave them out.")
    finite = np.asarray(np.isfinite(batch.values).all(axis=1))
    if finite.all():
        return batch
    return LikelihoodBatch(np.where(finite[:, None], batch.values, np.nan))  # a row is flagged by its waveform


def triangle(matrices: Floats) -> Floats:
    """The upper triangles of matrices ``(N, P, P)``, row by row: ``(N, P (P + 1) / 2)``."""
    return np.ascontiguousarray(matrices[(slice(None), *np.triu_indices(matrices.shape[-1]))])


def from_triangle(packed: Floats, *, symmetric: bool = False) -> Floats:
    """The matrices whose upper triangles these are, with zeros below, or ``symmetric``."""
    size = (math.isqrt(8 * packed.shape[1] + 1) - 1) // 2
    rows, columns = np.triu_indices(size)
    found = np.zeros((len(packed), size, size))
    found[:, rows, columns] = packed
    if symmetric:
        found[:, columns, rows] = packed
    return found
