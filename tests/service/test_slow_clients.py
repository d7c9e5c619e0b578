"""Peers that are slow or silent lose their connection; nobody else notices."""

import asyncio
import re
import socket
import time

import msgpack
import pytest

from bnserve_protocol.wire import content_digest
from bnserve_service.http.pace import Pace
from tests.service.asking import JSON, MSGPACK, ask, evaluate, question, raw_connection, read_response
from tests.service.chirp import ChirpModel, until

HEAD = b"POST /v1/models/chirp/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/json\r\n"


def ends(connection):
    """Read until the peer closes; a reset counts."""
    received = b""
    try:
        while data := connection.recv(65536):
            received += data
    except ConnectionError:
        pass
    return received


@pytest.fixture
def server(start):
    return start(ChirpModel(), header_timeout=0.3, body_timeout=0.3, write_timeout=0.3, keep_alive=0.3)


@pytest.mark.parametrize(
    "sent",
    [b"", b"\r\n\r\n", b"GET", HEAD, b"GET /v1/limits HTTP/1.1\r\nhost: localhost\r\n\r\n"],
    ids=["nothing", "empty lines", "half a line", "half the headers", "idle after an answer"],
)
def test_a_connection_that_waits_for_nothing_is_closed(server, sent):
    with raw_connection(server.address) as connection:
        connection.sendall(sent)
        ends(connection)
    assert evaluate(server.address, question()).status == 200


def test_a_body_that_does_not_come_is_answered_and_ended(server):
    with raw_connection(server.address) as connection:
        connection.sendall(HEAD + b"content-length: 1000\r\n\r\n{")
        answer = read_response(connection)
        assert (answer.status, answer.code) == (400, "body-undecodable")
        assert "arrive" in answer.document["detail"]
        assert answer.headers["connection"] == "close", "what may still come of the body is not waited for"
        ends(connection)


def test_empty_lines_between_requests_do_not_hold_a_connection(server):
    with raw_connection(server.address) as connection:
        connection.sendall(b"GET /v1/limits HTTP/1.1\r\nhost: localhost\r\n\r\n")
        read_response(connection)
        connection.sendall(b"\r\n")
        ends(connection)


def test_an_answer_that_is_not_taken_is_dropped(start):
    server = start(ChirpModel(), write_timeout=0.3, max_samples=2**22, max_frequencies=2**22, queue_samples=2**25)
    body = (
        b'{"parameters":{"mass_ratio":1.2,"lambda_1":1,"lambda_2":1,"chi_1":0,"chi_2":0,"distance_mpc":40,'
        b'"inclination":2,"total_mass":2.7},"grid":{"f_min":1,"f_max":4000000,"delta_f":1}}'
    )
    with socket.socket() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        host, port = server.address.removeprefix("http://").split(":")
        connection.connect((host, int(port)))
        connection.sendall(HEAD + b"accept: application/msgpack\r\ncontent-length: %d\r\n\r\n" % len(body) + body)
        assert connection.recv(1000).startswith(b"HTTP/1.1 200")
        waveforms = server.app.parts.evaluation
        assert waveforms.answer_bytes > 0
        until(lambda: waveforms.answer_bytes == 0, "the memory of the answer is given back")


LARGE = {"max_samples": 2**22, "max_frequencies": 2**22, "queue_samples": 2**25}
MIB = 2**20


def asks(address, points, more=b""):
    """A connection on which an answer of 16 bytes for each point is asked for, and little of it waits unread."""
    grid = {"f_min": 1.0, "f_max": float(points), "delta_f": 1.0}
    body = msgpack.packb(question(grid=grid, output="factored"))
    connection = socket.socket()
    connection.settimeout(60)
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2**16)
    host, port = address.removeprefix("http://").split(":")
    connection.connect((host, int(port)))
    head = HEAD.replace(JSON.encode(), MSGPACK.encode()) + more
    connection.sendall(head + b"content-length: %d\r\n\r\n" % len(body) + body)
    return connection


