"""Opening the socket: free ports, taken ports, Unix sockets left behind."""

import fcntl
import http.client
import os
import socket

import msgpack
import pytest

from bnserve_service import BackgroundServer, Settings
from bnserve_service.process.listening import CannotListen, address_of, listen_tcp, listen_unix
from bnserve_service.process.system import SocketFile, available_cpus, parse_cpu_max
from bnserve_service.workers.supervisor import become_supervisor
from tests.service.asking import MSGPACK, ask_on, question, read_response
from tests.service.chirp import ChirpModel, MemorySource, as_it_is


def test_port_zero_takes_a_free_port():
    with listen_tcp("127.0.0.1", 0) as listener:
        assert address_of(listener).startswith("http://127.0.0.1:")
        assert not address_of(listener).endswith(":0")


def test_a_port_in_use_is_said_with_what_to_do():
    with listen_tcp("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        with pytest.raises(CannotListen, match=rf"Port {port} .* in use.*--port"):
            listen_tcp("127.0.0.1", port)


def test_an_address_that_is_not_ours_is_said():
    with pytest.raises(CannotListen, match=r"no\.such\.host\.invalid"):
        listen_tcp("no.such.host.invalid", 0)


def test_a_unix_socket_left_behind_is_replaced_and_a_living_one_is_not(tmp_path):
    path = tmp_path / "bnserve.sock"
    listen_unix(path).close()
    assert path.is_socket()
    with listen_unix(path) as listener:
        assert address_of(listener) == f"unix:{path}"
        with pytest.raises(CannotListen, match="already listening"):
            listen_unix(path)
    with pytest.raises(CannotListen):
        listen_unix(tmp_path / "missing" / "bnserve.sock")
    (tmp_path / "file").write_text("not a socket")
    with pytest.raises(CannotListen):
        listen_unix(tmp_path / "file")


def test_a_unix_socket_is_removed_by_whoever_made_it_alone(tmp_path):
    path = tmp_path / "bnserve.sock"
    with listen_unix(path):
        first = SocketFile(path)
    with listen_unix(path):  # in place of the other, perhaps under the same number
        first.remove()
        assert path.is_socket()
        SocketFile(path).remove()
        assert not path.exists()
        first.remove()
    missing = SocketFile(path)
    with listen_unix(path):
        missing.remove()
        assert path.is_socket()


def test_nothing_is_left_of_a_unix_socket(tmp_path):
    path = tmp_path / "bnserve.sock"
    with BackgroundServer(
        Settings(uds=path, drain_grace=0.0), source=MemorySource().add(ChirpModel()), factory=as_it_is
    ):
        assert path.is_socket()
    assert not path.exists()
    with listen_tcp("127.0.0.1", 0) as taken, pytest.raises(CannotListen):
        become_supervisor(Settings(uds=path, workers=2, metrics_port=taken.getsockname()[1]), announce=print)
    assert not path.exists()


def test_serving_on_a_unix_socket(start, tmp_path):
    path = tmp_path / "bnserve.sock"
    server = start(ChirpModel(), uds=path)
    assert server.address == f"unix:{path}"
    connection = http.client.HTTPConnection("localhost")
    connection.sock = socket.socket(socket.AF_UNIX)
    connection.sock.connect(str(path))
    connection.request("GET", "/v2/health/ready")
    answer = connection.getresponse()
    assert (answer.status, answer.read()) == (200, b'{"ready":true}')
    connection.close()


def test_a_client_that_still_offers_memory_for_its_answer_gets_an_ordinary_answer(start, tmp_path):
    path = tmp_path / "bnserve.sock"
    start(ChirpModel(), uds=path)
    offered = os.memfd_create("test", os.MFD_ALLOW_SEALING)
    os.ftruncate(offered, 2**21)
    key = bytes(range(16))
    os.pwrite(offered, key, 0)
    fcntl.fcntl(offered, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW)
    body = msgpack.packb(question(grid={"f_min": 20.0, "f_max": 2000.0, "delta_f": 0.25}, output="factored"))
    answers = []
    for header in ("", f"X-Answer-Memory: fd={offered}; key={key.hex()}; size={2**21}\r\n"):
        head = f"POST /v1/models/chirp/waveforms HTTP/1.1\r\nHost: localhost\r\nContent-Type: {MSGPACK}\r\n{header}"
        with socket.socket(socket.AF_UNIX) as connection:
            connection.connect(str(path))
            connection.sendall(f"{head}Content-Length: {len(body)}\r\n\r\n".encode() + body)
            answers.append(read_response(connection))
    plain, other = answers
    assert (plain.status, other.status) == (200, 200)
    assert len(plain.body) > 2**16
    assert other.body == plain.body
    assert os.pread(offered, 2**21, 0) == key + bytes(2**21 - 16)
    os.close(offered)


def test_a_server_that_nobody_can_reach_any_more_is_not_ready(start, tmp_path):
    path = tmp_path / "bnserve.sock"
    server = start(ChirpModel(), uds=path)
    assert b"bnserve_ready 1.0" in server.app.parts.metrics.exposition()
    connection = http.client.HTTPConnection("localhost")
    connection.sock = socket.socket(socket.AF_UNIX)
    connection.sock.connect(str(path))
    path.unlink()
    answer = ask_on(connection, "GET", "/v2/health/ready")
    assert (answer.status, answer.code) == (503, "unavailable")
    assert b"bnserve_ready 0.0" in server.app.parts.metrics.exposition()
    connection.close()


@pytest.mark.parametrize(
    ("text", "expected"), [("max 100000", None), ("200000 100000\n", 2.0), ("50000 100000", 0.5), ("", None)]
)
def test_a_containers_quota(text, expected):
    assert parse_cpu_max(text) == expected
    assert available_cpus() >= 1


def test_who_may_connect_to_a_unix_socket(tmp_path):
    path = tmp_path / "socket"
    for mode in ("600", "0660", "666"):
        with listen_unix(path, mode):
            assert path.stat().st_mode & 0o777 == int(mode, 8)
        path.unlink()
    with listen_unix(path, "660", str(os.getgid())):
        assert path.stat().st_gid == os.getgid()
    path.unlink()
    with pytest.raises(CannotListen, match="There is no group 'no such group'"):
        listen_unix(path, "660", "no such group")
    assert not path.exists()


@pytest.mark.parametrize("mode", ["rw", "888", "77777", ""])
def test_what_is_no_mode_is_refused(mode):
    with pytest.raises(ValueError, match="uds_mode"):
        Settings(uds_mode=mode)
