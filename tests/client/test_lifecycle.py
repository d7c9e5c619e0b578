"""Closing, pickling, copying, threads, and what is sent along with each request."""

import copy
import pickle
from concurrent.futures import ThreadPoolExecutor

import httpx
import numpy as np
import pytest

from bnserve_client import AsyncModel, InvalidRequest, Model, ModelUnknown, ParametersWithExtrinsic, Unauthorized
from bnserve_protocol import WaveformModel
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel, binaries
from tests.client.reference_service import ReferenceService

FREQUENCIES = np.linspace(20.0, 1024.0, 50)
ONE = ParametersWithExtrinsic.gw170817()
RIGHT = ReferenceModel().predict(FREQUENCIES, ONE)


def test_it_is_a_waveform_model(model):
    assert isinstance(model, WaveformModel)


def test_connecting_takes_one_request(server, model):
    assert len(server.service.requests) == 1


def test_connections_are_used_again(server, model):
    for _ in range(20):
        model.predict(FREQUENCIES, ONE)
    assert server.connections == 1


def test_a_label_is_resolved_once_and_requests_name_the_version(server, connect):
    server.service.labels["production"] = "1.0.0"
    connect(server.address, version="production").predict(FREQUENCIES, ONE)
    assert server.service.requests[-1][1] == "/v1/models/default/versions/1.0.0/waveforms"


@pytest.mark.parametrize("arguments", [("other",), ("default", "0.0.1"), ("a/../b",), ("",)])
def test_an_unknown_model_or_version_is_an_error_at_once(server, connect, arguments):
    name, *version = arguments
    with pytest.raises(ModelUnknown):
        connect(server.address, name, version=version[0] if version else "stable")


def test_a_token_is_sent_and_a_wrong_one_is_an_error(start_server, connect):
    server = start_server(ReferenceService(token="secret"))
    assert same(connect(server.address, token="secret").predict(FREQUENCIES, ONE), RIGHT)
    with pytest.raises(Unauthorized):
        connect(server.address, token="guess")


def test_every_request_has_a_name_and_a_deadline(server, model):
    for _ in range(2):
        model.predict(FREQUENCIES, ONE)
    sent = [headers for _, _, headers, _ in server.service.requests]
    assert len({headers["x-request-id"] for headers in sent}) == len(sent)
    assert all(0 < int(headers["x-request-deadline-ms"]) <= 30_000 for headers in sent)


@pytest.mark.parametrize("copied", [lambda model: pickle.loads(pickle.dumps(model)), copy.deepcopy, copy.copy])
def test_a_copy_connects_when_it_is_needed(server, model, copied):
    before = server.connections
    with copied(model) as twin:
        assert server.connections == before
        assert same(twin.predict(FREQUENCIES, ONE), RIGHT)
        assert twin.description == model.description


def test_a_closed_model_opens_new_connections(model):
    model.predict(FREQUENCIES, ONE)
    model.close()
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_threads_share_a_model(model):
    def ask(number):
        batch = binaries(3, seed=number)
        return same(model.predict_batch(FREQUENCIES, batch), ReferenceModel().predict_batch(FREQUENCIES, batch))

    with ThreadPoolExecutor(16) as threads:
        assert all(threads.map(ask, range(400)))


WRONG_SETTINGS = {
    "no scheme": ("localhost:8000", {}),
    "another scheme": ("ftp://host", {}),
    "no address": ("", {}),
    "a password in the URL": ("http://user:word@host", {}),
    "a port that is none": ("http://host:port", {}),
    "an empty Unix path": ("unix:", {}),
    "no time": ("http://host", {"timeout": 0.0}),
    "negative retries": ("http://host", {"retries": -1}),
    "a time as text": ("http://host", {"timeout": "30"}),
    "no number of seconds": ("http://host", {"silence": np.nan}),
    "a time that is true": ("http://host", {"timeout": True}),
    "a fraction of a retry": ("http://host", {"retries": 1.5}),
    "half a chunk": ("http://host", {"parallel": 0.5}),
    "a chunk as text": ("http://host", {"chunk_samples": "many"}),
    "a token with a line break": ("http://host", {"token": "secret\n"}),
}


@pytest.mark.parametrize(("address", "options"), WRONG_SETTINGS.values(), ids=WRONG_SETTINGS)
def test_settings_that_cannot_work_are_refused(address, options):
    with pytest.raises(InvalidRequest):
        Model.connect(address, **options)


def test_settings_may_be_numbers_of_any_kind(server, connect):
    numbers = {"timeout": np.float32(30.0), "silence": np.array(30), "retries": np.int64(2), "parallel": np.uint8(2)}
    assert same(connect(server.address, **numbers).predict(FREQUENCIES, ONE), RIGHT)
    for_ever = connect(server.address, timeout=np.inf, silence=np.inf, chunk_samples=np.int64(100), progress=np.False_)
    assert same(for_ever.predict(FREQUENCIES, ONE), RIGHT)


def test_a_wrong_kind_of_transport_is_refused(server):
    with pytest.raises(InvalidRequest, match="BaseTransport"):
        Model.connect(server.address, transport=lambda: 3)


def test_a_transport_object_is_not_pickled(server, connect):
    transport = httpx.HTTPTransport()
    model = connect(server.address, transport=transport)
    with pytest.raises(TypeError, match="pass a module-level function"):
        pickle.dumps(model)
    transport.close()


def test_synchronous_and_asynchronous_models_have_the_same_methods():
    public = [{name for name in dir(kind) if not name.startswith("_")} for kind in (Model, AsyncModel)]
    assert public[0] == public[1]
