"""Digests of bodies, in the forms in which they travel."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Sequence
from typing import TypeAlias

Buffer: TypeAlias = bytes | memoryview


def content_digest(parts: Sequence[Buffer]) -> bytes:
    """The ``Content-Digest`` of a body (RFC 9530): ``sha-256=:<base64>:``."""
    hasher = hashlib.sha256()
    for part in parts:
        hasher.update(part)
    return b"sha-256=:" + base64.b64encode(hasher.digest()) + b":"


def sha256_hex(body: Buffer) -> str:
    """SHA-256 in hexadecimal: the ``X-Request-Digest`` of a request body."""
    return hashlib.sha256(body).hexdigest()
