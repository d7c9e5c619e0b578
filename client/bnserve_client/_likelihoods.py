"""Evaluating a likelihood remotely: an analysis made known where it is not, batches in parts that the service takes."""

from __future__ import annotations

from collections.abc import Callable

import msgspec

from bnserve_client._answers import check_model
from bnserve_client._chunks import Assembly, in_users_rows
from bnserve_client._messages import Conversation, Together
from bnserve_client._patience import Patience
from bnserve_client._progress import progress_bar
from bnserve_client._results import Arrays
from bnserve_client._session import Pinned, Session
from bnserve_protocol import (
    Analysis,
    AnalysisUnknown,
    AnswerCorrupted,
    BnserveError,
    LikelihoodBatch,
    Limits,
    TooLarge,
    UndecodableBody,
    check_model_of,
    encode_analysis,
    likelihood_samples,
)
from bnserve_protocol.wire import MSGPACK, decode_likelihood_answer, encode_likelihood_request

_UPLOADS = 16
"""Behind a load balancer an upload may reach one replica and the request another; in the end all have it."""
_BYTES_PER_ROW = 16
"""The most that one row takes in an answer."""
_HEAD_BYTES = 4096
"""Of a request beside its arrays."""


class AnalysisTooLarge(TooLarge):
    """The analysis itself is too large, which smaller batches do not help."""


class _AnalysisDocument(msgspec.Struct, frozen=True):
    """``GET /v1/analyses/{sha256}``."""

    sha256: str


class RemoteLikelihood:
    """Conversations about one analysis and one pinned model."""

    def __init__(self, session: Session, pinned: Pinned, analysis: Analysis) -> None:
        check_model_of(analysis, pinned.identity)
        self.analysis = analysis
        self._session = session
        self._identity = pinned.identity
        self._limits = pinned.limits
        self._samples = likelihood_samples(analysis)
        sha256 = analysis.digest.removeprefix("sha256:")
        self._path = f"{pinned.path}/likelihoods/{sha256}"
        self._analysis_path = f"/v1/analyses/{sha256}"

    def introduce(self) -> Conversation[None]:
        """Make the analysis known, if it is not.

        Raises
        ------
        AnalysisInvalid, TooLarge, Forbidden
            The service refuses the analysis.
        """
        patience = self._session.patience()
        try:
            yield from self._session.get(self._analysis_path, _AnalysisDocument, patience)
        except AnalysisUnknown:
            yield from self._upload(patience)

    def evaluate(self, batch: LikelihoodBatch) -> Conversation[Arrays]:
        """``log_likelihood`` and ``status`` of all rows.

        Raises
        ------
        BnserveError
            As the local likelihood; positions are rows of the whole batch.
        """
        assembly = Assembly(len(batch))
        pieces = self._pieces(batch)
        if len(pieces) == 1:
            yield from self._piece(batch, 0, len(batch), assembly.place)
            return assembly.arrays
        with progress_bar(len(batch), self._session.settings.progress) as bar:

            def keep(start: int, arrays: Arrays) -> None:
                assembly.place(start, arrays)
                if bar is not None:
                    bar.update(len(arrays["status"]))

            conversations = [self._piece(batch, start, stop, keep) for start, stop in pieces]
            yield Together(conversations, at_once=self._session.settings.parallel)
        return assembly.arrays

    def _pieces(self, batch: LikelihoodBatch) -> list[tuple[int, int]]:
        """Equal parts, as few as the limits allow: the service itself gives a large request to all its threads."""
        rows = len(batch)
        fitting = max(1, (self._limits.max_body_bytes - _HEAD_BYTES) // _bytes_per_row(batch))
        most = min(self._limits.rows_per_request(self._samples), fitting)
        count = max(1, -(-rows // most))
        step = max(1, -(-rows // count))
        return [(start, min(start + step, rows)) for start in range(0, max(rows, 1), step)]

    def _piece(
        self, batch: LikelihoodBatch, start: int, stop: int, keep: Callable[[int, Arrays], None]
    ) -> Conversation[None]:
        """Evaluate some rows; where the service finds them too many, in halves."""
        part = batch if stop - start == len(batch) else batch.rows(slice(start, stop))
        try:
            arrays = yield from self._request(part)
        except AnalysisTooLarge:
            raise
        except TooLarge as error:
            if stop - start < 2:
                raise in_users_rows(error, start) from error.__cause__
            self._limits = yield from self._session.get("/v1/limits", Limits, self._session.patience())
            middle = (start + stop) // 2
            yield from self._piece(batch, start, middle, keep)
            yield from self._piece(batch, middle, stop, keep)
            return
        except BnserveError as error:
            raise in_users_rows(error, start) from error.__cause__
        keep(start, arrays)

    def _request(self, part: LikelihoodBatch) -> Conversation[Arrays]:
        """One request; the analysis is uploaded wherever it is not known, or not any more."""
        patience = self._session.patience()
        body = encode_likelihood_request(self.analysis.digest, part)
        for _ in range(_UPLOADS):
            try:
                return (yield from self._post(body, len(part), patience))
            except AnalysisUnknown:
                yield from self._upload_again(patience)
        return (yield from self._post(body, len(part), patience))

    def _post(self, body: bytes, rows: int, patience: Patience) -> Conversation[Arrays]:
        def read(answer: bytes | memoryview, where: str) -> Arrays:
            try:
                found = decode_likelihood_answer(answer)
            except UndecodableBody as error:
                raise AnswerCorrupted(f"An answer from {where} cannot be read: {error.detail}") from error
            check_model(found.model, where, self._identity)
            if found.analysis != self.analysis.digest or len(found.status) != rows:
                raise AnswerCorrupted(f"An answer from {where} belongs to another analysis or batch.")
            return {"log_likelihood": found.log_likelihood.copy(), "status": found.status.copy()}

        return self._session.post(self._path, body, read, rows * _BYTES_PER_ROW, patience)

    def _upload_again(self, patience: Patience) -> Conversation[None]:
        try:
            yield from self._upload(patience)
        except TooLarge as error:
            raise AnalysisTooLarge(error.detail, request_id=error.request_id) from error

    def _upload(self, patience: Patience) -> Conversation[None]:
        body = b"".join(encode_analysis(self.analysis))
        limit = self._limits.max_analysis_bytes
        if len(body) > limit:
            raise TooLarge(
                f"This analysis has {len(body)} bytes and the service takes {limit}: use reduced-order quadrature or "
                "relative binning, or have its operators raise 'max_analysis_bytes'."
            )
        return self._session.upload(self._analysis_path, MSGPACK, body, patience)


def _bytes_per_row(batch: LikelihoodBatch) -> int:
    calibration = (*batch.calibration_amplitude.values(), *batch.calibration_phase.values())
    return 8 * sum(int(array.shape[1]) for array in (batch.values, *calibration))
