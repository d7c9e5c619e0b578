"""From residuals at the nodes to a few numbers and back: the paper's way, and the metric's.

Both are affine, ``[dA, dpsi] = mean + components @ basis``, and both take off and return three scalars beside the
components, so that the regressor and the exported model do not care which one was used.
"""

from typing import NamedTuple, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eigh
from sklearn.base import BaseEstimator, TransformerMixin

from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generators import WaveformGenerator
from bnserve_surrogate.training.data.residuals import flatten_phase, merger_phase
from bnserve_surrogate.training.reduction.metric import MetricCoordinates, MismatchMetric
from bnserve_surrogate.training.sections import TrainingConfiguration

FloatArray: TypeAlias = NDArray[np.float64]
SCALARS = ("log_amplitude", "time_shift", "phase_shift")
"""Outputs of the regressor beside the components: what the match does not see."""


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


class ReducedResiduals(NamedTuple):
    """``components`` (N, k); and (N,) each: ``log_amplitude``, ``phase`` at the reference frequency, ``phase_slope``.

    The scalars are those of :class:`~bnserve_surrogate.training.reduction.metric.MetricCoordinates`.
    """

    components: FloatArray
    log_amplitude: FloatArray
    phase: FloatArray
    phase_slope: FloatArray


class MetricReduction(BaseEstimator):
    """Principal components in the metric of the mismatch: squared distances of components are mismatches.

    Parameters
    ----------
    metric
        Of the nodes on which the residuals are given.
    n_components
        k; on the training box of the paper 20 truncate at 1e-8, 30 at 5e-10 (largest mismatch).

    Attributes
    ----------
    principal_components_
        The fitted :class:`PrincipalComponents` of the metric vectors.
    """

    def __init__(self, metric: MismatchMetric, n_components: int = 24) -> None:
        self.metric = metric
        self.n_components = n_components

    def fit(self, log_amplitude: ArrayLike, phase: ArrayLike) -> Self:
        """Learn from residuals of shape (N, n_A) and (N, n_phi)."""
        vectors = self.metric.transform(log_amplitude, phase).vectors
        self.principal_components_ = PrincipalComponents(self.n_components).fit(vectors)
        return self

    def transform(self, log_amplitude: ArrayLike, phase: ArrayLike) -> ReducedResiduals:
        """Reduce residuals."""
        vectors, *scalars = self.metric.transform(log_amplitude, phase)
        return ReducedResiduals(self.principal_components_.transform(vectors), *scalars)

    def inverse_transform(self, reduced: ReducedResiduals) -> tuple[FloatArray, FloatArray]:
        """Residuals (N, n_A) and (N, n_phi) back."""
        components, *scalars = reduced
        vectors = self.principal_components_.inverse_transform(components)
        return self.metric.inverse_transform(MetricCoordinates(vectors, *scalars))

    def node_basis(self) -> tuple[FloatArray, FloatArray]:
        """Mean (n,) and basis (k, n) at the n = n_A + n_phi nodes, without the scalars."""
        vectors = self.principal_components_
        mean, basis = (self.metric.residuals(each) for each in (vectors.mean_[None], vectors.components_))
        return np.hstack(mean)[0], np.hstack(basis)


