"""Pages of other sites that may ask: those that are named, and no others."""

import json

import pytest

from bnserve_service import Settings, Token
from tests.service.asking import JSON, ask, evaluate_json, question
from tests.service.chirp import ChirpModel, QuickChirpModel

PAGE = "https://notebook.example.org"
STRANGER = "https://evil.example.org"
PATH = "/v1/models/chirp/waveforms"
SECRET = "the token of a page"


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def server(start, request):
    return start(request.param(), cors_origins=(PAGE,), tokens=(Token.of(SECRET),))


def preflight(server, origin, **more):
    return ask(
        server.address, "OPTIONS", PATH, origin=origin, access_control_request_method="POST",
        access_control_request_headers="authorization,content-type", **more,
    )  # fmt: skip


def test_a_browser_is_told_that_the_page_may_ask_and_needs_no_token_for_that(server):
    told = preflight(server, PAGE)
    assert (told.status, told.body) == (204, b"")
    assert told.headers["access-control-allow-origin"] == PAGE
    assert "POST" in told.headers["access-control-allow-methods"]
    allowed = told.headers["access-control-allow-headers"].lower()
    assert {"authorization", "content-type"} <= set(allowed.split(", "))
    assert told.headers["vary"] == "Origin"
    assert "access-control-allow-private-network" not in told.headers
    private = preflight(server, PAGE, access_control_request_private_network="true")
    assert private.headers["access-control-allow-private-network"] == "true"


@pytest.mark.parametrize(
    "origin", [STRANGER, f"{PAGE}:8443", PAGE.replace("https", "http"), f"{PAGE}.evil.org", "null"]
)
def test_no_other_page_may(server, origin):
    told = preflight(server, origin)
    assert told.status in (401, 405)
    assert "access-control-allow-origin" not in told.headers
    asked = evaluate_json(server.address, question(), origin=origin, authorization=f"Bearer {SECRET}")
    assert (asked.status, asked.code) == (403, "forbidden")
    assert "access-control-allow-origin" not in asked.headers
    assert asked.headers["vary"] == "Origin"


def test_its_answers_may_be_read(server):
    for _ in range(3):  # the later ones are for the fast path
        answer = evaluate_json(server.address, question(), origin=PAGE, authorization=f"Bearer {SECRET}")
        assert answer.status == 200
        assert answer.headers["access-control-allow-origin"] == PAGE
        assert "Content-Digest" in answer.headers["access-control-expose-headers"]
        assert answer.headers["vary"] == "Origin"
    refused = evaluate_json(server.address, question(), origin=PAGE)
    assert refused.status == 401
    assert refused.headers["access-control-allow-origin"] == PAGE, "or the page could not say what is wrong"


def test_who_is_no_page_notices_nothing(server):
    answer = evaluate_json(server.address, question(), authorization=f"Bearer {SECRET}")
    assert answer.status == 200
    assert "access-control-allow-origin" not in answer.headers


def test_without_the_setting_nothing_is_said(start):
    server = start(ChirpModel())
    assert preflight(server, PAGE).status == 405
    body = json.dumps(question())
    assert "vary" not in ask(server.address, "POST", PATH, body, content_type=JSON).headers


@pytest.mark.parametrize(
    "origin", ["*", "notebook.example.org", f"{PAGE}/", f"{PAGE}/lab", "https://Notebook.example.org", "null", ""]
)
def test_what_is_no_origin_is_refused(origin):
    with pytest.raises(ValueError, match="is not the origin of a page"):
        Settings(cors_origins=(origin,))