def takes(connection, rate, at_most=2**40):
    """What comes, from the first byte, when at most ``rate`` bytes per second are taken, up to a number of bytes."""
    try:
        received = bytearray(connection.recv(2**16))
        began = time.monotonic()
        while len(received) < at_most and (data := connection.recv(2**16)):
            received += data
            time.sleep(max(0.0, began + len(received) / rate - time.monotonic()))
    except ConnectionError:
        pass
    return bytes(received)


def is_whole(received):
    head, _, body = received.partition(b"\r\n\r\n")
    assert head.startswith(b"HTTP/1.1 200")
    length = int(re.search(rb"content-length: (\d+)", head)[1])
    stated = re.search(rb"content-digest: (\S+)", head)[1].decode()
    assert len(body) < length or content_digest([body]) == stated
    return len(body) == length


def test_an_answer_that_is_taken_slowly_for_long_is_cut_off_though_some_of_it_is_always_taken(start):
    server = start(ChirpModel(), write_timeout=1.0, write_rate=64 * MIB, **LARGE)
    with asks(server.address, 2**22) as connection:  # 64 MiB, in nine seconds at least
        assert not is_whole(takes(connection, 7 * MIB))
    until(lambda: server.app.parts.evaluation.answer_bytes == 0, "the memory of the answer is given back")


def test_an_answer_that_is_taken_as_fast_as_asked_may_take_longer_than_the_timeout(start):
    server = start(ChirpModel(), write_timeout=2.0, write_rate=MIB, **LARGE)
    with asks(server.address, 2**20, b"connection: close\r\n") as connection:
        assert is_whole(takes(connection, 5 * MIB))


def test_what_has_left_of_an_answer_makes_room_for_others(start):
    server = start(ChirpModel(), max_answer_bytes=60 * MIB, **LARGE)
    waveforms = server.app.parts.evaluation
    with asks(server.address, 3 * 2**20, b"connection: close\r\n") as connection:  # 48 MiB
        received = takes(connection, 16 * MIB, 24 * MIB)
        until(lambda: waveforms.answer_bytes <= 30 * MIB, "what has left is not counted")
        assert waveforms.answer_bytes > 0
        other = msgpack.packb(question(grid={"f_min": 1.0, "f_max": 1.5 * 2**20, "delta_f": 1.0}, output="factored"))
        path = "/v1/models/chirp/waveforms"
        assert ask(server.address, "POST", path, other, content_type=MSGPACK).status == 200  # 24 MiB
        assert is_whole(received + takes(connection, 64 * MIB))
    until(lambda: waveforms.answer_bytes == 0, "there is nothing left")


class Listener(asyncio.Protocol):
    def __init__(self, gone):
        self.gone = gone

    def connection_lost(self, exc):
        self.gone.set()


def test_the_last_of_an_answer_has_to_be_taken_too():
    """A connection that is closed as soon as the rest has left does not wait for its peer for ever."""

    async def closed_with_something_unsent():
        ours, theirs = socket.socketpair()
        gone = asyncio.Event()
        transport, _ = await asyncio.get_running_loop().create_connection(lambda: Listener(gone), sock=ours)
        transport.write(bytes(4 * MIB))
        pace = Pace(transport, 0.05, MIB)
        pace.wait_if_closing()
        await asyncio.sleep(0.1)
        assert not gone.is_set(), "it is not closed yet"
        transport.close()
        pace.wait_if_closing()
        async with asyncio.timeout(30.0):
            await gone.wait()
        theirs.close()

    asyncio.run(closed_with_something_unsent())


def test_others_are_served_meanwhile(server):
    silent = [raw_connection(server.address) for _ in range(50)]
    for connection in silent:
        connection.sendall(HEAD)
    assert ask(server.address, "GET", "/v1/limits").status == 200
    assert evaluate(server.address, question(), accept=JSON).status == 200
    for connection in silent:
        connection.close()
