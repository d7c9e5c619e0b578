"""Large bodies on their way: all together have one room, and every token a fair share of it."""

import hashlib
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager

import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_service import Settings, Token
from bnserve_service.http.body import UNCOUNTED
from tests.service.asking import ask, evaluate, question, raw_connection, read_response
from tests.service.chirp import ChirpModel, until
from tests.service.test_metrics import value

GREEDY, MODEST = "the-greedy-token", "the-modest-token"
SIZE = 2**20
ROOM = 4 * (SIZE - UNCOUNTED)
LIMITS = {
    "max_body_bytes": SIZE, "max_analysis_bytes": SIZE, "max_network_bytes": SIZE, "max_incoming_bytes": ROOM,
    "body_timeout": 60.0,
}  # fmt: skip
PATHS = {
    "waveforms": "POST /v1/models/chirp/waveforms",
    "likelihoods": f"POST /v1/models/chirp/likelihoods/{'0' * 64}",
    "a grid": f"PUT /v1/grids/{'0' * 64}",
    "an analysis": f"PUT /v1/analyses/{'0' * 64}",
}


@pytest.fixture
def server(start):
    return start(ChirpModel(), max_frequencies=2**17, **LIMITS)


def head(path=PATHS["an analysis"], token=None, size=SIZE, length=True):
    kind = "application/octet-stream" if "grids" in path else "application/msgpack"
    lines = [f"{path} HTTP/1.1", "host: localhost", f"content-type: {kind}"]
    lines += [f"authorization: Bearer {token}"] if token else []
    lines += [f"content-length: {size}"] if length else ["transfer-encoding: chunked"]
    return "\r\n".join([*lines, "", ""]).encode()


@contextmanager
def bodies_without_end(server, count, path=PATHS["an analysis"], token=None):
    """Connections that have sent their bodies but for the last byte, which never comes."""
    with ExitStack() as stack:
        connections = [stack.enter_context(raw_connection(server.address)) for _ in range(count)]
        for connection in connections:
            connection.sendall(head(path, token) + b"x" * (SIZE - 1))
        held = count * (SIZE - 1 - UNCOUNTED)
        until(lambda: held_by(server, token) == held, "all is there")
        yield connections


def held_by(server, token):
    """Bytes of the bodies of one token, or of all where there are none."""
    return server.app.parts.bodies._held._of.get(hashlib.sha256(token.encode()).hexdigest() if token else "", 0)


def refusal(connection, status=503, code="overloaded"):
    answer = read_response(connection)
    assert (answer.status, answer.code) == (status, code)
    assert answer.headers["retry-after"] == "1"
    assert "try again" in answer.document["detail"]


@pytest.mark.parametrize("path", PATHS.values(), ids=PATHS)
def test_what_does_not_fit_is_refused_before_it_is_sent(server, path):
    with bodies_without_end(server, 4, path), raw_connection(server.address) as fifth:
        fifth.sendall(head())
        refusal(fifth)
    until(lambda: value(server, "bnserve_uploads_bytes") == 0, "nothing is held")
    with bodies_without_end(server, 4, path):
        assert value(server, "bnserve_uploads_bytes") <= ROOM


@pytest.mark.parametrize("path", PATHS.values(), ids=PATHS)
def test_a_body_that_does_not_state_its_size_is_refused_when_the_room_is_full(server, path):
    with bodies_without_end(server, 4), raw_connection(server.address) as fifth:
        fifth.sendall(head(path, length=False) + b"%x\r\n" % SIZE + b"x" * (SIZE - 1))
        refusal(fifth)


def test_many_at_once_hold_no_more_than_the_room(server):
    with ExitStack() as stack, ThreadPoolExecutor(12) as senders:
        connections = [stack.enter_context(raw_connection(server.address)) for _ in range(12)]
        sent = senders.map(lambda connection: connection.sendall(head() + b"x" * (SIZE - 1)), connections)
        assert len(list(sent)) == 12
        until(lambda: value(server, "bnserve_errors_total", code="overloaded") == 8, "what does not fit is refused")
        assert value(server, "bnserve_uploads_bytes") == 4 * (SIZE - 1 - UNCOUNTED)


def test_small_questions_pass_meanwhile(server):
    with bodies_without_end(server, 4):
        assert evaluate(server.address, question()).status == 200


def test_a_body_takes_room_until_it_is_decoded_and_no_longer(server):
    body = np.linspace(20.0, 900.0, SIZE // 8).tobytes()
    path = f"/v1/grids/{hashlib.sha256(body).hexdigest()}"
    for _ in range(8):
        assert ask(server.address, "PUT", path, body).status in (200, 201)
    assert value(server, "bnserve_uploads_bytes") == 0


@pytest.fixture
def of_two(start):
    tokens = (
        Token.of(GREEDY, "greedy"),
        Token.of(MODEST, "modest"),
        Token.of("the-operators-token", scopes=("admin",)),
    )
    return start(ChirpModel(), max_frequencies=2**17, tokens=tokens, **LIMITS)


def test_what_one_has_beyond_a_fair_share_makes_room_for_another(of_two):
    with bodies_without_end(of_two, 4, token=GREEDY) as greedy, bodies_without_end(of_two, 2, token=MODEST):
        for connection in greedy[2:]:
            refusal(connection, 429, "share-exceeded")
        with raw_connection(of_two.address) as third:
            third.sendall(head(token=MODEST))
            refusal(third, 429, "share-exceeded")
        for connection in greedy[:2]:
            connection.sendall(b"x")
            assert read_response(connection).code == "body-undecodable", "it was read to its end"


def test_the_client_tries_again_until_there_is_room(server):
    frequencies = np.linspace(20.0, 900.0, 2**14)
    with ThreadPoolExecutor(1) as callers, Model.connect(server.address, "chirp") as model:
        with bodies_without_end(server, 4):
            answer = callers.submit(model.predict, frequencies, ParametersWithExtrinsic.gw170817())
            until(lambda: value(server, "bnserve_errors_total", code="overloaded"), "it was refused")
        assert answer.result().plus.shape == (2**14,)


def test_the_room_is_among_the_limits(server):
    assert ask(server.address, "GET", "/v1/limits").document["max_incoming_bytes"] == ROOM
    assert Settings().limits().max_incoming_bytes == 256 * 2**20


def test_a_room_that_the_largest_body_does_not_fit_in_is_refused():
    with pytest.raises(ValueError, match="max_incoming_bytes must be at least 2097152"):
        Settings(max_body_bytes=2**20, max_network_bytes=2**20, max_analysis_bytes=2**21, max_incoming_bytes=2**20)
