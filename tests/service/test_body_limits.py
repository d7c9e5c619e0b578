"""The size of a body is capped while it arrives, whatever it declares."""

import resource
import threading
from pathlib import Path

import pytest

from tests.service.asking import MSGPACK, ask, evaluate, question, raw_connection, read_response

LIMIT = 2**20
HEAD = "POST /v1/models/chirp/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/msgpack\r\n"


def test_a_declared_size_is_refused_before_the_body_is_sent(server):
    with raw_connection(server.address) as connection:
        connection.sendall(f"{HEAD}content-length: {2**40}\r\n\r\n".encode())
        answer = read_response(connection)
    assert (answer.status, answer.code) == (413, "too-large")


def test_expect_continue_is_refused_before_the_body_is_sent(server):
    with raw_connection(server.address) as connection:
        connection.sendall(f"{HEAD}content-length: {2**40}\r\nexpect: 100-continue\r\n\r\n".encode())
        assert read_response(connection).status == 413


def test_a_chunked_body_is_refused_when_it_passes_the_limit(server):
    chunk = b"%x\r\n" % 2**16 + b"x" * 2**16 + b"\r\n"
    with raw_connection(server.address) as connection:
        connection.sendall(f"{HEAD}transfer-encoding: chunked\r\n\r\n".encode())
        for _ in range(LIMIT // 2**16 + 1):  # 64 KiB more than allowed, and no end in sight
            connection.sendall(chunk)
        answer = read_response(connection)
    assert (answer.status, answer.code) == (413, "too-large")


def test_an_endless_body_is_never_held(server):
    """The answer comes while the body is still being sent; what follows is thrown away and not kept."""
    stop = threading.Event()
    with raw_connection(server.address) as connection:
        connection.sendall(f"{HEAD}transfer-encoding: chunked\r\n\r\n".encode())

        def pour():
            chunk = b"%x\r\n" % 2**16 + b"x" * 2**16 + b"\r\n"
            for _ in range(1024):  # 64 MiB
                if stop.is_set():
                    break
                connection.sendall(chunk)

        before = resident_bytes()
        pouring = threading.Thread(target=pour)
        pouring.start()
        answer = read_response(connection)
        pouring.join()
        stop.set()
        assert (answer.status, answer.code) == (413, "too-large")
        assert resident_bytes() - before < 32 * 2**20


def resident_bytes():
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def test_a_body_shorter_than_declared_is_nobodys_question(server):
    with raw_connection(server.address) as connection:
        connection.sendall(f"{HEAD}content-length: 1000\r\n\r\nabc".encode())
    assert evaluate(server.address, question()).status == 200


def test_a_body_longer_than_declared_is_not_taken_for_more(server):
    """What follows the declared bytes is not HTTP, so that the connection ends after the one answer."""
    with raw_connection(server.address) as connection:
        connection.sendall(f"{HEAD}content-length: 3\r\n\r\n".encode() + b"abc" + b"\0" * 1000)
        assert read_response(connection).status == 400
        while connection.recv(4096):
            pass


def test_a_body_of_exactly_the_limit_is_read(server):
    answer = ask(server.address, "POST", "/v1/models/chirp/waveforms", b"\xc1" * LIMIT, content_type=MSGPACK)
    assert answer.status == 400  # read, and found not to be MessagePack


@pytest.mark.parametrize("method", ["GET", "DELETE", "PUT"])
def test_a_body_where_none_belongs_does_no_harm(server, method):
    assert ask(server.address, method, "/v1/limits", b"x" * 2**21).status in (200, 405)


def test_after_a_refused_body_the_connection_still_serves(server):
    from tests.service.asking import ask_on, closing_connection

    with closing_connection(server.address) as connection:
        body = b"x" * (2 * LIMIT)
        assert ask_on(connection, "POST", "/v1/models/chirp/waveforms", body, content_type=MSGPACK).status == 413
        assert ask_on(connection, "GET", "/v1/limits").status == 200
