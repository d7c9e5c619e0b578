"""The way of every question: admitted, read, queued, evaluated with others of its kind, packed. Knows no HTTP."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from bnserve_protocol import Overloaded
from bnserve_protocol.wire import content_digest
from bnserve_service.admission.control import Capacity, CostEstimates, Lifecycle
from bnserve_service.admission.queue import Job, WorkQueue
from bnserve_service.evaluation.questions import Arrays, Buffer, Kind, Question
from bnserve_service.http.body import BodyReader
from bnserve_service.http.requests import RequestContext
from bnserve_service.models.registry import LoadedModel, Registry
from bnserve_service.process.system import available_cpus
from bnserve_service.settings import Settings
from bnserve_service.telemetry.metrics import Metrics


@dataclass(slots=True, eq=False)
class Evaluated:
    """The arrays of one question, and the seconds they took."""

    arrays: Arrays
    started: float
    """``time.monotonic()`` when a worker took it."""
    seconds: float
    """For the whole group."""


@dataclass(slots=True, eq=False)
class Packed:
    """An answer ready for the socket, and the seconds it took, as of :class:`Evaluated`."""

    parts: list[Buffer]
    digest: bytes
    length: int
    started: float
    evaluated: float
    packed: float


Outcome: TypeAlias = Packed | Evaluated
EvaluationJob: TypeAlias = Job[Question, Outcome]

_NO_MEMORY = "There is no memory for this answer now; ask for fewer rows."


class Evaluator:
    """Evaluates groups of questions that share a key: what a :class:`WorkQueue` calls."""

    def __init__(self, metrics: Metrics) -> None:
        self._metrics = metrics

    def __call__(self, questions: Sequence[Question]) -> list[Outcome | BaseException]:
        """An answer or an error for each question, in order; the parts of one are packed when all are there."""
        started = time.monotonic()
        try:
            arrays = questions[0].kind.evaluate(questions)
        except Exception as error:
            if len(questions) == 1:
                return [Overloaded(_NO_MEMORY) if isinstance(error, MemoryError) else error]
            return [outcome for question in questions for outcome in self([question])]  # only the culprit is refused
        seconds = time.monotonic() - started
        self._metrics.evaluation.observe(seconds)
        answers: list[Outcome | BaseException] = []
        end = 0
        for question in questions:
            start, end = end, end + len(question.batch)
            own = arrays if len(questions) == 1 else {name: array[start:end] for name, array in arrays.items()}
            evaluated = Evaluated(own, started, seconds)
            answers.append(evaluated if question.is_part else pack(question, evaluated))
        return answers


def pack(question: Question, evaluated: Evaluated) -> Packed:
    """The answer as buffers, with their digest."""
    begun = time.monotonic()
    parts = question.kind.encode(question, evaluated.arrays)
    digest = content_digest(parts, question.digest).encode()
    seconds = time.monotonic() - begun
    return Packed(parts, digest, sum(map(len, parts)), evaluated.started, evaluated.seconds, seconds)


def join(question: Question, outcomes: Sequence[Outcome]) -> Packed:
    """The answer to a question, from those to its pieces."""
    if isinstance(outcomes[0], Packed):
        return outcomes[0]
    pieces = [piece for piece in outcomes if isinstance(piece, Evaluated)]
    arrays = {name: np.concatenate([piece.arrays[name] for piece in pieces]) for name in pieces[0].arrays}
    started, seconds = min(piece.started for piece in pieces), max(piece.seconds for piece in pieces)
    return pack(question, Evaluated(arrays, started, seconds))


class EvaluationService:
    """Admits questions, reads them and has them evaluated.

    Parameters
    ----------
    settings
        The limits, and how many threads evaluate: a large question may be divided among all of them.
    registry, lifecycle
        Where models are, and whether new work is accepted.
    bodies, metrics
        Who works through large bodies, and where to count.
    """

    def __init__(
        self, settings: Settings, registry: Registry, lifecycle: Lifecycle, bodies: BodyReader, metrics: Metrics
    ) -> None:
        self._registry = registry
        self._lifecycle = lifecycle
        self._bodies = bodies
        self._workers = settings.threads or available_cpus()
        self._piece_cost = settings.group_samples
        self.queue: WorkQueue[Question, Outcome] = WorkQueue(
            Evaluator(metrics),
            workers=self._workers,
            capacity=settings.queue_samples,
            group_cost=settings.group_samples,
            metrics=metrics,
        )
        """Who evaluates."""
        self._cost_estimates = CostEstimates()
        self._promised = Capacity(settings.max_answer_bytes)
        self._capacity = settings.queue_samples

    def watch(self, metrics: Metrics) -> None:
        """Show what waits."""
        queue, promised = self.queue, self._promised
        metrics.watch("bnserve_queue_samples", "Work waiting or running, in samples", lambda: queue.cost)
        metrics.watch("bnserve_queue_jobs", "Requests that no worker has taken yet", lambda: queue.workers.waiting)
        metrics.watch("bnserve_queue_capacity_samples", "Work that may wait or run", lambda: self._capacity)
        metrics.watch("bnserve_answers_bytes", "Memory of answers under way", lambda: promised.total)

    @property
    def answer_bytes(self) -> int:
        """Memory promised to answers that are being computed or sent."""
        return self._promised.total

    def refuse_early(self, kind: Kind[Any], request: RequestContext, deadline: float | None, size: int) -> None:
        """Refuse a body of ``size`` bytes before it is read and decoded, if others of its kind would be refused now.

        Raises
        ------
        Overloaded, QuotaExceeded, DeadlineExceeded
            As :meth:`submit`, for what bodies of this size have cost.
        """
        cost = self._cost_estimates.cost((request.owner, kind.subject(request)), size)
        if cost is not None:
            self.queue.check_room(request.owner, cost, deadline)

    async def ask(self, kind: Kind[Any], body: bytes, request: RequestContext) -> Question:
        """Find the model, decode and check a body; large ones in a thread.

        Raises
        ------
        Draining
            No new work is accepted.
        ModelUnknown, ModelLoading
            The model is not here, or not yet.
        UndecodableBody, InvalidRequest, NotFound, TooLarge
            As :meth:`Kind.read <bnserve_service.evaluation.questions.Kind.read>`.
        """
        kind.address(body, request)
        model = self._find(request)
        size = len(body) + kind.bytes_to_load(request)
        question: Question = await self._bodies.work(size, kind.read, model, body, request)
        self._cost_estimates.learn((request.owner, kind.subject(request)), len(body), question.cost)
        return question

    def ask_now(self, kind: Kind[Any], body: bytes, request: RequestContext) -> Question:
        """:meth:`ask`, for small bodies that tell all."""
        question: Question = kind.read(self._find(request), body, request)
        return question

    def _find(self, request: RequestContext) -> LoadedModel:
        self._lifecycle.check_accepting()
        return self._registry.find(request.path["name"], request.path.get("version"))

    @contextmanager
    def reserve(self, question: Question, owner: str) -> Iterator[Callable[[int], None]]:
        """Hold memory for an answer until it has been sent, or so many bytes less as the yielded function is told.

        Raises
        ------
        Overloaded
            Too many answers are waiting to be taken by their clients.
        """
        size = question.answer_bytes
        if self._promised.total and not (self._promised.fits(size) or self._promised.may_displace(owner, size)):
            raise Overloaded("Too many large answers are under way; try again shortly.", retry_after=1.0)
        left = size

        def give_back(nbytes: int) -> None:
            nonlocal left
            nbytes = min(nbytes, left)
            left -= nbytes
            self._promised.remove(owner, nbytes)

        self._promised.add(owner, size)
        try:
            yield give_back
        finally:
            give_back(left)

    def submit(self, question: Question, deadline: float | None, owner: str) -> list[EvaluationJob]:
        """Queue a question, in as many pieces as can be evaluated at once; all of them or none.

        Raises
        ------
        Overloaded, QuotaExceeded, DeadlineExceeded
            As :meth:`WorkQueue.submit <bnserve_service.admission.queue.WorkQueue.submit>`.
        """
        jobs: list[EvaluationJob] = []
        try:
            for piece in (question,) if question.quick else question.pieces(self._workers, self._piece_cost):
                jobs.append(self.queue.submit(piece.key, piece.cost, piece, deadline, quick=piece.quick, owner=owner))
        except BaseException:
            for job in jobs:
                self.queue.withdraw(job, "disconnect")
            raise
        return jobs
