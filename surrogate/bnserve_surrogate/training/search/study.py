"""A study that any number of processes may work on, belongs to one setup, and outlives all of them."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import optuna
from optuna.trial import FrozenTrial, TrialState

from bnserve_surrogate.training.data.chunks import unwritable_named
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.search.journal import StudyUnreadable, beside, open_journal

_SETUP, _REASON = "setup", "reason"


class StudyMismatch(TrainingError):
    """A study that was made with another configuration."""

    code = "study-mismatch"
    title = "Study of another configuration"


@contextlib.contextmanager
def working_on(path: Path, setup: dict[str, Any]) -> Iterator[optuna.Study]:
    """Open a study for more trials, or begin it; trials of processes that were killed are closed as failed.

    Parameters
    ----------
    path:
        The journal. Its folder is made.
    setup:
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
    """Open a study to look at it; raises as :func:`working_on`, and if there is none."""
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
