"""The two ways on which questions of every kind come: as requests of an ASGI application, and the fast path.

What came in one piece, and is evaluated in less time than a task takes, needs no coroutine, no ``receive`` and no
future: it is answered by plain calls. Nor does its head need a parser, or a look at what it asks for, when the same one
was right before: callers repeat theirs for hours, but for a few headers. This takes 60 us of the server's 200 less.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

from starlette.types import Receive, Scope, Send

from bnserve_protocol import BnserveError, QuotaExceeded
from bnserve_protocol.wire import JSON, MSGPACK, DigestName, request_digest
from bnserve_service.admission.control import Lifecycle
from bnserve_service.errors import ClientDisconnected
from bnserve_service.evaluation.questions import Kind, Question
from bnserve_service.evaluation.service import EvaluationJob, EvaluationService, Outcome, Packed, join
from bnserve_service.http.answers import Finish, send_answer
from bnserve_service.http.body import BodyReader
from bnserve_service.http.framing import Alone
from bnserve_service.http.front import Front
from bnserve_service.http.requests import (
    Header,
    RequestContext,
    context_of,
    header_fields,
    negotiate,
    new_context,
)
from bnserve_service.settings import Settings

WATCH_AFTER = 0.01
"""Seconds of waiting after which it is worth a task to notice that the caller went away."""


class EvaluationEndpoint:
    """An ASGI application for the paths of one kind of question.

    Parameters
    ----------
    kind
        Which.
    service
        The use case.
    settings
        Limits of size.
    bodies
        Reads the bodies.
    """

    def __init__(self, kind: Kind[Any], service: EvaluationService, settings: Settings, bodies: BodyReader) -> None:
        self._kind = kind
        self._service = service
        self._body_limits = {media_type: settings.body_limit(media_type) for media_type in (MSGPACK, JSON)}
        self._bodies = bodies

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Evaluate one request."""
        request = context_of(scope)
        request.media_type, request.answer_type, request.digest = self._kind.forms(request.headers)
        deadline = request.deadline
        refuse_early = partial(self._service.refuse_early, self._kind, request, deadline)
        with self._bodies.of(request) as incoming:
            body = await incoming.read(receive, self._body_limits[request.media_type], refuse_early)
            await incoming.name(body)
            question = await self._service.ask(self._kind, body, request)
            del body
        request.model = question.model.identity
        with request.paying(question.quota_rows), self._service.reserve(question, request.owner) as give_back:
            jobs = self._service.submit(question, deadline, request.owner)
            request.submitted = jobs[0].submitted
            outcomes = [await jobs[0].result] if question.quick else await wait_for(jobs, receive, self._service)
            packed = join(question, outcomes)
            request.started, request.evaluated = packed.started, packed.evaluated
            request.rows = len(question.batch)
            headers = answer_headers(packed, question.answer_type, jobs[0].submitted)
            await send_answer(send, 200, headers, packed.parts, give_back)


async def wait_for(jobs: Sequence[EvaluationJob], receive: Receive, service: EvaluationService) -> list[Outcome]:
    """The results of all jobs of one request, in order.

    When one fails, or nobody waits any more, the others are withdrawn.

    Raises
    ------
    ClientDisconnected
        Nobody waits any more.
    BnserveError
        One of the jobs failed.
    """
    loop = asyncio.get_running_loop()
    watcher: list[asyncio.Task[None]] = []
    timer = loop.call_later(
        WATCH_AFTER, lambda: watcher.append(loop.create_task(_forget_when_gone(jobs, receive, service)))
    )
    try:
        return [await job.result for job in jobs]
    except BaseException:
        for job in jobs:
            service.queue.withdraw(job, "disconnect")
        raise
    finally:
        timer.cancel()
        for task in watcher:
            task.cancel()


async def _forget_when_gone(jobs: Sequence[EvaluationJob], receive: Receive, service: EvaluationService) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass
    for job in jobs:
        service.queue.withdraw(job, "disconnect")
        if not job.result.done():
            job.result.set_exception(ClientDisconnected())
            job.result.exception()  # retrieved: only the first of them is waited for


_MOST_KNOWN = 256
"""Heads, of some 300 bytes and at most 16 KiB; they differ by model, program, and what proxies add."""


class _Asked(NamedTuple):
    """What a head asks for: all that goes by it but for the headers that vary."""

    fields: dict[bytes, bytes]
    kind: Kind[Any]
    route: str
    path: dict[str, str]
    media_type: str
    answer_type: str
    digest: DigestName


