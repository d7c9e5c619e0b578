"""What can go wrong with a posterior."""

from __future__ import annotations

from bnserve_protocol import BnserveError


class SamplingError(BnserveError):
    """Base of the errors of sampling."""

    code = "sampling"
    title = "No posterior"


class LikelihoodNotFinite(SamplingError):
    """A likelihood is NaN or infinitely large at a point of the prior; -inf is allowed."""

    code = "likelihood-not-finite"
    title = "A likelihood that is no number"


class LikelihoodEmpty(SamplingError):
    """The likelihood is zero wherever the prior was looked at."""

    code = "likelihood-empty"
    title = "No likelihood anywhere"


class PosteriorUnreliable(SamplingError):
    """The importance weights have too heavy a tail, or two evidences differ by more than their errors."""

    code = "posterior-unreliable"
    title = "The posterior is not reliable"


class CheckpointMismatch(SamplingError):
    """A checkpoint is of another problem or other settings, or is none."""

    code = "checkpoint-mismatch"
    title = "Another run's checkpoint"
