"""Writing files whole or not at all, and saying what is wrong when that fails."""

from __future__ import annotations

import contextlib
import os
import secrets
from collections.abc import Iterator
from pathlib import Path

from bnserve_inference.roq._errors import BasisUnwritable


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A temporary file beside ``path`` that takes its place when the block ends well: flushed, then renamed.

    Raises
    ------
    BasisUnwritable
        No room, no permission, and the like; nothing half-written is left.
    """
    # Not by the number of the process: two containers that share a disk have the same.
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(8)}.tmp")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            yield temporary
            with temporary.open("rb") as file:
                os.fsync(file.fileno())
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
        descriptor = os.open(path.parent, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
    except OSError as error:
        raise BasisUnwritable(
            f"Cannot write {path}: {error.strerror or error}. Make room, or choose a place that you can write to."
        ) from error
