"""A scripted server, a model connected to it, and what it must answer."""

from contextlib import ExitStack

import numpy as np
import pytest

from bnserve_client import Model
from tests.client.reference_model import ReferenceModel
from tests.client.scripted_server import ScriptedServer


@pytest.fixture
def start_server():
    """Starts scripted servers, as many as a test wants."""
    with ExitStack() as stack:
        yield lambda *arguments, **options: stack.enter_context(ScriptedServer(*arguments, **options).serving())


@pytest.fixture
def server(start_server):
    return start_server()


@pytest.fixture
def connect():
    """``Model.connect`` whose models are closed at the end."""
    with ExitStack() as stack:

        def connected(*arguments, **options):
            return stack.enter_context(Model.connect(*arguments, **options))

        yield connected


@pytest.fixture
def model(server, connect):
    return connect(server.address, timeout=30.0)


@pytest.fixture
def local():
    return ReferenceModel()


def same(one, other):
    """Whether two results hold the same bits."""
    fields = type(one).__slots__
    return type(one) is type(other) and all(
        np.asarray(getattr(one, name)).dtype == np.asarray(getattr(other, name)).dtype
        and np.asarray(getattr(one, name)).tobytes() == np.asarray(getattr(other, name)).tobytes()
        and np.shape(getattr(one, name)) == np.shape(getattr(other, name))
        for name in fields
    )
