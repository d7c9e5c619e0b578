"""HTTP/1.1 without sockets: what is accepted, what is refused, whatever the pieces in which it arrives."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_client._http1 import exchange
from bnserve_client._messages import Broken, Malformed, Stale, TransportFailure

ANSWER = b"HTTP/1.1 200 OK\r\nContent-Length: 5\r\nX-Name:  value \r\n\r\nhello"


def receive(data, sizes=(2**16,), max_bytes=100):
    """The outcome of an exchange whose answer arrives in pieces of these sizes and then ends."""
    steps = exchange(b"question", max_bytes)
    assert next(steps) == b"question"
    wanted, sizes, position = steps.send(0), list(sizes), 0
    while True:
        size = min(sizes.pop(0) if sizes else 2**16, len(wanted), len(data) - position)
        wanted[:size] = data[position : position + size]
        position += size
        try:
            wanted = steps.send(size)
        except StopIteration as finished:
            return finished.value


def test_an_answer_with_a_length():
    response, reusable = receive(ANSWER)
    assert (response.status, bytes(response.body), reusable) == (200, b"hello", True)
    assert response.headers == {"content-length": "5", "x-name": "value"}


@given(st.lists(st.integers(1, 40), max_size=80))
def test_the_pieces_do_not_matter(sizes):
    response, reusable = receive(ANSWER, sizes)
    assert (bytes(response.body), reusable) == (b"hello", True)


def test_an_answer_in_chunks():
    head = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n"
    response, reusable = receive(head + b"3\r\nhel\r\n2;note=x\r\nlo\r\n0\r\nTrailer: x\r\n\r\n")
    assert (bytes(response.body), reusable) == (b"hello", True)


def test_an_answer_that_ends_with_the_connection():
    response, reusable = receive(b"HTTP/1.0 200 OK\r\n\r\nhello")
    assert (bytes(response.body), reusable) == (b"hello", False)


def test_interim_answers_are_skipped():
    assert receive(b"HTTP/1.1 103 Early Hints\r\nLink: x\r\n\r\n" + ANSWER)[0].status == 200


@pytest.mark.parametrize(
    "data",
    [
        ANSWER + b"more",
        b"HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 0\r\n\r\n",
        b"HTTP/1.0 200 OK\r\nContent-Length: 0\r\n\r\n",
    ],
)
def test_a_connection_that_cannot_be_trusted_is_not_used_again(data):
    assert receive(data)[1] is False


REFUSED = {
    "not HTTP": b"SSH-2.0",
    "HTTP/2": b"HTTP/2 200 OK\r\n\r\n",
    "no status": b"HTTP/1.1 OK\r\n\r\n",
    "a header without a colon": b"HTTP/1.1 200 OK\r\nnonsense\r\n\r\n",
    "a header with a space in its name": b"HTTP/1.1 200 OK\r\nContent-Length : 5\r\n\r\nhello",
    "two lengths": b"HTTP/1.1 200 OK\r\nContent-Length: 5\r\nContent-Length: 6\r\n\r\nhello!",
    "a length and chunks": b"HTTP/1.1 200 OK\r\nContent-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
    "another coding": b"HTTP/1.1 200 OK\r\nTransfer-Encoding: gzip\r\n\r\n",
    "a negative length": b"HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n",
    "a length in other digits": "HTTP/1.1 200 OK\r\nContent-Length: \u00b2\r\n\r\n".encode("latin-1"),
    "too long": b"HTTP/1.1 200 OK\r\nContent-Length: 101\r\n\r\n",
    "far too long": b"HTTP/1.1 200 OK\r\nContent-Length: " + b"9" * 5000 + b"\r\n\r\n",
    "too long without a length": b"HTTP/1.1 200 OK\r\n\r\n" + b"x" * 200,
    "too long in chunks": b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFF\r\n",
    "a chunk size that is none": b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n-5\r\nhello\r\n",
    "a chunk without an end": b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n2\r\nhello\r\n",
    "an endless head": b"HTTP/1.1 200 OK\r\n" + b"x: y\r\n" * 30000,
}


@pytest.mark.parametrize("data", REFUSED.values(), ids=REFUSED)
def test_what_is_not_an_answer_is_refused(data):
    with pytest.raises(Malformed):
        receive(data)


@pytest.mark.parametrize("length", range(1, len(ANSWER)))
def test_an_answer_that_stops_early_is_broken(length):
    with pytest.raises(Broken):
        receive(ANSWER[:length])


def test_no_answer_at_all_is_a_stale_connection():
    with pytest.raises(Stale):
        receive(b"")


@given(st.binary(max_size=200) | st.binary(max_size=200).map(lambda tail: ANSWER[:40] + tail))
def test_no_bytes_do_anything_else_than_answer_or_fail(data):
    try:
        response, _ = receive(data)
    except TransportFailure:
        return
    assert len(response.body) <= 100
