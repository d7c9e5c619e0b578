"""What can go wrong while training data are made."""

from __future__ import annotations

from bnserve_protocol import BnserveError


class TrainingError(BnserveError):
    """Base of every error that only training raises."""

    code = "training"
    title = "Training failed"


class GeneratorFailure(TrainingError):
    """The generator has no waveform for these parameters."""

    code = "generator-failure"
    title = "Waveform could not be generated"


class GeneratorUnknown(TrainingError):
    """No waveform generator of that name, or options that it does not take."""

    code = "generator-unknown"
    title = "Waveform generator unknown"


class GeneratorDependsOnGrid(TrainingError):
    """What the generator gives at a frequency depends on the other frequencies asked for."""

    code = "generator-depends-on-grid"
    title = "Waveforms depend on the grid"


class WorkersUnusable(TrainingError):
    """The worker processes cannot load the generator."""

    code = "workers-unusable"
    title = "Worker processes unusable"


class TooManyFailures(TrainingError):
    """More waveforms failed than the run allows."""

    code = "too-many-failures"
    title = "Too many waveforms failed"


class DatasetInUse(TrainingError):
    """Another run is writing the same data set."""

    code = "dataset-in-use"
    title = "Data set in use"


class DatasetUnwritable(TrainingError):
    """The data set cannot be written; what was finished before is kept."""

    code = "dataset-unwritable"
    title = "Data set cannot be written"
