"""What schemathesis makes of our OpenAPI document, in MessagePack and in JSON: answered as the document says."""

import pytest

from benchmarks.reliability.fuzzing.openapi import exercise
from bnserve_service import BackgroundServer, Settings
from bnserve_service.evaluation import waveforms as answering
from tests.service.chirp import ChirpModel, MemorySource, as_it_is
from tests.service.conftest import SMALL_LIMITS


def fail(*arguments):
    raise KeyError("a defect")


@pytest.mark.slow
@pytest.mark.parametrize("sound", [True, False])
def test_generated_requests_are_answered_as_the_document_says(sound, monkeypatch):
    if not sound:
        monkeypatch.setattr(answering, "decode_request", fail)
    source = MemorySource().add(ChirpModel())
    with BackgroundServer(Settings(**SMALL_LIMITS), source=source, factory=as_it_is) as server:
        statuses, failures = exercise(server.address, {"name": "chirp", "version": "1.0.0"}, 3, method="POST")
    assert statuses.total() > 20
    assert bool(failures) is not sound, failures
