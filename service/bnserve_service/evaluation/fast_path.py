"""The fast path: waveform requests that take less time than a task, answered by plain calls.

A request whose body has come with its headers and whose model promises to answer at once needs no coroutine, no
``receive`` and no future. :class:`~bnserve_service.http.protocol.BoundedProtocol` offers it here; what it does
not take goes the way of every other request.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from bnserve_protocol import BnserveError, QuotaExceeded
from bnserve_protocol.wire import MSGPACK, DigestName
from bnserve_service.admission.control import Lifecycle
from bnserve_service.evaluation.endpoint import PATHS, answer_headers
from bnserve_service.evaluation.service import WaveformService
from bnserve_service.evaluation.waveforms import Packed, Question
from bnserve_service.http.access import AccessMiddleware
from bnserve_service.http.answers import Finish, Header, header_fields
from bnserve_service.http.front import RequestContext, RequestContextMiddleware, new_context
from bnserve_service.http.hosts import HostCheck
from bnserve_service.http.requests import answer_digest, answer_media_type, request_media_type

_URL = re.compile(rb"/v1/models/([A-Za-z0-9_.-]+)(?:/versions/([A-Za-z0-9_.:-]+))?/waveforms")


class Asked(NamedTuple):
    """What a head asks for: all that goes by it, and stays the same when it comes again."""

    headers: list[Header]
    fields: dict[bytes, bytes]
    route: str
    name: str
    version: str | None
    media_type: str
    answer_type: str
    digest: DigestName


class FastPath:
    """Answers small waveform requests without a task.

    Parameters
    ----------
    service:
        The use case.
    lifecycle:
        While draining, it is closed.
    front:
        What every answer has in common.
    hosts:
        Under which names.
    access:
        Who is let in; None for everybody.
    """

    def __init__(
        self,
        service: WaveformService,
        lifecycle: Lifecycle,
        front: RequestContextMiddleware,
        hosts: HostCheck,
        access: AccessMiddleware | None,
    ) -> None:
        self._service = service
        self._lifecycle = lifecycle
        self._front = front
        self._hosts = hosts
        self._access = access

    def read(self, url: bytes, headers: list[Header]) -> Asked | None:
        """What a POST asks for, as far as its head says; None where the other way has to look at it."""
        found = _URL.fullmatch(url)
        if found is None:
            return None
        name, version = found[1].decode(), found[2].decode() if found[2] else None
        route, fields = PATHS[0] if version is None else PATHS[1], header_fields(headers)
        try:
            self._hosts.check(fields, "POST", route)
            media_type = request_media_type(fields)
            answer_type = answer_media_type(fields, preferred=media_type)
        except BnserveError:  # the other way finds it again, and says what is wrong
            return None
        return Asked(headers, fields, route, name, version, media_type, answer_type, answer_digest(fields))

    def take(self, asked: Asked, varying: dict[bytes, bytes], body: bytes, finish: Finish) -> bool:
        """Begin to answer a request; ``finish`` is called at the end of this turn of the event loop.

        False when the request has to go the other way, and nothing has happened.

        Parameters
        ----------
        asked:
            From :meth:`read`, for this head or one that differs by the values of ``varying`` alone.
        """
        if self._lifecycle.draining:
            return False
        context = new_context(asked.fields | varying, asked.route)
        try:
            if self._access is not None:
                self._access.check(context, asked.headers, "POST")
            context.request_digest = self._service.digest_now(body)
            question = self._service.ask_now(
                asked.name, asked.version, body, asked.media_type, asked.answer_type, asked.digest
            )
            if not question.quick:
                return False
            self._submit(context, question, finish)
        except QuotaExceeded as error:
            told = error.with_traceback(None)  # which knows this call, which knows the error: a ring of garbage
            self._service.refuse(context.owner, lambda: self._finish(context, told, finish))
        except Exception:  # as above
            return False
        return True

    def _submit(self, context: RequestContext, question: Question, finish: Finish) -> None:
        quota = context.quota

        def deliver(outcome: Packed | BaseException) -> None:
            if quota is not None:
                quota.end()
            self._finish(context, outcome, finish)

        if quota is not None:
            quota.begin()
        try:
            with context.paying(len(question.batch)):
                self._service.submit_quick(question, context.deadline, deliver, context.owner)
        except BaseException:
            if quota is not None:
                quota.end()
            raise

    def _finish(self, context: RequestContext, outcome: Packed | BaseException, finish: Finish) -> None:
        if isinstance(outcome, BaseException):
            context.status, headers, body = self._front.problem_answer(outcome, context)
        else:
            context.status, body = 200, b"".join(outcome.parts)
            headers = answer_headers(outcome, MSGPACK, outcome.started)
        finish(context.status, headers + self._front.common_headers(context), body)
        self._front.finish("POST", context)
