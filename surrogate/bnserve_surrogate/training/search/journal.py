"""The file of a study: optuna's journal, one JSON object per line, which any number of processes may append to.

Nothing in it can run: optuna unpickles snapshots of a journal only from backends that keep them, and a file has none.
"""

from __future__ import annotations

import fcntl
import json
import os
from pathlib import Path

import optuna
from optuna.storages.journal import JournalFileBackend, JournalStorage
from optuna.study import StudyDirection

from bnserve_surrogate.training.data.chunks import unwritable_named
from bnserve_surrogate.training.errors import TrainingError

_NAME = "bnserve search"


class StudyUnreadable(TrainingError):
    """A file that is not a study, or not one of ours."""

    code = "study-unreadable"
    title = "Not a study"


class JournalLock:
    """A lock of optuna's journal that the operating system lets go of however a process ends."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._descriptor = -1

    def acquire(self) -> bool:
        """Wait for the lock."""
        descriptor = os.open(self._path, os.O_RDWR | os.O_CREAT, 0o644)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        self._descriptor = descriptor
        return True

    def release(self) -> None:
        """Give it back."""
        os.close(self._descriptor)


def open_journal(path: Path) -> optuna.Study:
    """The study in a file, which is made if there is none.

    Raises
    ------
    StudyUnreadable
        The file is something else, or holds another study.
    DatasetUnwritable
        Disk full, no permission.
    """
    lock = JournalLock(beside(path, "lock"))
    try:
        with unwritable_named(path.parent):
            _mend(path, lock)
            storage = JournalStorage(JournalFileBackend(str(path), lock_obj=lock))  # type: ignore[arg-type] # duck-typed
        names = {study.study_name for study in storage.get_all_studies()}
        if names - {_NAME}:
            raise StudyUnreadable(f"{path} holds another study, {names.pop()}. Name another file with --study.")
        if _NAME in names:
            return optuna.load_study(storage=storage, study_name=_NAME)
        both = [StudyDirection.MINIMIZE] * 2
        return optuna.create_study(storage=storage, study_name=_NAME, directions=both, load_if_exists=True)
    except (ValueError, KeyError, TypeError, AssertionError) as error:  # what optuna raises for lines not its own
        raise StudyUnreadable(
            f"{path} is not a study, or damaged ({error}). Name another file with --study."
        ) from error


def beside(path: Path, suffix: str) -> Path:
    """A hidden file beside a study."""
    return path.with_name(f".{path.name}.{suffix}")


def _mend(path: Path, lock: JournalLock) -> None:
    """Cut off a last line that its writer did not finish, if this is a journal at all."""
    if not path.exists() or not path.stat().st_size:
        return
    with path.open("rb+") as file:
        if "op_code" not in json.loads(file.readline()):
            raise ValueError("its first line is not an entry of a journal")
        lock.acquire()
        try:
            file.seek(0)
            file.truncate(file.read().rfind(b"\n") + 1)
        finally:
            lock.release()
