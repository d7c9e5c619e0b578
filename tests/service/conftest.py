"""A server in a thread of the test process, reached over its port."""

import pytest

from bnserve_service import BackgroundServer, Settings
from tests.service.chirp import ChirpModel, MemorySource, QuickChirpModel, as_it_is

SMALL_LIMITS = {
    "port": 0,
    "threads": 2,
    "max_body_bytes": 2**20,
    "max_json_body_bytes": 2**16,
    "max_json_samples": 1000,
    "max_rows": 64,
    "max_frequencies": 2**14,
    "max_samples": 2**18,
    "max_grids": 3,
    "poll_seconds": 0.05,
    "self_check_seconds": 0.05,
    "drain_grace": 0.0,
}


@pytest.fixture(scope="session", params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def server(request):
    """A server of the Newtonian chirp with small limits, shared by the tests that do not change it."""
    source = MemorySource().add(request.param())
    with BackgroundServer(Settings(**SMALL_LIMITS), source=source, factory=as_it_is) as it:
        yield it


@pytest.fixture
def start():
    """Start servers of given models for one test."""
    running = []

    def start_one(*models, source=None, **settings):
        source = source or MemorySource()
        for model in models:
            source.add(model)
        server = BackgroundServer(Settings(**(SMALL_LIMITS | settings)), source=source, factory=as_it_is)
        running.append(server.__enter__())
        return server

    yield start_one
    for server in running:
        server.__exit__()
