"""From a decoded question to a packed answer: stacking, one call of the model, splitting, packing. No HTTP."""

from __future__ import annotations

import time
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    DtypeName,
    EvaluationOptions,
    GridLike,
    InvalidRequest,
    Limits,
    Overloaded,
    ParameterBatch,
    TooLarge,
    UniformGrid,
)
from bnserve_protocol.wire import (
    JSON,
    MSGPACK,
    DigestName,
    array_keys,
    content_digest,
    encode_answer,
    encode_answer_json,
)
from bnserve_service.http.answers import Buffer
from bnserve_service.models.registry import LoadedModel, ServedModel, quick_work
from bnserve_service.settings import REQUEST_COST, ROW_COST, ServiceLimits
from bnserve_service.telemetry.metrics import Metrics

Arrays: TypeAlias = dict[str, NDArray[Any]]


@dataclass(frozen=True, slots=True, eq=False)
class Question:
    """One request, ready to evaluate."""

    model: LoadedModel
    batch: ParameterBatch
    grid: GridLike
    grid_key: Hashable
    """Equal keys mean equal grids."""
    output: str
    dtype: DtypeName
    options: EvaluationOptions
    media_type: str
    digest: DigestName = "sha-256"
    """Of the answer, as the caller wants it."""

    @property
    def key(self) -> Hashable:
        """Questions with equal keys may be evaluated in one call of the model."""
        return (id(self.model), self.grid_key, self.output, self.dtype, self.options)

    @property
    def points(self) -> int:
        """Frequencies."""
        return _points(self.grid)

    @property
    def cost(self) -> int:
        """Work in samples, what is fixed per row and per request included."""
        return len(self.batch) * (self.points + ROW_COST) + REQUEST_COST

    @property
    def quick(self) -> bool:
        """Whether it takes less time than handing it to a worker."""
        work = len(self.batch) * (self.points + ROW_COST)
        return work <= quick_work(self.model.model) and self.media_type == MSGPACK

    @property
    def answer_bytes(self) -> int:
        """Memory of the answer's arrays."""
        arrays = 1 if self.output in ("factored", "modes") else 2
        return len(self.batch) * self.points * arrays * (8 if self.dtype == "complex64" else 16)

    def check(self, limits: ServiceLimits) -> None:
        """Raise ``TooLarge`` when it is over a limit."""
        _check_sizes(len(self.batch), self.points, limits)
        if self.media_type == JSON and len(self.batch) * self.points > limits.max_json_samples:
            raise TooLarge(
                f"A JSON answer has at most {limits.max_json_samples} samples (rows times frequencies), this one would "
                f"have {len(self.batch) * self.points}: send Accept: application/msgpack, or ask for less."
            )


@dataclass(frozen=True, slots=True, eq=False)
class Packed:
    """An answer ready for the socket, and the seconds it took."""

    parts: list[Buffer]
    digest: bytes
    length: int
    evaluated: float
    """Seconds in the model, for the whole group."""
    packed: float
    started: float
    """``time.monotonic()`` when a worker took it."""


def grid_key(grid: GridLike, digest: Callable[[NDArray[np.float64]], str]) -> Hashable:
    """A key that is equal for equal grids."""
    return grid if isinstance(grid, UniformGrid) else digest(np.asarray(grid))


def _points(grid: GridLike) -> int:
    return len(grid)  # type: ignore[arg-type]  # a UniformGrid or an array here, both of which have a length


def _check_sizes(rows: int, points: int, limits: Limits) -> None:
    if points > limits.max_frequencies:
        raise TooLarge(f"A grid has at most {limits.max_frequencies} frequencies here; this one has {points}.")
    if rows > limits.max_rows:
        raise TooLarge(f"A batch has at most {limits.max_rows} rows here; this one has {rows}: split it.")
    if rows * points > limits.max_samples:
        raise TooLarge(
            f"A request has at most {limits.max_samples} samples (rows times frequencies) here; this one has "
            f"{rows * points}: send at most {limits.rows_per_request(points)} rows at a time on this grid."
        )


