"""Whether a trained model is worth a label, by which it would be served to everyone who names no version."""

from __future__ import annotations

import numpy as np

from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.validation.measurement import Validation

LEAST_GAIN = 10.0
"""Factor by which the median mismatch must be below that of the post-Newtonian baseline alone, which costs nothing to
train; the shipped models have 600 to 70 million."""
LARGEST_PHASE_ERROR = 1.5
"""Radians, root mean square, of the phase with ``alignment="merger"``: numbers drawn at random leave 1.8."""


class NotBetter(TrainingError):
    """The model is not so much better than its baseline that it should get a label."""

    code = "not-better"
    title = "Model not better than its baseline"


def check_worth_a_label(validations: dict[str, Validation]) -> None:
    """Compare a model with its baseline, on every kind of fresh waveforms.

    Raises
    ------
    NotBetter
        The median mismatch is not a tenth of the baseline's, or the largest is above the baseline's, or the absolute
        phase was not learnt.
    """
    complaints = [complaint for kind, validation in validations.items() for complaint in _complaints(kind, validation)]
    if complaints:
        raise NotBetter(
            f"Nothing was published: {'; '.join(complaints)}. Train on more waveforms or with another regressor (those "
            "there are will be used again), publish without a label (labels = []), or as it is with --force."
        )


def _complaints(kind: str, validation: Validation) -> list[str]:
    ours, theirs = validation.mismatch, validation.baseline_mismatch
    found = []
    if not LEAST_GAIN * np.median(ours) <= np.median(theirs):
        found.append(
            f"the median mismatch ({kind}), {np.median(ours):.2g}, is not {LEAST_GAIN:g} times below that of the "
            f"post-Newtonian baseline alone, {np.median(theirs):.2g}"
        )
    if not ours.max() <= theirs.max():
        found.append(f"the largest mismatch ({kind}), {ours.max():.2g}, is above the baseline's, {theirs.max():.2g}")
    error = np.sqrt(np.mean(np.angle(np.exp(1j * validation.merger_phase)) ** 2))
    if not error <= LARGEST_PHASE_ERROR:
        found.append(
            f'the phase with alignment="merger" ({kind}) is off by {error:.2g} rad: the constant of the generator\'s '
            "phase is not continuous over the parameters, or too few waveforms show how it varies"
        )
    return found
