"""Questions of every kind go one way: refused, digested and packed alike; and a new kind is one class."""

import base64
import dataclasses
import hashlib
import json
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import msgpack
import numpy as np
import pytest
from crc32c import crc32c

from bnserve_protocol import AnalysisInvalid
from bnserve_protocol.wire import encode_likelihood_request
from bnserve_service import Settings, create_app
from bnserve_service.app import Application
from bnserve_service.evaluation.questions import Kind, Operation, Question
from bnserve_service.http.body import OFF_LOOP
from bnserve_service.process.listening import address_of, listen_tcp
from bnserve_service.server import BnserveServer
from bnserve_service.uploads import analyses
from tests.service.asking import GW170817, JSON, MSGPACK, as_array, ask, question, raw_connection, read_response
from tests.service.chirp import GatedModel, MemorySource, QuickChirpModel, as_it_is, until
from tests.service.conftest import SMALL_LIMITS
from tests.service.injections import name_of, samples, small_analysis, upload

ANALYSIS = small_analysis()
WAVEFORMS = "/v1/models/chirp/waveforms"
LIKELIHOODS = f"/v1/models/chirp/likelihoods/{name_of(ANALYSIS)}"
ROWS = 60
MANY = {name: [value] * ROWS for name, value in GW170817.items()}
BODIES = {
    WAVEFORMS: msgpack.packb(question(MANY, {"f_min": 20.0, "f_max": 60.0, "delta_f": 0.25}, output="factored")),
    LIKELIHOODS: encode_likelihood_request(ANALYSIS.digest, samples(ROWS)),
}
"""Of more than 4 KiB: smaller ones are decoded in less time than it takes to think about them."""
NARROW = {"queue_samples": 110_000, "max_samples": 2**15}
"""Room for one of them."""
kinds = pytest.mark.parametrize("path", BODIES, ids=["waveforms", "likelihoods"])


def put(server, path, body=None, **headers):
    return ask(server.address, "POST", path, body or BODIES[path], **{"content_type": MSGPACK} | headers)


@pytest.fixture
def closed(start):
    """A server whose evaluations wait for a gate, and that knows the analysis."""

    def start_closed(**settings):
        model = GatedModel()
        server = start(model, threads=1, **settings)
        assert upload(server.address, ANALYSIS).status == 201
        return model, server

    return start_closed


WANTED = {
    "crc32c=10, sha-256=1": "crc32c",
    "crc32c=1": "crc32c",
    "sha-256=9, crc32c=1": "sha-256",
    "sha-512=9": "sha-256",
    "crc32c=0": "sha-256",
    "crc32c": "sha-256",
    "=,;": "sha-256",
}


@kinds
@pytest.mark.parametrize("wanted", WANTED)
def test_the_digest_is_the_one_that_the_caller_wants(server, path, wanted):
    upload(server.address, ANALYSIS)
    answer = put(server, path, want_content_digest=wanted)
    assert answer.status == 200
    checksum = crc32c(answer.body).to_bytes(4, "big")
    digest = checksum if WANTED[wanted] == "crc32c" else hashlib.sha256(answer.body).digest()
    assert answer.headers["content-digest"] == f"{WANTED[wanted]}=:{base64.b64encode(digest).decode()}:"


@kinds
def test_what_a_full_queue_would_refuse_is_refused_before_it_is_decoded(closed, path):
    model, server = closed(**NARROW)
    assert put(server, path).status == 200
    wrong = b"\xc1" * len(BODIES[path])
    assert put(server, path, wrong).code == "body-undecodable"
    model.gate.clear()
    with ThreadPoolExecutor(1) as caller:
        waiting = caller.submit(put, server, path)
        until(lambda: server.app.parts.evaluation.queue.cost > 0, "one that waits")
        refused = put(server, path, wrong)
        assert (refused.status, refused.code) == (503, "overloaded")
        assert "x-request-digest" not in refused.headers, "nor is it hashed"
        assert put(server, path, wrong[:1000]).code == "body-undecodable", "a small one is read"
        model.gate.set()
        assert waiting.result().status == 200


