"""Files written whole or not at all."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A temporary file beside ``path`` that takes its place when the block ends well: flushed, then renamed.

    It is hidden and ends in ``.tmp``: whoever writes to the folder alone may remove what a run that was killed left.

    Raises
    ------
    OSError
        No room, no permission, and the like; nothing half-written is left, and ``path`` is what it was.
    """
    # Not by the number of the process: two containers that share a disk have the same.
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(8)}.tmp")
    try:
        yield temporary
        _flush(temporary)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
    _flush(path.parent)  # or a power cut undoes the renaming


def _flush(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