class FastPath:
    """Answers quick questions without a task; what it does not take goes the way of every other request.

    :class:`~bnserve_service.http.protocol.BoundedProtocol` offers it what comes in one piece.

    Parameters
    ----------
    kinds
        Of questions.
    service
        The use case.
    lifecycle
        While draining, it is closed.
    front
        Knows who is let in, and what every answer has in common.
    """

    def __init__(
        self, kinds: Sequence[Kind[Any]], service: EvaluationService, lifecycle: Lifecycle, front: Front
    ) -> None:
        self._places = [
            (kind, template, _pattern(template)) for kind in kinds if kind.may_be_quick for template in kind.paths
        ]
        self._service = service
        self._lifecycle = lifecycle
        self._front = front
        self._known: dict[tuple[bytes, ...], _Asked] = {}

    def learn(self, request: Alone, url: bytes, headers: list[Header]) -> None:
        """Know the head of a POST, if it asks for what may be quick and is no error."""
        for kind, route, pattern in self._places:
            found = pattern.fullmatch(url)
            if found is not None and request.head not in self._known:
                path = {name: text.decode() for name, text in found.groupdict().items()}
                fields = header_fields(headers)
                try:
                    self._front.hosts.check(fields, "POST", route)
                    forms = negotiate(fields)
                except BnserveError:  # the other way finds it again, and says what is wrong
                    return
                if len(self._known) >= _MOST_KNOWN:
                    self._known.clear()
                constant = {name: value for name, value in fields.items() if name not in request.varying}
                self._known[request.head] = _Asked(constant, kind, route, path, *forms)

    def take(self, request: Alone, finish: Finish, peer: tuple[str, int] | None) -> bool:
        """Begin to answer a request of ``peer``; ``finish`` is called at the end of this turn of the event loop.

        False when the request has to go the other way, and nothing has happened.
        """
        asked = self._known.get(request.head)
        if asked is None or self._lifecycle.draining:
            return False
        context = new_context(asked.fields | request.varying, asked.route)
        context.path = asked.path
        if peer is not None:
            context.peer = peer[0]
        context.media_type, context.answer_type, context.digest = asked.media_type, asked.answer_type, asked.digest
        try:
            if self._front.tokens is not None:
                self._front.tokens.check(context, list(request.varying.items()), "POST")
                context.check_quota()
            context.request_digest, context.bytes_in = request_digest(request.body), len(request.body)
            question = self._service.ask_now(asked.kind, request.body, context)
            if not question.quick:
                return False
            self._submit(context, question, finish)
        except QuotaExceeded as error:
            told = error.with_traceback(None)  # which knows this call, which knows the error: a ring of garbage
            self._service.queue.turns.refuse(context.owner, lambda: self._finish(context, told, finish))
        except Exception:  # as above
            return False
        return True

    def _submit(self, context: RequestContext, question: Question, finish: Finish) -> None:
        quota = context.quota
        context.model = question.model.identity

        def deliver(outcome: Outcome | BaseException) -> None:
            if isinstance(outcome, Packed):
                context.rows = len(question.batch)
                context.started, context.evaluated = outcome.started, outcome.evaluated
            if quota is not None:
                quota.end()
            self._finish(context, outcome, finish)

        if quota is not None:
            quota.begin()
        try:
            with context.paying(question.quota_rows):
                [job] = self._service.submit(question, context.deadline, context.owner)
            context.submitted, job.deliver = job.submitted, deliver
        except BaseException:
            if quota is not None:
                quota.end()
            raise

    def _finish(self, context: RequestContext, outcome: Outcome | BaseException, finish: Finish) -> None:
        if isinstance(outcome, BaseException):
            context.status, headers, body = self._front.problem_answer(outcome, context)
        else:
            assert isinstance(outcome, Packed), "a quick question is in one piece"
            context.status, body = 200, b"".join(outcome.parts)
            headers = answer_headers(outcome, context.answer_type, outcome.started)
        context.bytes_out = len(body)
        finish(context.status, headers + self._front.common_headers(context), body)
        self._front.finish("POST", context)


def _pattern(template: str) -> re.Pattern[bytes]:
    """Of the URLs that a template stands for and that need no decoding."""
    literals = re.split(r"{(\w+)}", template)
    parts = (f"(?P<{text}>[A-Za-z0-9_.:-]+)" if i % 2 else re.escape(text) for i, text in enumerate(literals))
    return re.compile("".join(parts).encode())


def answer_headers(packed: Packed, media_type: str, submitted: float) -> list[Header]:
    """The headers of an evaluated answer, with the milliseconds that its parts took."""
    waited, evaluated, written = 1e3 * (packed.started - submitted), 1e3 * packed.evaluated, 1e3 * packed.packed
    return [
        (b"content-type", media_type.encode()),
        (b"content-length", b"%d" % packed.length),
        (b"content-digest", packed.digest),
        (b"server-timing", b"queue;dur=%.3f, eval;dur=%.3f, pack;dur=%.3f" % (waited, evaluated, written)),
    ]
