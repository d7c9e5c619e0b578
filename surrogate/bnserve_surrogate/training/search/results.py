"""What a study has found: its Pareto collection, and a plot of it."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path

import optuna
from optuna.trial import TrialState

from bnserve_protocol import require
from bnserve_surrogate.training.data.generation import configured_generator
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.search.hyperparameters import (
    Hyperparameters,
    ParetoCollection,
    ParetoEntry,
    ParetoSetup,
    nested,
)
from bnserve_surrogate.training.search.study import failures, read_study
from bnserve_surrogate.training.search.trials import Search
from bnserve_surrogate.training.validation.report import write_file


class SearchEmpty(TrainingError):
    """A study without a single result."""

    code = "search-empty"
    title = "No result"


@dataclass(frozen=True)
class SearchResults:
    """Of a study: ``pareto``, every finished trial in ``trials``, and how many ``failed`` for a reason."""

    pareto: ParetoCollection
    trials: tuple[ParetoEntry, ...]
    failed: int


def search_results(search: Search) -> SearchResults:
    """Read a study.

    Raises
    ------
    SearchEmpty
        No trial has finished.
    StudyUnreadable, StudyMismatch
        There is no study, or one of another configuration.
    """
    study = read_study(search.study, search.setup)
    reasons = failures(study)
    done = study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,))
    if not done:
        hint = f" Failed: {'; '.join(sorted(set(reasons))[:3])}." if reasons else ""
        raise SearchEmpty(f"No trial of {search.study} has finished.{hint} Give it more trials or time.")
    best = sorted((_entry(search, trial) for trial in study.best_trials), key=lambda entry: entry.waveforms)
    pareto = ParetoCollection(setup=_setup(search, len(done)), entry=tuple(best))
    return SearchResults(pareto, tuple(_entry(search, trial) for trial in done), len(reasons))


def results_table(results: SearchResults) -> str:
    """The Pareto front as plain text."""
    lines = [f"{'waveforms':>10}{'cost [s]':>12}{'training [s]':>14}{'error':>12}{'median mismatch':>18}{'trial':>8}"]
    for entry in results.pareto.entry:
        lines.append(
            f"{entry.waveforms:>10}{entry.cost_seconds:>12.4g}{entry.training_seconds:>14.3g}"
            f"{entry.reconstruction_error:>12.3g}{entry.median_mismatch:>18.3g}{entry.trial:>8}"
        )
    return "\n".join(lines)


def plot_results(path: Path, title: str, results: SearchResults) -> None:
    """Write the two costs of every trial and the Pareto front as a picture.

    Raises
    ------
    DatasetUnwritable
        Disk full, no permission.
    """
    drawing = require("matplotlib.figure", "The picture of a search", "train")
    figure = drawing.Figure(figsize=(9, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    front = sorted(results.pareto.entry, key=lambda entry: entry.cost_seconds)
    for axis, by in ((left, "cost_seconds"), (right, "waveforms")):
        x = [getattr(entry, by) for entry in results.trials]
        axis.plot(x, [entry.reconstruction_error for entry in results.trials], ".", color="#9aa7b5", label="trials")
        x, y = [getattr(entry, by) for entry in front], [entry.reconstruction_error for entry in front]
        axis.plot(x, y, "o-" if by == "cost_seconds" else "o", color="#c8452d", ms=5, lw=1, label="Pareto front")
        axis.set(xscale="log", yscale="log")
    left.set(xlabel="waveforms and training [s]", ylabel="average squared error on validation waveforms", title=title)
    right.set(xlabel="training waveforms")
    right.legend(frameon=False)
    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=130)
    write_file(path, picture.getvalue())


def _entry(search: Search, trial: optuna.trial.FrozenTrial) -> ParetoEntry:
    found = trial.user_attrs
    costs = {name: _rounded(found[name]) for name in ("reconstruction_error", "median_mismatch", "training_seconds")}
    return ParetoEntry(
        trial=trial.number,
        waveforms=found["waveforms"],
        cost_seconds=_rounded(search.waveform_seconds * found["waveforms"] + found["training_seconds"]),
        hyperparameters=Hyperparameters(**nested(found["values"])),
        **costs,
    )


def _setup(search: Search, trials: int) -> ParetoSetup:
    configuration, ranges = search.configuration, search.configuration.ranges
    generator = configured_generator(configuration)
    return ParetoSetup(
        regressor=configuration.regressor.kind,
        reduction=configuration.reduction.kind,
        coordinates=configuration.regressor.coordinates,
        generator=f"{generator.name} {generator.version}",
        sampling=configuration.dataset.sampling,
        waveforms=search.count,
        waveform_seconds=search.waveform_seconds,
        trials=trials,
        mass_ratio=ranges.mass_ratio,
        chi=ranges.chi,
        tidal_deformability=ranges.tidal_deformability,
    )


def _rounded(value: float) -> float:
    return float(f"{value:.4g}")
