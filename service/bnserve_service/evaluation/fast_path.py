"""The fast path: waveform requests that take less time than a task, answered by plain calls.

A request whose body has come with its headers and whose model promises to answer at once needs no coroutine, no
``receive`` and no future. :class:`~bnserve_service.http.protocol.BoundedProtocol` offers it here; what it
does not take goes the way of every other request.
"""

from __future__ import annotations

import re

from bnserve_protocol import QuotaExceeded
from bnserve_protocol.wire import MSGPACK
from bnserve_service.admission.control import Lifecycle
from bnserve_service.evaluation.endpoint import PATHS, answer_headers
from bnserve_service.evaluation.service import WaveformService
from bnserve_service.evaluation.waveforms import Packed, Question
from bnserve_service.http.access import AccessMiddleware
from bnserve_service.http.answers import Finish, Header
from bnserve_service.http.front import RequestContext, RequestContextMiddleware, new_context
from bnserve_service.http.hosts import HostCheck
from bnserve_service.http.requests import answer_digest, answer_media_type, request_media_type

_URL = re.compile(rb"/v1/models/([A-Za-z0-9_.-]+)(?:/versions/([A-Za-z0-9_.:-]+))?/waveforms")


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

    def offers(self, url: bytes) -> bool:
        """Whether a POST to ``url`` may be for it."""
        return _URL.fullmatch(url) is not None and not self._lifecycle.draining

    def take(self, url: bytes, headers: list[Header], body: bytes, finish: Finish) -> bool:
        """Begin to answer a request; ``finish`` is called at the end of this turn of the event loop.

        False when the request has to go the other way, and nothing has happened.
        """
        context = new_context(headers)
        try:
            question = self._ask(context, url, headers, body)
            if not question.quick:
                return False
            self._submit(context, question, finish)
        except QuotaExceeded as error:
            told = error.with_traceback(None)  # which knows this call, which knows the error: a ring of garbage
            self._service.refuse(context.owner, lambda: self._finish(context, told, finish))
        except Exception:  # the other way finds it again, and says what is wrong
            return False
        return True

    def _ask(self, context: RequestContext, url: bytes, headers: list[Header], body: bytes) -> Question:
        found = _URL.fullmatch(url)
        assert found is not None, "only what was offered"
        name, version = found[1].decode(), found[2].decode() if found[2] else None
        context.route = PATHS[0] if version is None else PATHS[1]
        self._hosts.check(context.headers, "POST", context.route)
        if self._access is not None:
            self._access.check(context, headers, "POST")
        media_type = request_media_type(context.headers)
        answer_type = answer_media_type(context.headers, preferred=media_type)
        context.request_digest = self._service.digest_now(body)
        return self._service.ask_now(name, version, body, media_type, answer_type, answer_digest(context.headers))

    def _submit(self, context: RequestContext, question: Question, finish: Finish) -> None:
        quota = context.quota
        if quota is None:
            self._service.submit_quick(
                question, context.deadline, lambda outcome: self._finish(context, outcome, finish), context.owner
            )
            return

        def deliver(outcome: Packed | BaseException) -> None:
            quota.end()
            self._finish(context, outcome, finish)

        quota.begin()
        try:
            with quota.paying(len(question.batch)):
                self._service.submit_quick(question, context.deadline, deliver, context.owner)
        except BaseException:
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
