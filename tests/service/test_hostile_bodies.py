"""Bodies that were made to break a decoder: refused by schema, quickly, and the server goes on."""

import json
import random
import socket
import struct

import msgpack
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.service.asking import (
    GRID,
    GW170817,
    JSON,
    MSGPACK,
    as_array,
    ask,
    ask_on,
    closing_connection,
    evaluate,
    question,
    raw_connection,
    read_response,
)

PATH = "/v1/models/chirp/waveforms"
GOOD = msgpack.packb(
    {
        "parameters": {name: as_array(np.full(3, value)) for name, value in GW170817.items()},
        "grid": {"frequencies": as_array(np.linspace(20.0, 100.0, 9))},
        "output": "factored",
    }
)
REFUSALS = {400, 404, 413, 422}


def refused(answer):
    assert answer.status in REFUSALS, (answer.status, answer.body[:200])
    assert answer.code


@pytest.mark.parametrize(
    "body",
    [
        b"\x81\xaaparameters" + b"\x81\xa1a" * 20_000 + b"\xc0",
        b"\x91" * 100_000,
        b"\xdf\xff\xff\xff\xff",
        b"\xdd\xff\xff\xff\xff" + b"\xc0" * 100,
        b"\xc6\xff\xff\xff\xff" + b"x" * 100,
        b"\xdb\xff\xff\xff\xff" + b"x" * 100,
        b"\xdc\xff\xff" + b"\x80" * 65535,
        b"\xd4\x01\x00",
        b"\xc7\x08\xff" + b"\0" * 8,
    ],
    ids=["nested maps", "nested lists", "lying map", "lying list", "lying binary", "lying string", "empty maps",
         "extension", "timestamp"],
)  # fmt: skip
def test_messagepack_that_lies_or_nests(server, body):
    refused(ask(server.address, "POST", PATH, body, content_type=MSGPACK))


def array_map(**changes):
    good = {"nd": True, "type": "<f8", "kind": b"", "shape": [2], "data": bytes(16)}
    return good | changes


@pytest.mark.parametrize(
    "array",
    [
        array_map(type="|O"),
        array_map(type="|O", kind=b"O", data=b"cos\nsystem\n(S'true'\ntR."),
        array_map(kind=b"V"),
        array_map(type="<U8"),
        array_map(type="|V16"),
        array_map(type=[["a", "<f8"]]),
        array_map(shape=[3]),
        array_map(shape=[-2]),
        array_map(shape=[2**40, 2**40]),
        array_map(shape=[2**63]),
        array_map(shape=[]),
        array_map(shape=[1, 1, 2]),
        array_map(data=b""),
        array_map(data=bytes(15)),
        array_map(data="text"),
        array_map(nd=False),
        array_map(nd=1),
        array_map(type="<c16", shape=[1]),
        array_map(extra=1),
        {"nd": True},
    ],
)
def test_arrays_that_are_not_arrays(server, array):
    refused(evaluate(server.address, question(GW170817 | {"chi_1": array})))
    refused(evaluate(server.address, {"parameters": GW170817, "grid": {"frequencies": array}}))


@pytest.mark.parametrize("length", range(0, len(GOOD), 23))
def test_truncated_messages(server, length):
    refused(ask(server.address, "POST", PATH, GOOD[:length], content_type=MSGPACK))


def test_trailing_bytes(server):
    refused(ask(server.address, "POST", PATH, GOOD + b"\xc0", content_type=MSGPACK))


def test_random_flips_of_a_good_message_never_crash(server):
    generator = random.Random(20170817)
    statuses = set()
    with closing_connection(server.address) as connection:
        for _ in range(400):
            body = bytearray(GOOD)
            for _ in range(generator.randint(1, 4)):
                body[generator.randrange(len(body))] = generator.randrange(256)
            answer = ask_on(connection, "POST", PATH, bytes(body), content_type=MSGPACK)
            statuses.add(answer.status)
    assert statuses <= REFUSALS | {200}
    assert 400 in statuses


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**70), 2**70) | st.floats() | st.text(max_size=5),
    lambda children: st.lists(children, max_size=4) | st.dictionaries(st.text(max_size=8), children, max_size=4),
    max_leaves=12,
)


@settings(max_examples=150)
@given(
    parameters=st.one_of(JSON_VALUES, st.fixed_dictionaries({}, optional=dict.fromkeys(GW170817, JSON_VALUES))),
    grid=st.one_of(JSON_VALUES, st.fixed_dictionaries({}, optional=dict.fromkeys(GRID, JSON_VALUES))),
    rest=st.fixed_dictionaries({}, optional={"output": JSON_VALUES, "dtype": JSON_VALUES, "names": JSON_VALUES}),
)
def test_any_json_is_answered_or_refused(server, parameters, grid, rest):
    body = json.dumps({"parameters": parameters, "grid": grid, **rest}).encode("utf-8", "replace")
    answer = ask(server.address, "POST", PATH, body, content_type=JSON)
    assert answer.status == 200 or answer.status in REFUSALS


@pytest.mark.parametrize(
    "bytes_sent",
    [
        b"\0\0\0\0\r\n\r\n",
        b"GET\r\n\r\n",
        b"GET / HTTP/9.9\r\n\r\n",
        b"POST " + PATH.encode() + b" HTTP/1.1\r\ncontent-length: -5\r\n\r\n",
        b"POST " + PATH.encode() + b" HTTP/1.1\r\ncontent-length: 5\r\ntransfer-encoding: chunked\r\n\r\n",
        b"POST " + PATH.encode() + b" HTTP/1.1\r\nhost: localhost\r\ntransfer-encoding: chunked\r\n\r\nZZZ\r\n",
        b"GET /%zz HTTP/1.1\r\nhost: localhost\r\nbad header\r\n\r\n",
    ],
)
def test_what_is_not_http_is_refused_in_the_usual_form(server, bytes_sent):
    with raw_connection(server.address) as connection:
        connection.sendall(bytes_sent)
        answer = read_response(connection)
    assert answer.status == 400
    assert answer.headers["content-type"] == "application/problem+json"
    assert json.loads(answer.body)["code"] == "body-undecodable"


def test_endless_headers_are_cut_off(server):
    with raw_connection(server.address) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nhost: localhost\r\n")
        sent = 0
        try:
            while sent < 2**22:
                sent += connection.send(b"x-padding: " + b"y" * 4096 + b"\r\n")
        except OSError:
            pass
    assert sent < 2**22


def test_the_server_forgets_a_connection_that_is_reset(server):
    for _ in range(20):
        connection = raw_connection(server.address)
        connection.sendall(
            b"POST " + PATH.encode() + b" HTTP/1.1\r\nhost: localhost\r\ncontent-length: 1000\r\n\r\nabc"
        )
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        connection.close()
    assert evaluate(server.address, question()).status == 200
