"""What a set of hyper-parameters costs: the paper's two figures, and the mismatch beside them."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sklearn.exceptions import ConvergenceWarning

from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generation import Generation, configured_generator, training_set
from bnserve_surrogate.training.data.generators import FloatArray, WaveformGenerator
from bnserve_surrogate.training.data.residuals import flatten_phase
from bnserve_surrogate.training.errors import DatasetInUse, TrainingError
from bnserve_surrogate.training.reduction.metric import MismatchMetric
from bnserve_surrogate.training.reduction.nodes import configured_nodes
from bnserve_surrogate.training.reduction.reductions import PaperReduction, ReducedResiduals, Reduction, reduce_dataset
from bnserve_surrogate.training.reduction.weights import mismatch_metric
from bnserve_surrogate.training.regressors import Beside, coordinate_map, make_regressor
from bnserve_surrogate.training.sections import TrainingConfiguration

Rows = NDArray[np.intp]
_TIMEOUT = 60.0
"""How long to wait for another process that reads the same data set."""


class TrialFailed(TrainingError):
    """Hyper-parameters with which nothing can be fitted, or whose predictions are not finite."""

    code = "trial-failed"
    title = "Hyper-parameters without a result"


@dataclass(frozen=True)
class TrialCost:
    """Of one set of hyper-parameters.

    Parameters
    ----------
    reconstruction_error
        Average over the validation waveforms of |x_orig - x_pred|^2 / (n_A + n_phi) (paper, section "Hyperparameter
        optimization"), x = [dA, dphi] at the nodes without what the reduction treats as a scalar.
    median_mismatch
        Of the same waveforms, time and phase maximised, to second order in the differences.
    training_seconds
        CPU seconds of reduction and regression.
    """

    reconstruction_error: float
    median_mismatch: float
    training_seconds: float


@dataclass(frozen=True)
class SearchData:
    """One data set from which every trial draws its own training and validation waveforms, and its metric."""

    dataset: ResidualDataset
    metric: MismatchMetric
    generator: WaveformGenerator

    def draw(self, seed: int, training: int, validation: int) -> tuple[Rows, Rows]:
        """Rows of the two sets, disjoint; other ones for another seed."""
        order = np.random.default_rng(seed).permutation(len(self.dataset))
        return np.sort(order[:training]), np.sort(order[training : training + validation])


def load_search_data(
    configuration: TrainingConfiguration, directory: Path, say: Callable[[str], None] = print, **options: Any
) -> SearchData:
    """The waveforms of a configuration; ``options`` and errors as for ``Generation``.

    Waits for another process that reads the same ones.
    """
    generator = configured_generator(configuration)
    generate = Generation(configuration, generator, directory, **options)
    until = time.monotonic() + _TIMEOUT
    while True:
        try:
            dataset = training_set(generate, *configured_nodes(generate, say), say)
            return SearchData(dataset, mismatch_metric(dataset, configuration), generator)
        except DatasetInUse:
            if time.monotonic() > until:
                raise
            time.sleep(0.5)


def evaluate(configuration: TrainingConfiguration, data: SearchData, training: Rows, validation: Rows) -> TrialCost:
    """Train with a configuration on some rows and measure on others.

    What is fitted is what a training fits for the components; the merger's time and phase, which neither cost sees,
    are left out where they have a regressor of their own.

    Raises
    ------
    TrialFailed
        With the reason.
    """
    components = configuration.reduction.components
    known, unseen = data.dataset.subset(training), data.dataset.subset(validation)
    started = time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)  # the number of epochs is searched
            reduction, targets, _ = reduce_dataset(configuration, data.generator, data.metric, known)
            coordinates = coordinate_map(configuration, known.theta)
            regressor = make_regressor(configuration, data.metric)
            if isinstance(regressor, Beside):
                regressor, targets = regressor.first, targets[:, :components]
            regressor.fit(coordinates(known.theta), targets)
        seconds = time.process_time() - started
        predicted = regressor.predict(coordinates(unseen.theta))[:, :components]
    except (ValueError, ArithmeticError, np.linalg.LinAlgError) as error:
        raise TrialFailed(f"{type(error).__name__}: {error}") from error
    return _cost(reduction, data.metric, unseen, predicted, seconds)


def _cost(
    reduction: Reduction, metric: MismatchMetric, unseen: ResidualDataset, components: FloatArray, seconds: float
) -> TrialCost:
    zero = np.zeros(len(unseen))
    amplitude, phase = _flat(reduction, metric, unseen)
    with np.errstate(over="ignore", invalid="ignore"):
        ours = reduction.inverse_transform(ReducedResiduals(components, zero, zero, zero))
        differences = ours[0] - amplitude, ours[1] - phase
        error = float(np.mean(np.hstack(differences) ** 2))
        mismatch = np.sum(metric.transform(*differences).vectors ** 2, axis=1)
    if not (np.isfinite(error) and np.isfinite(mismatch).all()):
        raise TrialFailed("The predictions are not finite.")
    return TrialCost(error, float(np.median(mismatch)), seconds)


def _flat(reduction: Reduction, metric: MismatchMetric, dataset: ResidualDataset) -> tuple[FloatArray, FloatArray]:
    """The residuals that the components of a reduction stand for."""
    if isinstance(reduction, PaperReduction):
        return dataset.log_amplitude_ratio, flatten_phase(dataset.mf_phase, dataset.psi_residual).residual
    return metric.residuals(metric.transform(dataset.log_amplitude_ratio, dataset.psi_residual).vectors)
