"""Files of bases, and the directory of a construction: what is finished survives anything."""

from __future__ import annotations

import contextlib
import fcntl
import time
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

import bnserve_store
from bnserve_inference.roq._errors import BasisUnwritable

_EVERY_SECONDS = 5.0
"""Between two checkpoints; what comes between is computed again after a kill, with the same result."""


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """As :func:`bnserve_store.replacing`, in a folder that is made if need be.

    Raises
    ------
    BasisUnwritable
        No room, no permission, and the like; nothing half-written is left.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with bnserve_store.replacing(path) as temporary:
            yield temporary
    except OSError as error:
        raise BasisUnwritable(
            f"Cannot write {path}: {error.strerror or error}. Make room, or choose a place that you can write to."
        ) from error


class Checkpoints:
    """Arrays by name in a directory, each replaced as a whole.

    Parameters
    ----------
    directory
        Made if it does not exist.
    every
        Seconds between two checkpoints of the same name, unless forced.
    """

    def __init__(self, directory: Path, every: float = _EVERY_SECONDS) -> None:
        self.directory = directory
        self._every = every
        self._last: dict[str, float] = {}

    def keep(self, name: str, arrays: dict[str, Any], force: bool = False) -> None:
        """Write the arrays, if the last time is long enough ago or ``force``.

        Raises
        ------
        BasisUnwritable
            There is no room, or no permission.
        """
        now = time.monotonic()
        if not force and now - self._last.setdefault(name, now) < self._every:
            return
        with replacing(self.directory / f"{name}.npz") as temporary, temporary.open("wb") as file:
            np.savez(file, allow_pickle=False, **arrays)
        self._last[name] = now

    def find(self, name: str) -> dict[str, Any] | None:
        """The arrays kept last; None if there are none, or what there is cannot be read and must be computed again."""
        try:
            with (self.directory / f"{name}.npz").open("rb") as file, np.load(file, allow_pickle=False) as archive:
                return {key: archive[key] for key in archive.files}
        except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
            return None


@contextmanager
def working_in(directory: Path) -> Iterator[Checkpoints]:
    """The directory's checkpoints, for this process alone.

    Raises
    ------
    BasisUnwritable
        Another process builds the same basis there, or the directory cannot be written.
    """
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with (directory / "lock").open("w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError as error:
                raise BasisUnwritable(
                    f"Another process builds this basis in {directory}. Wait for it, or choose another directory."
                ) from error
            yield Checkpoints(directory)
    except OSError as error:
        raise BasisUnwritable(
            f"Cannot work in {directory}: {error.strerror or error}. Make room, or choose another directory."
        ) from error
