"""JAX in double precision, as the model needs it, and the models."""

import jax
import pytest

import bnserve_jax
from bnserve_surrogate import Model


@pytest.fixture(autouse=True)
def _double_precision():
    """A setting of the whole process: given back, so that no other test meets it."""
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture(scope="session")
def local():
    return Model.default()


@pytest.fixture(scope="session")
def model():
    jax.config.update("jax_enable_x64", True)
    return bnserve_jax.Model.default()
