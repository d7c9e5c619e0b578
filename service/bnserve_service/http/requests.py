"""What came: the headers of a request, what is known about it beside its body, and which forms of bodies it names."""

from __future__ import annotations

import os
import re
import time
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TypeAlias

from starlette.types import Scope

from bnserve_protocol import InvalidRequest, ModelIdentity, NotAcceptable, UnsupportedMediaType
from bnserve_protocol.wire import JSON, MSGPACK, MSGPACK_BYTES, DigestName
from bnserve_service.admission.quotas import RateQuota

Header: TypeAlias = tuple[bytes, bytes]

OFFERED = (MSGPACK, JSON)
OCTETS = "application/octet-stream"

_ALIASES = {"application/x-msgpack": MSGPACK, "application/vnd.msgpack": MSGPACK}
"""Names that MessagePack had before it was registered; libraries still send them."""
_REQUEST_ID = re.compile(rb"[\x21-\x7e]{1,128}")
CONTEXT = "bnserve.request"
"""Where a scope has its :class:`RequestContext`."""
NO_ROUTE = "none"
_FREE = nullcontext()


@dataclass(slots=True)
class RequestContext:
    """What is known about one request beside its body."""

    request_id: str
    headers: dict[bytes, bytes]
    arrived: float
    """``time.monotonic()``."""
    route: str = NO_ROUTE
    """The route's template: what access and metrics go by. A path would let callers invent label values."""
    caller: str = "anonymous"
    owner: str = ""
    """To whom belongs what this request uploads: the digest of the token; without tokens, everybody is one."""
    quota: RateQuota | None = None
    """What the token may still do, if that is limited."""
    pays: bool = False
    """Whether this request counts towards it."""
    request_digest: str | None = None
    """SHA-256 of the request body, in hexadecimal, once it was read."""
    status: int = 0
    error: str = ""
    """The code of the error that was answered, if it was one."""
    peer: str = ""
    """The address that the connection comes from; empty on a Unix socket."""
    model: ModelIdentity | None = None
    """The model that was asked."""
    rows: int = 0
    """Rows that were evaluated."""
    submitted: float = 0.0
    """``time.monotonic()`` when an evaluation was asked for, and when it began; 0 before."""
    started: float = 0.0
    evaluated: float = 0.0
    """Seconds that it took."""
    bytes_in: int = 0
    bytes_out: int = 0
    """Of the bodies."""
    path: Mapping[str, str] = field(default_factory=dict)
    """The parameters of the route."""
    media_type: str = ""
    """Of the body; it and what follows are those of an evaluation, from :func:`negotiate`."""
    answer_type: str = ""
    """The media type of the answer."""
    digest: DigestName = "sha-256"
    """The algorithm of the answer's digest."""

    @property
    def deadline(self) -> float | None:
        """When the caller stops waiting (``time.monotonic()``), from ``X-Request-Deadline-Ms``.

        Raises
        ------
        InvalidRequest
            Not a positive number.
        """
        text = self.headers.get(b"x-request-deadline-ms")
        if text is None:
            return None
        try:
            milliseconds = float(text)
        except ValueError:
            milliseconds = -1.0
        if not 0.0 <= milliseconds < 1e12:
            raise InvalidRequest("X-Request-Deadline-Ms must be a number of milliseconds from now.")
        return self.arrived + milliseconds / 1e3

    def check_quota(self) -> None:
        """Refuse early what :meth:`paying` would refuse.

        Raises
        ------
        QuotaExceeded
            The quota of rows is used up.
        """
        if self.quota is not None and self.pays:
            self.quota.check()

    def under_way(self) -> AbstractContextManager[None]:
        """Count towards the caller's requests under way, if those are limited.

        Raises
        ------
        QuotaExceeded
            As many as allowed are.
        """
        return _FREE if self.quota is None else self.quota.under_way()

    def paying(self, rows: int) -> AbstractContextManager[None]:
        """Charge rows to the caller's quota, if there is one; given back when they cannot be evaluated now.

        Raises
        ------
        QuotaExceeded
            It is used up.
        """
        return _FREE if self.quota is None else self.quota.paying(rows)


def new_context(headers: dict[bytes, bytes], route: str = NO_ROUTE) -> RequestContext:
    """The context of a request that arrives now; header names are lower case."""
    given = headers.get(b"x-request-id", b"")
    request_id = given.decode("ascii") if _REQUEST_ID.fullmatch(given) else os.urandom(16).hex()
    return RequestContext(request_id=request_id, headers=headers, arrived=time.monotonic(), route=route)


def context_of(scope: Scope) -> RequestContext:
    """The context that :class:`~bnserve_service.http.front.Front` attached to a request."""
    context: RequestContext = scope[CONTEXT]
    return context


def header_fields(headers: Sequence[Header]) -> dict[bytes, bytes]:
    """Headers by name, those that are there several times as one list (RFC 9110, 5.3).

    None of several values wins without a word: where one belongs, a list is none.
    """
    fields = dict(headers)
    if len(fields) != len(headers):
        fields = {name: b", ".join(value for other, value in headers if other == name) for name in fields}
    return fields


