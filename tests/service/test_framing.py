"""Where a request ends and the next begins, and what is refused because somebody else might see that otherwise."""

import contextlib
import json
import logging
import shutil
import subprocess
import time

import msgpack
import pytest

from bnserve_service import Token
from tests.service.asking import (
    MSGPACK,
    evaluate,
    question,
    raw_connection,
    read_msgpack,
    read_response,
    read_responses,
)
from tests.service.chirp import ChirpModel, GatedModel, QuickChirpModel, until

PATH = "/v1/models/chirp/waveforms"
SECRET = "the-token-of-a-sampler"
BODY = msgpack.packb(question())
LIMITS = b"GET /v1/limits HTTP/1.1\r\nHost: localhost\r\n\r\n"
CHUNKED = (
    f"POST {PATH} HTTP/1.1\r\nHost: localhost\r\nContent-Type: {MSGPACK}\r\nTransfer-Encoding: chunked\r\n".encode()
)
WHOLE = b"%x\r\n%b\r\n0\r\n" % (len(BODY), BODY)
KIB = 2**10


def posted(*headers):
    """A question with these headers beside those that it needs."""
    lines = [f"POST {PATH} HTTP/1.1", "Host: localhost", f"Content-Type: {MSGPACK}", f"Content-Length: {len(BODY)}"]
    return "\r\n".join([*lines, *headers, "", ""]).encode() + BODY


def asked(server, *pieces, count=1):
    """The answers to bytes that are sent in pieces, and whether the connection ends with them."""
    with raw_connection(server.address) as connection:
        for piece in pieces:
            connection.sendall(piece)
        return read_responses(connection, count)


def flooded(server, begin, again, pieces):
    """Bytes that were taken of a request without end, and what came back."""
    with raw_connection(server.address) as connection:
        sent, received = 0, b""
        try:
            connection.sendall(begin)
            for _ in range(pieces):
                sent += connection.send(again)
        except OSError:
            pass
        try:
            while data := connection.recv(2**16):
                received += data
        except OSError:
            pass
        return sent, received


def refused(answer, *words):
    assert answer.status == 400, answer.body
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.headers["connection"] == "close"
    for word in words:
        assert word in json.loads(answer.body)["detail"]


# Trailers


def test_trailers_are_no_headers(start):
    server = start(ChirpModel(), tokens=(Token.of(SECRET, "sampler"),))
    trailers = f"Authorization: Bearer {SECRET}\r\nX-Request-ID: mine\r\nAccept: application/json\r\n\r\n".encode()
    [answer] = asked(server, CHUNKED + b"\r\n" + WHOLE + trailers)
    assert (answer.status, answer.code) == (401, "unauthorized")
    head = CHUNKED + f"Authorization: Bearer {SECRET}\r\nX-Request-ID: mine\r\n\r\n".encode()
    trailers = (b"X-Request-ID: other\r\nAccept: application/json\r\n", b"Authorization: Bearer wrong\r\n\r\n")
    [answer] = asked(server, head + WHOLE, *trailers)
    assert (answer.status, answer.headers["x-request-id"]) == (200, "mine")
    assert answer.headers["content-type"] == MSGPACK


@pytest.mark.parametrize("model", [ChirpModel, QuickChirpModel])
@pytest.mark.parametrize(
    "message", [CHUNKED, CHUNKED.replace(b"POST", b"GET"), CHUNKED.replace(PATH.encode(), b"/none")]
)
def test_a_trailer_that_ends_the_connection_leaves_no_request_without_an_end(start, model, message):
    server = start(model(), keep_alive=60.0, header_timeout=60.0)
    for trailer in (b"Connection: close", b"connection:\tClose ", b"Proxy-Connection: close"):
        with raw_connection(server.address) as connection:
            connection.settimeout(10)
            connection.sendall(message + b"\r\n" + WHOLE + trailer + b"\r\n\r\n")
            assert read_response(connection).status in (200, 404, 405)
            with contextlib.suppress(ConnectionError):
                connection.sendall(LIMITS)
                assert connection.recv(1) == b"", "or a proxy would wait, with the request of somebody else"


