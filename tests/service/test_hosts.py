"""A web page does not reach a server on its visitor's machine: other hosts and other sites' changes are refused."""

import http.client
import json
import logging
import socket

import msgpack
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_protocol import Forbidden
from bnserve_service.admission.tokens import Token
from bnserve_service.errors import SettingsInvalid
from bnserve_service.http.access import HostCheck
from bnserve_service.process.listening import is_loopback, open_listener
from bnserve_service.settings import Settings, load_settings
from tests.service.asking import MSGPACK, ask, question, raw_connection, read_response
from tests.service.chirp import ChirpModel, QuickChirpModel

EVIL = "rebound.example:8000"
PATH = "/v1/models/chirp/waveforms"


def lets(check, host, origin=None, method="POST", path=PATH):
    headers = {b"host": host.encode()} | ({} if origin is None else {b"origin": origin.encode()})
    try:
        check.check(headers, method, path)
    except Forbidden:
        return False
    return True


LOOPBACK = ["localhost", "LocalHost:8000", "localhost.", "me.localhost:80", "127.0.0.1:8000", "127.9.8.7", "[::1]:8000"]
FOREIGN = [
    EVIL, "localhost.example", "127.0.0.1.nip.example", "notlocalhost", "10.0.0.1", "0.0.0.0:8000", "[::]", "[::2]:1",
    "x@localhost", "localhost/evil", "localhost,rebound.example", "localhost rebound.example", "2130706433", "\xff",
]  # fmt: skip


@pytest.mark.parametrize("settings", [{}, {"host": "::1"}, {"host": "localhost"}, {"uds": "/run/bnserve.sock"}])
def test_a_server_of_one_machine_goes_by_loopback_names(settings):
    check = HostCheck.of(Settings(**settings))
    assert [host for host in LOOPBACK if not lets(check, host)] == []
    assert [host for host in FOREIGN if lets(check, host)] == []
    assert [host for host in LOOPBACK if not lets(check, host)] == []


def test_a_server_of_a_network_goes_by_every_name_until_it_is_told_its_own():
    assert lets(HostCheck.of(Settings(host="0.0.0.0")), EVIL)
    told = HostCheck.of(Settings(host="0.0.0.0", allowed_hosts=["Waves.example", "10.0.0.7", "[fd00::1]"]))
    for host in ("waves.example", "WAVES.example:443", "10.0.0.7:8000", "[fd00::1]:8000", *LOOPBACK):
        assert lets(told, host)
    assert [host for host in ("sub.waves.example", "10.0.0.8", *FOREIGN) if lets(told, host)] == []
    assert lets(HostCheck.of(Settings(allowed_hosts=["*"])), EVIL)


def test_probes_may_name_any_host():
    assert lets(HostCheck.of(Settings()), "bnserve", method="GET", path="/v2/health/ready")
    assert not lets(HostCheck.of(Settings()), "bnserve", method="GET", path="/metrics")


def test_only_its_own_pages_may_ask_for_changes():
    check = HostCheck.of(Settings(host="0.0.0.0", allowed_hosts=["waves.example"]))
    own = {"localhost:8000": "http://localhost:8000", "waves.example": "https://Waves.example"}
    assert all(lets(check, host, origin) for host, origin in own.items())
    assert lets(check, "localhost:8000", "https://waves.example")  # a proxy in front of it has changed the host
    for origin in ("http://evil.example", "http://localhost:3000", "http://127.0.0.1:8000", "null", "", "file://"):
        for method in ("POST", "PUT", "DELETE"):
            assert not lets(check, "localhost:8000", origin, method)
        assert lets(check, "localhost:8000", origin, "GET")  # which browsers let no other site read
    assert not lets(HostCheck.of(Settings(host="0.0.0.0")), "10.0.0.1:8000", "http://evil.example")
    assert not lets(HostCheck.of(Settings(allowed_hosts=["*"])), "localhost:8000", "http://evil.example")


