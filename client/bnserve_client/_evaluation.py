"""One question, however many requests it takes: in pieces that the service takes, with what it has to know uploaded.

Waveforms and likelihoods are questions; a new kind is one module with one more class of :class:`Question`.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Any, ClassVar, NamedTuple, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_client._addresses import Address
from bnserve_client._messages import Conversation, Together
from bnserve_client._pinned import Pinned
from bnserve_client._session import RetryPolicy, Session
from bnserve_client._settings import progress_bar
from bnserve_protocol import (
    AnswerCorrupted,
    BnserveError,
    Forbidden,
    InvalidFrequencies,
    Limits,
    ModelIdentity,
    TooLarge,
    UndecodableBody,
    printable,
)

Arrays: TypeAlias = Mapping[str, NDArray[Any]]
_ROW = re.compile(r"\b([Rr]ow) (\d+)")


class UploadTooLarge(TooLarge):
    """What a question refers to is too large, which smaller batches do not help."""


class Upload(NamedTuple):
    """What the service has to know before it can answer, at a path that ends with its digest."""

    path: str
    media_type: str
    body: bytes


class Question(ABC):
    """One evaluation of a whole batch: where it is asked, what it costs, how it travels and what comes back."""

    unknown: ClassVar[type[BnserveError]]
    """What a service says that has not, or no longer, what was uploaded."""
    uploads: int
    """Behind a load balancer an upload may reach one replica and the request another: how often it is tried."""

    path: str
    """Below that of the model."""

    @abstractmethod
    def __len__(self) -> int:
        """Rows."""

    @abstractmethod
    def rows_per_request(self, limits: Limits) -> int:
        """How many of its rows one request may have."""

    @abstractmethod
    def encode(self, start: int, stop: int, address: Address | None) -> bytes:
        """A request for some rows, to the replica at ``address``; to any, with all that it needs, for None."""

    @abstractmethod
    def max_bytes(self, rows: int) -> int:
        """More than any right answer for that many rows can have."""

    @abstractmethod
    def decode(self, body: bytes | memoryview, rows: int, where: str, model: ModelIdentity) -> Arrays:
        """The arrays of that many rows, as they are kept, from an answer that must come from ``model``.

        Raises
        ------
        UndecodableBody
            The message cannot be read.
        AnswerCorrupted
            It is not an answer to this question, or another model's (:func:`check_model`).
        """

    @abstractmethod
    def upload(self, limits: Limits) -> Upload:
        """What the service has to know; UploadTooLarge where it takes nothing of that size."""

    def upload_refused(self, error: Forbidden | TooLarge) -> None:
        """Go on without the upload, if that is possible; raises ``error`` otherwise."""
        raise error

    def check(self) -> Question | None:
        """A smaller question with the same errors, to be asked before a large one is begun; None if there is none."""
        return None

    def smaller_may_pass(self, limits: Limits) -> bool:
        """Whether fewer rows could be taken where these are too many."""
        return True


class Evaluator:
    """Answers a :class:`Question` with one pinned model."""

    def __init__(self, session: Session, pinned: Pinned) -> None:
        self.session = session
        self.identity = pinned.identity
        self._limits = pinned.limits
        self._path = pinned.path

    def evaluate(self, question: Question) -> Conversation[Arrays]:
        """The arrays of all rows.

        Raises
        ------
        BnserveError
            As the local model; positions are rows of the whole batch.
        """
        rows = len(question)
        assembly = Assembly(rows)
        pieces = self._pieces(question)
        if len(pieces) == 1:
            yield from self._piece(question, 0, rows, assembly.place)
            return assembly.arrays
        check = question.check()
        if check is not None:
            for start, stop in self._pieces(check):
                yield from self._piece(check, start, stop, lambda start, arrays: None)
        with progress_bar(rows, self.session.settings.progress) as bar:

            def keep(start: int, arrays: Arrays) -> None:
                assembly.place(start, arrays)
                if bar is not None:
                    bar.update(len(arrays["status"]))

            conversations = [self._piece(question, start, stop, keep) for start, stop in pieces]
            yield Together(conversations, at_once=self.session.settings.parallel)
        return assembly.arrays

    def upload(self, question: Question, retries: RetryPolicy) -> Conversation[None]:
        """Make what a question refers to known to the replica that is being asked.

        Raises
        ------
        BnserveError
            The service refuses it.
        """
        path, media_type, body = question.upload(self._limits)
        try:
            yield from self.session.upload(path, media_type, body, retries)
        except (Forbidden, TooLarge) as error:
            question.upload_refused(error)

    def _pieces(self, question: Question) -> list[tuple[int, int]]:
        """Equal parts, as few as the limits allow: the service itself gives a large request to all its threads."""
        rows, most = len(question), question.rows_per_request(self._limits)
        if rows <= most:
            return [(0, rows)]
        step = -(-rows // -(-rows // most))
        return [(start, min(start + step, rows)) for start in range(0, rows, step)]

    def _piece(
        self, question: Question, start: int, stop: int, keep: Callable[[int, Arrays], None]
    ) -> Conversation[None]:
        """Evaluate some rows; where the service finds them too many, in halves."""
        try:
            arrays = yield from self._request(question, start, stop)
        except TooLarge as error:
            if isinstance(error, UploadTooLarge) or stop - start < 2:
                raise in_users_rows(error, start) from error.__cause__
            self._limits = yield from self.session.get("/v1/limits", Limits, self.session.retry_policy())
            if not question.smaller_may_pass(self._limits):
                raise in_users_rows(error, start) from error.__cause__
            middle = (start + stop) // 2
            yield from self._piece(question, start, middle, keep)
            yield from self._piece(question, middle, stop, keep)
            return
        except BnserveError as error:
            raise in_users_rows(error, start) from error.__cause__
        keep(start, arrays)

    def _request(self, question: Question, start: int, stop: int) -> Conversation[Arrays]:
        """One request; what it refers to is uploaded wherever it is not known, or not any more."""
        retries = self.session.retry_policy()
        for _ in range(question.uploads):
            try:
                body = question.encode(start, stop, retries.address)
                return (yield from self._post(question, body, stop - start, retries))
            except question.unknown:
                yield from self.upload(question, retries)
        body = question.encode(start, stop, None)
        return (yield from self._post(question, body, stop - start, retries))

    def _post(self, question: Question, body: bytes, rows: int, retries: RetryPolicy) -> Conversation[Arrays]:
        def read(answer: bytes | memoryview, where: str) -> Arrays:
            try:
                return question.decode(answer, rows, where, self.identity)
            except UndecodableBody as error:
                raise AnswerCorrupted(f"An answer from {where} cannot be read: {error.detail}") from error

        path = f"{self._path}/{question.path}"
        return self.session.post(path, body, read, question.max_bytes(rows), retries)


def check_model(answered: ModelIdentity, where: str, model: ModelIdentity) -> None:
    """Refuse the answer of another model: AnswerCorrupted."""
    if answered != model:
        other = printable(f"{answered.name} {answered.version} ({answered.digest})")
        raise AnswerCorrupted(
            f"{where} answered with {other}, but this model "
            f"is pinned to {model.name} {model.version} ({model.digest}). Connect again to use the other one."
        )


class Assembly:
    """Arrays of all ``rows`` of a batch, filled piece by piece; pieces may arrive in any order and thread."""

    def __init__(self, rows: int) -> None:
        self._rows = rows
        self.arrays: dict[str, NDArray[Any]] = {}

    def place(self, start: int, piece: Mapping[str, NDArray[Any]]) -> None:
        """Put a piece at its rows. A piece that is everything is kept without a copy."""
        for name, array in piece.items():
            if len(array) == self._rows:
                self.arrays[name] = array
                continue
            whole = self.arrays.get(name)
            if whole is None:
                whole = self.arrays.setdefault(name, self._room(array))
            whole[start : start + len(array)] = array

    def _room(self, piece: NDArray[Any]) -> NDArray[Any]:
        try:
            return np.empty((self._rows, *piece.shape[1:]), dtype=piece.dtype)
        except MemoryError as error:
            raise TooLarge(
                f"There is no memory here for the answers to all {self._rows} rows; ask for fewer rows at a time, for "
                'fewer frequencies, or with dtype="complex64".'
            ) from error


def in_users_rows(error: BnserveError, start: int) -> BnserveError:
    """The same error about rows of the whole batch, where it was about rows of the piece that begins at ``start``."""
    if start == 0 or isinstance(error, InvalidFrequencies):
        return error
    return type(error)(
        _ROW.sub(lambda found: f"{found[1]} {int(found[2]) + start}", error.detail),
        errors=[
            problem if problem.row is None else msgspec.structs.replace(problem, row=problem.row + start)
            for problem in error.errors
        ],
        retry_after=error.retry_after,
        request_id=error.request_id,
    )
