"""Digests of bodies, in the forms in which they travel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from bnserve_protocol import wire
from bnserve_protocol.wire import DigestName

Buffer: TypeAlias = bytes | memoryview


def content_digest(parts: Sequence[Buffer], algorithm: DigestName = "sha-256") -> bytes:
    """The value of ``Content-Digest`` for a body (RFC 9530)."""
    return wire.content_digest(parts, algorithm).encode("ascii")


def sha256_hex(body: Buffer) -> str:
    """SHA-256 in hexadecimal: the ``X-Request-Digest`` of a request body."""
    return wire.request_digest(body)
