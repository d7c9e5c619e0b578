"""What a server, a proxy or a network can do: the answer is right after all, or there is a clear error."""

import msgspec
import numpy as np
import pytest

from bnserve_client import BnserveError, ConnectionFailed, DeadlineExceeded, Model, NotBnserve, Unavailable
from bnserve_protocol import (
    AnswerCorrupted,
    Draining,
    FieldError,
    InternalError,
    ModelUnknown,
    Overloaded,
    ParametersWithExtrinsic,
    PathUnknown,
    TooLarge,
    Unauthorized,
    UnsupportedMediaType,
)
from bnserve_protocol import DeadlineExceeded as LateAnswer
from bnserve_protocol.wire import Problem, encode_array
from tests.client import scripted_server as faults
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel, binaries

FREQUENCIES = np.linspace(20.0, 1024.0, 100)
ONE = ParametersWithExtrinsic.gw170817()
RIGHT = ReferenceModel().predict(FREQUENCIES, ONE)
HTML = b"<html>Not here</html>"


def problem(error, status, **headers):
    body = msgspec.json.encode(Problem.from_error(error, status))
    return faults.instead(status, body, content_type="application/problem+json", **headers)


PASSING = {
    "reset": faults.reset,
    "no answer": faults.close_silently,
    "the server stops in the middle of an answer": faults.truncate,
    "garbage instead of HTTP": faults.send_bytes(b"\x15\x03\x01 garbage \r\n\r\n"),
    "endless head": faults.send_bytes(b"HTTP/1.1 200 OK\r\n" + b"x: y\r\n" * 20000),
    "flipped bit in the array": faults.flip_bit(-1),
    "flipped bit in the middle": faults.flip_bit(-300),
    "flipped bit in the status line": faults.flip_bit(2),
    "flipped bit in the status": faults.flip_bit(9),
    "wrong Content-Digest": faults.change(content_digest="sha-256=:AAAA:"),
    "no Content-Digest": faults.change(content_digest=None),
    "another request's answer": faults.change(x_request_digest="00" * 32),
    "no X-Request-Digest": faults.change(x_request_digest=None),
    "a length that is too long": faults.change(content_length=str(10**9)),
    "a length that is a lie": faults.change(content_length="999999999999999999999"),
    "a length that is no number": faults.change(content_length="-5"),
    "full": problem(Overloaded("full"), 503, retry_after="0"),
    "draining": problem(Draining("stopping"), 503),
    "a gateway without a backend": faults.instead(502, HTML, content_digest=None),
    "an overloaded gateway": faults.send_bytes(b"HTTP/1.1 503 Busy\r\nRetry-After: 0\r\nContent-Length: 0\r\n\r\n"),
    "a model of another digest": faults.instead(200, b"\x81\xa5model\xc0"),
}


@pytest.mark.parametrize("fault", PASSING.values(), ids=PASSING)
def test_a_passing_fault_is_not_noticed(server, model, fault):
    server.faults.append(fault)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    assert not server.faults


@pytest.mark.parametrize("fault", PASSING.values(), ids=PASSING)
def test_a_fault_is_noticed_when_retries_are_off(server, connect, fault):
    model = connect(server.address, retries=0)
    server.faults.extend([fault] * 2)  # a connection that was idle may be replaced once, silently
    with pytest.raises(BnserveError):
        model.predict(FREQUENCIES, ONE)


def test_an_answer_in_chunks_is_an_answer(server, model):
    server.faults.append(faults.chunked)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_a_connection_that_had_gone_stale_is_replaced_even_without_retries(server, connect):
    model = connect(server.address, retries=0)

    def answer_and_leave(handler, reply):
        handler.wfile.write(faults.raw(handler, reply))
        handler.close_connection = True  # without saying so

    server.faults.append(answer_and_leave)
    for _ in range(3):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_a_damaged_answer_is_retried_and_then_an_error(server, model):
    server.faults.extend([faults.flip_bit(-1)] * 20)
    with pytest.raises(AnswerCorrupted, match="damaged on the way"):
        model.predict(FREQUENCIES, ONE)
    assert len(server.faults) == 14


