"""Priors of bilby over the unit cube, and the coordinates in which the posterior of a binary is simple."""

from bnserve_posterior.priors._coordinates import coordinates_of
from bnserve_posterior.priors._cube import PriorCube
from bnserve_posterior.priors._parameters import derived_parameters, likelihood_batch, likelihood_parameters
from bnserve_posterior.priors._reading import priors_of
from bnserve_posterior.priors._sky import seconds_before
from bnserve_posterior.priors._syntax import parse_prior, read_prior_file
from bnserve_posterior.priors._twins import twins_of

__all__ = [
    "PriorCube",
    "coordinates_of",
    "derived_parameters",
    "likelihood_batch",
    "likelihood_parameters",
    "parse_prior",
    "priors_of",
    "read_prior_file",
    "seconds_before",
    "twins_of",
]
