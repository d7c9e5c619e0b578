"""Tokens: the right one is let in, nothing of it is kept or logged."""

import hashlib
import hmac
import json
import logging
from contextlib import suppress
from types import SimpleNamespace

import pytest

from bnserve_protocol import Unauthorized
from bnserve_service import Settings, Token
from bnserve_service.admission.token_book import TokenBook
from bnserve_service.http import access
from bnserve_service.http.requests import new_context
from bnserve_service.reference.explorer import PAGES
from tests.service.asking import MSGPACK, ask, evaluate, question, raw_connection, read_response
from tests.service.chirp import ChirpModel

SECRET = "correct horse battery staple"
UPLOADER = "only uploads, never asks"
OPERATOR = "runs the whole place"


@pytest.fixture
def server(start):
    tokens = (
        Token.of(SECRET, "sampler"),
        Token.of(UPLOADER, "uploader", ("upload",)),
        Token.of(OPERATOR, "operator", ("admin",)),
    )
    return start(ChirpModel(), tokens=tokens, access_log=True)


@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"authorization": ""},
        {"authorization": "Bearer"},
        {"authorization": "Bearer "},
        {"authorization": f"Bearer {SECRET[:-1]}"},
        {"authorization": f"Bearer {SECRET}x"},
        {"authorization": f"Basic {SECRET}"},
        {"authorization": SECRET},
        {"authorization": f"Bearer {SECRET}".encode()[:-1] + "\u00e9".encode()},
        {"authorization": b"Bearer \xff\xfe"},
        {"authorization": f"Bearer {hashlib.sha256(SECRET.encode()).hexdigest()}"},
    ],
)
def test_401_missing_or_wrong(server, headers):
    answer = evaluate(server.address, question(), **headers)
    assert (answer.status, answer.code) == (401, "unauthorized")
    assert answer.headers["www-authenticate"].startswith("Bearer")
    assert ask(server.address, "GET", "/v1/models", **headers).status == 401
    assert ask(server.address, "GET", "/nowhere", **headers).status == 401


def test_401_two_authorization_headers_even_if_both_are_right(server):
    head = f"GET /v1/models HTTP/1.1\r\nhost: localhost\r\nauthorization: Bearer {SECRET}\r\n"
    for second in (SECRET, "guess"):
        with raw_connection(server.address) as connection:
            connection.sendall(f"{head}Authorization: Bearer {second}\r\n\r\n".encode())
            answer = read_response(connection)
        assert (answer.status, answer.code) == (401, "unauthorized")


def test_every_token_is_compared_also_after_one_was_found(monkeypatch):
    compared = []

    def compare(one, other):
        compared.append(one)
        return hmac.compare_digest(one, other)

    monkeypatch.setattr(access, "hmac", SimpleNamespace(compare_digest=compare))
    tokens = [Token.of(text) for text in ("the first of three", "the second of three", "the third of three")]
    middleware = access.TokenCheck(TokenBook(Settings(tokens=tuple(tokens)).token_files()))
    for text in ("the first of three", "the third of three", "none of them"):
        compared.clear()
        with suppress(Unauthorized):
            middleware.check(new_context({}), [(b"authorization", f"Bearer {text}".encode())], "GET")
        assert compared == [token.sha256 for token in tokens]


@pytest.mark.parametrize(("method", "path"), [("GET", "/metrics"), ("HEAD", "/metrics"), ("POST", "/v1/reload")])
def test_what_concerns_everybody_needs_the_scope_admin(server, method, path):
    assert ask(server.address, method, path).status == 401
    assert ask(server.address, method, path, authorization=f"Bearer {SECRET}").status == 403
    assert ask(server.address, method, path, authorization=f"Bearer {OPERATOR}").status == 200


def test_an_operator_evaluates_nothing(server):
    assert evaluate(server.address, question(), authorization=f"Bearer {OPERATOR}").code == "forbidden"
    assert ask(server.address, "GET", "/v1/manifest", authorization=f"Bearer {OPERATOR}").status == 200


def test_the_right_token_is_let_in(server):
    assert evaluate(server.address, question(), authorization=f"Bearer {SECRET}").status == 200
    assert evaluate(server.address, question(), authorization=f"bearer {SECRET}").status == 200


def test_403_a_token_without_the_scope(server):
    answer = evaluate(server.address, question(), authorization=f"Bearer {UPLOADER}")
    assert (answer.status, answer.code) == (403, "forbidden")
    assert "evaluate" in answer.document["detail"]
    assert ask(server.address, "GET", "/v1/limits", authorization=f"Bearer {UPLOADER}").status == 200


@pytest.mark.parametrize(
    "path",
    [
        "/v2/health/live",
        "/v2/health/ready",
        "/v2/models/chirp/ready",
        *PAGES,
        "/pages/style/base.css",
    ],
)
def test_probes_and_pages_need_no_token(server, path):
    assert ask(server.address, "GET", path).status == 200


def test_nothing_of_a_token_is_logged(server, caplog):
    caplog.set_level(logging.DEBUG)
    evaluate(server.address, question(), authorization=f"Bearer {SECRET}")
    evaluate(server.address, question(), authorization=f"Bearer {SECRET}-wrong")
    assert "caller=sampler" in caplog.text
    page = ask(server.address, "GET", "/metrics", authorization=f"Bearer {OPERATOR}").body.decode()
    for secret in (SECRET, OPERATOR, hashlib.sha256(SECRET.encode()).hexdigest()):
        assert secret not in caplog.text + page


def test_settings_keep_the_hash_alone():
    settings = Settings(tokens=(Token.of(SECRET),))
    assert SECRET not in settings.model_dump_json()
    assert SECRET not in repr(settings)


def test_without_tokens_nobody_is_asked(start):
    server = start(ChirpModel())
    assert evaluate(server.address, question()).status == 200
    assert "securitySchemes" not in json.loads(ask(server.address, "GET", "/openapi.json").body)["components"]


def test_a_refused_caller_is_told_before_the_body_is_read(server):
    assert ask(server.address, "POST", "/v1/models/chirp/waveforms", b"x" * 2**19, content_type=MSGPACK).status == 401
