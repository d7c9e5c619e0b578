"""Evaluating a batch remotely: in chunks that fit the service's limits, on a grid that it knows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from bnserve_client._answers import read_waveforms
from bnserve_client._chunks import Assembly, in_users_rows
from bnserve_client._grids import IN_FULL_ONCE, ExplicitGrid, ends_of
from bnserve_client._messages import Conversation, Together
from bnserve_client._patience import Patience
from bnserve_client._progress import progress_bar
from bnserve_client._results import Arrays, check_arrays
from bnserve_client._session import Pinned, Session
from bnserve_protocol import (
    BnserveError,
    DtypeName,
    EvaluationOptions,
    Forbidden,
    GridUnknown,
    Limits,
    ParameterBatch,
    TooLarge,
    UniformGrid,
)
from bnserve_protocol.wire import OutputName, WaveformRequest, encode_request

_UPLOADS = 2
"""Behind a load balancer an upload may reach one replica and the request another; then the grid travels in full."""
_BYTES_PER_SAMPLE = 32
"""The most that one sample takes in an answer: two complex128."""
_BYTES_PER_ROW = 64


@dataclass(frozen=True, slots=True)
class Question:
    """One evaluation of a whole batch, however many requests it takes."""

    batch: ParameterBatch
    grid: UniformGrid | ExplicitGrid
    output: OutputName
    dtype: DtypeName
    options: EvaluationOptions


class Evaluator:
    """Answers a :class:`Question` with one pinned model."""

    def __init__(self, session: Session, pinned: Pinned) -> None:
        self._session = session
        self._identity = pinned.identity
        self._limits = pinned.limits
        self._path = f"{pinned.path}/waveforms"

    def evaluate(self, question: Question, finish: Callable[[Arrays], Arrays]) -> Conversation[Arrays]:
        """The arrays of all rows.

        Parameters
        ----------
        question:
            What to evaluate.
        finish:
            Turns the arrays of any number of rows, read-only as they arrive, into those to keep.

        Raises
        ------
        BnserveError
            As the local model; positions are rows of the whole batch.
        """
        rows = len(question.batch)
        assembly = Assembly(rows)
        pieces = self._pieces(rows, len(question.grid), self._session.settings.chunk_samples)
        if len(pieces) == 1:
            yield from self._piece(question, 0, rows, lambda start, arrays: assembly.place(start, finish(arrays)))
            return assembly.arrays
        if question.options.out_of_domain == "error":
            yield from self._check(question)
        with progress_bar(rows, self._session.settings.progress) as bar:

            def keep(start: int, arrays: Arrays) -> None:
                assembly.place(start, finish(arrays))
                if bar is not None:
                    bar.update(len(arrays["status"]))

            conversations = [self._piece(question, start, stop, keep) for start, stop in pieces]
            yield Together(conversations, at_once=self._session.settings.parallel)
        return assembly.arrays

    def _pieces(self, rows: int, frequencies: int, samples: int) -> list[tuple[int, int]]:
        step = max(1, min(samples // frequencies, self._limits.rows_per_request(frequencies)))
        return [(start, min(start + step, rows)) for start in range(0, max(rows, 1), step)]

    def _check(self, question: Question) -> Conversation[None]:
        """Have all rows checked before the first is evaluated, so that errors speak of the whole batch, and at once.

        The checks depend on the parameters and on the ends of the grid, so two frequencies are enough.
        """
        ends = ends_of(question.grid)
        small = Question(question.batch, ends, question.output, question.dtype, question.options)
        for start, stop in self._pieces(len(question.batch), len(ends), self._limits.max_samples):
            yield from self._piece(small, start, stop, lambda start, arrays: None)

    def _piece(
        self, question: Question, start: int, stop: int, keep: Callable[[int, Arrays], None]
    ) -> Conversation[None]:
        """Evaluate some rows; where the service finds them too many, in halves."""
        part = ParameterBatch(question.batch.values[start:stop])
        try:
            arrays = yield from self._request(question, part)
        except TooLarge as error:
            if stop - start > 1 and (yield from self._smaller_may_pass(question)):
                middle = (start + stop) // 2
                yield from self._piece(question, start, middle, keep)
                yield from self._piece(question, middle, stop, keep)
                return
            raise in_users_rows(error, start) from error.__cause__
        except BnserveError as error:
            raise in_users_rows(error, start) from error.__cause__
        keep(start, arrays)

    def _smaller_may_pass(self, question: Question) -> Conversation[bool]:
        """Learn the limits anew: they differ from those at the time of connecting."""
        self._limits = yield from self._session.get("/v1/limits", Limits, self._session.patience())
        return len(question.grid) <= self._limits.max_frequencies

    def _request(self, question: Question, part: ParameterBatch) -> Conversation[Arrays]:
        """One request, with the grid in the shortest form that the service understands."""
        patience = self._session.patience()
        grid = question.grid
        if isinstance(grid, UniformGrid):
            return (yield from self._post(question, part, grid, patience))
        for _ in range(_UPLOADS + 1):
            try:
                return (yield from self._post(question, part, grid.on_the_wire(patience.address), patience))
            except GridUnknown:
                try:
                    yield from self._session.upload_grid(grid.sha256, grid.frequencies.tobytes(), patience)
                except (Forbidden, TooLarge):
                    grid.in_full = True
                    break
        grid.in_full = grid.in_full or len(grid) <= IN_FULL_ONCE  # short enough not to try again each time
        return (yield from self._post(question, part, grid.frequencies, patience))

    def _post(self, question: Question, part: ParameterBatch, grid: Any, patience: Patience) -> Conversation[Arrays]:
        rows, frequencies = len(part), len(question.grid)
        body = encode_request(
            WaveformRequest(
                batch=part, grid=grid, output=question.output, dtype=question.dtype, options=question.options
            )
        )

        def read(answer: bytes | memoryview, where: str) -> Arrays:
            arrays = read_waveforms(answer, where, self._identity).arrays
            check_arrays(arrays, question.output, question.dtype, rows, frequencies)
            return arrays

        max_bytes = rows * (frequencies * _BYTES_PER_SAMPLE + _BYTES_PER_ROW)
        return self._session.post(self._path, body, read, max_bytes, patience)
