"""Machine code, made once for each processor and kept among the user's caches.

Making it takes longer than all else between the start of a process and its first waveform. A file is used if it is
whole, if nobody else could have written it, and if it was made from the same assembly by the same compiler for the same
processor. Where there is no place for it (no home, a read-only disk) code is made anew every time.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import stat
import tempfile
from collections.abc import Callable
from pathlib import Path

_MOST_BYTES = 2**24
_MOST_FILES = 8
"""Those of other versions and processors go, the oldest first."""
_DIGEST_BYTES = hashlib.sha256().digest_size


def cached_code(key: bytes, make: Callable[[], bytes]) -> bytes:
    """What ``make`` returns, or what it returned for the same ``key`` before."""
    folder = cache_folder()
    if folder is None:
        return make()
    file = folder / f"{hashlib.sha256(key).hexdigest()}.o"
    code = _read(file, key)
    if code is None:
        code = make()
        with contextlib.suppress(OSError):  # then it is made again the next time
            _write(file, key, code)
    return code


def cache_folder() -> Path | None:
    """``bnserve`` in ``$XDG_CACHE_HOME`` or else ``~/.cache``; None where the user has no home."""
    given = Path(os.environ.get("XDG_CACHE_HOME", ""))
    try:
        base = given if given.is_absolute() else Path.home() / ".cache"
    except RuntimeError:
        return None
    return base / "bnserve" if hasattr(os, "geteuid") else None


def _seal(key: bytes, code: bytes) -> bytes:
    return hashlib.sha256(hashlib.sha256(key).digest() + code).digest()


def _read(file: Path, key: bytes) -> bytes | None:
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC | os.O_NONBLOCK)
    except OSError:
        return None
    with os.fdopen(descriptor, "rb") as stream:
        about = os.fstat(descriptor)
        mine = about.st_uid == os.geteuid() and not about.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
        if not (mine and stat.S_ISREG(about.st_mode) and about.st_size <= _MOST_BYTES):
            return None
        content = stream.read(_MOST_BYTES)
    seal, code = content[:_DIGEST_BYTES], content[_DIGEST_BYTES:]
    return code if seal == _seal(key, code) else None


def _write(file: Path, key: bytes, code: bytes) -> None:
    file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor, name = tempfile.mkstemp(dir=file.parent, suffix=".draft")
    draft = Path(name)
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(_seal(key, code) + code)
        draft.replace(file)
    except BaseException:
        draft.unlink(missing_ok=True)
        raise
    newest_last = sorted(file.parent.glob("*.o"), key=lambda other: other.stat().st_mtime)
    for old in newest_last[:-_MOST_FILES]:
        old.unlink(missing_ok=True)