def evaluate_output(model: ServedModel, question: Question, batch: ParameterBatch) -> Arrays:
    """The arrays of one ``output``, one row per row of ``batch``; with the model's own error estimate if it has one."""
    arrays, estimates = _evaluate_output(model, question, batch)
    return arrays if estimates is None else arrays | {"estimated_mismatch": estimates}


def _evaluate_output(
    model: ServedModel, question: Question, batch: ParameterBatch
) -> tuple[Arrays, NDArray[np.float64] | None]:
    if question.output == "amplitude_phase":
        curves = model.predict_amplitude_phase(question.grid, batch, options=question.options)
        return {
            "amplitude": curves.amplitude,
            "phase": curves.phase,
            "status": curves.status,
        }, curves.estimated_mismatch
    if question.output == "polarizations":
        both = model.predict_batch(question.grid, batch, options=question.options, dtype=question.dtype)
        return {"h_plus": both.plus, "h_cross": both.cross, "status": both.status}, both.estimated_mismatch
    if len(model.description.modes) != 1:
        raise InvalidRequest(
            f"output '{question.output}' is for models of one mode; ask this model for 'polarizations'."
        )
    one = model.predict_factored(question.grid, batch, options=question.options, dtype=question.dtype)
    if question.output == "modes":
        degree, order = model.description.modes[0]
        return {f"h_{degree}{order}": one.h, "status": one.status}, one.estimated_mismatch
    return {"h": one.h, "plus": one.plus, "cross": one.cross, "status": one.status}, one.estimated_mismatch


class Evaluator:
    """Evaluates groups of questions that share a key; what a :class:`~bnserve_service.admission.queue.WorkQueue` calls.

    The model gives the same bits for a row whatever the batch around it, so that being grouped is invisible.
    """

    def __init__(self, metrics: Metrics) -> None:
        self._metrics = metrics

    def __call__(self, questions: Sequence[Question]) -> list[Packed | BaseException]:
        """An answer or an error for each question, in order."""
        started = time.monotonic()
        try:
            arrays = self._together(questions)
        except Exception as error:
            if len(questions) == 1:
                return [_told(error)]
            return [outcome for question in questions for outcome in self([question])]  # only the culprit is refused
        evaluated = time.monotonic() - started
        self._metrics.evaluation.observe(evaluated)
        return [pack(question, own, started, evaluated) for question, own in zip(questions, arrays, strict=True)]

    def _together(self, questions: Sequence[Question]) -> list[Arrays]:
        first = questions[0]
        loaded = first.model
        batches = [question.batch for question in questions]
        stacked = first.batch if len(batches) == 1 else ParameterBatch(np.concatenate([b.values for b in batches]))
        arrays = evaluate_output(loaded.model, first, stacked)
        self._metrics.evaluated(loaded.identity.name, len(stacked), len(stacked) * first.points)
        return split_rows(arrays, [len(batch) for batch in batches])


def _told(error: Exception) -> Exception:
    if isinstance(error, MemoryError):
        return Overloaded("There is no memory for this answer now; ask for fewer rows.")
    return error


def split_rows(arrays: Mapping[str, NDArray[Any]], lengths: Sequence[int]) -> list[Arrays]:
    """The rows of each part of a stacked batch, as views."""
    if len(lengths) == 1:
        return [dict(arrays)]
    ends = np.cumsum(lengths).tolist()
    return [
        {name: array[end - length : end] for name, array in arrays.items()}
        for end, length in zip(ends, lengths, strict=True)
    ]


def pack(question: Question, arrays: Arrays, started: float, evaluated: float) -> Packed:
    """The answer as buffers; the arrays' memory is not copied for MessagePack."""
    begun = time.monotonic()
    identity = question.model.identity
    parts: list[Buffer] = (
        [encode_answer_json(arrays, identity)]
        if question.media_type == JSON
        else encode_answer(arrays, identity, array_keys(question.media_type))
    )
    digest = content_digest(parts, question.digest).encode()
    length = sum(len(part) for part in parts)
    return Packed(parts, digest, length, evaluated, time.monotonic() - begun, started)
