"""The paper's search for hyper-parameters: two costs at once, by a tree-structured Parzen estimator."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import optuna
from optuna.samplers import TPESampler

from bnserve_surrogate.training.search.cost import SearchData, TrialFailed, evaluate, load_search_data
from bnserve_surrogate.training.search.hyperparameters import flat, override
from bnserve_surrogate.training.search.space import first_suggestions, searched_keys, suggest
from bnserve_surrogate.training.search.study import fail, finished, working_on
from bnserve_surrogate.training.sections import TrainingConfiguration

Say = Callable[[str], None]

WAVEFORM_SECONDS = 0.1
"""What the paper counts for one waveform."""
_SPACE = 1
"""Part of every study: raise it when the meaning of a parameter changes."""
_VALIDATION = 512
"""Validation waveforms of a trial, or a quarter of the data set: their average error is known to a few per cent."""
_LEAST_ERROR = 1e-300
"""Has a logarithm."""


@dataclass(frozen=True)
class Search:
    """What is searched, and where the results are kept.

    Parameters
    ----------
    configuration
        The kind of its regressor, its reduction and coordinates decide what is searched; all trials draw their
        waveforms from its data set.
    study
        File of the study.
    waveforms
        Size of the data set; None for the configuration's.
    waveform_seconds
        What one training waveform adds to the second cost.
    """

    configuration: TrainingConfiguration
    study: Path
    waveforms: int | None = None
    waveform_seconds: float = WAVEFORM_SECONDS

    @property
    def count(self) -> int:
        """Size of the data set."""
        return self.configuration.dataset.count if self.waveforms is None else self.waveforms

    @property
    def setup(self) -> dict[str, Any]:
        """What all trials have in common, by dotted key: a study belongs to it."""
        left_out = ("name", "version", "labels", "citation", "validation")
        table = {k: v for k, v in msgspec.to_builtins(self.configuration).items() if k not in left_out}
        searched = {*searched_keys(self.configuration), "regressor.hyperparameters", "regressor.pareto"}
        common = {key: value for key, value in flat(table).items() if key not in searched}
        return common | {"space": _SPACE, "waveforms": self.count, "waveform_seconds": self.waveform_seconds}


def run_search(
    search: Search,
    directory: Path,
    *,
    trials: int,
    timeout: float = math.inf,
    seed: int = 0,
    n_jobs: int = -1,
    backend: str = "loky",
    progress: bool | None = None,
    say: Say = print,
) -> None:
    """Add trials until the study has ``trials`` of them, or ``timeout`` seconds are over.

    The first trials are what the configuration gives, with all waveforms, a quarter, a sixteenth and so on. A trial
    that has begun is finished. The same call after an interruption of whatever kind goes on with the trials that were
    finished; several processes may run it at once.

    Parameters
    ----------
    search
        What, and where.
    directory
        Where waveforms are kept.
    trials, timeout
        When to stop. ``timeout`` does not count the generation of waveforms.
    seed
        Trial i draws its waveforms from it and i, and its parameters from these and the trials before.
    n_jobs, backend, progress
        As for ``build_dataset``.
    say
        Called with a line for every trial.

    Raises
    ------
    TrainingError
        With what to do; finished trials are kept.
    """
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    with working_on(search.study, search.setup) as study:
        whole = override(search.configuration, {"dataset.count": search.count})
        data = load_search_data(whole, directory, n_jobs=n_jobs, backend=backend, progress=progress, say=say)
        validation = min(_VALIDATION, len(data.dataset) // 4)
        most = len(data.dataset) - validation
        if not study.get_trials(deepcopy=False):
            for parameters in first_suggestions(search.configuration, most):
                study.enqueue_trial(parameters, skip_if_exists=True)
        stop = time.monotonic() + timeout
        while finished(study) < trials and time.monotonic() < stop:
            _run_trial(search, study, data, validation, seed, say)


def _run_trial(search: Search, study: optuna.Study, data: SearchData, validation: int, seed: int, say: Say) -> None:
    trial = study.ask()
    own_seed = int(np.random.SeedSequence([seed, trial.number]).generate_state(1)[0])
    study.sampler = TPESampler(seed=own_seed)  # the same draws, whichever process makes them
    values = suggest(trial, search.configuration, len(data.dataset) - validation)
    waveforms = values.pop("dataset.count")
    trial.set_user_attr("waveforms", waveforms)
    trial.set_user_attr("values", values)
    label = f"Trial {trial.number}: {waveforms} waveforms"
    try:
        cost = evaluate(override(search.configuration, values), data, *data.draw(own_seed, waveforms, validation))
    except TrialFailed as error:
        fail(study, trial, error.detail)
        say(f"{label}, failed: {error.detail}")
        return
    for name, value in asdict(cost).items():
        trial.set_user_attr(name, value)
    seconds = search.waveform_seconds * waveforms + cost.training_seconds
    # Logarithms: the estimator compares volumes, and both costs span decades.
    study.tell(trial, [math.log10(max(cost.reconstruction_error, _LEAST_ERROR)), math.log10(seconds)])
    say(
        f"{label}, error {cost.reconstruction_error:.3g}, median mismatch {cost.median_mismatch:.3g}, "
        f"training {cost.training_seconds:.3g} s"
    )
