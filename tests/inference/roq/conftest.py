"""The shipped model, and one basis built with it."""

import pytest

from bnserve_inference.roq import build_basis
from bnserve_surrogate import Model
from tests.inference.roq.tiny import tiny


@pytest.fixture(scope="session")
def model():
    return Model.default()


@pytest.fixture(scope="session")
def built(model, tmp_path_factory):
    """The finished construction of :data:`tests.inference.roq.tiny.TINY`."""
    return build_basis(tiny(), model, tmp_path_factory.mktemp("roq"), n_jobs=2, progress=False, say=lambda line: None)


@pytest.fixture(scope="session")
def basis(built):
    return built.quadrature
