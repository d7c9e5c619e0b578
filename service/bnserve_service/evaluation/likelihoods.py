"""The use case behind ``/v1/analyses`` and ``POST .../likelihoods/{id}``: bodies in, answers out. Knows no HTTP."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from bnserve_protocol import InvalidRequest
from bnserve_protocol.wire import (
    JSON,
    LikelihoodAnswer,
    LikelihoodRequest,
    array_keys,
    content_digest,
    decode_likelihood_request,
    encode_likelihood_answer,
    encode_likelihood_answer_json,
    request_digest,
)
from bnserve_service.admission.control import Lifecycle
from bnserve_service.admission.queue import Job, WorkQueue
from bnserve_service.evaluation.likelihood_evaluator import LikelihoodQuestion, LogLikelihoods
from bnserve_service.evaluation.service import OFF_LOOP
from bnserve_service.evaluation.waveforms import Packed
from bnserve_service.http.answers import Buffer
from bnserve_service.models.registry import Registry
from bnserve_service.settings import Settings
from bnserve_service.uploads.stores import AnalysisStore, StoredAnalysis


class LikelihoodService:
    """Keep analyses; decode questions, look up, admit, evaluate, pack.

    Parameters
    ----------
    settings:
        The limits.
    registry, analyses, queue, lifecycle:
        Where models and analyses are, who evaluates, and whether new work is accepted.
    workers:
        Threads that evaluate: a large request is given to all of them.
    """

    def __init__(
        self,
        settings: Settings,
        registry: Registry,
        analyses: AnalysisStore,
        queue: WorkQueue[Any, Any],
        lifecycle: Lifecycle,
        workers: int,
    ) -> None:
        self._limits = settings.limits()
        self._piece_cost = settings.group_samples
        self._registry = registry
        self._analyses = analyses
        self._queue: WorkQueue[LikelihoodQuestion, LogLikelihoods] = queue
        self._lifecycle = lifecycle
        self._workers = workers
        self._helper = ThreadPoolExecutor(1, thread_name_prefix="bnserve-analyses")

    async def large_or_small(self, size: int, function: Any, *arguments: Any) -> Any:
        """Call ``function`` at once for small bodies and in a helper thread for large ones."""
        if size <= OFF_LOOP:
            return function(*arguments)
        return await asyncio.get_running_loop().run_in_executor(self._helper, function, *arguments)

    async def digest(self, body: bytes) -> str:
        """SHA-256 of a request body, in hexadecimal."""
        return await self.large_or_small(len(body), request_digest, body)

    def close(self) -> None:
        """Stop the helper thread."""
        self._helper.shutdown(wait=False, cancel_futures=True)

    async def keep(self, owner: str, sha256: str, body: bytes) -> tuple[StoredAnalysis, bool]:
        """Decode and store an analysis; whether it is new to its owner.

        Raises
        ------
        Draining, UndecodableBody, AnalysisInvalid, TooLarge
        """
        self._lifecycle.check_accepting()
        return await self.large_or_small(len(body), self._analyses.put, owner, sha256, body)

    async def ask(
        self, owner: str, model: tuple[str, str | None], sha256: str, body: bytes, media_type: str
    ) -> LikelihoodQuestion:
        """Decode and check a request.

        Raises
        ------
        Draining, ModelUnknown, ModelLoading, AnalysisUnknown, AnalysisInvalid, UndecodableBody, InvalidParameters,
        TooLarge
        """
        self._lifecycle.check_accepting()
        loaded = self._registry.find(*model)
        to_read = self._analyses.bytes_to_read(owner, sha256)
        stored: StoredAnalysis = await self.large_or_small(to_read, self._analyses.get, owner, sha256)
        request: LikelihoodRequest = await self.large_or_small(len(body), decode_likelihood_request, body, media_type)
        if request.analysis not in (None, stored.analysis.digest):
            raise InvalidRequest("The body names another analysis than the path; they must be the same.")
        question = LikelihoodQuestion(loaded, stored, request.batch)
        question.check(self._limits)
        return question

    def submit(self, question: LikelihoodQuestion, deadline: float | None, owner: str = "") -> list[Job[Any, Any]]:
        """Queue a question, in as many pieces as can be evaluated at once; all of them or none.

        Raises
        ------
        Overloaded, QuotaExceeded, DeadlineExceeded
        """
        jobs: list[Job[Any, Any]] = []
        try:
            for piece in question.pieces(self._workers, self._piece_cost):
                jobs.append(self._queue.submit(piece.key, piece.cost, piece, deadline, owner=owner))
        except BaseException:
            for job in jobs:
                self.withdraw(job)
            raise
        return jobs

    def withdraw(self, job: Job[Any, Any]) -> None:
        """Forget a job whose caller went away."""
        self._queue.withdraw(job, "disconnect")


def pack(question: LikelihoodQuestion, pieces: Sequence[LogLikelihoods], media_type: str) -> Packed:
    """The answer as buffers."""
    begun = time.monotonic()
    answer = LikelihoodAnswer(
        log_likelihood=np.concatenate([piece.values for piece in pieces]),
        status=np.concatenate([piece.status for piece in pieces]),
        model=question.model.identity,
        analysis=question.stored.analysis.digest,
    )
    parts: list[Buffer] = (
        [encode_likelihood_answer_json(answer)]
        if media_type == JSON
        else encode_likelihood_answer(answer, array_keys(media_type))
    )
    digest = content_digest(parts).encode()
    evaluated = max(piece.evaluated for piece in pieces)
    started = min(piece.started for piece in pieces)
    return Packed(parts, digest, sum(len(part) for part in parts), evaluated, time.monotonic() - begun, started)