def test_an_early_answer_before_such_a_trailer_is_the_last(start):
    server = start(ChirpModel(), tokens=(Token.of(SECRET),), keep_alive=60.0)
    with raw_connection(server.address) as connection:
        connection.settimeout(10)
        connection.sendall(CHUNKED + b"\r\n" + WHOLE[:20])
        assert read_response(connection).status == 401
        connection.sendall(WHOLE[20:] + b"Connection: close\r\n\r\n")
        assert connection.recv(1) == b""


def test_trailers_are_limited_like_headers(server):
    some = b"X-Trailer: %b\r\n" % (b"y" * KIB)
    answer, after = asked(server, CHUNKED + b"\r\n" + WHOLE + 60 * some + b"\r\n" + LIMITS, count=2)
    assert (answer.status, after.status) == (200, 200)
    refused(asked(server, CHUNKED + b"\r\n" + WHOLE[:-3], b"0\r\n" + 70 * some + b"\r\n")[0], "trailers", "65536")


ENDLESS = {
    "trailers": (CHUNKED + b"\r\n" + WHOLE, b"X-Trailer: %b\r\n" % (b"y" * 4 * KIB)),
    "one trailer": (CHUNKED + b"\r\n" + WHOLE + b"X-Trailer: ", b"y" * 4 * KIB),
    "the name of a trailer": (CHUNKED + b"\r\n" + WHOLE, b"y" * 4 * KIB),
    "a chunk extension": (CHUNKED + b"\r\n3;a=", b"y" * 4 * KIB),
    "empty lines": (b"", b"\r\n" * 2 * KIB),
    "one header": (b"GET / HTTP/1.1\r\nHost: localhost\r\nX-Header: ", b"y" * 4 * KIB),
    "headers": (b"GET / HTTP/1.1\r\nHost: localhost\r\n", b"a: b\r\n" * 700),
    "a target": (b"GET /", b"y" * 4 * KIB),
    "a method": (b"", b"G" * 4 * KIB),
}


@pytest.mark.parametrize(("begin", "again"), ENDLESS.values(), ids=ENDLESS)
def test_what_does_not_end_is_cut_off(server, begin, again):
    sent, received = flooded(server, begin, again, 4 * KIB)
    assert sent < 2**23, "of sixteen megabytes, buffers of the system included"
    assert received.startswith(b"HTTP/1.1 400 ") or not received, "a reset may take the answer along"
    assert evaluate(server.address, question()).status == 200


@pytest.mark.parametrize("name", ENDLESS)
def test_who_stops_a_little_beyond_the_limit_reads_why(server, name):
    begin, again = ENDLESS[name]
    pieces = (begin, *[again] * 40)
    refused(asked(server, *[piece for piece in pieces if piece])[0])