def negotiate(headers: Mapping[bytes, bytes]) -> tuple[str, str, DigestName]:
    """The media type of the body, that of the answer, and the algorithm of the answer's digest.

    Raises
    ------
    UnsupportedMediaType
        The body is none that is read here: :func:`request_media_type`.
    NotAcceptable
        The caller accepts no answer that is given here.
    """
    media_type = request_media_type(headers)
    return media_type, answer_media_type(headers, preferred=media_type), answer_digest(headers)


def request_media_type(headers: Mapping[bytes, bytes]) -> str:
    """The media type of the request body, one of :data:`OFFERED`.

    Raises
    ------
    UnsupportedMediaType
        Missing, another one, or compressed.
    """
    refuse_encoded(headers)
    given = media_type_of(headers)
    if given in OFFERED:
        return given
    raise UnsupportedMediaType(
        f"Send the body as {MSGPACK} or {JSON} and say so in Content-Type; got '{given[:80] or 'nothing'}'."
    )


def media_type_of(headers: Mapping[bytes, bytes]) -> str:
    """The ``Content-Type`` without its parameters, lower case, old names of MessagePack replaced; '' if missing."""
    value = headers.get(b"content-type", b"")
    one = value if b"," in value else value.partition(b";")[0]  # several are no media type, whichever comes first
    given = one.strip().lower().decode("latin-1")
    return _ALIASES.get(given, given)


def refuse_encoded(headers: Mapping[bytes, bytes]) -> None:
    """Bodies are taken as they are: a compressed one could be a bomb, and waveforms do not compress.

    Raises
    ------
    UnsupportedMediaType
        ``Content-Encoding`` names another form.
    """
    encoding = headers.get(b"content-encoding", b"identity").strip().lower()
    if encoding not in (b"identity", b""):
        raise UnsupportedMediaType("Compressed bodies are not accepted; send it without Content-Encoding.")


def require_media_type(headers: Mapping[bytes, bytes], wanted: str, advice: str, *others: str) -> None:
    """Take bodies of one media type, which may be left out, or of some others, and as they are.

    Raises
    ------
    UnsupportedMediaType
        Another one, with the ``advice``; or an encoded body.
    """
    refuse_encoded(headers)
    if media_type_of(headers) not in ("", wanted, *others):
        raise UnsupportedMediaType(advice)


def answer_media_type(headers: Mapping[bytes, bytes], preferred: str) -> str:
    """The offered media type that the ``Accept`` header likes best, with its parameter; ``preferred`` breaks ties.

    Raises
    ------
    NotAcceptable
        The caller accepts neither MessagePack nor JSON.
    """
    accept = headers.get(b"accept")
    if accept is None or accept == b"*/*":
        return preferred
    return _best(accept, preferred)


def answer_digest(headers: Mapping[bytes, bytes]) -> DigestName:
    """The algorithm of ``Content-Digest`` that ``Want-Content-Digest`` (RFC 9530) likes best, by default SHA-256."""
    wanted = headers.get(b"want-content-digest")
    return "sha-256" if wanted is None else _preferred_digest(wanted)


@lru_cache(maxsize=64)
def _preferred_digest(wanted: bytes) -> DigestName:
    weights = {"sha-256": 0, "crc32c": 0}
    for item in wanted.decode("latin-1").lower().split(","):
        name, _, weight = (part.strip() for part in item.partition("="))
        if name in weights and weight.isascii() and weight.isdigit():
            weights[name] = int(weight[:2])
    return "crc32c" if weights["crc32c"] > weights["sha-256"] else "sha-256"


@lru_cache(maxsize=64)
def _best(accept: bytes, preferred: str) -> str:
    ranges = _parse(accept.decode("latin-1").lower())
    candidates = [preferred, *(offer for offer in OFFERED if offer != preferred), MSGPACK_BYTES]
    qualities = {offer: _quality(offer, ranges) for offer in candidates}
    best = max(candidates, key=lambda offer: qualities[offer])
    if qualities[best] <= 0.0:
        raise NotAcceptable(f"Answers are offered as {MSGPACK} and {JSON}; name one of them in Accept.")
    return best


def _parse(accept: str) -> dict[str, float]:
    ranges: dict[str, float] = {}
    for item in accept.split(","):
        name, *parameters = (part.strip() for part in item.split(";"))
        keys = ";keys=bytes" if "keys=bytes" in parameters else ""
        ranges[_ALIASES.get(name, name) + keys] = _q(parameters)
    return ranges


def _q(parameters: list[str]) -> float:
    for parameter in parameters:
        if parameter.startswith("q="):
            try:
                return float(parameter[2:])
            except ValueError:
                return 0.0
    return 1.0


def _quality(offer: str, ranges: dict[str, float]) -> float:
    for name in (offer,) if offer == MSGPACK_BYTES else (offer, "application/*", "*/*"):
        if name in ranges:
            return ranges[name]
    return 0.0