@contextmanager
def with_full_queue(model, server, path):
    """One question waits, and there is no room for another; the gate is open afterwards."""
    assert put(server, path).status == 200
    model.gate.clear()
    with ThreadPoolExecutor(1) as caller:
        waiting = caller.submit(put, server, path)
        until(lambda: server.app.parts.evaluation.queue.cost > 0, "one that waits")
        yield
        model.gate.set()
        assert waiting.result().status == 200


def head(path, form):
    return f"POST {path} HTTP/1.1\r\nhost: localhost\r\ncontent-type: {MSGPACK}\r\n{form}\r\n\r\n".encode()


@kinds
def test_and_before_it_is_sent_where_its_size_is_stated_on_a_connection_that_stays_open(closed, path):
    model, server = closed(**NARROW, header_timeout=0.3)
    body = BODIES[path]
    with raw_connection(server.address) as connection:
        with with_full_queue(model, server, path):
            connection.sendall(head(path, f"content-length: {len(body)}\r\nexpect: 100-continue") + body[:100])
            refused = read_response(connection)
            assert (refused.status, refused.code) == (503, "overloaded")
            assert "connection" not in refused.headers
            connection.sendall(body[100:])
        time.sleep(0.6)  # longer than a head may take, which is not due
        connection.sendall(head(path, f"content-length: {len(body)}") + body)
        assert read_response(connection).status == 200


@kinds
def test_and_once_it_is_there_where_it_is_not_stated_or_the_queue_has_filled_meanwhile(closed, path):
    model, server = closed(**NARROW)
    wrong = b"\xc1" * len(BODIES[path])
    with raw_connection(server.address) as stated, raw_connection(server.address) as chunked:
        stated.sendall(head(path, f"content-length: {len(wrong)}\r\nexpect: 100-continue"))
        assert stated.recv(25) == b"HTTP/1.1 100 Continue\r\n\r\n", "it is being read"
        with with_full_queue(model, server, path):
            stated.sendall(wrong)
            chunked.sendall(head(path, "transfer-encoding: chunked") + b"%x\r\n%b\r\n0\r\n\r\n" % (len(wrong), wrong))
            assert [read_response(each).code for each in (stated, chunked)] == ["overloaded"] * 2


def test_what_one_analysis_costs_says_nothing_about_another(closed):
    model, server = closed(**NARROW)
    assert put(server, LIKELIHOODS).status == 200
    model.gate.clear()
    other = LIKELIHOODS.replace(name_of(ANALYSIS), "0" * 64)
    with ThreadPoolExecutor(1) as caller:
        waiting = caller.submit(put, server, LIKELIHOODS)
        until(lambda: server.app.parts.evaluation.queue.cost > 0, "one that waits")
        assert put(server, other, BODIES[LIKELIHOODS]).code == "analysis-unknown"
        assert put(server, LIKELIHOODS).code == "overloaded"
        model.gate.set()
        assert waiting.result().status == 200


@kinds
def test_the_memory_of_answers_is_reserved(closed, path):
    model, server = closed(max_answer_bytes=2**20)
    model.gate.clear()
    with ThreadPoolExecutor(1) as caller:
        waiting = caller.submit(put, server, path)
        model.wait_until_entered()
        assert server.app.parts.evaluation.answer_bytes == {WAVEFORMS: ROWS * 161 * 16, LIKELIHOODS: ROWS * 9}[path]
        model.gate.set()
        assert waiting.result().status == 200
    until(lambda: server.app.parts.evaluation.answer_bytes == 0, "the memory is given back")