def test_a_head_is_limited_to_the_byte_however_it_comes(server):
    def head(size):
        begin, end = b"GET /v1/limits HTTP/1.1\r\nHost: localhost\r\n", b"\r\n\r\n"
        return begin + b"X-Header: " + b"y" * (size - len(begin) - len(end) - 10) + end

    for size in (KIB, 60 * KIB):
        whole = head(size)
        for pieces in ([whole], [whole[:100], whole[100:]], [whole[: size // 2], whole[size // 2 :]]):
            assert asked(server, *pieces)[0].status == 200
    for size in (66 * KIB, 127 * KIB, 200 * KIB):
        refused(asked(server, head(size))[0], "65536")


def test_a_large_body_after_a_head_in_two_pieces_is_a_body(start):
    server = start(ChirpModel(), max_body_bytes=2**21)
    head = posted()[: -len(BODY)].replace(b"%d\r\n" % len(BODY), b"%d\r\n" % 2**20)
    [answer] = asked(server, head[:30], head[30:] + bytes(2**20))
    assert (answer.status, answer.code) == (400, "body-undecodable")
    assert answer.headers["x-request-digest"], "it was read"


def test_a_body_of_tiny_chunks_with_extensions_is_a_body(server):
    chunks = b"".join(b"1;n=%d\r\n%b\r\n" % (number, bytes([byte])) for number, byte in enumerate(BODY))
    [answer] = asked(server, CHUNKED + b"\r\n" + chunks + b"0;end\r\n\r\n")
    assert answer.status == 200


# Upgrade

OFFERS = {
    "curl --http2": ("Connection: Upgrade, HTTP2-Settings", "Upgrade: h2c", "HTTP2-Settings: AAMAAABkAAQAoAAAAAIAAAAA"),
    "a websocket": ("Connection: keep-alive, Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13"),
    "TLS": ("Upgrade: TLS/1.3", "Connection: upgrade"),
    "two": ("Upgrade: a", "Upgrade: b, c", "Connection: upgrade"),
}


@pytest.mark.parametrize("offer", OFFERS.values(), ids=OFFERS)
@pytest.mark.parametrize("cut", [None, -1, -len(BODY), -len(BODY) - 2, 40])
def test_an_offer_to_upgrade_is_ignored_and_the_body_stays_a_body(server, offer, cut):
    message = posted("X-Request-ID: upgrading", *offer)
    pieces = [message] if cut is None else [message[:cut], message[cut:]]
    [answer, after] = asked(server, *pieces, LIMITS, count=2)
    assert (answer.status, after.status) == (200, 200)
    assert answer.headers["x-request-id"] == "upgrading"
    assert answer.body == evaluate(server.address, question()).body
    assert after.document["max_body_bytes"]


@pytest.mark.parametrize(
    "connection", ["upgrade, close", "upgrade\r\nConnection: close", "close\r\nConnection: upgrade"]
)
def test_an_offer_on_a_connection_that_is_to_end_is_answered_before(server, connection):
    [answer] = asked(server, posted(f"Connection: {connection}", "Upgrade: h2c"))
    assert (answer.status, answer.headers["connection"]) == (200, "close")
    assert answer.body == evaluate(server.address, question()).body


def test_an_offer_with_a_chunked_body_and_one_without_a_body(server):
    offer = b"Connection: Upgrade\r\nUpgrade: h2c\r\n\r\n"
    get = LIMITS[:-2] + offer
    answers = asked(server, CHUNKED + offer + WHOLE + b"\r\n" + get + get + LIMITS, count=4)
    assert [answer.status for answer in answers] == [200] * 4


def test_a_body_is_never_a_request(server):
    inner = b"GET /v1/limits HTTP/1.1\r\nHost: localhost\r\nX-Request-ID: inner\r\n\r\n"
    outer = f"POST {PATH} HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: h2c\r\n"
    [answer, after] = asked(server, f"{outer}Content-Length: {len(inner)}\r\n\r\n".encode(), inner, LIMITS, count=2)
    assert answer.status == 415
    assert after.headers["x-request-id"] != "inner"


@pytest.mark.parametrize("target", ["localhost:80", "/v1/limits", "http://localhost/v1/limits"])
def test_no_tunnel_is_opened(server, target):
    refused(asked(server, f"CONNECT {target} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode() + LIMITS)[0])


@pytest.mark.skipif(shutil.which("curl") is None, reason="needs curl")
@pytest.mark.parametrize("options", [["--http2"], ["--http1.1", "-H", "Expect: 100-continue"], ["--http1.0"]])
def test_curl_is_answered(server, options, tmp_path):
    (tmp_path / "body").write_bytes(BODY)
    command = ["curl", "-sS", "--max-time", "60", *options, "-H", f"Content-Type: {MSGPACK}",
               "--data-binary", f"@{tmp_path / 'body'}", server.address + PATH]  # fmt: skip
    done = subprocess.run(command, capture_output=True, check=True)
    assert read_msgpack(done.stdout)["h_plus"].size


# Heads that could be read otherwise

AMBIGUOUS = {
    "no host": b"GET /v1/limits HTTP/1.1\r\n\r\n",
    "two hosts": b"GET /v1/limits HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n",
    "two hosts in HTTP/1.0": b"GET /v1/limits HTTP/1.0\r\nHost: localhost\r\nHost: other\r\n\r\n",
    "a host with a user": b"GET /v2/health/live HTTP/1.1\r\nHost: a@localhost\r\n\r\n",
    "two hosts in one header": b"GET /v2/health/live HTTP/1.1\r\nHost: localhost other\r\n\r\n",
    "a host that is no text": b"GET /v2/health/live HTTP/1.1\r\nHost: local\xffhost\r\n\r\n",
    "a host with a path": b"GET /v1/limits HTTP/1.1\r\nHost: localhost/v2/\r\n\r\n",
    "a host with a port that is none": b"GET /v1/limits HTTP/1.1\r\nHost: localhost:http\r\n\r\n",
    "no version": b"GET /v1/limits\r\n\r\n",
    "no version, but a host": b"GET /v1/limits\r\nHost: localhost\r\n\r\n",
    "another version": b"GET /v1/limits HTTP/2.0\r\nHost: localhost\r\n\r\n",
    "a fragment": b"GET /v1/limits#/docs HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "an authority": b"GET localhost:80 HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "a host without a path": b"GET http://localhost HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "chunked in HTTP/1.0": b"POST / HTTP/1.0\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
    "two codings": b"POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: gzip, chunked\r\n\r\n0\r\n\r\n",
    "an unknown coding": b"POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: xchunked\r\n\r\n0\r\n\r\n",
    "coding and length": CHUNKED + b"Content-Length: 5\r\n\r\n",
    "two lengths": b"POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\n",
    "a folded header": b"GET / HTTP/1.1\r\nHost: localhost\r\nA: b\r\n c\r\n\r\n",
    "a space before a colon": b"GET / HTTP/1.1\r\nHost : localhost\r\n\r\n",
    "HTTP/2": b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    "TLS": bytes.fromhex("16030100a5010000a1"),
}


@pytest.mark.parametrize("head", AMBIGUOUS.values(), ids=AMBIGUOUS)
def test_a_head_that_others_read_otherwise_is_refused(server, head):
    refused(asked(server, head)[0])


@pytest.mark.parametrize("host", ["localhost", "localhost:8000", "localhost:", "[::1]", "[::1]:8000", "127.0.0.1:1 \t"])
def test_a_host_that_is_one_is_taken(server, host):
    assert asked(server, f"GET /v1/limits HTTP/1.1\r\nHost: {host}\r\n\r\n".encode())[0].status == 200


def test_a_host_may_be_empty_and_in_http_1_0_missing(server):
    assert asked(server, b"GET /v1/limits HTTP/1.1\r\nHost:\r\n\r\n")[0].status == 200
    assert asked(server, b"GET /v1/limits HTTP/1.0\r\n\r\n")[0].status == 200


def test_blanks_around_a_value_are_not_part_of_it(server):
    head = b"GET /v1/limits HTTP/1.1\r\nHost:  localhost \t\r\nX-Request-ID: \tmine"
    for pieces in ([head + b" \t\r\n\r\n"], [head + b" ", b"\t\r\n\r\n"]):
        [answer] = asked(server, *pieces)
        assert (answer.status, answer.headers["x-request-id"]) == (200, "mine")


def test_an_empty_header_does_not_run_into_the_next(start):
    server = start(ChirpModel(), tokens=(Token.of(SECRET),))
    head = LIMITS[:-2] + f"Authoriz:\r\nation: Bearer {SECRET}\r\n\r\n".encode()
    assert asked(server, head)[0].status == 401


# One after the other


def test_garbage_after_a_request_does_not_overtake_its_answer(start):
    model = GatedModel()
    server = start(model)
    model.gate.clear()
    with raw_connection(server.address) as connection:
        connection.sendall(posted())
        model.wait_until_entered()
        connection.sendall(b"\0garbage")
        model.gate.set()
        assert read_response(connection).status == 200
        assert connection.recv(1) == b""


@pytest.mark.parametrize("bad", [b"\0garbage", b"GET / HTTP/1.1\r\nbad header\r\n", CHUNKED + b"\r\nnot a chunk\r\n"])
def test_answers_to_requests_before_it_may_take_their_time(start, bad):
    class SlowModel(ChirpModel):
        def predict_factored(self, *arguments, **options):
            time.sleep(0.5)
            return super().predict_factored(*arguments, **options)

    server = start(SlowModel(), header_timeout=0.2, body_timeout=0.2, keep_alive=0.2)
    with raw_connection(server.address) as connection:
        connection.sendall(posted() + posted("X-Request-ID: second") + bad)
        first, second = read_responses(connection, 2)
        assert (first.status, second.status) == (200, 200)
        assert second.headers["x-request-id"] == "second"
        assert connection.recv(1) == b""


def test_a_flood_of_garbage_does_not_cost_the_answers_before_it(start):
    model = GatedModel()
    server = start(model)
    model.gate.clear()
    with raw_connection(server.address) as connection:
        connection.sendall(posted())
        model.wait_until_entered()
        connection.settimeout(0.5)
        with contextlib.suppress(TimeoutError):
            connection.sendall(bytes(2**25))
        connection.settimeout(60)
        model.gate.set()
        assert read_response(connection).status == 200


@pytest.mark.parametrize("bad", [b"\0garbage", CHUNKED + b"\r\nnot a chunk\r\n"], ids=["head", "body"])
def test_requests_before_what_is_none_are_answered_in_order(server, bad):
    with raw_connection(server.address) as connection:
        connection.sendall(LIMITS + posted("X-Request-ID: second") + bad + LIMITS)
        first, second = read_responses(connection, 2)
        assert (first.status, second.status) == (200, 200)
        assert second.headers["x-request-id"] == "second"
        assert connection.recv(1) == b""


def test_a_broken_chunk_is_told_to_whoever_sends_it(server):
    refused(asked(server, CHUNKED + b"\r\n3\r\nabc\r\n", b"not a chunk\r\n")[0], "chunk")


def test_many_requests_at_once_are_answered_in_order_and_more_are_not_kept(server):
    some = b"".join(LIMITS.replace(b"\r\n\r\n", b"\r\nX-Request-ID: n%d\r\n\r\n" % number) for number in range(90))
    assert [answer.headers["x-request-id"] for answer in asked(server, some, count=90)] == [f"n{n}" for n in range(90)]
    with raw_connection(server.address) as connection:
        connection.sendall(LIMITS * 500)
        answers = connection.makefile("rb").read()
    assert 100 <= answers.count(b"HTTP/1.1 200 ") < 500
    assert answers.count(b"HTTP/1.1 ") == answers.count(b"HTTP/1.1 200 ")


# The log


def test_garbage_writes_one_line_a_second_with_an_address(start, caplog):
    caplog.set_level(logging.DEBUG)
    server = start(QuickChirpModel())
    caplog.clear()
    with raw_connection(server.address) as connection:
        port = connection.getsockname()[1]
        connection.sendall(b"\x85\0garbage\r\n\r\n")
        refused(read_response(connection))
    for message in (*AMBIGUOUS.values(), posted(*OFFERS["a websocket"])):
        asked(server, message)
    lines = [record for record in caplog.records if record.levelno >= logging.WARNING]
    assert lines[0].getMessage().startswith(f"no valid HTTP request from 127.0.0.1 port {port}: ")
    seconds = lines[-1].created - lines[0].created
    assert len(lines) <= 1.1 + seconds, "one a second"
    assert all(record.getMessage().isascii() for record in lines)


def test_lines_that_were_left_out_are_counted(start, caplog):
    server = start(ChirpModel())

    def complained():
        asked(server, b"\0\r\n\r\n")
        return any("more since" in record.getMessage() for record in caplog.records)

    until(complained, "the next second")
