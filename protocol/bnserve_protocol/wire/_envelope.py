"""What goes around a message: its media type, digests of its bytes and of its question; and the error in its place."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable
from typing import Literal, TypeAlias

import msgspec

from bnserve_protocol._errors import ERRORS_BY_CODE, BnserveError, FieldError
from bnserve_protocol._printable import printable

MSGPACK = "application/msgpack"
JSON = "application/json"
PROBLEM_JSON = "application/problem+json"

DigestName: TypeAlias = Literal["sha-256", "crc32c"]
"""Algorithms of ``Content-Digest``, by their names in the registry of RFC 9530."""

WANTED_DIGEST = "crc32c=10, sha-256=1"
"""The ``Want-Content-Digest`` of our client: the fast one, see ``docs/decisions/0006-digests-of-answers.md``."""


def content_digest(parts: Iterable[bytes | memoryview], algorithm: DigestName = "sha-256") -> str:
    """The ``Content-Digest`` of a body that is the concatenation of ``parts``, such as ``crc32c=:4waSgw==:``."""
    if algorithm == "crc32c":
        from crc32c import crc32c  # where it is needed: it takes as long to import as everything else here

        checksum = 0
        for part in parts:
            checksum = crc32c(part, checksum)
        return f"crc32c=:{base64.b64encode(checksum.to_bytes(4, 'big')).decode()}:"
    hasher = hashlib.sha256()
    for part in parts:
        hasher.update(part)
    return f"sha-256=:{base64.b64encode(hasher.digest()).decode()}:"


def request_digest(body: bytes | memoryview) -> str:
    """SHA-256 of a request body in hexadecimal: the ``X-Request-Digest`` of its answer."""
    return hashlib.sha256(body).hexdigest()


class Problem(msgspec.Struct, frozen=True, omit_defaults=True):
    """RFC 9457 problem details, the body of every error answer (``application/problem+json``).

    ``error`` repeats ``detail`` for Open Inference Protocol clients.
    """

    type: str
    title: str
    status: int
    detail: str
    code: str
    error: str = ""
    request_id: str | None = None
    retryable: bool = False
    errors: list[FieldError] = []
    retry_after: float | None = None
    """Seconds; the header ``Retry-After`` has only whole ones."""

    @classmethod
    def from_error(cls, error: BnserveError, status: int, request_id: str | None = None) -> Problem:
        """Describe ``error`` for the wire under the HTTP ``status`` chosen by the service."""
        return cls(
            type=f"urn:bnserve:error:{error.code}",
            title=error.title,
            status=status,
            detail=error.detail,
            code=error.code,
            error=error.detail,
            request_id=request_id,
            retryable=error.retryable,
            errors=list(error.errors),
            retry_after=error.retry_after,
        )

    def to_error(self, retry_after: float | None = None) -> BnserveError:
        """Rebuild the exception; an unknown code (from a newer service) becomes plain ``BnserveError``.

        ``retry_after`` is that of the header, for services that do not say it more exactly. Line breaks in the detail
        are written out: another's text cannot begin a line that looks like one of ours.
        """
        cls = ERRORS_BY_CODE.get(self.code, BnserveError)
        exact = self.retry_after if self.retry_after is not None and self.retry_after >= 0.0 else retry_after
        return cls(printable(self.detail), errors=self.errors, retry_after=exact, request_id=self.request_id)
