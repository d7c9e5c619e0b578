"""A study that any number of processes may work on, belongs to one setup, and outlives all of them.

Its file is optuna's journal, one JSON object per line. Nothing in it can run: optuna unpickles snapshots of a journal
only from backends that keep them, and a file has none.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import optuna
from optuna.storages.journal import JournalFileBackend, JournalStorage
from optuna.study import StudyDirection
from optuna.trial import FrozenTrial, TrialState

from bnserve_surrogate.training.data.chunks import unwritable_named
from bnserve_surrogate.training.errors import TrainingError

_NAME = "bnserve search"
_SETUP, _REASON = "setup", "reason"


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


class StudyMismatch(TrainingError):
    """A study that was made with another configuration."""

    code = "study-mismatch"
    title = "Study of another configuration"


@contextlib.contextmanager
def working_on(path: Path, setup: dict[str, Any]) -> Iterator[optuna.Study]:
    """Open a study for more trials, or begin it; trials of processes that were killed are closed as failed.

    Parameters
    ----------
    path
        The journal. Its folder is made.
    setup
        Everything that trials of this study have in common, as plain values.

    Raises
    ------
    StudyUnreadable, StudyMismatch
        The file is something else.
    DatasetUnwritable
        Disk full, no permission.
    """
    with unwritable_named(path.parent):
        path.parent.mkdir(parents=True, exist_ok=True)
        workers = os.open(beside(path, "workers"), os.O_RDWR | os.O_CREAT, 0o644)
    try:
        alone = _only_one(workers)
        study = open_journal(path)
        if _SETUP not in study.user_attrs:
            study.set_user_attr(_SETUP, setup)
        _compare(path, study.user_attrs[_SETUP], setup)
        if alone:
            for trial in study.get_trials(deepcopy=False, states=(TrialState.RUNNING,)):
                study.tell(trial.number, state=TrialState.FAIL)
        fcntl.flock(workers, fcntl.LOCK_SH)
        with unwritable_named(path.parent):
            yield study
    finally:
        os.close(workers)


def read_study(path: Path, setup: dict[str, Any]) -> optuna.Study:
    """Open a study to look at it.

    Raises
    ------
    StudyUnreadable
        There is none, or the file is something else.
    StudyMismatch
        It was made with another configuration.
    """
    if not path.is_file() or not path.stat().st_size:
        raise StudyUnreadable(f"There is no study {path}. Begin one by leaving out --report, or name another.")
    study = open_journal(path)
    _compare(path, study.user_attrs.get(_SETUP, {}), setup)
    return study


def finished(study: optuna.Study) -> int:
    """Trials that are done, have failed for a reason, or run in some process; interrupted ones do not count."""
    counted = (TrialState.COMPLETE, TrialState.RUNNING)
    return sum(trial.state in counted or _REASON in trial.user_attrs for trial in study.get_trials(deepcopy=False))


def fail(study: optuna.Study, trial: optuna.Trial, reason: str) -> None:
    """Close a trial without a result."""
    trial.set_user_attr(_REASON, reason)
    study.tell(trial, state=TrialState.FAIL)


def failures(study: optuna.Study) -> list[str]:
    """Why trials failed."""
    trials: list[FrozenTrial] = study.get_trials(deepcopy=False)
    return [trial.user_attrs[_REASON] for trial in trials if _REASON in trial.user_attrs]


def _only_one(workers: int) -> bool:
    try:
        fcntl.flock(workers, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        fcntl.flock(workers, fcntl.LOCK_SH)
        return False
    return True


def _compare(path: Path, theirs: dict[str, Any], ours: dict[str, Any]) -> None:
    ours = json.loads(json.dumps(ours))
    different = sorted(key for key in theirs.keys() | ours.keys() if theirs.get(key) != ours.get(key))
    if different:
        listed = "; ".join(f"{key}: {theirs.get(key)} there, {ours.get(key)} here" for key in different)
        raise StudyMismatch(
            f"The study {path} was made with another configuration ({listed}). Use that one, or name another file "
            "with --study."
        )
