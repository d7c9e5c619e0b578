"""The model and the data that most tests of likelihoods share."""

import pytest

from bnserve_surrogate import Model
from tests.inference.networks import network


@pytest.fixture(scope="session")
def model():
    """Of one mode; likelihoods of several are in :mod:`tests.inference.test_modes`."""
    return Model.load("fast", "1.0.0")


@pytest.fixture(scope="session")
def data(model):
    return network(model)