def test_another_model_under_the_pinned_version_is_refused(server, model):
    server.service.model = Replaced()
    with pytest.raises(AnswerCorrupted, match=r"pinned to default 1\.0\.0"):
        model.predict(FREQUENCIES, ONE)


class Replaced(ReferenceModel):
    description = msgspec.structs.replace(ReferenceModel.description, digest="sha256:" + "cd" * 32)


def test_a_reload_does_not_move_a_pinned_model(server, model):
    server.service.labels["stable"] = "2.0.0"
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    assert model.description.version == "1.0.0"


def test_what_a_retry_cannot_help_is_raised_at_once(server, model):
    server.faults.extend([problem(InternalError("sorry"), 500)] * 2)
    with pytest.raises(InternalError):
        model.predict(FREQUENCIES, ONE)
    assert len(server.faults) == 1


DAMAGED_HEADS = {
    "deadline": (problem(LateAnswer("late"), 504), DeadlineExceeded),
    "path": (problem(PathUnknown("no such path"), 404), PathUnknown),
    "version": (problem(ModelUnknown("no such version"), 404), ModelUnknown),
    "media type": (problem(UnsupportedMediaType("applicatinn"), 415), UnsupportedMediaType),
    "token": (problem(Unauthorized("no such token"), 401), Unauthorized),
    "length": (problem(TooLarge("too large"), 413), TooLarge),
}


@pytest.mark.parametrize(("fault", "kind"), DAMAGED_HEADS.values(), ids=DAMAGED_HEADS)
def test_what_a_damaged_head_deserves_is_believed_when_it_is_said_four_times(server, model, fault, kind):
    server.faults.extend([fault] * 3)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    server.faults.extend([fault] * 5)
    with pytest.raises(kind):
        model.predict(FREQUENCIES, ONE)
    assert len(server.faults) == 1


def test_the_error_of_an_overload_is_the_services_own_when_time_runs_out(server, connect):
    model = connect(server.address, timeout=0.5)
    server.faults.extend([problem(Overloaded("full"), 503, retry_after="60")] * 2)
    with pytest.raises(Overloaded) as raised:
        model.predict(FREQUENCIES, ONE)
    assert raised.value.retry_after == 60.0


def test_silence_ends_with_the_timeout(server, connect):
    model = connect(server.address, timeout=0.3)
    server.faults.append(faults.hang(0.8))
    with pytest.raises(DeadlineExceeded, match=r"timeout of 0\.3 s"):
        model.predict(FREQUENCIES, ONE)


def test_a_server_that_hangs_is_left_for_another(start_server, connect):
    hung, other = start_server(), start_server()
    model = connect([hung.address, other.address], silence=0.2)
    hung.faults.extend([faults.hang(0.8)] * 4)
    for _ in range(4):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_a_stopped_replica_is_left_for_another(start_server, connect):
    servers = [start_server() for _ in range(3)]
    model = connect(",".join(server.address for server in servers), retries=2)
    for server in servers[:2]:
        server.faults.extend([faults.reset] * 1)
    for _ in range(12):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_load_spreads_over_the_replicas(start_server, connect):
    servers = [start_server() for _ in range(3)]
    model = connect([server.address for server in servers])
    for _ in range(30):
        model.predict(FREQUENCIES, ONE)
    assert [len(server.service.evaluations()) for server in servers] == [10, 10, 10]


def test_a_large_batch_survives_faults_in_its_pieces(server, connect):
    model, batch = connect(server.address, chunk_samples=1000, parallel=3), binaries(64)
    server.faults.extend([faults.reset, None, faults.truncate, faults.flip_bit(-9), None, faults.close_silently])
    assert same(model.predict_batch(FREQUENCIES, batch), ReferenceModel().predict_batch(FREQUENCIES, batch))


STRANGERS = {
    "a web server": faults.instead(404, HTML, content_digest=None),
    "a web server that answers everything": faults.send_bytes(b"HTTP/1.0 200 OK\r\n\r\n" + HTML),
    "a redirect": faults.send_bytes(b"HTTP/1.1 302 F\r\nLocation: /login\r\nContent-Length: 0\r\n\r\n"),
    "an SSH server": faults.send_bytes(b"SSH-2.0-OpenSSH_9.2\r\n"),
    "other JSON": faults.instead(200, b'{"hello": 1}', content_type="application/json"),
}


