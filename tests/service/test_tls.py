"""TLS: what is spoken, which certificate a connection gets, and that its renewal ends no connection."""

import contextlib
import shutil
import socket
import ssl
import subprocess
import time
from datetime import UTC, datetime

import httpx
import pytest

from bnserve_service import Settings
from bnserve_service.errors import SettingsInvalid
from bnserve_service.process.certificate import Certificate
from tests.certificates import certificates
from tests.service.asking import question
from tests.service.chirp import ChirpModel, QuickChirpModel


@pytest.fixture
def made(tmp_path):
    return certificates(tmp_path)


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def server(start, made, request):
    return start(request.param(), **made.settings)


@pytest.fixture
def client(server, made):
    with httpx.Client(base_url=server.address, verify=ssl.create_default_context(cafile=made.trusted)) as it:
        yield it


def shown(address, trusted=None) -> bytes:
    """The certificate that a new connection gets."""
    host, port = address.removeprefix("https://").split(":")
    context = ssl.create_default_context(cafile=trusted)
    if trusted is None:
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    with (
        socket.create_connection((host, int(port)), timeout=30) as plain,
        context.wrap_socket(plain, server_hostname="localhost") as connection,
    ):
        return connection.getpeercert(binary_form=True)


def until(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_it_says_that_it_speaks_tls_and_does(server, client):
    assert server.address.startswith("https://127.0.0.1:")
    assert client.get("/v2/health/ready").json() == {"ready": True}
    for _ in range(3):  # the second is for the fast path
        answer = client.post("/v1/models/chirp/waveforms", json=question(), headers={"accept": "application/json"})
        assert answer.status_code == 200


def test_curl_and_openssl_get_along_with_it(server, made):
    curl = ["curl", "-sS", "--fail", "--cacert", made.trusted, "--tlsv1.2", f"{server.address}/v2/health/ready"]
    assert subprocess.run(curl, capture_output=True, text=True, check=True, timeout=60).stdout == '{"ready":true}'
    program = shutil.which("openssl")
    assert program, "openssl is not installed: apt-get install openssl"
    place = server.address.removeprefix("https://")
    asked = [program, "s_client", "-connect", place, "-CAfile", made.trusted, "-verify_return_error", "-ign_eof"]
    request = "GET /v2/health/live HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"
    done = subprocess.run(asked, input=request, capture_output=True, text=True, check=True, timeout=60)
    assert "Verify return code: 0 (ok)" in done.stdout
    assert '{"live":true}' in done.stdout


def test_old_versions_are_not_spoken(server):
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    with pytest.warns(DeprecationWarning, match=r"TLSv1_1 is deprecated"):
        context.maximum_version = ssl.TLSVersion.TLSv1_1
    host, port = server.address.removeprefix("https://").split(":")
    with socket.create_connection((host, int(port)), timeout=30) as plain, pytest.raises(ssl.SSLError):
        context.wrap_socket(plain)


def test_what_is_no_tls_is_cut_off_and_told_in_the_log(server, client, caplog):
    host, port = server.address.removeprefix("https://").split(":")
    with socket.create_connection((host, int(port)), timeout=30) as plain:
        plain.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert b"HTTP/1.1" not in plain.recv(1000)
    until(lambda: "no valid connection from 127.0.0.1" in caplog.text)
    assert client.get("/v2/health/ready").status_code == 200


def test_who_says_nothing_is_not_waited_for(start, made):
    server = start(ChirpModel(), header_timeout=0.3, **made.settings)
    host, port = server.address.removeprefix("https://").split(":")
    with socket.create_connection((host, int(port)), timeout=30) as silent:
        assert silent.recv(1) == b""


def test_what_is_no_http_is_refused_inside_of_it_too(server, made):
    host, port = server.address.removeprefix("https://").split(":")
    context = ssl.create_default_context(cafile=made.trusted)
    with (
        socket.create_connection((host, int(port)), timeout=30) as plain,
        context.wrap_socket(plain, server_hostname="localhost") as connection,
    ):
        connection.sendall(b"nonsense\r\n\r\n")
        assert connection.recv(1000).startswith(b"HTTP/1.1 400 ")
        while connection.recv(1000):
            pass


@pytest.mark.parametrize("told", ["by its files", "by whoever runs it"])
def test_a_renewed_certificate_is_for_new_connections(start, made, told):
    server = start(ChirpModel(), poll_seconds=0.05 if told == "by its files" else 1000.0, **made.settings)
    before = shown(server.address, made.trusted)
    with httpx.Client(base_url=server.address, verify=ssl.create_default_context(cafile=made.trusted)) as client:
        assert client.get("/v2/health/ready").status_code == 200
        made.renew()
        if told == "by whoever runs it":
            assert client.post("/v1/reload").status_code == 200
        until(lambda: shown(server.address, made.trusted) != before)
        [connection] = client._transport._pool.connections
        assert client.get("/v2/health/ready").status_code == 200
        assert client._transport._pool.connections == [connection], "the one that was open goes on"


@pytest.mark.parametrize("broken", ["chain", "key"])
def test_a_renewal_that_went_wrong_changes_nothing(start, made, broken, caplog):
    server = start(ChirpModel(), **made.settings)
    before = shown(server.address, made.trusted)
    file = getattr(made, broken)
    file.write_text("not a certificate")
    until(lambda: "the certificate stays as it was" in caplog.text)
    assert shown(server.address, made.trusted) == before
    made.renew()
    until(lambda: shown(server.address, made.trusted) != before)


def test_a_certificate_that_came_before_its_key_waits_for_it(made):
    certificate = Certificate(made.chain, made.key)
    old = made.key.read_bytes()
    made.renew()
    new = made.key.read_bytes()
    made.key.write_bytes(old)
    assert not certificate.renew()
    made.key.write_bytes(new)
    assert certificate.renew()
    assert not certificate.renew(), "it is the same"


def test_settings_that_cannot_be(made, tmp_path):
    with pytest.raises(ValueError, match="tls_cert names its file"):
        Settings(tls_key=made.key)
    assert Certificate.of(Settings(uds=tmp_path / "socket", **made.settings)) is None, "nothing travels there"
    for chain, key in ((tmp_path / "none", made.key), (made.chain, tmp_path / "none"), (made.key, made.chain)):
        with pytest.raises(SettingsInvalid, match="certificate"):
            Certificate(chain, key)


def test_a_key_with_a_password_is_refused_and_nobody_is_asked_for_it(made, tmp_path):
    encrypted = tmp_path / "encrypted.key"
    command = ["openssl", "pkey", "-in", made.key, "-aes256", "-passout", "pass:secret", "-out", encrypted]
    subprocess.run(command, check=True, capture_output=True, timeout=60)
    with pytest.raises(SettingsInvalid, match="the key is encrypted"):
        Certificate(made.chain, encrypted)


def test_when_the_certificate_ends_is_told_also_after_it_was_renewed(start, made):
    server = start(ChirpModel(), **made.settings)
    name = "bnserve_certificate_expires_timestamp_seconds"
    with httpx.Client(base_url=server.address, verify=ssl.create_default_context(cafile=made.trusted)) as client:

        def told():
            [line] = [line for line in client.get("/metrics").text.splitlines() if line.startswith(f"{name} ")]
            return float(line.split()[1])

        def is_of(expires):
            made.renew(expires=expires)
            until(lambda: told() == expires.timestamp())

        is_of(datetime(2049, 12, 31, 23, 59, 59, tzinfo=UTC))
        is_of(datetime(2050, 1, 1, tzinfo=UTC))  # from then on, years have four digits (RFC 5280, 4.1.2.5)
        is_of(datetime(2026, 1, 1, tzinfo=UTC))  # it has ended: the connection that is open tells it


def test_the_metrics_may_have_tls_on_their_port_also_before_a_unix_socket(start, made, tmp_path):
    server = start(ChirpModel(), uds=tmp_path / "http.sock", metrics_port=0, metrics_tls=True, **made.settings)
    assert server.metrics_address.startswith("https://127.0.0.1:")
    context = ssl.create_default_context(cafile=made.trusted)
    with httpx.Client(verify=context) as client:
        assert "bnserve_ready 1.0" in client.get(server.metrics_address).text
    before = shown(server.metrics_address.removesuffix("/metrics"))
    made.renew()
    until(lambda: shown(server.metrics_address.removesuffix("/metrics"), made.trusted) != before)


def test_peers_that_speak_no_tls_do_not_pile_up_at_the_metrics_port(start, made):
    server = start(ChirpModel(), metrics_port=0, metrics_tls=True, header_timeout=0.2, **made.settings)
    host, port = server.metrics_address.removeprefix("https://").removesuffix("/metrics").split(":")
    silent = [socket.create_connection((host, int(port)), timeout=30) for _ in range(70)]
    for connection in silent[::2]:
        connection.sendall(b"GET /metrics HTTP/1.1\r\n\r\n")
    for connection in silent:
        with contextlib.suppress(OSError):
            while connection.recv(1000):
                pass  # until it is cut off
        connection.close()
    with httpx.Client(verify=ssl.create_default_context(cafile=made.trusted)) as client:
        assert client.get(server.metrics_address).status_code == 200


def test_tls_for_the_metrics_needs_a_certificate():
    with pytest.raises(ValueError, match="metrics_tls needs a certificate"):
        Settings(metrics_tls=True)
