"""Uploading analyses, and everything about them that is refused."""

import json
from concurrent.futures import ThreadPoolExecutor

import msgpack
import numpy as np
import pytest

from bnserve_protocol import LIKELIHOOD_NAMES, TimeMarginalisation, encode_analysis
from bnserve_protocol.wire import encode_likelihood_request
from bnserve_service import Token
from tests.service.asking import JSON, MSGPACK, as_array, ask, question, raw_connection, read_msgpack, read_response
from tests.service.asking import evaluate as waveforms
from tests.service.chirp import ChirpModel, GatedModel, until
from tests.service.injections import SIGNAL, columns, name_of, samples, small_analysis, upload
from tests.service.test_metrics import value

ANALYSIS = small_analysis()
NAME = name_of(ANALYSIS)
BODY = b"".join(encode_analysis(ANALYSIS))
AT = f"/v1/analyses/{NAME}"
PATH = f"/v1/models/chirp/likelihoods/{NAME}"


def evaluate(address, batch=None, path=PATH, **headers):
    body = encode_likelihood_request(ANALYSIS.digest, batch or samples(3))
    return ask(address, "POST", path, body, content_type=MSGPACK, **headers)


def test_an_analysis_lives_from_its_upload_to_its_end(start):
    server = start(ChirpModel())
    assert ask(server.address, "HEAD", AT).status == 404
    assert (evaluate(server.address).status, evaluate(server.address).code) == (404, "analysis-unknown")
    first = upload(server.address, ANALYSIS)
    assert first.status == 201
    assert first.document == {
        "sha256": NAME, "kind": "full", "detectors": ["H1", "L1"], "parameters": list(LIKELIHOOD_NAMES), "nodes": 177,
        "samples_per_row": 531, "stored_bytes": len(BODY), "model_digest": None,
    }  # fmt: skip
    assert upload(server.address, ANALYSIS).status == 200
    assert ask(server.address, "GET", AT).document == first.document
    assert ask(server.address, "HEAD", AT).status == 200
    assert evaluate(server.address).status == 200
    assert ask(server.address, "DELETE", AT).status == 204
    for method in ("GET", "DELETE"):
        answer = ask(server.address, method, AT)
        assert (answer.status, answer.code) == (404, "analysis-unknown")
    assert evaluate(server.address).status == 404


def test_digests_are_read_in_capitals_too(server):
    assert ask(server.address, "PUT", f"/v1/analyses/{NAME.upper()}", BODY).status in (200, 201)
    assert ask(server.address, "HEAD", AT).status == 200


@pytest.fixture
def of_two(start):
    tokens = (
        Token.of("the-token-of-mine"),
        Token.of("the-token-of-yours"),
        Token.of("the-token-of-reads", scopes=("evaluate",)),
    )  # all of one name
    return start(ChirpModel(), tokens=tokens)


def test_an_analysis_of_another_token_is_as_unknown(of_two):
    mine, yours = {"authorization": "Bearer the-token-of-mine"}, {"authorization": "Bearer the-token-of-yours"}
    assert upload(of_two.address, ANALYSIS, **mine).status == 201
    for method in ("GET", "HEAD", "DELETE"):
        assert ask(of_two.address, method, AT, **yours).status == 404
    assert evaluate(of_two.address, **yours).code == "analysis-unknown"
    assert evaluate(of_two.address, **mine).status == 200
    assert upload(of_two.address, ANALYSIS, **yours).status == 201, "it is new to them"
    assert ask(of_two.address, "DELETE", AT, **yours).status == 204
    assert evaluate(of_two.address, **mine).status == 200


def test_a_token_that_may_not_upload_may_neither_put_nor_delete(of_two):
    reads = {"authorization": "Bearer the-token-of-reads"}
    assert upload(of_two.address, ANALYSIS, **reads).code == "forbidden"
    assert ask(of_two.address, "DELETE", AT, **reads).code == "forbidden"


def refusal(answer, status, code, *words):
    assert (answer.status, answer.code) == (status, code), answer.body
    for word in words:
        assert word in answer.document["detail"]


