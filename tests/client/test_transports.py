"""The same conversation over plain sockets, Unix sockets, httpx, and transports that the user injects."""

import asyncio
import socket
import socketserver
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import httpx
import numpy as np
import pytest

from bnserve_client import (
    AsyncModel,
    ConnectionFailed,
    DeadlineExceeded,
    NotBnserve,
    ParametersWithExtrinsic,
)
from bnserve_client._addresses import parse_addresses
from bnserve_client._blocking import uses_plain_sockets
from tests.client import scripted_server as faults
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel, binaries
from tests.client.reference_service import ReferenceService, handler_for

FREQUENCIES = np.linspace(20.0, 1024.0, 50)
ONE = ParametersWithExtrinsic.gw170817()
RIGHT = ReferenceModel().predict(FREQUENCIES, ONE)


class UnixServer(socketserver.ThreadingUnixStreamServer):
    daemon_threads = True


@pytest.fixture
def unix_address(tmp_path):
    path = tmp_path / "bnserve.sock"
    handler = type("Handler", (handler_for(ReferenceService()),), {"disable_nagle_algorithm": False})
    with UnixServer(str(path), handler) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield f"unix:{path}"
        server.shutdown()
        thread.join()


def in_process():
    """An httpx transport that is the service itself."""
    service = ReferenceService()

    def answer(request):
        reply = service.respond(request.method, request.url.path, dict(request.headers), request.content)
        return httpx.Response(reply.status, headers=reply.headers, content=reply.body)

    return httpx.MockTransport(answer)


def test_a_unix_socket(unix_address, connect):
    assert same(connect(unix_address).predict(FREQUENCIES, ONE), RIGHT)


def test_a_unix_socket_that_is_not_there(tmp_path, connect):
    with pytest.raises(ConnectionFailed, match=r"No such file.*bnserve serve"):
        connect(f"unix:{tmp_path}/nothing")


SOURCES = {
    "transport": httpx.HTTPTransport,
    "client": httpx.Client,
    "function that makes a transport": lambda: lambda: httpx.HTTPTransport(retries=1),
    "function that makes a client": lambda: lambda: httpx.Client(headers={"X-Site": "here"}),
}


@pytest.mark.parametrize("make", SOURCES.values(), ids=SOURCES)
def test_an_injected_httpx_transport_or_client(server, connect, make):
    source = make()
    model = connect(server.address, transport=source)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    model.close()
    if hasattr(source, "close"):
        source.close()


def test_an_application_in_the_same_process(connect):
    batch = binaries(40)
    model = connect("http://anything", transport=in_process(), chunk_samples=500)
    assert same(model.predict_batch(FREQUENCIES, batch), ReferenceModel().predict_batch(FREQUENCIES, batch))


HTTPX_FAULTS = {
    "reset": faults.reset,
    "no answer": faults.close_silently,
    "truncated": faults.truncate,
    "garbage": faults.send_bytes(b"garbage\r\n\r\n"),
    "flipped bit": faults.flip_bit(-1),
    "too long": faults.change(content_length=str(10**9)),
    "silent": faults.hang(0.6),
}


@pytest.mark.parametrize("fault", HTTPX_FAULTS.values(), ids=HTTPX_FAULTS)
def test_a_passing_fault_is_not_noticed_through_httpx_either(server, connect, fault):
    model = connect(server.address, transport=httpx.HTTPTransport, silence=0.3)
    server.faults.append(fault)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_something_that_is_not_http_is_named_through_httpx_too(server, connect):
    server.faults.extend([faults.send_bytes(b"garbage\r\n\r\n")] * 5)
    with pytest.raises(NotBnserve):
        connect(server.address, transport=httpx.HTTPTransport)


