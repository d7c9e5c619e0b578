"""Small questions to a quick model: answered on the event loop, and as every other request."""

import http.client
import itertools
import socket
import time
from concurrent.futures import ThreadPoolExecutor

import msgpack
import numpy as np
import pytest

from bnserve_client import Model
from bnserve_protocol import ParametersWithExtrinsic
from bnserve_service import Token
from bnserve_service.http.protocol import BoundedProtocol
from tests.service.asking import (
    GW170817,
    MSGPACK,
    ask,
    closing_connection,
    evaluate,
    question,
    raw_connection,
    read_msgpack,
    read_response,
    read_responses,
)
from tests.service.chirp import ChirpModel, QuickChirpModel, until

PATH = "/v1/models/chirp/waveforms"
TIMES = ("date", "server-timing")


def message(parameters=None, path=PATH, **headers):
    """Head and body of a question."""
    body = msgpack.packb(question(parameters))
    names = {"Host": "localhost", "Content-Type": MSGPACK, "X-Request-ID": "me", "Content-Length": len(body)} | headers
    lines = [f"POST {path} HTTP/1.1", *(f"{name}: {value}" for name, value in names.items()), "", ""]
    return "\r\n".join(lines).encode(), body


def in_one_piece(server, *given, **headers):
    """Ask so that the fast path can take it: for the second time."""
    with raw_connection(server.address) as connection:
        for _ in range(2):
            connection.sendall(b"".join(message(*given, **headers)))
            answer = read_response(connection)
        return answer


def in_two_pieces(server, *given, **headers):
    """Ask so that it cannot: the body comes later than its headers."""
    head, body = message(*given, **headers)
    with raw_connection(server.address) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.sendall(head)
        time.sleep(0.1)
        connection.sendall(body)
        return read_response(connection)


QUESTIONS = {
    "one": None,
    "a batch": GW170817 | {"total_mass": [2.5, 2.6, 2.7]},
    "outside of the domain": GW170817 | {"mass_ratio": 9.0},
    "a misspelt parameter": GW170817 | {"lamda_1": 1.0},
}


@pytest.mark.parametrize("parameters", QUESTIONS.values(), ids=QUESTIONS)
def test_both_ways_give_the_same_answer(start, parameters):
    server = start(QuickChirpModel())
    one, other = in_one_piece(server, parameters), in_two_pieces(server, parameters)
    assert one.status == other.status
    assert one.body == other.body
    without_times = [{k: v for k, v in answer.headers.items() if k not in TIMES} for answer in (one, other)]
    assert without_times[0] == without_times[1]
    assert set(one.headers) == set(other.headers)


def test_small_questions_are_evaluated_on_the_event_loop_and_large_ones_in_threads(start):
    model = QuickChirpModel()
    server = start(model)
    model.threads.clear()
    assert in_one_piece(server).status == in_two_pieces(server).status == 200
    assert model.threads == {"bnserve-server"}
    model.threads.clear()
    assert evaluate(server.address, question(GW170817 | {"total_mass": np.full(60, 2.7).tolist()})).status == 200
    assert all(name.startswith("bnserve-worker") for name in model.threads)


@pytest.mark.parametrize("cuts", [[], [242, 1015], [19, 444, 781, 865, 1109], [342, 684, 1026], [200], [1366]])
def test_pipelined_questions_are_answered_in_order(start, cuts):
    server = start(QuickChirpModel())
    masses = [2.5, 2.6, 2.7, 2.8]
    asked = b"".join(b"".join(message(GW170817 | {"total_mass": mass})) for mass in masses)
    with raw_connection(server.address) as connection:
        for start_at, end in itertools.pairwise([0, *cuts, len(asked)]):
            connection.sendall(asked[start_at:end])
            time.sleep(0.01)
        answers = read_responses(connection, len(masses))
    for mass, answer in zip(masses, answers, strict=True):
        assert answer.body == in_one_piece(server, GW170817 | {"total_mass": mass}).body


def test_many_callers_at_once_get_their_own_answers(start):
    model = QuickChirpModel()
    server = start(model)

    def many(mass):
        with closing_connection(server.address) as connection:
            for _ in range(30):
                connection.request("POST", PATH, msgpack.packb(question(GW170817 | {"total_mass": mass})),
                                   {"Content-Type": MSGPACK})  # fmt: skip
                body = connection.getresponse().read()
        return read_msgpack(body)["h_plus"].tobytes()

    masses = np.linspace(2.1, 3.9, 16).tolist()
    model.calls.clear()
    with ThreadPoolExecutor(len(masses)) as callers:
        answers = list(callers.map(many, masses))
    assert sum(model.calls) == 30 * len(masses)
    for mass, answer in zip(masses, answers, strict=True):
        assert answer == read_msgpack(in_one_piece(server, GW170817 | {"total_mass": mass}).body)["h_plus"].tobytes()


def test_a_caller_that_went_away_does_no_harm(start):
    server = start(QuickChirpModel())
    for _ in range(20):
        with raw_connection(server.address) as connection:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")  # reset at once
            connection.sendall(b"".join(message()))
    assert in_one_piece(server).status == 200


