"""Every row of the service's table of errors: what is wrong, the status, the code, and a sentence that helps."""

import hashlib
import json

import msgpack
import numpy as np
import pytest

from bnserve_service.errors import STATUS_OF, status_of
from tests.service.asking import (
    GW170817,
    JSON,
    MSGPACK,
    as_array,
    ask,
    closing_connection,
    evaluate,
    evaluate_json,
    question,
)
from tests.service.chirp import ChirpModel, GatedModel, until

PATH = "/v1/models/chirp/waveforms"


def without(name):
    return {key: value for key, value in GW170817.items() if key != name}


def check(answer, status, code, *words):
    assert answer.code == code
    assert answer.status == status
    for word in words:
        assert word in answer.document["detail"]


@pytest.mark.parametrize("body", [b"", b"\xc1", b"not messagepack", b"\x81", msgpack.packb([1, 2]), b"\x92" * 5000])
def test_400_what_is_not_messagepack(server, body):
    check(ask(server.address, "POST", PATH, body, content_type=MSGPACK), 400, "body-undecodable")


@pytest.mark.parametrize("body", [b"", b"{", b"[1, 2]", b'{"parameters": {}}', b"[" * 50_000, b'"\xff"'])
def test_400_what_is_not_json(server, body):
    check(ask(server.address, "POST", PATH, body, content_type=JSON), 400, "body-undecodable")


def test_400_an_unknown_field(server):
    check(evaluate(server.address, question(outptu="modes")), 400, "body-undecodable", "outptu")


def test_an_enormous_field_name_is_not_sent_back(server):
    answer = evaluate(server.address, question() | {"x" * 500_000: 1})
    check(answer, 400, "body-undecodable")
    assert len(answer.body) < 10_000


@pytest.mark.parametrize("content_type", ["text/plain", "application/octet-stream", "", "multipart/form-data"])
def test_415_a_media_type_that_is_not_offered(server, content_type):
    check(evaluate(server.address, question(), content_type=content_type), 415, "media-type-unsupported", MSGPACK)


def test_415_a_compressed_body(server):
    check(evaluate(server.address, question(), content_encoding="gzip"), 415, "media-type-unsupported", "Compressed")


@pytest.mark.parametrize(
    ("headers", "status", "code"),
    [
        ([("content-type", JSON), ("content-type", JSON)], 415, "media-type-unsupported"),
        ([("content-type", f"{JSON}; charset=utf-8"), ("content-type", MSGPACK)], 415, "media-type-unsupported"),
        ([("content-type", JSON), ("content-encoding", "identity"), ("content-encoding", "gzip")], 415,
         "media-type-unsupported"),
        ([("content-type", JSON), ("x-request-deadline-ms", "1"), ("x-request-deadline-ms", "60000")], 422,
         "request-invalid"),
    ],
)  # fmt: skip
def test_of_headers_that_are_there_twice_none_wins(server, headers, status, code):
    body = json.dumps(question()).encode()
    with closing_connection(server.address) as connection:
        connection.putrequest("POST", PATH)
        for name, value in [*headers, ("content-length", str(len(body)))]:
            connection.putheader(name, value)
        connection.endheaders(body)
        response = connection.getresponse()
        document = json.loads(response.read())
    assert (response.status, document["code"]) == (status, code)


def test_lists_may_come_in_several_headers(server):
    with closing_connection(server.address) as connection:
        connection.putrequest("GET", "/v1/models")
        for accept in (MSGPACK, f"{JSON};q=0.1"):
            connection.putheader("accept", accept)
        connection.endheaders()
        response = connection.getresponse()
        response.read()
    assert (response.status, response.getheader("content-type")) == (200, MSGPACK)


@pytest.mark.parametrize("accept", ["text/html", "image/*", f"{MSGPACK};q=0, {JSON};q=0", "nonsense"])
def test_406_no_media_type_that_the_caller_accepts(server, accept):
    check(evaluate(server.address, question(), accept=accept), 406, "not-acceptable", MSGPACK)


def test_404_unknown_model_with_the_nearest_name(server):
    answer = evaluate(server.address, question(), model="chrip")
    check(answer, 404, "model-unknown", "Did you mean 'chirp'?")
    check(ask(server.address, "GET", "/v1/models/chrip"), 404, "model-unknown", "Did you mean 'chirp'?")


def test_404_unknown_version_with_those_that_are_there(server):
    check(ask(server.address, "GET", "/v1/models/chirp/versions/7.0"), 404, "model-unknown", "1.0.0", "stable")


def test_404_unknown_grid(server):
    check(evaluate(server.address, question(grid={"sha256": "0" * 64})), 404, "grid-unknown", "upload")
    assert ask(server.address, "HEAD", "/v1/grids/" + "0" * 64).status == 404


