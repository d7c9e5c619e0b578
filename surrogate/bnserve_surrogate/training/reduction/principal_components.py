r"""Principal component analysis by diagonalising the covariance matrix, for many samples of a few hundred numbers.

The paper's section "Principal Component Analysis": :math:`C = V D V^T`, :math:`\tilde x = U^T (x - \mu)`,
:math:`x = U \tilde x + \mu`. What the components are multiplied by afterwards belongs to the reduction.
"""

from typing import Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eigh
from sklearn.base import BaseEstimator, TransformerMixin

FloatArray: TypeAlias = NDArray[np.float64]


class PrincipalComponents(TransformerMixin, BaseEstimator):
    """The ``n_components`` directions of largest variance.

    Deterministic: the entry of largest modulus of every component is positive.

    Parameters
    ----------
    n_components
        How many to keep, k; the paper keeps 30.

    Attributes
    ----------
    mean_ : ndarray, shape (D,)
    components_ : ndarray, shape (k, D)
        Orthonormal rows.
    eigenvalues_ : ndarray, shape (k,)
        Variances along them, decreasing.
    """

    def __init__(self, n_components: int = 30) -> None:
        self.n_components = n_components

    def fit(self, X: ArrayLike, y: None = None) -> Self:  # noqa: N803 (scikit-learn's name for the samples)
        """Learn from N samples, shape (N, D); covariances are averages over N.

        Raises
        ------
        ValueError
            If ``X`` is not a finite matrix, or has fewer rows or columns than components are wanted.
        """
        samples = np.asarray(X, dtype=np.float64)
        if samples.ndim != 2 or not np.isfinite(samples).all():
            raise ValueError("Principal components need a matrix of finite samples; screen failed waveforms first.")
        if not 1 <= self.n_components <= min(samples.shape):
            raise ValueError(
                f"Cannot keep {self.n_components} components of {samples.shape[0]} samples of {samples.shape[1]} "
                "numbers; ask for fewer components or give more samples."
            )
        self.mean_ = samples.mean(axis=0)
        values, vectors = eigh(_covariance(samples, self.mean_))
        kept = np.argsort(values)[::-1][: self.n_components]
        components = np.ascontiguousarray(vectors[:, kept].T)
        largest = np.argmax(np.abs(components), axis=1)
        components *= np.sign(components[np.arange(len(components)), largest])[:, None]
        self.components_ = components
        self.eigenvalues_ = np.maximum(values[kept], 0.0)
        return self

    def transform(self, X: ArrayLike) -> FloatArray:  # noqa: N803
        """Coordinates of the samples, shape (N, D) -> (N, k)."""
        return (np.asarray(X, dtype=np.float64) - self.mean_) @ self.components_.T

    def inverse_transform(self, X: ArrayLike) -> FloatArray:  # noqa: N803
        """Samples from coordinates, shape (N, k) -> (N, D)."""
        return np.asarray(X, dtype=np.float64) @ self.components_ + self.mean_


def _covariance(samples: FloatArray, mean: FloatArray, rows: int = 16_384) -> FloatArray:
    """Average of the outer products of ``samples - mean``, in pieces: no second copy of all samples is made."""
    total = np.zeros((samples.shape[1], samples.shape[1]))
    for start in range(0, len(samples), rows):
        centred = samples[start : start + rows] - mean
        total += centred.T @ centred
    return total / len(samples)