class PaperReduction(BaseEstimator):
    """The paper's: principal components of the unweighted joint vector [dA, dphi], scaled by lambda^alpha.

    The paper's components "natively have comparable variance" before that: its code divides each by the largest modulus
    it has in the training set, and so does this. Without it alpha would act on top of the square root of lambda.

    As in the paper, the residuals' linear trend should be off before: the three scalars are zero.

    Parameters
    ----------
    n_components, eigenvalue_exponent
        The paper's 30 and 0.37.

    Attributes
    ----------
    principal_components_
        The fitted :class:`PrincipalComponents` of the joint vectors.
    scale_ : ndarray, shape (k,)
        By which the components are multiplied: lambda^alpha over the largest modulus.
    """

    def __init__(self, n_components: int = 30, eigenvalue_exponent: float = 0.37) -> None:
        self.n_components = n_components
        self.eigenvalue_exponent = eigenvalue_exponent

    def fit(self, log_amplitude: ArrayLike, phase: ArrayLike) -> Self:
        """Learn from residuals of shape (N, n_A) and (N, n_phi)."""
        vectors = _joint(log_amplitude, phase)
        self.split_ = np.shape(log_amplitude)[1]
        self.principal_components_ = PrincipalComponents(self.n_components).fit(vectors)
        eigenvalues = self.principal_components_.eigenvalues_
        largest = np.abs(self.principal_components_.transform(vectors)).max(axis=0)
        varies = (eigenvalues > 0.0) & (largest > 0.0)
        powers = np.where(varies, eigenvalues, 1.0) ** self.eigenvalue_exponent
        self.scale_ = powers / np.where(varies, largest, 1.0)
        return self

    def transform(self, log_amplitude: ArrayLike, phase: ArrayLike) -> ReducedResiduals:
        """Reduce residuals."""
        components = self.principal_components_.transform(_joint(log_amplitude, phase)) * self.scale_
        return ReducedResiduals(components, *(np.zeros(len(components)),) * 3)

    def inverse_transform(self, reduced: ReducedResiduals) -> tuple[FloatArray, FloatArray]:
        """Residuals (N, n_A) and (N, n_phi) back."""
        joint = self.principal_components_.inverse_transform(np.asarray(reduced.components) / self.scale_)
        return joint[:, : self.split_], joint[:, self.split_ :]

    def node_basis(self) -> tuple[FloatArray, FloatArray]:
        """Mean (n,) and basis (k, n) at the n = n_A + n_phi nodes, without the scalars."""
        components = self.principal_components_
        return components.mean_, components.components_ / self.scale_[:, None]


Reduction: TypeAlias = MetricReduction | PaperReduction


def _joint(log_amplitude: ArrayLike, phase: ArrayLike) -> FloatArray:
    return np.hstack([np.asarray(log_amplitude, dtype=np.float64), np.asarray(phase, dtype=np.float64)])


def reduce_dataset(
    configuration: TrainingConfiguration, generator: WaveformGenerator, metric: MismatchMetric, dataset: ResidualDataset
) -> tuple[Reduction, FloatArray, float]:
    """The fitted reduction, the regressor's targets, and where the generator's phase starts from zero."""
    section = configuration.reduction
    start_mf = float(getattr(generator, "phase_start", 0.0))
    if section.kind == "metric":
        reduction: Reduction = MetricReduction(metric, section.components)
        phase = dataset.psi_residual
        constant = slope = np.zeros(len(dataset))
    else:
        reduction = PaperReduction(section.components, section.eigenvalue_exponent)
        flat = flatten_phase(dataset.mf_phase, dataset.psi_residual)
        phase, constant, slope = flat.residual, flat.constant, 2.0 * np.pi * flat.time_shift
    reduced = reduction.fit(dataset.log_amplitude_ratio, phase).transform(dataset.log_amplitude_ratio, phase)
    reference = metric.reference_frequency if section.kind == "metric" else 0.0
    reduced = reduced._replace(phase=reduced.phase + constant, phase_slope=reduced.phase_slope + slope)
    return reduction, regression_targets(reduced, dataset.theta, reference, start_mf), start_mf


def regression_targets(
    reduced: ReducedResiduals, theta: FloatArray, reference_mf: float, start_mf: float
) -> FloatArray:
    """What the regressor learns, (N, k + 3): components, then the scalars of :data:`SCALARS`.

    Parameters
    ----------
    reduced
        Of N residuals.
    theta
        Their parameters.
    reference_mf
        Where ``reduced.phase`` is taken.
    start_mf
        Where the generator's phase starts from zero, or 0 if it does not.
    """
    intercept = reduced.phase - reduced.phase_slope * reference_mf
    if start_mf > 0.0:
        intercept = intercept + merger_phase(theta, start_mf)
    return np.column_stack([reduced.components, reduced.log_amplitude, reduced.phase_slope, intercept])