def test_tokens_are_asked_for_here_too(start):
    server = start(
        QuickChirpModel(),
        tokens=(Token.of("the-token-of-secret"), Token.of("the-token-of-reader", scopes=("upload",))),
    )
    assert in_one_piece(server).status == 401
    assert in_one_piece(server, Authorization="Bearer the-token-of-wrong").status == 401
    assert in_one_piece(server, Authorization="Bearer the-token-of-reader").status == 403
    assert in_one_piece(server, Authorization="Bearer the-token-of-secret").status == 200


def test_a_deadline_that_has_passed_is_told(start):
    server = start(QuickChirpModel())
    assert in_one_piece(server, **{"X-Request-Deadline-Ms": "0"}).code == "deadline-exceeded"
    assert in_one_piece(server, **{"X-Request-Deadline-Ms": "60000"}).status == 200


def test_quick_requests_are_counted(start):
    server = start(QuickChirpModel())
    for _ in range(3):
        in_one_piece(server)
    counted = f'bnserve_requests_total{{method="POST",route="{"/v1/models/{name}/waveforms"}",status="200"}} 6.0'
    until(lambda: counted in ask(server.address, "GET", "/metrics").body.decode(), "six requests")


@pytest.mark.parametrize("before", [0, 2])
def test_a_draining_server_closes_the_connection(start, before):
    server = start(QuickChirpModel(), drain_grace=5.0)
    with closing_connection(server.address) as connection:
        connection.connect()
        for _ in range(before):
            connection.request("POST", PATH, msgpack.packb(question()), {"Content-Type": MSGPACK})
            assert connection.getresponse().read()
        server.stop()
        until(lambda: server.app.parts.lifecycle.draining, "the drain")
        connection.request("POST", PATH, msgpack.packb(question()), {"Content-Type": MSGPACK})
        response = connection.getresponse()
        response.read()
    assert (response.status, response.getheader("connection")) == (200, "close")


# Heads that are known


HEAD, ASKED = message(**{"X-Request-Deadline-Ms": "60000", "Want-Content-Digest": "crc32c=9"})
AGAIN = HEAD.replace(b": me\r\n", b": you\r\n").replace(b"60000", b"59999")


def told(connection, said):
    """What is answered, without what differs every time; None where the connection ends."""
    connection.sendall(said)
    try:
        answer = read_response(connection)
    except (http.client.HTTPException, OSError):
        return None
    name, digest = answer.headers.get("x-request-id", ""), answer.headers["content-digest"].partition("=")[0]
    is_ours = name.encode() in said
    return answer.status, name if is_ours else "", digest, answer.body if answer.status == 200 or is_ours else b""


def told_first(server, said):
    with raw_connection(server.address) as connection:
        return told(connection, said)


def test_a_head_that_comes_again_is_not_parsed_again(start, monkeypatch):
    parsed = []
    begin = BoundedProtocol.on_message_begin
    monkeypatch.setattr(BoundedProtocol, "on_message_begin", lambda self: parsed.append(self) or begin(self))
    server = start(QuickChirpModel())
    with Model.connect(server.address, "chirp") as model:
        grid, binary = np.linspace(20.0, 2048.0, 277), ParametersWithExtrinsic.gw170817()
        answers = [model.predict(grid, binary) for _ in range(3)]  # the grid in full, uploaded, known
        parsed.clear()
        answers += [model.predict(grid, binary) for _ in range(20)]
        assert not parsed
    assert {answer.plus.tobytes() for answer in answers} == {answers[0].plus.tobytes()}
    for said, name in ((HEAD, "me"), (AGAIN, "you")):
        parsed.clear()
        assert told_first(server, said + ASKED)[:2] == (200, name)
        assert len(parsed) == (said is HEAD), "whoever sends it"


@pytest.mark.parametrize("wanted", ["close", "Close", "x, close"])
def test_a_connection_ends_with_the_answer_if_its_caller_wants_it_each_time(start, wanted):
    server = start(QuickChirpModel())
    for _ in range(3):
        with raw_connection(server.address) as connection:
            connection.sendall(b"".join(message(Connection=wanted)))
            assert read_response(connection).status == 200
            assert connection.recv(1) == b""


def test_every_byte_of_a_known_head_counts(start):
    """Changed, left out or there twice: it is read as where no head is known."""
    knowing, other = (start(model(), header_timeout=0.2, body_timeout=0.2) for model in (QuickChirpModel, ChirpModel))
    assert told_first(knowing, HEAD + ASKED) == told_first(other, HEAD + ASKED)
    for place in range(len(AGAIN)):
        byte = AGAIN[place : place + 1]
        for instead in (b"", 2 * byte, b"\n" if byte == b" " else b" ", b"a" if byte.isdigit() else b"0"):
            said = AGAIN[:place] + instead + AGAIN[place + 1 :] + ASKED
            assert told_first(knowing, said) == told_first(other, said), said
