"""Tokens: the right one is let in, nothing of it is kept or logged."""

import json
import logging

import pytest

from bnserve_service import Settings, Token
from tests.service.asking import MSGPACK, ask, evaluate, question
from tests.service.chirp import ChirpModel

SECRET = "correct horse battery staple"
UPLOADER = "only uploads"


@pytest.fixture
def server(start):
    tokens = (Token.of(SECRET, "sampler"), Token.of(UPLOADER, "uploader", ("upload",)))
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
    ],
)
def test_401_missing_or_wrong(server, headers):
    answer = evaluate(server.address, question(), **headers)
    assert (answer.status, answer.code) == (401, "unauthorized")
    assert answer.headers["www-authenticate"].startswith("Bearer")
    assert ask(server.address, "GET", "/v1/models", **headers).status == 401
    assert ask(server.address, "GET", "/nowhere", **headers).status == 401


def test_the_right_token_is_let_in(server):
    assert evaluate(server.address, question(), authorization=f"Bearer {SECRET}").status == 200
    assert evaluate(server.address, question(), authorization=f"bearer {SECRET}").status == 200


def test_403_a_token_without_the_scope(server):
    answer = evaluate(server.address, question(), authorization=f"Bearer {UPLOADER}")
    assert (answer.status, answer.code) == (403, "forbidden")
    assert "evaluate" in answer.document["detail"]
    assert ask(server.address, "GET", "/v1/limits", authorization=f"Bearer {UPLOADER}").status == 200


@pytest.mark.parametrize("path", ["/v2/health/live", "/v2/health/ready", "/v2/models/chirp/ready", "/", "/docs"])
def test_probes_and_pages_need_no_token(server, path):
    assert ask(server.address, "GET", path).status == 200


def test_nothing_of_a_token_is_logged(server, caplog):
    caplog.set_level(logging.DEBUG)
    evaluate(server.address, question(), authorization=f"Bearer {SECRET}")
    evaluate(server.address, question(), authorization=f"Bearer {SECRET}-wrong")
    assert "caller=sampler" in caplog.text
    assert SECRET not in caplog.text


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
