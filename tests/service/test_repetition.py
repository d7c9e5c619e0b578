"""A head that repeats the last one of its connection is recognised byte by byte, and nothing else is."""

import pytest

from bnserve_service.transport.repetition import repeatable
from tests.service.asking import raw_connection, read_response
from tests.service.chirp import QuickChirpModel
from tests.service.test_quick_lane import PATH, message

CONSTANT = b"POST /v1/models/default/waveforms HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer a\r\n"
HEADERS = [(b"host", b"x"), (b"authorization", b"Bearer a")]
VARIABLE = b"X-Request-ID: %b\r\nX-Request-Deadline-Ms: 100\r\nContent-Length: %d\r\n\r\n"


def request(body=b"body", name=b"one", constant=CONSTANT):
    return constant + VARIABLE % (name, len(body)) + body


def variable(name=b"one", length=4):
    return [(b"x-request-id", name), (b"x-request-deadline-ms", b"100"), (b"content-length", b"%d" % length)]


@pytest.fixture
def head():
    return repeatable(request(), b"/", HEADERS + variable())


def test_a_repeated_head_is_read_with_its_own_name_and_body(head):
    headers, body = head.read(request(b"another", b"two"))
    assert headers == HEADERS + variable(b"two", 7)
    assert body == b"another"


@pytest.mark.parametrize(
    "data",
    [
        request(constant=CONSTANT.replace(b"Bearer a", b"Bearer b")),
        request(constant=CONSTANT + b"Expect: 100-continue\r\n"),
        request() + b"POST",
        request()[:-1],
        request().replace(b"Content-Length: 4", b"Content-Length: 04\r\nTransfer-Encoding: chunked"),
        request(name=b"a b"),
        b"",
    ],
    ids=["another token", "another header", "pipelined", "in part", "two framings", "a name with a space", "nothing"],
)
def test_everything_else_goes_to_the_parser(head, data):
    assert head.read(data) is None


def test_a_head_that_ends_otherwise_is_not_remembered():
    moved = CONSTANT + (VARIABLE % (b"one", 4))[:-2] + b"Accept: */*\r\n\r\nbody"
    assert repeatable(moved, b"/", [*HEADERS, *variable(), (b"accept", b"*/*")]) is None
    twice = CONSTANT + b"content-length: 4\r\n" + VARIABLE % (b"one", 4) + b"body"
    assert repeatable(twice, b"/", [*HEADERS, (b"content-length", b"4"), *variable()]) is None
    in_the_body = CONSTANT + b"\r\n" + VARIABLE % (b"one", 4)
    assert repeatable(in_the_body, b"/", HEADERS) is None


def test_repeated_requests_are_answered_like_the_first(start):
    server = start(QuickChirpModel())
    head, body = message()
    begin, _, _ = head.partition(b"X-Request-ID")
    answers = []
    with raw_connection(server.address) as connection:
        for name in (b"first", b"second", b"third"):
            connection.sendall(begin + VARIABLE % (name, len(body)) + body)
            answers.append(read_response(connection))
        connection.sendall(begin + VARIABLE % (b"bad", 3) + b"bad")
        refused = read_response(connection)
        connection.sendall(begin + VARIABLE % (b"last", len(body)) + body)
        answers.append(read_response(connection))
    assert [answer.headers["x-request-id"] for answer in answers] == ["first", "second", "third", "last"]
    assert len({answer.body for answer in answers}) == 1
    assert (refused.status, refused.headers["x-request-id"]) == (400, "bad")
    assert PATH.encode() in begin
