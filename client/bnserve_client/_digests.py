"""Digests that tie an answer to its bytes and to its question."""

from __future__ import annotations

import base64
import hashlib


def content_digest(body: bytes | memoryview) -> str:
    """The ``Content-Digest`` of a body in the form of RFC 9530: ``sha-256=:<base64>:``."""
    return f"sha-256=:{base64.b64encode(hashlib.sha256(body).digest()).decode()}:"


def request_digest(body: bytes) -> str:
    """The ``X-Request-Digest`` of a request: SHA-256 of its body in hexadecimal."""
    return hashlib.sha256(body).hexdigest()
