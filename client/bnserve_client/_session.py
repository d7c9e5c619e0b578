"""Talking to one service: every request with its headers, its checks and its retry policy. Knows no sockets."""

from __future__ import annotations

import os
import random
import time
from collections.abc import Callable
from contextlib import nullcontext
from typing import TypeVar

from bnserve_client._addresses import Address
from bnserve_client._answers import problem_of, read_description, stranger
from bnserve_client._messages import Conversation, HttpRequest, HttpResponse, LookUp, Send, Sleep
from bnserve_client._replicas import Replicas, Resolver, names_to_resolve
from bnserve_client._settings import Settings
from bnserve_client._trace import trace_headers
from bnserve_client._trust import warn_of_token_in_clear
from bnserve_protocol import (
    AnswerCorrupted,
    BnserveError,
    ConnectionFailed,
    DeadlineExceeded,
    DigestUnknown,
    Forbidden,
    ModelUnknown,
    NotAcceptable,
    Overloaded,
    PathUnknown,
    QuotaExceeded,
    RunManifest,
    TooLarge,
    Unauthorized,
    UndecodableBody,
    UnsupportedMediaType,
    UntrustedAnswer,
    __version__,
)
from bnserve_protocol.wire import JSON, MSGPACK, PROBLEM_JSON, WANTED_DIGEST, content_digest, request_digest

_FIRST_PAUSE = 0.05
_LONGEST_PAUSE = 5.0
_UNTRUSTED_ATTEMPTS = 6
"""An answer that is damaged this often in a row, within some seconds, is not bad luck."""
_DOUBTFUL = (
    UndecodableBody,
    UnsupportedMediaType,
    NotAcceptable,
    TooLarge,
    PathUnknown,
    ModelUnknown,
    Unauthorized,
    Forbidden,
    DeadlineExceeded,
)
"""What a sound question cannot deserve, and one whose head was damaged on the way does."""
_DOUBTS = 3
"""It is believed when it is said once more than that, in a row."""

_chance = random.SystemRandom()
"""Neither shared between forked processes nor drawn from the generator that a sampler may have seeded."""


class RetryPolicy:
    """The retry state of one request: its deadline, its failures, and the replica it is talking to.

    Evaluations change nothing on the server, so every request may be sent again.
    """

    def __init__(self, settings: Settings, replicas: Replicas) -> None:
        self._timeout = settings.timeout
        self._retries = settings.retries
        self._replicas = replicas
        self._failures = 0
        self._untrusted = 0
        self._doubts = 0
        self.deadline = time.monotonic() + settings.timeout
        self._address: Address | None = replicas.only

    @property
    def address(self) -> Address:
        """The replica to ask: the same one until it fails."""
        if self._address is None:
            self._address = self._replicas.choose()
        return self._address

    def follow(self) -> None:
        """Choose another replica if the one to ask is none any more, because its name stands for other hosts now."""
        if self._address is not None and self._address not in self._replicas.addresses:
            self._address = None

    @property
    def seconds_left(self) -> float:
        """Seconds until the deadline, never negative."""
        return max(0.0, self.deadline - time.monotonic())

    def succeeded(self) -> None:
        """The replica gave an answer that can be used."""
        self._doubts = 0
        if self._failures or self._replicas.only is None:
            self._replicas.wake(self.address)

    def pause_after(self, error: BnserveError) -> float:
        """Seconds to wait before asking again (:attr:`address` may have moved on to another replica).

        Raises
        ------
        BnserveError
            ``error`` itself where asking again cannot help, or the retries or the time are used up.
        """
        untrusted = isinstance(error, UntrustedAnswer) or self._another_may_have_it(error)
        doubtful = isinstance(error, _DOUBTFUL) and not untrusted
        self._doubts = self._doubts + 1 if doubtful else 0
        doubted = doubtful and self._doubts <= _DOUBTS
        if not (error.retryable or untrusted or doubted):
            raise error
        self._failures += 1
        self._untrusted += untrusted
        if self._untrusted >= _UNTRUSTED_ATTEMPTS or (self._retries is not None and self._failures > self._retries):
            raise error
        if doubted:
            return 0.0
        pause = self._pause(error)
        if pause >= self.seconds_left:
            raise self._out_of_time(error) from error
        return pause

    def _another_may_have_it(self, error: BnserveError) -> bool:
        """Whether a replica lacks a model that others may have: while they are replaced one by one, some do."""
        return isinstance(error, DigestUnknown) or (
            isinstance(error, ModelUnknown) and len(self._replicas.addresses) > 1
        )

    def _pause(self, error: BnserveError) -> float:
        if isinstance(error, QuotaExceeded):
            if error.retry_after:  # exact: a quota is a sum, not a guess
                return error.retry_after * _chance.uniform(1.0, 1.25)
        else:
            self._replicas.rest(self.address, error.retry_after or 0.0, broken=not isinstance(error, Overloaded))
            self._address = self._replicas.choose()
            if self._replicas.any_awake():
                return 0.0
        pause = min(_LONGEST_PAUSE, _FIRST_PAUSE * 2.0 ** min(self._failures, 30)) * _chance.uniform(0.5, 1.0)
        return max(pause, (error.retry_after or 0.0) * _chance.uniform(1.0, 1.25))

    def _out_of_time(self, error: BnserveError) -> BnserveError:
        if self.seconds_left > 0.0 or not isinstance(error, ConnectionFailed):
            return error
        return DeadlineExceeded(
            f"No answer within the timeout of {self._timeout:g} s. {error.detail}", request_id=error.request_id
        )


_T = TypeVar("_T")

_SMALL_ANSWER = 2**20
"""No description, limit or problem is larger."""
_ALONE = nullcontext()


def trusted_body(response: HttpResponse, where: str, asked: str | None) -> bytes | memoryview:
    """The body of a successful answer, checked.

    Parameters
    ----------
    response
        What came back.
    where
        The address, for messages.
    asked
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
        self._token: tuple[tuple[str, str], ...] | None = None
        self._warned = False
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
        max_bytes
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
        named = (*request.headers, *trace_headers(), ("X-Request-ID", os.urandom(16).hex()))
        several = self._replicas.only is None
        while True:
            if several:
                yield from self._tend()
                retries.follow()
            deadline = ("X-Request-Deadline-Ms", str(int(min(retries.seconds_left, 1e8) * 1e3)))
            sent = HttpRequest(request.method, request.path, (*self._token_headers(), *named, deadline), request.body)
            try:
                with self._replicas.asking(retries.address) if several else _ALONE:
                    response = yield Send(retries.address, sent, self.settings.silence, retries.deadline, max_bytes)
                answer = read(response, retries.address.text)
            except BnserveError as error:
                if isinstance(error, Unauthorized):
                    self._token = None  # there may be another now
                    self.settings.token.forget()
                pause = retries.pause_after(error)
            else:
                retries.succeeded()
                return answer
            if pause > 0.0:
                yield Sleep(pause)

    def _token_headers(self) -> tuple[tuple[str, str], ...]:
        if self._token is None:
            self._token = self.settings.token.headers()
            if self._token and not self._warned:
                self._warned = True
                warn_of_token_in_clear(self.settings.addresses)
        return self._token

    def _tend(self) -> Conversation[None]:
        """Look at names again from time to time, and whether a replica that failed is back."""
        resolver = self._replicas.resolver
        if resolver is not None and (due := resolver.due()):
            resolver.found((yield LookUp(due)))
        resting = self._replicas.to_probe()
        if resting is None:
            return
        request = HttpRequest("GET", "/v2/health/ready", (*self._token_headers(), *self._headers))
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