@pytest.mark.parametrize("fault", STRANGERS.values(), ids=STRANGERS)
def test_something_that_is_not_bnserve_is_named(server, connect, fault):
    server.faults.extend([fault] * 10)
    with pytest.raises(NotBnserve, match="is not bnserve") as raised:
        connect(server.address)
    assert server.address in str(raised.value)
    assert "Check the address" in str(raised.value)


def test_a_server_that_is_not_there_is_said_to_be_so(connect):
    with pytest.raises(ConnectionFailed, match=r"http://127\.0\.0\.1:9.*bnserve serve"):
        connect("http://127.0.0.1:9")


def test_all_replicas_may_be_away_for_a_while(server, model):
    server.faults.extend([faults.reset] * 6)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_an_unknown_problem_code_of_a_newer_service_is_an_error_of_ours(server, model):
    body = b'{"type": "x", "title": "New", "status": 499, "detail": "It is new.", "code": "brand-new"}'
    server.faults.append(faults.instead(499, body, content_type="application/problem+json"))
    with pytest.raises(BnserveError, match=r"It is new\."):
        model.predict(FREQUENCIES, ONE)


STATUS = msgspec.Raw(b"".join(encode_array(np.zeros(1, np.uint8))))
ESCAPE = "\x1b]0;owned\x07\r\n\x9b2J"
SPEAKING = {
    "a problem": problem(ModelUnknown(ESCAPE, errors=[FieldError(reason=ESCAPE, parameter=ESCAPE)]), 404),
    "a problem of a code of its own": faults.instead(
        418, msgspec.json.encode({"type": ESCAPE, "title": ESCAPE, "status": 418, "detail": ESCAPE, "code": ESCAPE}),
        content_type="application/problem+json",
    ),
    "a redirection": faults.send_bytes(b"HTTP/1.1 302 Found\r\nLocation: \x1b[2J\x9b\r\nContent-Length: 0\r\n\r\n"),
    "a model of another name": faults.instead(200, msgspec.msgpack.encode(
        {"model": {"name": ESCAPE, "version": ESCAPE, "digest": ""}, "status": STATUS}
    )),
}  # fmt: skip


@pytest.mark.parametrize("fault", SPEAKING.values(), ids=SPEAKING)
def test_nothing_that_a_server_says_reaches_the_terminal_as_an_escape(server, connect, fault):
    model = connect(server.address, retries=0)
    server.faults.extend([fault] * 6)
    with pytest.raises(BnserveError) as raised:
        model.predict(FREQUENCIES, ONE)
    error = raised.value
    assert "".join([str(error), repr(error), str(error.errors), error.request_id or ""]).isprintable()


DESCRIBED = {
    "version": "\x1b[2J",
    "digest": "sha256:\x9b",
    "citation": "Somebody \x1b]0;owned\x07 (2024)",
    "provenance": {"notes": ["fine", {"host": "\b\b"}]},
    "accuracy": {"\u202e": 1.0},
}


@pytest.mark.parametrize(("field", "value"), DESCRIBED.items())
def test_a_description_that_a_terminal_would_obey_is_not_bnserves(server, field, value):
    described = server.service.model.description
    server.service.model.description = msgspec.structs.replace(described, **{field: value})
    server.service.labels["stable"] = server.service.model.description.version
    with pytest.raises(NotBnserve, match="control characters") as raised:
        Model.connect(server.address, retries=0)
    assert str(raised.value).isprintable()


def test_a_description_may_have_lines(server, connect):
    server.service.model.description = msgspec.structs.replace(
        server.service.model.description, citation="Ünal\n\tet al."
    )
    assert connect(server.address).description.citation == "Ünal\n\tet al."


def test_unavailability_has_one_name():
    assert all(issubclass(kind, Unavailable) for kind in (ConnectionFailed, DeadlineExceeded, Overloaded, Draining))