@pytest.mark.parametrize("path", ["/nowhere", "/v1", "/v1/models/", "/v1/models/chirp/waveforms/", "/../etc/passwd"])
def test_404_unknown_path(server, path):
    check(ask(server.address, "GET", path), 404, "path-unknown", "/docs")


@pytest.mark.parametrize(
    ("method", "path"), [("GET", PATH), ("POST", "/v1/models"), ("DELETE", "/v1/limits"), ("GET", "/v1/grids/0")]
)
def test_405_a_method_that_is_not_offered(server, method, path):
    answer = ask(server.address, method, path)
    check(answer, 405, "path-unknown", "method")
    assert answer.headers["allow"]


def test_413_a_declared_body_over_the_limit(server):
    check(ask(server.address, "POST", PATH, b"x" * (2**20 + 1), content_type=MSGPACK), 413, "too-large", str(2**20))


def test_413_a_json_body_over_its_own_limit(server):
    check(ask(server.address, "POST", PATH, b" " * (2**16 + 1), content_type=JSON), 413, "too-large", str(2**16))


@pytest.mark.parametrize(
    ("message", "limit"),
    [
        (question(GW170817 | {"total_mass": [2.5] * 65}), 64),
        (question(grid={"f_min": 1.0, "f_max": 2.0**15, "delta_f": 1.0}), 2**14),
        (question(grid={"f_min": 1e-9, "f_max": 1e6, "delta_f": 1e-9}), 2**14),
        (question(grid={"frequencies": as_array(np.arange(1.0, 2.0**14 + 2.0))}), 2**14),
        (question(GW170817 | {"total_mass": [2.5] * 64}, {"f_min": 1, "f_max": 2**13, "delta_f": 1}), 2**18),
    ],
    ids=["rows", "points", "astronomically many points", "explicit points", "samples"],
)
def test_413_a_question_over_a_limit_states_the_limit(server, message, limit):
    check(evaluate(server.address, message), 413, "too-large", str(limit))


def test_413_a_json_answer_that_is_too_large_suggests_messagepack(server):
    message = question(grid={"f_min": 1, "f_max": 1001, "delta_f": 1})
    check(evaluate_json(server.address, message), 413, "too-large", MSGPACK)
    assert evaluate_json(server.address, message, accept=MSGPACK).status == 200


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        (GW170817 | {"lamda_1": 3.0}, ["lamda_1", "Did you mean 'lambda_1'?"]),
        (without("total_mass"), ["Missing", "total_mass"]),
        (GW170817 | {"chi_1": [0.1, 0.2], "chi_2": [0.1, 0.2, 0.3]}, ["same length"]),
    ],
)
def test_422_parameters_that_no_model_accepts(server, parameters, words):
    check(evaluate(server.address, question(parameters)), 422, "parameters-invalid", *words)


def test_422_out_of_domain_is_told_by_the_model(server):
    answer = evaluate(server.address, question(GW170817 | {"mass_ratio": [1.0, 0.5]}))
    check(answer, 422, "out-of-domain", "Row 1", "mass_ratio")


@pytest.mark.parametrize(
    "grid",
    [
        {"frequencies": []},
        {"frequencies": [20.0, 10.0]},
        {"frequencies": [20.0, 20.0]},
        {"frequencies": [-1.0, 20.0]},
        {"frequencies": [0.0, 20.0]},
        {"frequencies": [float("nan"), 20.0]},
        {"f_min": 20.0, "f_max": 10.0, "delta_f": 1.0},
        {"f_min": 20.0, "f_max": 30.0},
        {"f_min": 20.0, "f_max": 30.0, "delta_f": 0.0},
        {"f_min": 20.0, "f_max": 30.0, "delta_f": 1.0, "sha256": "0"},
        {},
    ],
)
def test_422_frequencies_that_no_model_accepts(server, grid):
    check(evaluate(server.address, {"parameters": GW170817, "grid": grid}), 422, "frequencies-invalid")


@pytest.mark.parametrize("deadline", ["soon", "-1", "nan", "1e400"])
def test_422_a_deadline_that_is_no_time(server, deadline):
    answer = evaluate(server.address, question(), x_request_deadline_ms=deadline)
    check(answer, 422, "request-invalid", "X-Request-Deadline-Ms")


@pytest.mark.parametrize(
    ("body", "status", "code"),
    [
        (b"1234567", 400, "body-undecodable"),
        (np.array([20.0, 10.0]).tobytes(), 422, "frequencies-invalid"),
        (b"", 422, "frequencies-invalid"),
        (np.arange(1.0, 2**14 + 2).tobytes(), 413, "too-large"),
    ],
)
def test_a_grid_that_cannot_be_kept(server, body, status, code):
    check(ask(server.address, "PUT", f"/v1/grids/{hashlib.sha256(body).hexdigest()}", body), status, code)


