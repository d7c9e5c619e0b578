"""How many uploads are kept, and which go first when there is no room."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Blob(NamedTuple):
    """What is known of an upload beside its content."""

    owner: str
    name: str
    """Its digest: blobs of one name are one, whoever has it."""
    size: int


class Bounds(NamedTuple):
    """How much is kept: blobs and bytes of one owner, and bytes of all owners together."""

    max_blobs: int
    max_owner_bytes: int
    max_bytes: int

    def surplus(self, fresh: Blob, others: Sequence[Blob]) -> list[Blob]:
        """What makes room for ``fresh``, which itself stays; ``others`` are in the order in which they were used.

        An owner who has too much loses what he used longest ago; then, while all have too much together, whoever has
        most does.
        """
        dropped = []
        left = list(others)
        own = [blob for blob in left if blob.owner == fresh.owner]
        while own and (len(own) >= self.max_blobs or size_of([fresh, *own]) > self.max_owner_bytes):
            dropped.append(own.pop(0))
            left.remove(dropped[-1])
        while left and size_of([fresh, *left]) > self.max_bytes:
            dropped.append(first_to_go(left, fresh))
            left.remove(dropped[-1])
        return dropped


def size_of(blobs: Sequence[Blob]) -> int:
    """Bytes of all together, those of several owners once."""
    return sum({blob.name: blob.size for blob in blobs}.values())


def first_to_go(blobs: Sequence[Blob], *staying: Blob) -> Blob:
    """What was used longest ago by whoever has most."""
    has: dict[str, int] = {}
    for blob in (*blobs, *staying):
        has[blob.owner] = has.get(blob.owner, 0) + blob.size
    richest = max((blob.owner for blob in blobs), key=lambda owner: has[owner])
    return next(blob for blob in blobs if blob.owner == richest)
