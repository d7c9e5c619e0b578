"""Posteriors and evidences of likelihoods over the unit cube, in batches of thousands, with honest errors."""

from bnserve_posterior.sampling._errors import (
    CheckpointMismatch,
    LikelihoodEmpty,
    LikelihoodNotFinite,
    PosteriorUnreliable,
    SamplingError,
)
from bnserve_posterior.sampling._pareto import BELIEVED, pareto_k
from bnserve_posterior.sampling._posterior import Posterior
from bnserve_posterior.sampling._problem import (
    PLAIN,
    Coordinates,
    Problem,
    Progress,
    Settings,
    Twins,
    log_normal,
    plain,
)
from bnserve_posterior.sampling._sample import sample

__all__ = [
    "BELIEVED",
    "PLAIN",
    "CheckpointMismatch",
    "Coordinates",
    "LikelihoodEmpty",
    "LikelihoodNotFinite",
    "Posterior",
    "PosteriorUnreliable",
    "Problem",
    "Progress",
    "SamplingError",
    "Settings",
    "Twins",
    "log_normal",
    "pareto_k",
    "plain",
    "sample",
]
