"""From a decoded likelihood question to log-likelihoods: pieces for the workers, stacking, evaluating. No HTTP."""

from __future__ import annotations

import time
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import LikelihoodBatch, Limits, Overloaded, TooLarge, check_model_of, likelihood_samples
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import REQUEST_COST, ROW_COST
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.stores import LikelihoodFactory, StoredAnalysis

Layout: TypeAlias = tuple[frozenset[str], tuple[tuple[str, int], ...]]


@dataclass(frozen=True, slots=True, eq=False)
class LikelihoodQuestion:
    """One request, or the rows of one request that one worker takes."""

    model: LoadedModel
    stored: StoredAnalysis
    batch: LikelihoodBatch

    @property
    def key(self) -> Hashable:
        """Questions with equal keys may be evaluated in one call."""
        return (id(self.model), self.stored.analysis.digest, _layout(self.batch))

    @property
    def row_cost(self) -> int:
        """Work of one row in samples."""
        return likelihood_samples(self.stored.analysis) + ROW_COST

    @property
    def cost(self) -> int:
        """Work in samples, what is fixed per row and per piece included."""
        return len(self.batch) * self.row_cost + REQUEST_COST

    def check(self, limits: Limits) -> None:
        """Raise what need not wait for a worker: ``TooLarge``, and ``AnalysisInvalid`` for another model's analysis."""
        analysis = self.stored.analysis
        check_model_of(analysis, self.model.identity)
        rows, samples = len(self.batch), likelihood_samples(analysis)
        if rows > limits.max_rows:
            raise TooLarge(f"A batch has at most {limits.max_rows} rows here; this one has {rows}: split it.")
        if rows * samples > limits.max_samples:
            raise TooLarge(
                f"A request has at most {limits.max_samples} samples here, and a row of this analysis counts as "
                f"{samples}: send at most {limits.max_samples // samples} rows at a time."
            )

    def pieces(self, most: int, piece_cost: int) -> list[LikelihoodQuestion]:
        """The rows in at most ``most`` consecutive parts, each worth the hand-over to a worker."""
        count = max(1, min(most, self.cost // piece_cost))
        rows = max(1, -(-len(self.batch) // count))
        if rows >= len(self.batch):
            return [self]
        return [LikelihoodQuestion(self.model, self.stored, part) for part in self.batch.split(rows)]


def _layout(batch: LikelihoodBatch) -> Layout:
    """Which parameters were left out, and which detectors have how many calibration nodes."""
    return batch.absent, tuple((name, array.shape[1]) for name, array in batch.calibration_amplitude.items())


@dataclass(frozen=True, slots=True, eq=False)
class LogLikelihoods:
    """The answer to one question, and the seconds it took."""

    values: NDArray[np.float64]
    status: NDArray[np.uint8]
    evaluated: float
    """Seconds of the evaluation, for the whole group."""
    started: float
    """``time.monotonic()`` when a worker took it."""


class LikelihoodEvaluator:
    """Evaluates groups of questions that share a key; what a :class:`~bnserve_service.admission.queue.WorkQueue` calls.

    A row has the same bits whatever the batch around it, so that being split and being grouped are invisible.

    Parameters
    ----------
    metrics:
        Where to count.
    bind:
        Makes the likelihood of an analysis with a model.
    """

    def __init__(self, metrics: Metrics, bind: LikelihoodFactory) -> None:
        self._metrics = metrics
        self._bind = bind

    def __call__(self, questions: Sequence[LikelihoodQuestion]) -> list[LogLikelihoods | BaseException]:
        """An answer or an error for each question, in order."""
        started = time.monotonic()
        try:
            values, status = self._together(questions)
        except Exception as error:
            if len(questions) == 1:
                return [_told(error)]
            return [outcome for question in questions for outcome in self([question])]  # only the culprit is refused
        evaluated = time.monotonic() - started
        self._metrics.evaluation.observe(evaluated)
        self._metrics.likelihoods(questions[0].model.identity.name, status)
        answers: list[LogLikelihoods | BaseException] = []
        end = 0
        for question in questions:
            rows = slice(end, end := end + len(question.batch))
            answers.append(LogLikelihoods(values[rows], status[rows], evaluated, started))
        return answers

    def _together(self, questions: Sequence[LikelihoodQuestion]) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        first = questions[0]
        likelihood = first.stored.likelihood(first.model, self._bind)
        return likelihood.evaluate(stack([question.batch for question in questions]))


def evaluating_both(
    waveforms: Callable[[Sequence[Any]], Sequence[Any]], likelihoods: LikelihoodEvaluator
) -> Callable[[Sequence[Any]], Sequence[Any]]:
    """One function for one queue: groups of likelihood questions to one evaluator, all others to the other."""

    def evaluate(questions: Sequence[Any]) -> Sequence[Any]:
        return (likelihoods if isinstance(questions[0], LikelihoodQuestion) else waveforms)(questions)

    return evaluate


def stack(batches: Sequence[LikelihoodBatch]) -> LikelihoodBatch:
    """Batches of one layout as one batch."""
    if len(batches) == 1:
        return batches[0]
    first = batches[0]
    return LikelihoodBatch(
        np.concatenate([batch.values for batch in batches]),
        {
            name: np.concatenate([b.calibration_amplitude[name] for b in batches])
            for name in first.calibration_amplitude
        },
        {name: np.concatenate([b.calibration_phase[name] for b in batches]) for name in first.calibration_phase},
        first.absent,
    )


def _told(error: Exception) -> Exception:
    if isinstance(error, MemoryError):
        return Overloaded("There is no memory for this answer now; ask for fewer rows.")
    return error
