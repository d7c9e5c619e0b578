"""Who has uploaded what: written down before it is stored, so that uploads at the same time see each other."""

from __future__ import annotations

import fcntl
import os
import threading
import time
import uuid
from collections.abc import Generator
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal, Protocol, TypeAlias

Kind: TypeAlias = Literal["grid", "analysis"]
LEFT_BEHIND = 60.0
"""Seconds after which an upload that is still being stored belongs to a worker that did not live to finish it."""


@dataclass(frozen=True, slots=True)
class Upload:
    """What an owner has uploaded, or is uploading."""

    kind: Kind
    sha256: str
    nbytes: int
    when: float
    """``time.time()``."""
    coming: str = ""
    """A name of its own while it is being stored; empty once it is kept."""

    @property
    def what(self) -> tuple[Kind, str]:
        """The object: the same for all uploads of one content."""
        return self.kind, self.sha256


def coming(kind: Kind, sha256: str, nbytes: int) -> Upload:
    """An upload that is about to be stored."""
    return Upload(kind, sha256, nbytes, time.time(), uuid.uuid4().hex)


def kept(upload: Upload) -> Upload:
    """The same, once it is stored."""
    return replace(upload, when=time.time(), coming="")


class UploadRecords(Protocol):
    """The records of all owners. Whoever reads them and then changes them does both :meth:`alone`."""

    def alone(self) -> AbstractContextManager[None]:
        """Keep all others out for a moment."""

    def of(self, owner: str) -> list[Upload]:
        """Those of one owner."""

    def has_owner(self, kind: Kind, sha256: str) -> bool:
        """Whether anybody has this object, or is uploading it."""

    def add(self, owner: str, upload: Upload) -> None:
        """Write one down."""

    def remove(self, owner: str, upload: Upload) -> None:
        """Forget one, if it is there."""


class OwnRecords:
    """The records of a server of one process, in memory."""

    def __init__(self) -> None:
        self._of: dict[str, dict[tuple[Kind, str, str], Upload]] = {}
        self._lock = threading.Lock()

    def alone(self) -> AbstractContextManager[None]:
        """See :class:`UploadRecords`."""
        return _holding(self._lock)

    def of(self, owner: str) -> list[Upload]:
        """See :class:`UploadRecords`."""
        return list(self._of.get(owner, {}).values())

    def has_owner(self, kind: Kind, sha256: str) -> bool:
        """See :class:`UploadRecords`."""
        return any(upload.what == (kind, sha256) for uploads in self._of.values() for upload in uploads.values())

    def add(self, owner: str, upload: Upload) -> None:
        """See :class:`UploadRecords`."""
        self._of.setdefault(owner, {})[*upload.what, upload.coming] = upload

    def remove(self, owner: str, upload: Upload) -> None:
        """See :class:`UploadRecords`."""
        self._of.get(owner, {}).pop((*upload.what, upload.coming), None)


@contextmanager
def _holding(lock: threading.Lock) -> Generator[None, None, None]:
    with lock:
        yield


class SharedRecords:
    """The records of all workers of one server: empty files whose names say what, and whose times say when.

    Parameters
    ----------
    folder:
        Where; it is made.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        folder.mkdir(mode=0o700, exist_ok=True)

    @contextmanager
    def alone(self) -> Generator[None, None, None]:
        """See :class:`UploadRecords`; a process that dies lets go."""
        self._folder.mkdir(mode=0o700, exist_ok=True)
        lock = os.open(self._folder / "lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield
        finally:
            os.close(lock)

    def of(self, owner: str) -> list[Upload]:
        """See :class:`UploadRecords`."""
        found = []
        for path in sorted(self._folder.glob(f"{owner}/*-*")):
            kind, sha256, nbytes, *name = path.name.split("-")
            with suppress(FileNotFoundError):
                when = path.stat().st_mtime
                found.append(Upload("grid" if kind == "grid" else "analysis", sha256, int(nbytes), when, "".join(name)))
        return found

    def has_owner(self, kind: Kind, sha256: str) -> bool:
        """See :class:`UploadRecords`."""
        return any(self._folder.glob(f"*/{kind}-{sha256}-*"))

    def add(self, owner: str, upload: Upload) -> None:
        """See :class:`UploadRecords`."""
        path = self._path(owner, upload)
        path.parent.mkdir(mode=0o700, exist_ok=True)
        path.touch(mode=0o600)

    def remove(self, owner: str, upload: Upload) -> None:
        """See :class:`UploadRecords`."""
        self._path(owner, upload).unlink(missing_ok=True)

    def _path(self, owner: str, upload: Upload) -> Path:
        name = f"{upload.kind}-{upload.sha256}-{upload.nbytes}"
        return self._folder / owner / (f"{name}-{upload.coming}" if upload.coming else name)
