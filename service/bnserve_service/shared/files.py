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
from dataclasses import dataclass
from pathlib import Path

from bnserve_protocol import Overloaded, Unavailable

_NAME = re.compile(r"[0-9a-f]{64}")
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


@dataclass(frozen=True, slots=True)
class _File:
    path: Path
    owner: str
    number: int
    size: int
    used: int


class BlobStore:
    """Files by owner and digest; safe to use from several threads and processes.

    Owners of the same bytes share them. An owner over ``max_owner_bytes`` or ``max_files`` loses the files that they
    used longest ago; when all together are over ``max_bytes``, or there is no room, whoever has most does.

    Parameters
    ----------
    folder:
        Where; it is made.
    max_files, max_owner_bytes:
        Of one owner.
    max_bytes:
        Of all owners together.
    """

    def __init__(self, folder: Path, max_files: int, max_owner_bytes: int, max_bytes: int) -> None:
        self._folder = folder
        self._max_files = max_files
        self._max_owner_bytes = max_owner_bytes
        self._max_bytes = max_bytes
        folder.mkdir(mode=0o700, exist_ok=True)

    def check(self) -> None:
        """Find out why a file is not there: because nothing is.

        Raises
        ------
        Unavailable
        """
        if not self._folder.parent.is_dir():
            raise gone()

    def use(self, owner: str, name: str) -> bool:
        """Whether a file is there; it counts as used now."""
        path = self._path(owner, name)
        if path is None:
            return False
        try:
            os.utime(path)
        except OSError:
            return False
        return True

    def has(self, owner: str, name: str) -> bool:
        """Whether a file is there."""
        return self.size(owner, name) is not None

    def size(self, owner: str, name: str) -> int | None:
        """Bytes of a file; None when it is not there."""
        path = self._path(owner, name)
        try:
            return None if path is None else path.stat().st_size
        except OSError:
            return None

    def read(self, owner: str, name: str) -> memoryview | None:
        """The content of a file, mapped, so that it takes memory once; None when it is not there."""
        path = self._path(owner, name)
        if path is None:
            return None
        try:
            with path.open("rb") as file:
                # What is renamed into place is never written again, and what is dropped lives while it is mapped.
                return memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
        except (OSError, ValueError):
            return None

    def put(self, owner: str, name: str, body: bytes) -> bool:
        """Keep a file, making room for it; false when there is none: it is not kept then.

        The caller has checked that ``name`` is its digest.

        Raises
        ------
        FileNotFoundError
            The folder that workers share is gone.
        """
        path = self._path(owner, name)
        if path is None:
            return False
        with self._locked():
            path.parent.mkdir(mode=0o700, exist_ok=True)
            files = self._files()
            same = next((file for file in files if file.path.name == name), None)
            if same is not None and same.size == len(body):
                with suppress(FileExistsError):
                    os.link(same.path, path)
                os.utime(path)
            elif not self._write(path, body):
                return False
            self._shrink(path, owner)
        return True

    def drop(self, owner: str, name: str) -> bool:
        """Take a file from one owner; whether it was there."""
        path = self._path(owner, name)
        if path is None:
            return False
        try:
            path.unlink()
        except OSError:
            return False
        return True

    def usage(self) -> tuple[int, int]:
        """Files and their bytes, those of several owners once."""
        try:
            sizes = {file.number: file.size for file in self._files()}
        except FileNotFoundError:  # all of it is gone
            sizes = {}
        return len(sizes), sum(sizes.values())

    def _path(self, owner: str, name: str) -> Path | None:
        if not _NAME.fullmatch(name) or not (owner == "" or _NAME.fullmatch(owner)):
            return None  # nothing else is a digest, and nothing else may become part of a path
        return self._folder / (owner or _EVERYBODY) / name

    @contextmanager
    def _locked(self) -> Generator[None, None, None]:
        """Alone among all threads and processes; a process that dies lets go."""
        self._folder.mkdir(mode=0o700, exist_ok=True)
        lock = os.open(self._folder / "lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield
        finally:
            os.close(lock)

    def _files(self) -> list[_File]:
        found = []
        for owner in os.scandir(self._folder):
            if not owner.is_dir():
                continue
            for entry in os.scandir(owner.path):
                with suppress(FileNotFoundError):
                    status = entry.stat()
                    if _NAME.fullmatch(entry.name):
                        path = Path(entry.path)
                        found.append(_File(path, owner.name, status.st_ino, status.st_size, status.st_mtime_ns))
                    elif time.time() - status.st_mtime > _LEFT_BEHIND:
                        Path(entry.path).unlink()
        return found

    def _write(self, path: Path, body: bytes) -> bool:
        fresh = path.with_name(f"new-{os.getpid()}-{time.monotonic_ns()}")
        try:
            while True:
                try:
                    fresh.write_bytes(body)
                    break
                except OSError as error:
                    if error.errno not in (errno.ENOSPC, errno.EDQUOT) or not self._drop_one(self._files()):
                        return False
            fresh.replace(path)
        finally:
            fresh.unlink(missing_ok=True)
        return True

    def _shrink(self, kept: Path, owner: str) -> None:
        """Make room for what ``owner`` has just got, which itself stays."""
        name = owner or _EVERYBODY
        files = [file for file in self._files() if file.path != kept or file.owner != name]
        size = kept.stat().st_size
        own = sorted((file for file in files if file.owner == name), key=lambda file: file.used)
        while own and (sum(file.size for file in own) + size > self._max_owner_bytes or len(own) >= self._max_files):
            self.drop(owner, own.pop(0).path.name)
        while self.usage()[1] > self._max_bytes and self._drop_one(
            [file for file in self._files() if file.path != kept]
        ):
            pass

    def _drop_one(self, files: list[_File]) -> bool:
        """Drop what was used longest ago of whoever has most; whether there was any."""
        if not files:
            return False
        has: dict[str, int] = {}
        for file in files:
            has[file.owner] = has.get(file.owner, 0) + file.size
        richest = max(has, key=lambda owner: has[owner])
        oldest = min((file for file in files if file.owner == richest), key=lambda file: file.used)
        oldest.path.unlink(missing_ok=True)
        return True
