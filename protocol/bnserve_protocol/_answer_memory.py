"""Answers in memory that client and service share: on one host, over a Unix socket, a large answer need not travel.

The client makes the memory (a ``memfd``, sealed so that it cannot shrink) and names it in :data:`ANSWER_MEMORY`; a
service that can open it puts the body of the answer there and says how long it is in :data:`ANSWER_IN_MEMORY`. A
service that cannot answers as always. See ``docs/reference/wire.md``.
"""

from __future__ import annotations

import re
from typing import NamedTuple

ANSWER_MEMORY = "X-Answer-Memory"
"""Of a request: ``fd=<descriptor in the client's process>; key=<32 hexadecimal digits>; size=<bytes>``."""
ANSWER_IN_MEMORY = "X-Answer-In-Memory"
"""Of an answer without a body: the length of the body in the shared memory, where it begins at BODY_AT."""
BODY_AT = 64
"""What comes before it: the 16 bytes of the key, by which the service knows the memory, and zeros."""

_FORM = re.compile(r"fd=([0-9]{1,9}); key=([0-9a-f]{32}); size=([0-9]{1,12})")


class MemoryName(NamedTuple):
    """What a request says about its memory."""

    descriptor: int
    key: bytes
    size: int

    def __str__(self) -> str:
        """As it travels."""
        return f"fd={self.descriptor}; key={self.key.hex()}; size={self.size}"

    @classmethod
    def read(cls, text: str) -> MemoryName | None:
        """From a header; None if it has another form."""
        found = _FORM.fullmatch(text)
        return None if found is None else cls(int(found[1]), bytes.fromhex(found[2]), int(found[3]))
