"""What was uploaded to one worker, for all of them: files known by their digest, in the folder that workers share.

The folder is the truth: who has what, and what was used last. Processes that map the same file share its memory.
"""

from __future__ import annotations

import errno
import fcntl
import mmap
import os
import re
import time
from collections.abc import Generator
from contextlib import contextmanager, suppress
from pathlib import Path

from bnserve_protocol import Overloaded, Unavailable
from bnserve_service.uploads.bounds import Blob, Bounds, first_to_go, size_of

DIGEST = re.compile(r"[0-9a-f]{64}")
_EVERYBODY = "everybody"
_LEFT_BEHIND = 60.0
"""Seconds after which an unfinished file belongs to a worker that did not live to finish it."""


def gone() -> Unavailable:
    """The error for what needs the folder that workers share, while there is none."""
    return Unavailable(
        "The memory that the workers of this server share is gone and is made anew; ask again in a moment.",
        retry_after=0.5,
    )


def no_room() -> Overloaded:
    """The error for an upload that does not even fit when everything else is dropped."""
    return Overloaded(
        "There is no room for this upload in the memory that the workers of this server share; its operators can give "
        "it more (in containers, the size of /dev/shm).",
        retry_after=5.0,
    )


@contextmanager
def locked(folder: Path) -> Generator[None, None, None]:
    """Alone with a folder among all threads and processes; a process that dies lets go."""
    folder.mkdir(mode=0o700, exist_ok=True)
    lock = os.open(folder / "lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield
    finally:
        os.close(lock)


class BlobStore:
    """Files by owner and digest; safe to use from several threads and processes. Owners of the same bytes share them.

    Parameters
    ----------
    folder
        Where; it is made.
    bounds
        How much is kept; less when there is no room.
    """

    def __init__(self, folder: Path, bounds: Bounds) -> None:
        self._folder = folder
        self._bounds = bounds
        folder.mkdir(mode=0o700, exist_ok=True)

    def use(self, owner: str, name: str) -> bool:
        """Whether a file is there; it counts as used now.

        Raises
        ------
        Unavailable
            Nothing is there: the folder that workers share is gone.
        """
        try:
            os.utime(self._path(owner, name))
        except OSError:
            if not self._folder.parent.is_dir():
                raise gone() from None
            return False
        return True

    def has(self, owner: str, name: str) -> bool:
        """Whether a file is there."""
        return self.size(owner, name) is not None

    def size(self, owner: str, name: str) -> int | None:
        """Bytes of a file; None when it is not there."""
        try:
            return self._path(owner, name).stat().st_size
        except OSError:
            return None

    def names(self, owner: str) -> list[str]:
        """What an owner has, by its digests, sorted."""
        with suppress(FileNotFoundError):
            folder = self._path(owner, "0" * 64).parent
            return sorted(path.name for path in folder.iterdir() if DIGEST.fullmatch(path.name))
        return []

    def read(self, owner: str, name: str) -> memoryview | None:
        """The content of a file, mapped, so that it takes memory once; None when it is not there."""
        try:
            with self._path(owner, name).open("rb") as file:
                # What is renamed into place is never written again, and what is dropped lives while it is mapped.
                return memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
        except ValueError:  # it is empty, which none is
            return memoryview(b"")
        except OSError:
            return None

    def put(self, owner: str, name: str, body: bytes) -> bool:
        """Keep a file, making room for it; false when there is none: it is not kept then.

        The caller has checked that ``name`` is its digest.

        Raises
        ------
        FileNotFoundError
            The folder that workers share is gone, or this is no digest.
        """
        path = self._path(owner, name)
        with locked(self._folder):
            path.parent.mkdir(mode=0o700, exist_ok=True)
            same = next((blob for blob in self._blobs() if blob.name == name and blob.size == len(body)), None)
            if (same is None or not self._share(same, path)) and not self._write(path, body):
                return False
            fresh = Blob(owner, name, len(body))
            for blob in self._bounds.surplus(fresh, [blob for blob in self._blobs() if blob[:2] != fresh[:2]]):
                self.drop(*blob[:2])
        return True

    def drop(self, owner: str, name: str) -> bool:
        """Take a file from one owner; whether it was there."""
        try:
            self._path(owner, name).unlink()
        except OSError:
            return False
        return True

    def usage(self) -> tuple[int, int]:
        """Files and their bytes, those of several owners once."""
        try:
            blobs = self._blobs()
        except FileNotFoundError:  # all of it is gone
            blobs = []
        return len({blob.name for blob in blobs}), size_of(blobs)

    def _path(self, owner: str, name: str) -> Path:
        if not DIGEST.fullmatch(name) or not (owner == "" or DIGEST.fullmatch(owner)):
            raise FileNotFoundError(name)  # nothing else is a digest, and nothing else may become part of a path
        return self._folder / (owner or _EVERYBODY) / name

    def _blobs(self) -> list[Blob]:
        """All, in the order in which they were used. What is left unfinished is removed."""
        found = []
        for folder in os.scandir(self._folder):
            owner = folder.name.replace(_EVERYBODY, "")
            for entry in os.scandir(folder.path) if folder.is_dir() else ():
                with suppress(FileNotFoundError):
                    status = entry.stat()
                    if DIGEST.fullmatch(entry.name):
                        found.append((status.st_mtime_ns, Blob(owner, entry.name, status.st_size)))
                    elif time.time() - status.st_mtime > _LEFT_BEHIND:
                        Path(entry.path).unlink()
        return [blob for _, blob in sorted(found)]

    def _share(self, same: Blob, path: Path) -> bool:
        """Whether a file that is there could be had at ``path``, too: whoever has it may drop it at any time."""
        try:
            with suppress(FileExistsError):
                os.link(self._path(same.owner, same.name), path)
            os.utime(path)
        except FileNotFoundError:
            return False
        return True

    def _write(self, path: Path, body: bytes) -> bool:
        fresh = path.with_name(f"new-{os.getpid()}-{time.monotonic_ns()}")
        try:
            while True:
                try:
                    fresh.write_bytes(body)
                    break
                except OSError as error:
                    if error.errno not in (errno.ENOSPC, errno.EDQUOT) or not (blobs := self._blobs()):
                        return False
                    self._path(*first_to_go(blobs)[:2]).unlink(missing_ok=True)
            fresh.replace(path)
        finally:
            fresh.unlink(missing_ok=True)
        return True
