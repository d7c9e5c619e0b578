"""Talking to one service: every request with its headers, its retries and its checks. Knows no sockets."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import TypeVar

from bnserve_client._answers import problem_of, read_description, stranger
from bnserve_client._messages import Conversation, HttpRequest, HttpResponse, LookUp, Send, Sleep
from bnserve_client._resolver import Resolver, names_to_resolve
from bnserve_client._retry_policy import Replicas, RetryPolicy
from bnserve_client._settings import Settings
from bnserve_protocol import (
    AnswerCorrupted,
    BnserveError,
    RunManifest,
    __version__,
)
from bnserve_protocol.wire import JSON, MSGPACK, PROBLEM_JSON, WANTED_DIGEST, content_digest, request_digest

_T = TypeVar("_T")

_SMALL_ANSWER = 2**20
"""No description, limit or problem is larger."""


def trusted_body(response: HttpResponse, where: str, asked: str | None) -> bytes | memoryview:
    """The body of a successful answer, checked.

    Parameters
    ----------
    response:
        What came back.
    where:
        The address, for messages.
    asked:
        The :func:`bnserve_protocol.wire.request_digest` of the question; None for a GET.

    Raises
    ------
    AnswerCorrupted
        The body is not the one that was sent, or answers another question.
    NotBnserve
        No such answer could come from bnserve.
    BnserveError
        What the service said was wrong.
    """
    stated = response.headers.get("content-digest")
    if stated is None:
        raise stranger(response, where)
    if stated != content_digest([response.body], "crc32c" if stated.startswith("crc32c=") else "sha-256"):
        raise AnswerCorrupted(f"An answer from {where} was damaged on the way: its Content-Digest does not match.")
    answered = response.headers.get("x-request-digest")
    successful = 200 <= response.status < 300
    if asked is not None and answered != asked and (answered is not None or successful):
        raise AnswerCorrupted(f"An answer from {where} belongs to another question: its X-Request-Digest is wrong.")
    if not successful:
        raise problem_of(response, where)
    return response.body


class Session:
    """Requests to the replicas of one service."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        names = names_to_resolve(settings.addresses) if settings.resolve else ()
        self._replicas = Replicas(settings.addresses, Resolver(settings.addresses, names) if names else None)
        self._headers = (("User-Agent", f"bnserve-client/{__version__}"),)
        self._post_headers = (
            *self._headers,
            ("Content-Type", MSGPACK),
            ("Accept", f"{MSGPACK}, {PROBLEM_JSON}"),
            ("Want-Content-Digest", WANTED_DIGEST),
        )

    def retry_policy(self) -> RetryPolicy:
        """A fresh deadline."""
        return RetryPolicy(self.settings, self._replicas)

    def get(self, path: str, message: type[_T], retries: RetryPolicy) -> Conversation[_T]:
        """Ask for a structured answer."""
        request = HttpRequest("GET", path, (*self._headers, ("Accept", f"{JSON}, {PROBLEM_JSON}")))

        def read(response: HttpResponse, where: str) -> _T:
            return read_description(trusted_body(response, where, None), message, where)

        return self._ask(request, read, _SMALL_ANSWER, retries)

    def manifest(self) -> Conversation[RunManifest]:
        """The manifest of the replica that answers."""
        return self.get("/v1/manifest", RunManifest, self.retry_policy())

    def upload(self, path: str, media_type: str, body: bytes, retries: RetryPolicy) -> Conversation[None]:
        """Put something that its path names by its digest."""
        headers = (*self._headers, ("Content-Type", media_type), ("Accept", f"{JSON}, {PROBLEM_JSON}"))
        request = HttpRequest("PUT", path, headers, body)
        asked = request_digest(body)

        def read(response: HttpResponse, where: str) -> None:
            trusted_body(response, where, asked)

        return self._ask(request, read, _SMALL_ANSWER, retries)

    def post(
        self,
        path: str,
        body: bytes,
        read: Callable[[bytes | memoryview, str], _T],
        max_bytes: int,
        retries: RetryPolicy,
    ) -> Conversation[_T]:
        """Send MessagePack and read MessagePack: ``read(body, where)`` gets a body whose digests are right.

        Parameters
        ----------
        max_bytes:
            More than any right answer can have.
        """
        request = HttpRequest("POST", path, self._post_headers, body)
        asked = request_digest(body)

        def checked(response: HttpResponse, where: str) -> _T:
            return read(trusted_body(response, where, asked), where)

        return self._ask(request, checked, max(_SMALL_ANSWER, max_bytes), retries)

    def _ask(
        self, request: HttpRequest, read: Callable[[HttpResponse, str], _T], max_bytes: int, retries: RetryPolicy
    ) -> Conversation[_T]:
        """Ask until there is an answer that can be used, or the retries end."""
        named = (*self.settings.token.headers(), *request.headers, ("X-Request-ID", os.urandom(16).hex()))
        while True:
            yield from self._tend()
            retries.follow()
            deadline = ("X-Request-Deadline-Ms", str(int(min(retries.seconds_left, 1e8) * 1e3)))
            sent = HttpRequest(request.method, request.path, (*named, deadline), request.body)
            try:
                with self._replicas.asking(retries.address):
                    response = yield Send(retries.address, sent, self.settings.silence, retries.deadline, max_bytes)
                answer = read(response, retries.address.text)
            except BnserveError as error:
                pause = retries.pause_after(error)
            else:
                retries.succeeded()
                return answer
            if pause > 0.0:
                yield Sleep(pause)

    def _tend(self) -> Conversation[None]:
        """Look at names again from time to time, and whether a replica that failed is back."""
        resolver = self._replicas.resolver
        if resolver is not None and (due := resolver.due()):
            resolver.found((yield LookUp(due)))
        resting = self._replicas.to_probe()
        if resting is None:
            return
        request = HttpRequest("GET", "/v2/health/ready", (*self.settings.token.headers(), *self._headers))
        try:
            seconds = self._replicas.probe_seconds
            answer = yield Send(resting, request, seconds, time.monotonic() + seconds, _SMALL_ANSWER)
        except BnserveError:
            ready = False
        else:
            ready = answer.status < 500
        if ready:
            self._replicas.wake(resting)
        else:
            self._replicas.rest(resting)