@pytest.mark.parametrize(
    ("address", "environment", "plain"),
    [
        ("http://host:8000", {}, True),
        ("unix:/run/bnserve.sock", {"http_proxy": "http://proxy"}, True),
        ("https://host", {}, False),
        ("http://host:8000", {"http_proxy": "http://proxy"}, False),
        ("http://host:8000", {"ALL_PROXY": "http://proxy"}, False),
    ],
)
def test_httpx_serves_tls_and_proxies(address, environment, plain, monkeypatch):
    for name in ("http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert uses_plain_sockets(parse_addresses(address)[0], None) is plain


def test_addresses_keep_their_prefix_and_their_port():
    first, second = parse_addresses("https://gateway/bnserve/, http://[::1]:8000")
    assert first.base_url == "https://gateway/bnserve"
    assert second.base_url == "http://[::1]:8000"


WAYS = {
    "plain sockets": None,
    "httpx": httpx.HTTPTransport,
    "a client of the user's": lambda: httpx.Client(http1=True),
    "a transport around another": lambda: Around(httpx.HTTPTransport(retries=1)),
}


class Around(httpx.BaseTransport):
    """What users put around a transport, to authenticate say."""

    def __init__(self, inner):
        self._inner = inner

    def handle_request(self, request):
        return self._inner.handle_request(request)

    def close(self):
        self._inner.close()


def hurried(model, **settings):
    """The same model with so little time that only what takes for ever is sure to fail."""
    settings = replace(model._remote.settings, timeout=1.0, **settings)
    return type(model)(settings, model._remote.pinned, model._factory)


@pytest.mark.parametrize("of_head", [True, False], ids=["the head", "the body"])
@pytest.mark.parametrize("transport", WAYS.values(), ids=WAYS)
def test_a_server_that_drips_is_given_up_at_the_timeout(server, connect, transport, of_head):
    """Byte by byte it is never silent; without a limit of the whole it would have an answer in the end."""
    model = connect(server.address, transport=transport)
    drip = faults.Drip(of_head=of_head)
    server.faults.append(drip)
    with (
        hurried(model) as twin,
        pytest.raises(DeadlineExceeded, match=r"timeout of 1 s.*did not finish its answer in that time"),
    ):
        twin.predict(FREQUENCIES, ONE)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    assert drip.ended.wait(60.0)
    assert drip.was_cut_off


@pytest.mark.parametrize("of_head", [True, False], ids=["the head", "the body"])
@pytest.mark.parametrize("transport", [None, httpx.AsyncHTTPTransport, httpx.AsyncClient], ids=str)
def test_asynchronous_models_give_up_a_server_that_drips(server, transport, of_head):
    drip = faults.Drip(of_head=of_head)

    async def run():
        async with await AsyncModel.connect(server.address, transport=transport) as model, hurried(model) as twin:
            server.faults.append(drip)
            with pytest.raises(DeadlineExceeded, match=r"timeout of 1 s.*did not finish its answer in that time"):
                await twin.predict(FREQUENCIES, ONE)
            assert same(await model.predict(FREQUENCIES, ONE), RIGHT)

    asyncio.run(run())
    assert drip.ended.wait(60.0)
    assert drip.was_cut_off


def test_a_server_that_drips_is_given_up_while_others_are_answered(server, connect):
    """The deadline belongs to the request, not to the client that several threads share."""
    with httpx.Client() as shared, ThreadPoolExecutor(2) as threads:
        patient = connect(server.address, transport=shared)
        drip = faults.Drip(of_head=True, seconds=0.003)
        server.faults.append(drip)
        slow = threads.submit(patient.predict, FREQUENCIES, ONE)
        assert drip.begun.wait(60.0)
        assert same(patient.predict(FREQUENCIES, ONE), RIGHT)
        assert same(slow.result(), RIGHT)
        assert not drip.was_cut_off
        server.faults.append(drip := faults.Drip(of_head=True))
        with hurried(patient) as twin, pytest.raises(DeadlineExceeded):
            twin.predict(FREQUENCIES, ONE)  # on a connection that another model has opened
        assert drip.ended.wait(60.0)
        assert drip.was_cut_off


def test_a_server_that_does_not_read_is_given_up_at_the_timeout(connect, server):
    """A large request, written in pieces, each of which the server could take in time."""
    grid = np.linspace(20.0, 1024.0, 200_000)
    model = connect(server.address, transport=httpx.HTTPTransport)
    with socket.create_server(("127.0.0.1", 0)) as listening:
        address = "http://{}:{}".format(*listening.getsockname())
        with hurried(model, addresses=parse_addresses(address)) as stuck, pytest.raises(DeadlineExceeded):
            stuck.predict_batch(grid, binaries(3))