def test_the_server_computes_the_digest_itself(server):
    other = "0" * 64
    refusal(ask(server.address, "PUT", f"/v1/analyses/{other}", BODY), 422, "analysis-invalid", ANALYSIS.digest)
    refusal(ask(server.address, "PUT", "/v1/analyses/mine", BODY), 422, "analysis-invalid")
    assert ask(server.address, "HEAD", f"/v1/analyses/{other}").status == 404


def test_media_types(server):
    refusal(ask(server.address, "PUT", AT, BODY, content_type=JSON), 415, "media-type-unsupported")
    refusal(ask(server.address, "PUT", AT, BODY, content_encoding="gzip"), 415, "media-type-unsupported")
    refusal(ask(server.address, "POST", PATH, b"", content_type="text/plain"), 415, "media-type-unsupported")


def test_an_analysis_made_for_another_model_is_refused(server):
    analysis = small_analysis(model_digest="sha256:another")
    assert upload(server.address, analysis).status == 201
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"
    body = json.dumps({"parameters": SIGNAL})
    refusal(ask(server.address, "POST", path, body, content_type=JSON), 422, "analysis-invalid", "sha256:another")


def test_an_analysis_made_for_this_model_is_not(server):
    analysis = small_analysis(model_digest="sha256:0")
    upload(server.address, analysis)
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"
    assert ask(server.address, "POST", path, json.dumps({"parameters": SIGNAL}), content_type=JSON).status == 200


def test_an_unknown_model_is_named(server):
    upload(server.address, ANALYSIS)
    refusal(evaluate(server.address, path=f"/v1/models/chrip/likelihoods/{NAME}"), 404, "model-unknown", "'chirp'")


def test_the_body_may_not_name_another_analysis(server):
    upload(server.address, ANALYSIS)
    body = encode_likelihood_request("sha256:" + "0" * 64, samples(1))
    refusal(ask(server.address, "POST", PATH, body, content_type=MSGPACK), 422, "request-invalid", "same")


def test_sizes_are_limited(start):
    server = start(ChirpModel(), max_rows=8, max_samples=6 * 531, max_frequencies=2**10, max_analysis_bytes=len(BODY))
    upload(server.address, ANALYSIS)
    refusal(evaluate(server.address, samples(9)), 413, "too-large", "at most 8 rows")
    refusal(evaluate(server.address, samples(7)), 413, "too-large", "at most 6 rows")
    assert evaluate(server.address, samples(6)).status == 200
    larger = small_analysis(f_max=65.0)
    refusal(upload(server.address, larger), 413, "too-large", str(len(BODY)))
    assert ask(server.address, "GET", "/v1/limits").document["max_analysis_bytes"] == len(BODY)


def test_bodies_are_capped_while_they_arrive(start):
    server = start(ChirpModel(), max_analysis_bytes=2**16)
    with raw_connection(server.address) as connection:
        connection.sendall(f"PUT {AT} HTTP/1.1\r\nhost: localhost\r\ntransfer-encoding: chunked\r\n\r\n".encode())
        for _ in range(8):  # twice as much as allowed, and no end in sight
            connection.sendall(b"4000\r\n" + b"x" * 0x4000 + b"\r\n")
        answer = read_response(connection)
    refusal(answer, 413, "too-large", str(2**16))
    assert upload(server.address, ANALYSIS).status == 201


BAD_CONTENT = {
    "NaN in the weights": ("linear_weights/H1", lambda array: array * np.nan, "linear_weights/H1"),
    "infinite weights": ("quadratic_weights/L1", lambda array: array + np.inf, "quadratic_weights/L1"),
    "weights of another length": ("linear_weights/L1", lambda array: array[:, :-1], "shape"),
    "real weights": ("linear_weights/L1", lambda array: array.real, "complex128"),
    "an array too many": ("extra", lambda array: np.zeros(3), "extra"),
}


