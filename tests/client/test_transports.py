"""The same conversation over plain sockets, Unix sockets, httpx, and transports that the user injects."""

import socketserver
import threading

import httpx
import numpy as np
import pytest

from bnserve_client import ConnectionFailed, NotBnserve, ParametersWithExtrinsic
from bnserve_client._addresses import parse_addresses
from bnserve_client._connections import uses_plain_sockets
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
