"""From whitened derivatives to what they say: covariances, errors, areas of the sky."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

LARGEST_CONDITION = 1e14
"""Of a matrix with a unit diagonal; beyond it a direction is not measured, and its covariance is rounding."""
_DEGREES = (180.0 / np.pi) ** 2


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
        """Standard deviation of each coordinate, the others unknown, ``(N,)`` by name."""
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


def condition(root: Floats) -> Floats:
    """Condition number of the squares of R with a unit diagonal, ``(N,)``."""
    scale = np.sqrt((root**2).sum(axis=1))
    good = (scale > 0.0).all(axis=1) & np.isfinite(root).all(axis=(1, 2))
    regular = np.where(good[:, None, None], root / np.where(scale > 0.0, scale, 1.0)[:, None], np.eye(root.shape[1]))
    values = np.linalg.svd(regular, compute_uv=False)
    with np.errstate(divide="ignore"):
        found = (values[:, 0] / values[:, -1]) ** 2
    return np.asarray(np.where(good, found, np.inf))