@contextmanager
def serving(app):
    """The address of a server of an application."""
    with listen_tcp("127.0.0.1", 0) as listener, ThreadPoolExecutor(1) as thread:
        server = BnserveServer(app, lambda line: None)
        running = thread.submit(server.run, listener, with_signals=False)
        assert server.ready.wait(60.0)
        try:
            yield address_of(listener)
        finally:
            server.stop_from_thread()
            running.result()


def test_large_questions_do_not_wait_for_large_uploads(monkeypatch):
    entered, gate = threading.Semaphore(0), threading.Event()

    def decode(_):
        entered.release()
        assert gate.wait(60.0), "the test forgot to open the gate"
        raise AnalysisInvalid("It took long enough.")

    monkeypatch.setattr(analyses, "decode_analysis", decode)
    app = create_app(Settings(**SMALL_LIMITS), source=MemorySource().add(QuickChirpModel()), factory=as_it_is)
    grid = as_array(np.linspace(20.0, 40.0, SMALL_LIMITS["max_frequencies"]))
    with serving(app) as address, ThreadPoolExecutor(3) as callers:
        uploads = [
            callers.submit(ask, address, "PUT", f"/v1/analyses/{digit * 64}", bytes(2**18), content_type=MSGPACK)
            for digit in "123"
        ]
        assert entered.acquire(timeout=60.0)
        body = msgpack.packb(question(grid={"frequencies": grid}))
        assert len(body) > OFF_LOOP
        assert ask(address, "POST", WAVEFORMS, body, content_type=MSGPACK).status == 200
        gate.set()
        assert {upload.result().code for upload in uploads} == {"analysis-invalid"}


class SumQuestion(Question, frozen=True, eq=False, kw_only=True):
    """Numbers to add up."""


class Sums(Kind[SumQuestion]):
    """A kind of question that bnserve has not: sums, at once where there are few numbers."""

    name = "sums"
    paths = ("/v1/models/{name}/sums/{unit}",)
    may_be_quick = True
    operation = Operation(tag="sums", identifier="add", summary="Add up", bodies="Waveform", example=[1])

    def read(self, model, body, request):
        numbers = np.array(json.loads(body))
        return SumQuestion(
            kind=self, model=model, batch=numbers, key=(self.name, request.path["unit"]), cost=len(numbers),
            answer_bytes=8 * len(numbers), answer_type=request.answer_type, digest=request.digest,
            quick=len(numbers) < 3,
        )  # fmt: skip

    def evaluate(self, questions):
        return {"numbers": np.concatenate([question.batch for question in questions])}

    def encode(self, question, arrays):
        return [json.dumps([question.key[1], arrays["numbers"].sum().item()]).encode()]


def test_a_new_kind_is_one_class_and_takes_both_ways():
    app = create_app(Settings(**SMALL_LIMITS), source=MemorySource().add(QuickChirpModel()), factory=as_it_is)
    app = Application(dataclasses.replace(app.parts, kinds=(*app.parts.kinds, Sums())), wait_for_models=True)
    take, taken = app.fast_path.take, []
    app.fast_path.take = lambda *given: taken.append(take(*given)) or taken[-1]
    with serving(app) as address:
        for numbers in ([1, 2], [3, 4], [1, 2, 3]):  # whose head comes first, is known, and is not quick
            body = json.dumps(numbers).encode()
            head = f"POST /v1/models/chirp/sums/g HTTP/1.1\r\nHost: localhost\r\nContent-Type: {JSON}\r\n"
            with raw_connection(address) as connection:
                connection.sendall(f"{head}Content-Length: {len(body)}\r\n\r\n".encode() + body)
                answer = read_response(connection)
            assert answer.document == ["g", sum(numbers)]
            assert answer.headers["content-digest"].startswith("sha-256=:")
            assert answer.headers["x-request-digest"] == hashlib.sha256(body).hexdigest()
        described = ask(address, "GET", "/openapi.json").document
        assert described["paths"]["/v1/models/{name}/sums/{unit}"]["post"]["operationId"] == "add"
    assert taken[-2:] == [True, False]