def test_a_grid_that_is_not_what_its_name_says(server):
    body = np.array([1.0, 2.0]).tobytes()
    answer = ask(server.address, "PUT", "/v1/grids/" + "0" * 64, body)
    check(answer, 422, "frequencies-invalid", hashlib.sha256(body).hexdigest())
    assert ask(server.address, "PUT", "/v1/grids/" + "0" * 64, body, content_type="text/plain").status == 415


def test_503_a_full_queue_refuses_at_once_and_says_when_to_come_back(start):
    model = GatedModel()
    model.gate.clear()
    one = 2**18 + 1 * 1000 + 10_000
    server = start(model, threads=1, queue_samples=2 * one + 64_000, max_samples=2**18, max_frequencies=2**18)
    message = question(grid={"f_min": 1.0, "f_max": float(2**18), "delta_f": 1.0}, output="factored")
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(2) as callers:
        waiting = [callers.submit(evaluate, server.address, message) for _ in range(2)]
        until(lambda: server.app.parts.evaluation.queue.cost >= 2 * one, "two requests fill the queue")
        refused = evaluate(server.address, message)
        check(refused, 503, "overloaded", "full")
        assert refused.document["retryable"] is True
        assert int(refused.headers["retry-after"]) >= 1
        assert ask(server.address, "GET", "/v2/health/ready").status == 200  # probes are never shed
        model.gate.set()
        assert [call.result().status for call in waiting] == [200, 200]
    assert evaluate(server.address, message).status == 200


def test_503_when_answers_fill_the_memory(start):
    model = GatedModel()
    model.gate.clear()
    server = start(model, threads=1, max_answer_bytes=2**20, max_frequencies=2**16)
    message = question(grid={"f_min": 1.0, "f_max": float(2**16), "delta_f": 1.0}, output="factored")
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(1) as caller:
        waiting = caller.submit(evaluate, server.address, message)
        model.wait_until_entered()
        check(evaluate(server.address, message), 503, "overloaded", "answers")
        model.gate.set()
        assert waiting.result().status == 200
    until(lambda: server.app.parts.evaluation.answer_bytes == 0, "the memory is given back")


def test_504_a_deadline_that_passes_in_the_queue(start):
    model = GatedModel()
    model.gate.clear()
    server = start(model, threads=1)
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(1) as caller:
        running = caller.submit(evaluate, server.address, question())
        model.wait_until_entered()
        late = evaluate(server.address, question(), x_request_deadline_ms="50")
        check(late, 504, "deadline-exceeded", "deadline")
        assert "retry-after" not in late.headers
        model.gate.set()
        assert running.result().status == 200
    assert model.calls == [1], "what nobody waits for is not evaluated"


def test_504_a_deadline_that_passed_already(server):
    check(evaluate(server.address, question(), x_request_deadline_ms="0"), 504, "deadline-exceeded")


class BrokenModel(ChirpModel):
    def predict_factored(self, *_, **__):
        raise RuntimeError("secret: /srv/models/tensors.bin in numpy.linalg")


def test_500_a_defect_of_ours_tells_nothing_but_where_to_look(start, caplog):
    server = start(BrokenModel())
    answer = evaluate(server.address, question(), x_request_id="find-me")
    check(answer, 500, "internal", "find-me")
    for secret in ("Traceback", "RuntimeError", "secret", "/srv", "numpy", ".py"):
        assert secret not in answer.body.decode()
    assert any("find-me" in record.getMessage() and record.exc_info for record in caplog.records)


class HungryModel(ChirpModel):
    def predict_factored(self, *_, **__):
        raise MemoryError


def test_503_when_there_is_no_memory(start):
    check(evaluate(start(HungryModel()).address, question()), 503, "overloaded", "memory")


def test_every_error_has_a_status_and_no_error_knows_it():
    from bnserve_protocol import ERRORS_BY_CODE

    for error in ERRORS_BY_CODE.values():
        assert 400 <= status_of(error("detail")) < 600
        assert not hasattr(error, "status")
    assert set(STATUS_OF.values()) >= {400, 401, 403, 404, 406, 413, 415, 422, 429, 500, 503, 504}


def test_an_answer_about_many_bad_rows_stays_small(start):
    from bnserve_protocol import FieldError, InvalidParameters

    class Talkative(ChirpModel):
        def predict_factored(self, *_, **__):
            raise InvalidParameters("x" * 10**6, errors=[FieldError(reason="bad", row=row) for row in range(10_000)])

    answer = evaluate(start(Talkative()).address, question())
    assert answer.status == 422
    assert len(json.loads(answer.body)["errors"]) <= 100
    assert len(answer.body) < 20_000
