"""Peers that are slow or silent lose their connection; nobody else notices."""

import socket

import pytest

from tests.service.asking import JSON, ask, evaluate, question, raw_connection, read_response
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
        waveforms = server.app.parts.waveforms
        assert waveforms.answer_bytes > 0
        until(lambda: waveforms.answer_bytes == 0, "the memory of the answer is given back")


def test_others_are_served_meanwhile(server):
    silent = [raw_connection(server.address) for _ in range(50)]
    for connection in silent:
        connection.sendall(HEAD)
    assert ask(server.address, "GET", "/v1/limits").status == 200
    assert evaluate(server.address, question(), accept=JSON).status == 200
    for connection in silent:
        connection.close()