@pytest.mark.parametrize("model", [ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def test_answers_to_other_hosts_and_sites_are_403_with_what_to_do(start, model):
    server = start(model())
    for headers in ({"host": EVIL}, {"origin": "http://evil.example"}):
        for method, path in (("POST", "/v1/reload"), ("POST", PATH), ("DELETE", f"/v1/analyses/{'0' * 64}")):
            answer = ask(server.address, method, path, msgpack.packb(question()), content_type=MSGPACK, **headers)
            assert (answer.status, answer.code) == (403, "forbidden")
            assert "allowed_hosts" in answer.document["detail"]
    for path in ("/metrics", "/", "/docs", "/v1/models"):
        assert ask(server.address, "GET", path, host=EVIL).status == 403
    assert ask(server.address, "GET", "/v2/health/ready", host=EVIL).status == 200
    assert ask(server.address, "POST", "/v1/reload", origin=server.address).status == 200


def test_a_connection_whose_first_request_was_right_is_looked_at_again(start):
    """What was right for one request says nothing of the next."""
    server, body = start(QuickChirpModel()), msgpack.packb(question())
    with raw_connection(server.address) as connection:
        for host, status in (("localhost", 200), ("localhost", 200), (EVIL, 403), ("localhost", 200)):
            head = f"POST {PATH} HTTP/1.1\r\nHost: {host}\r\nContent-Type: {MSGPACK}\r\nX-Request-ID: me\r\n"
            head += f"X-Request-Deadline-Ms: 9000\r\nContent-Length: {len(body)}\r\n\r\n"
            connection.sendall(head.encode() + body)
            assert read_response(connection).status == status


def test_our_client_connects_over_loopback_and_unix_sockets(start, tmp_path):
    by_port, by_path = start(ChirpModel()), start(ChirpModel(), uds=tmp_path / "bnserve.sock")
    port = by_port.address.rpartition(":")[2]
    for address in (by_port.address, f"http://localhost:{port}", by_path.address):
        with Model.connect(address, "chirp") as model:
            assert model.predict([20.0, 30.0], ParametersWithExtrinsic.gw170817()).plus.shape == (2,)


def test_over_a_unix_socket_another_host_is_refused_too(start, tmp_path):
    server = start(ChirpModel(), uds=tmp_path / "bnserve.sock")
    connection = http.client.HTTPConnection("evil.example")
    connection.sock = socket.socket(socket.AF_UNIX)
    connection.sock.connect(server.address.removeprefix("unix:"))
    connection.request("GET", "/v1/models")
    answer = connection.getresponse()
    assert answer.status == 403
    assert "'evil.example'" in json.loads(answer.read())["detail"]
    connection.close()


def test_our_client_says_what_the_server_said(start, monkeypatch):
    """Of a name that was made to point here."""
    resolve = socket.getaddrinfo
    monkeypatch.setattr(
        socket, "getaddrinfo", lambda host, *rest, **more: resolve(str(host).replace("rebound.example", "127.0.0.1"),
        *rest, **more),
    )  # fmt: skip
    server = start(ChirpModel())
    with pytest.raises(Forbidden, match=r"'rebound\.example'.*allowed_hosts"):
        Model.connect(server.address.replace("127.0.0.1", "rebound.example"), "chirp")


@pytest.mark.parametrize("host", ["http://waves.example", "waves.example:8000", "", "a b", "[::1]:80"])
def test_a_setting_that_is_no_host_is_refused(host):
    with pytest.raises(SettingsInvalid, match="without scheme and port"):
        load_settings(None, {"allowed_hosts": [host]})


def test_which_addresses_only_this_machine_can_connect_to():
    assert all(is_loopback(host) for host in ("127.0.0.1", "127.8.8.8", "::1", "localhost"))
    assert not any(is_loopback(host) for host in ("0.0.0.0", "::", "", "no.such.host.invalid"))


@pytest.mark.parametrize(
    ("settings", "warns"),
    [
        ({"host": "0.0.0.0"}, True),
        ({}, False),
        ({"host": "0.0.0.0", "tokens": [Token.of("a token of our own")]}, False),
    ],
)
def test_an_open_door_is_said_aloud(settings, warns, caplog):
    with caplog.at_level(logging.WARNING), open_listener(Settings(port=0, **settings)):
        assert ("NO TOKENS" in caplog.text) is warns
        assert ("bnserve tokens new" in caplog.text) is warns
