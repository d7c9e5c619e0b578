"""One matcher of paths: what may be asked, what is counted and who answers are decided by the same route."""

import asyncio
import itertools
import json
import logging

import httpx
import msgpack
import pytest
from starlette.applications import Starlette
from starlette.routing import Mount

from bnserve_service import Settings, Token, create_app
from tests.service.asking import (
    MSGPACK,
    ask,
    ask_on,
    closing_connection,
    evaluate,
    question,
    raw_connection,
    read_response,
)
from tests.service.chirp import ChirpModel, MemorySource, QuickChirpModel, as_it_is, until

ADMIN = [("GET", "/metrics"), ("HEAD", "/metrics"), ("POST", "/v1/reload")]
CONTROLS = [*(f"%{number:02X}" for number in (*range(32), 127)), "%C2%85", "%C2%80", "%E2%80%A8", "%E2%80%A9"]
NOT_UTF8 = ["%FF", "%C3", "%C0%AF", "%ED%A0%80"]
READER, SAMPLER, OPERATOR = "the-token-of-a-reader", "the-token-of-a-sampler", "the-token-of-an-operator"
TOKENS = {"none": None, "without scopes": READER, "evaluate": SAMPLER, "admin": OPERATOR}


@pytest.fixture
def server(start):
    tokens = (Token.of(READER, scopes=()), Token.of(SAMPLER), Token.of(OPERATOR, scopes=("admin",)))
    return start(ChirpModel(), tokens=tokens)


def asked(server, method, path, token):
    return ask(server.address, method, path, **({} if token is None else {"authorization": f"Bearer {token}"}))


@pytest.mark.parametrize("token", TOKENS.values(), ids=TOKENS)
def test_control_characters_in_a_path_are_400_for_everybody(server, token):
    headers = {} if token is None else {"authorization": f"Bearer {token}"}
    with closing_connection(server.address) as connection:
        for method, path in (*ADMIN, ("GET", "/v1/limits"), ("GET", "/v2/health/live"), ("GET", "/")):
            for written in [path + text for text in (*CONTROLS, *NOT_UTF8)] + [path[0] + "%0A" + path[1:]]:
                answer = ask_on(connection, method, written, **headers)
                assert answer.status == 400, written
                assert method == "HEAD" or answer.code == "body-undecodable"