@pytest.mark.parametrize(("name", "change", "says"), BAD_CONTENT.values(), ids=BAD_CONTENT)
def test_content_that_no_likelihood_could_use_is_refused_with_the_reason(server, name, change, says):
    body = rewritten(name, change)
    refusal(ask(server.address, "PUT", AT.replace(NAME, "1" * 64), body), 422, "analysis-invalid", says)


def rewritten(name, change):
    """The body with one array changed, as somebody could send it who does not use our classes."""
    settings = msgpack.unpackb(BODY, strict_map_key=False)["settings"]
    arrays = dict(ANALYSIS.arrays)
    arrays[name] = np.ascontiguousarray(change(arrays.get(name)))
    return msgpack.packb({"settings": settings, "arrays": {key: as_array(array) for key, array in arrays.items()}})


def test_work_is_admitted_by_its_cost(start):
    """A sum over many times makes a row dear, and a request of such rows is refused before it takes a worker."""
    sums = TimeMarginalisation(minimum=-0.1, maximum=0.1, step=1e-6)
    analysis = small_analysis(time_marginalisation=sums)
    server = start(ChirpModel())
    assert upload(server.address, analysis).document["samples_per_row"] > 2 * 200_000
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"
    body = json.dumps({"parameters": columns(samples(10))})
    refusal(ask(server.address, "POST", path, body, content_type=JSON), 413, "too-large", "at a time")


def test_a_deadline_that_passes_in_the_queue_is_told(start):
    model = GatedModel()
    server = start(model, threads=1)
    upload(server.address, ANALYSIS)
    model.gate.clear()
    with ThreadPoolExecutor(1) as other:
        first = other.submit(evaluate, server.address)
        model.wait_until_entered()
        late = evaluate(server.address, samples(4), x_request_deadline_ms="50")
        model.gate.set()
        assert first.result().status == 200
    refusal(late, 504, "deadline-exceeded")


def test_a_client_that_went_away_costs_nothing(start):
    model = GatedModel()
    server = start(model, threads=1, group_samples=1)
    upload(server.address, ANALYSIS)
    model.gate.clear()
    body = encode_likelihood_request(ANALYSIS.digest, samples(5))
    lines = [f"POST {PATH} HTTP/1.1", "host: localhost", f"content-type: {MSGPACK}", f"content-length: {len(body)}"]
    head = "\r\n".join([*lines, "", ""]).encode()
    connections = [raw_connection(server.address) for _ in range(3)]
    for connection in connections:
        connection.sendall(head + body)
    model.wait_until_entered()
    until(lambda: value(server, "bnserve_queue_jobs") == 2, "two wait")
    for connection in connections[1:]:
        connection.close()
    until(lambda: value(server, "bnserve_withdrawn_total", reason="disconnect") == 2, "both are forgotten")
    calls = len(model.calls)
    model.gate.set()
    assert read_response(connections[0]).status == 200
    connections[0].close()
    assert len(model.calls) <= calls + 1


def test_a_full_queue_refuses_all_pieces_of_a_request_or_none(start):
    model = GatedModel()
    settings = {"max_samples": 2**14, "max_frequencies": 2**10, "queue_samples": 2**17}
    server = start(model, threads=2, group_samples=1, **settings)
    upload(server.address, ANALYSIS)
    model.gate.clear()
    with ThreadPoolExecutor(8) as others:
        running = [others.submit(evaluate, server.address, samples(16)) for _ in range(2)]
        until(lambda: value(server, "bnserve_queue_samples") > 60_000, "two are there")
        held = value(server, "bnserve_queue_samples")
        refused = evaluate(server.address, samples(30))
        assert value(server, "bnserve_queue_samples") == held
        model.gate.set()
        assert [one.result().status for one in running] == [200, 200]
    refusal(refused, 503, "overloaded")


def test_waveforms_and_likelihoods_share_one_queue(start):
    server = start(ChirpModel())
    upload(server.address, ANALYSIS)
    assert waveforms(server.address, question()).status == 200
    assert evaluate(server.address).status == 200
    assert read_msgpack(evaluate(server.address).body)["status"].tolist() == [0, 0, 0]
    assert value(server, "bnserve_queue_wait_seconds_count") == 3
