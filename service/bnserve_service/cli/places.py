"""Files that a command is told to write: whether they can be is found before the work, not after it."""

from __future__ import annotations

import errno
import os
from pathlib import Path

from bnserve_protocol import InvalidRequest
from bnserve_store import check_writable


def check_place(path: Path, option: str) -> None:
    """Refuse a file that could not be written, before it is worked for; its folders need not exist.

    Raises
    ------
    InvalidRequest
        It is a folder, or its folder cannot be written, or the disk is full.
    """
    try:
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        check_writable(path.parent)
    except OSError as error:
        raise InvalidRequest(
            f"Cannot write {path}: {error.strerror}. Make room, or choose another {option}."
        ) from error