@pytest.mark.parametrize("character", ["\0", "\t", "\x0b", "\x7f", "\x85", "\xe9"])
def test_so_are_characters_that_are_not_encoded(server, character):
    with raw_connection(server.address) as connection:
        connection.sendall(f"GET /metrics{character} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode("latin-1"))
        answer = read_response(connection)
    assert (answer.status, json.loads(answer.body)["code"]) == (400, "body-undecodable")


SAME = ["/%6detrics", "/%6D%65%74%72%69%63%73", "/metrics?x=/docs", "http://localhost/metrics"]
OTHERS = [
    "//metrics", "/metrics/", "/./metrics", "/v2/../metrics", "/docs/../metrics", "/metrics;v=1", "/metrics%20",
    "/METRICS", "/metrics%3F", "/metrics%23", "/metrics%2F", "/%2Fmetrics", "/%252Fmetrics", "/metrics.", "/metrics%5C",
    "/v2/metrics", "/v2//metrics", "http://localhost//metrics", "*",
]  # fmt: skip


@pytest.mark.parametrize("target", SAME)
def test_every_way_to_write_a_path_needs_the_same_scope(server, target):
    assert [asked(server, "GET", target, token).status for token in TOKENS.values()] == [401, 403, 403, 200]


@pytest.mark.parametrize("target", OTHERS)
def test_what_is_another_path_is_not_found(server, target):
    assert [asked(server, "GET", target, token).status for token in TOKENS.values()] == [401, 404, 404, 404]


def test_an_encoded_slash_does_not_reach_another_route(server):
    for target in ("/v1/models/chirp%2Fversions", "/v1/models/%2E%2E/limits", "/v1/models/..%2Flimits"):
        assert asked(server, "GET", target, SAMPLER).status == 404


@pytest.mark.parametrize("model", [ChirpModel, QuickChirpModel])
def test_both_ways_of_a_question_go_by_the_same_route(start, model):
    server = start(model(), tokens=(Token.of(SAMPLER), Token.of(READER, scopes=())))
    body = msgpack.packb(question())
    for name, (token, status) in itertools.product(
        ("chirp", "%63hirp", "%63%68irp"), ((None, 401), (READER, 403), (SAMPLER, 200))
    ):
        headers = {"content_type": MSGPACK} | ({} if token is None else {"authorization": f"Bearer {token}"})
        assert ask(server.address, "POST", f"/v1/models/{name}/waveforms", body, **headers).status == status


def test_routes_are_the_same_inside_another_application():
    tokens = (Token.of(SAMPLER), Token.of(OPERATOR, scopes=("admin",)))
    inner = create_app(Settings(tokens=tokens), source=MemorySource().add(ChirpModel()), factory=as_it_is)
    transport = httpx.ASGITransport(Starlette(routes=[Mount("/waves", inner)]))

    async def statuses():
        client = httpx.AsyncClient(transport=transport, base_url="http://localhost")
        async with inner.router.lifespan_context(inner), client:
            return [
                (await client.get(path, headers={"authorization": f"Bearer {token}"})).status_code
                for path in ("/waves/metrics", "/waves/v1/limits", "/waves/nowhere", "/waves/metrics%0A")
                for token in (SAMPLER, OPERATOR)
            ] + [(await client.get("/waves/v2/health/live")).status_code]

    assert asyncio.run(statuses()) == [403, 200, 200, 200, 404, 404, 400, 400, 200]


# HEAD


def test_where_there_is_get_there_is_head(start):
    server = start(ChirpModel())
    document = ask(server.address, "GET", "/openapi.json").document
    paths = [path for path, methods in document["paths"].items() if "get" in methods]
    values = {"{name}": "chirp", "{version}": "1.0.0"}
    paths = [path for path in paths if "{sha256}" not in path] + ["/", "/docs", "/openapi.json"]
    assert len(paths) > 10
    for path in paths:
        for template, value in values.items():
            path = path.replace(template, value)
        got, head = ask(server.address, "GET", path), ask(server.address, "HEAD", path)
        assert (got.status, head.status, head.body) == (200, 200, b""), path
        varying = ("date", "x-request-id") + (("content-length", "content-digest") if path == "/metrics" else ())
        told = [{k: v for k, v in answer.headers.items() if k not in varying} for answer in (got, head)]
        assert told[0] == told[1]


def test_probes_say_no_to_head_as_to_get(start):
    server = start(ChirpModel(), drain_grace=5.0)
    assert ask(server.address, "HEAD", "/v2/models/none/ready").status == 404
    server.stop()
    while (answer := ask(server.address, "HEAD", "/v2/health/ready")).status == 200:
        pass
    assert (answer.status, answer.body) == (503, b"")


def test_a_connection_goes_on_after_head(start):
    server = start(ChirpModel())
    with closing_connection(server.address) as connection:
        for method in ("HEAD", "GET", "HEAD", "GET"):
            connection.request(method, "/v2/health/live")
            assert connection.getresponse().read() == (b"" if method == "HEAD" else b'{"live":true}')


@pytest.mark.parametrize(
    ("method", "path", "allowed"),
    [
        ("POST", "/v2/health/live", "GET, HEAD"),
        ("POST", "/metrics", "GET, HEAD"),
        ("GET", "/v1/models/chirp/waveforms", "POST"),
        ("HEAD", "/v1/models/chirp/waveforms", "POST"),
        ("POST", "/v1/analyses/" + "0" * 64, "DELETE, GET, HEAD, PUT"),
        ("GET", "/v1/grids/" + "0" * 64, "HEAD, PUT"),
    ],
)
def test_405_lists_all_that_the_path_offers(start, method, path, allowed):
    answer = ask(start(ChirpModel()).address, method, path)
    assert (answer.status, answer.headers["allow"]) == (405, allowed)


# The log


def logged(caplog):
    """The line of the one request, which comes after its answer."""
    lines = []

    def written():
        lines[:] = [record.getMessage() for record in caplog.records if record.name == "bnserve.access"]
        return lines

    until(written, "the line of the request")
    [line] = lines
    return line


@pytest.mark.parametrize("given", [b"a\x85b", b"a\xffb", b"\x9b2J", b"a caller=root", b"a\tb", b"x" * 500])
def test_nothing_of_a_stranger_is_a_line_or_a_field_of_its_own_in_the_log(start, caplog, given):
    caplog.set_level(logging.INFO)
    server = start(ChirpModel(), access_log=True)
    caplog.clear()
    with raw_connection(server.address) as connection:
        connection.sendall(b"GET /v1/limits HTTP/1.1\r\nHost: localhost\r\ntraceparent: " + given + b"\r\n\r\n")
        assert read_response(connection).status == 200
    line = logged(caplog)
    assert line.isascii()
    assert line.isprintable()
    traceparent = line.partition("traceparent=")[2]
    assert " " not in traceparent
    assert len(traceparent) <= 64


def test_a_right_traceparent_is_logged_as_it_is(start, caplog):
    caplog.set_level(logging.INFO)
    server = start(QuickChirpModel(), access_log=True)
    traceparent = "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01"
    assert evaluate(server.address, question(), traceparent=traceparent).status == 200
    assert logged(caplog).endswith(f"traceparent={traceparent}")


def test_methods_that_callers_invent_are_one_in_the_metrics(start):
    server = start(ChirpModel())
    for method in ("PROPFIND", "SOURCE", "M-SEARCH"):
        assert ask(server.address, method, "/v1/limits").status == 405
    page = ask(server.address, "GET", "/metrics").body.decode()
    assert 'method="other"' in page
    assert "PROPFIND" not in page
