"""The access log in JSON: what an auditor asks for, and nothing forged; and what tokens used is counted."""

import hashlib
import io
import json
import logging

import msgpack
import pytest
from prometheus_client import CollectorRegistry

from bnserve_protocol.wire import encode_likelihood_request
from bnserve_service import Token
from bnserve_service.telemetry.callers import OTHERS, Callers
from bnserve_service.telemetry.log import JsonLines
from tests.service import networks
from tests.service.asking import GW170817, MSGPACK, ask, evaluate, question
from tests.service.chirp import ChirpModel, QuickChirpModel, until
from tests.service.injections import name_of, samples, small_analysis, upload
from tests.service.test_metrics import samples as samples_of_page
from tests.service.test_metrics import value

ALICE, OPERATOR = "the token of alice", "the token of an operator"


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def server(start, request):
    tokens = Token.of(ALICE, "alice", rows_per_second=1000.0), Token.of(OPERATOR, "operator", ("metrics",))
    return start(request.param(), tokens=tokens, access_log=True)


@pytest.fixture
def written(caplog):
    """What the log has, in its form for programs."""
    caplog.set_level(logging.INFO)
    stream = io.StringIO()
    handler = logging.StreamHandler(stream)
    handler.setFormatter(JsonLines())
    logging.getLogger().addHandler(handler)
    yield stream
    logging.getLogger().removeHandler(handler)


@pytest.fixture
def lines(written):
    """Those of requests, as objects."""

    def read(count=1):
        def there():
            found = [json.loads(line) for line in written.getvalue().splitlines()]
            return [line for line in found if line["logger"] == "bnserve.access"]

        until(lambda: len(there()) >= count, "it is written")
        return there()

    return read


def bearer(text, **more):
    return {"authorization": f"Bearer {text}", **more}


def test_a_request_with_all_that_there_is_to_know(server, lines):
    body = msgpack.packb(question(GW170817 | {"total_mass": [2.5, 2.6, 2.7]}))
    for number in range(1, 4):  # the later ones on one connection are for the fast path
        answer = ask(
            server.address, "POST", "/v1/models/chirp/waveforms", body, content_type=MSGPACK, x_request_id=f"r{number}",
            x_forwarded_for="203.0.113.7, 10.0.0.1", **bearer(ALICE),
        )  # fmt: skip
        assert answer.status == 200
    [identity] = [loaded.identity for loaded in server.app.parts.registry.catalogue.models.values()]
    line = lines(3)[2]
    assert line.pop("seconds") > 0.0
    assert line.pop("time").endswith("+00:00")
    assert line.pop("process") > 0
    assert line == {
        "level": "INFO", "logger": "bnserve.access", "request_id": "r3", "caller": "alice",
        "token": hashlib.sha256(ALICE.encode()).hexdigest()[:16], "peer": "127.0.0.1",
        "forwarded_for": "203.0.113.7,?10.0.0.1", "method": "POST", "route": "/v1/models/{name}/waveforms",
        "path": "/v1/models/chirp/waveforms", "model": f"chirp {identity.version}", "model_digest": identity.digest,
        "rows": 3, "bytes_in": len(body), "bytes_out": len(answer.body), "status": 200,
    }  # fmt: skip


def test_a_likelihood_names_its_analysis(start, lines):
    server = start(ChirpModel(), access_log=True)
    analysis = small_analysis()
    name = name_of(analysis)
    assert upload(server.address, analysis).status == 201
    body = encode_likelihood_request(analysis.digest, samples(2))
    answer = ask(server.address, "POST", f"/v1/models/chirp/likelihoods/{name}", body, content_type=MSGPACK)
    assert answer.status == 200
    uploaded, asked = lines(2)
    assert (uploaded["path"], uploaded["caller"], uploaded["rows"]) == (f"/v1/analyses/{name}", "anonymous", 0)
    assert uploaded["bytes_in"] > 1000
    assert (asked["analysis"], asked["rows"], asked["bytes_in"]) == (name, 2, len(body))


def test_a_forecast_names_its_network(start, lines):
    server = start(ChirpModel(), access_log=True)
    _, sha256 = networks.put(server.address, networks.network())
    asked = {"parameters": networks.BINARY, "output": "snr"}
    assert networks.forecast(server.address, sha256, asked, model="chirp").status == 200
    assert (lines(2)[1]["network"], lines(2)[1]["rows"]) == (sha256, 1)


def test_a_refusal_says_which(server, lines):
    assert evaluate(server.address, question(), **bearer("nobody's token at all")).status == 401
    assert evaluate(server.address, question(), **bearer(OPERATOR)).status == 403
    assert ask(server.address, "GET", "/no/such%C3%A9", **bearer(ALICE)).status == 404
    refused, forbidden, nowhere = lines(3)
    assert (refused["error"], refused["status"], refused["caller"]) == ("unauthorized", 401, "anonymous")
    assert (forbidden["error"], forbidden["caller"], forbidden["rows"]) == ("forbidden", "operator", 0)
    assert (nowhere["error"], nowhere["route"]) == ("path-unknown", "none")
    assert "path" not in nowhere, "a stranger's path is nobody's business"


def test_no_token_is_in_it(server, lines):
    evaluate(server.address, question(), **bearer(ALICE))
    assert ALICE not in json.dumps(lines())


def test_what_is_no_request_is_a_message(written):
    try:
        raise ValueError("what went wrong")
    except ValueError:
        logging.getLogger("bnserve.service").exception("of %s\nand more", "something")
    line = json.loads(written.getvalue())
    assert line["message"] == "of something\nand more"
    assert "ValueError: what went wrong" in line["exception"]


def test_what_each_token_used_is_counted(server):
    sizes = [len(evaluate(server.address, question(), **bearer(ALICE)).body) for _ in range(3)]

    def counted(name, **labels):
        page = ask(server.address, "GET", "/metrics", **bearer(OPERATOR)).body.decode()
        return samples_of_page(page).get((name, frozenset(labels.items())))

    until(lambda: counted("bnserve_token_requests_total", token="alice") == 3, "three answers")
    assert counted("bnserve_token_rows_total", token="alice") == 3
    assert counted("bnserve_token_answer_bytes_total", token="alice") == sum(sizes)
    assert counted("bnserve_token_seconds_total", token="alice") > 0.0
    assert counted("bnserve_token_requests_total", token="anonymous") is None


def test_without_tokens_nobody_is_counted(start):
    server = start(ChirpModel())
    evaluate(server.address, question())
    assert value(server, "bnserve_token_requests_total", token="anonymous") is None


def test_names_are_few_however_many_callers_there_are():
    registry, callers = CollectorRegistry(), Callers()
    registry.register(callers)
    for number in range(10_000):
        callers.count(f"caller {number}", 1, 10, 0.001)
    callers.count("caller 0", 1, 10, 0.001)
    series = {sample.labels["token"]: sample.value for metric in registry.collect() for sample in metric.samples
              if sample.name == "bnserve_token_rows_total"}  # fmt: skip
    assert len(series) == 257
    assert sum(series.values()) == 10_001
    assert (series["caller 0"], series[OTHERS]) == (2, 10_000 - 256)
