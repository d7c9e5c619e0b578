"""What commands are told: files to write, which can be or not before the work and not after it, servers, and models."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path


def check_place(path: Path, option: str) -> None:
    """Refuse a file that could not be written, before it is worked for; its folders need not exist.

    Raises
    ------
    InvalidRequest
        It is a folder, or its folder cannot be written, or the disk is full.
    """
    from bnserve_protocol import InvalidRequest
    from bnserve_store import check_writable

    try:
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        check_writable(path.parent)
    except OSError as error:
        raise InvalidRequest(
            f"Cannot write {path}: {error.strerror}. Make room, or choose another {option}."
        ) from error


def server_address(text: str) -> str:
    """What a client connects to, also where ``http://`` or ``unix:`` was left out."""
    if "://" in text or text.startswith("unix:"):
        return text
    return f"unix:{text}" if text.startswith("/") else f"http://{text}"


def name_and_version(model: str) -> tuple[str, str]:
    """From ``NAME[@VERSION]``, a version or a label."""
    name, _, version = model.partition("@")
    return name, version or "stable"


def print_json(document: object) -> None:
    """For machines, on standard output."""
    print(json.dumps(document, indent=2, ensure_ascii=False))
