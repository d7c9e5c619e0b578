"""The folder that the processes of one server share: in memory where there is such a file system, gone when they are.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import shutil
import struct
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Self

_IN_MEMORY = Path("/dev/shm")
_PREFIX = "bnserve-"
_LOCK = "alive"
_NUMBER = struct.Struct("<q")
_ABSENT = -1
REPORT = "supervisor.json"
"""The file in it in which the supervisor tells of the workers, in the form of ``shared.metrics``."""


def models_file(shared: Path, place: int) -> Path:
    """The file in it in which the worker in a place says which models it has; removed once nobody is there."""
    return shared / f"models-{place}.json"


def addresses_file(shared: Path, place: int | str) -> Path:
    """The file in it in which the worker in a place says how many connections each address has there."""
    return shared / f"addresses-{place}.json"


class SharedFolder:
    """A folder for one user alone; every process of the server that opens it keeps it from being taken for a ruin.

    Parameters
    ----------
    path
        A folder that :meth:`create` made.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._lock = os.open(path / _LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        fcntl.flock(self._lock, fcntl.LOCK_SH)

    @classmethod
    def create(cls, needed: int, places: Sequence[Path] | None = None) -> Self:
        """Make a folder, after removing those of servers that did not live to do so.

        Parameters
        ----------
        needed
            Bytes that should fit: the first place that has them free is taken, or else the one that has most.
        places
            Where it may be; by default in memory, else where temporary files are.

        Raises
        ------
        FileNotFoundError
            Nothing can be written anywhere.
        """
        where = [place for place in places or usual_places() if os.access(place, os.W_OK)]
        if not where:
            raise FileNotFoundError(
                "workers share a folder, and neither /dev/shm nor a temporary folder can be written"
            )
        for place in where:
            _remove_ruins(place)
        roomy = [place for place in where if free_bytes(place) >= needed] or sorted(where, key=free_bytes)[-1:]
        while True:
            folder = cls(Path(tempfile.mkdtemp(prefix=_PREFIX, dir=roomy[0])))  # mkdtemp lets nobody else in
            if (folder.path / _LOCK).exists():
                return folder
            folder.close()  # another server that starts now took it for a ruin before it was locked

    def remove_if_last(self) -> bool:
        """Remove the folder unless another process has it open."""
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return False
        self.remove()
        return True

    def is_there(self) -> bool:
        """Whether it still is where it was, and nobody has put another one there."""
        try:
            return os.path.samestat(os.fstat(self._lock), (self.path / _LOCK).stat())
        except OSError:
            return False

    def remove(self) -> None:
        """Remove the folder, whoever has it open."""
        if self.is_there():
            shutil.rmtree(self.path, ignore_errors=True)

    def close(self) -> None:
        """Say that this process does not use it any more."""
        os.close(self._lock)


class SharedLoads:
    """How many connections the worker in each place has, which all of them see at once.

    Each number is written by the worker in that place, and by the supervisor once it is gone.

    Parameters
    ----------
    shared
        The folder of the server.
    places
        How many there are, when the file has to be made; nobody is there then.
    """

    def __init__(self, shared: Path, places: int | None = None) -> None:
        self._file = os.open(shared / "loads", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        if places is not None:
            os.pwrite(self._file, _NUMBER.pack(_ABSENT) * places, 0)

    def say(self, place: int, connections: int) -> None:
        """State how many connections the worker in a place has."""
        os.pwrite(self._file, _NUMBER.pack(connections), place * _NUMBER.size)

    def leave(self, place: int) -> None:
        """State that no worker in this place takes connections."""
        self.say(place, _ABSENT)

    def least(self) -> int:
        """The connections of the worker that has fewest; 0 when there is none."""
        data = os.pread(self._file, 2**16, 0)
        return min((number for (number,) in _NUMBER.iter_unpack(data) if number != _ABSENT), default=0)

    def close(self) -> None:
        """Close the file."""
        os.close(self._file)


def usual_places() -> list[Path]:
    """Where the folder may be, the best first."""
    try:
        return [_IN_MEMORY, Path(tempfile.gettempdir())]
    except FileNotFoundError:  # a container that is read-only
        return [_IN_MEMORY]


def free_bytes(place: Path) -> int:
    """Room that is left there; none where it cannot be told."""
    try:
        room = os.statvfs(place)
    except OSError:
        return 0
    return room.f_bavail * room.f_frsize


def _remove_ruins(place: Path) -> None:
    """Remove folders of this user that no process has open."""
    for path in place.glob(f"{_PREFIX}*/{_LOCK}"):
        with contextlib.suppress(OSError):  # somebody else's, or gone meanwhile
            if path.parent.stat().st_uid != os.getuid() or path.parent.is_symlink():
                continue
            ruin = SharedFolder(path.parent)
            try:
                ruin.remove_if_last()
            finally:
                ruin.close()
