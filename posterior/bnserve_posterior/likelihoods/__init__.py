"""The likelihood of an event over its prior: the cheapest that is exact enough."""

from bnserve_posterior.likelihoods._building import Choice, build_likelihood, full_likelihood
from bnserve_posterior.likelihoods._doubts import model_doubts, response_doubts
from bnserve_posterior.likelihoods._envelopes import Envelopes
from bnserve_posterior.likelihoods._marginalised import integrated_names, marginalised_distance
from bnserve_posterior.likelihoods._ranges import analysis_ranges

__all__ = [
    "Choice",
    "Envelopes",
    "analysis_ranges",
    "build_likelihood",
    "full_likelihood",
    "integrated_names",
    "marginalised_distance",
    "model_doubts",
    "response_doubts",
]
