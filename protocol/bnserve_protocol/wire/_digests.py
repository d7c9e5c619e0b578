"""Digests that tie an answer to its bytes and to its question, in the forms in which they travel."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable
from typing import Literal, TypeAlias

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
