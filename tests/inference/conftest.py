"""The model and the data that most tests of likelihoods share."""

import pytest

from bnserve_surrogate import Model
from tests.inference.networks import network


@pytest.fixture(scope="session")
def model():
    return Model.load("fast")


@pytest.fixture(scope="session")
def data(model):
    return network(model)
