"""What Prometheus reads: base units, true counts, labels that callers cannot invent."""

import contextlib
import json
import subprocess
import threading
import urllib.request
from datetime import UTC, datetime

import numpy as np
import pytest
from prometheus_client.parser import text_string_to_metric_families

from bnserve_service import Token
from bnserve_service.shared.metrics import SharedMetrics
from bnserve_service.telemetry.metrics import Metrics
from tests.service.asking import GW170817, ask, evaluate, question, raw_connection, read_response
from tests.service.chirp import ChirpModel, until


def samples(text):
    return {
        (sample.name, frozenset(sample.labels.items())): sample.value
        for family in text_string_to_metric_families(text)
        for sample in family.samples
    }


def value(server, metric, **labels):
    return samples(ask(server.address, "GET", "/metrics").body.decode()).get((metric, frozenset(labels.items())))


def test_requests_rows_and_samples_are_counted(start):
    server = start(ChirpModel())
    for _ in range(3):
        evaluate(server.address, question(GW170817 | {"total_mass": [2.5, 2.6]}))
    evaluate(server.address, question(), model="unheard-of")
    route = "/v1/models/{name}/waveforms"
    labels = {"route": route, "method": "POST"}
    # counted when the answer has left, which may be after it has arrived
    until(lambda: value(server, "bnserve_requests_total", status="200", **labels) == 3, "three answers")
    until(lambda: value(server, "bnserve_requests_total", status="404", **labels) == 1, "one refusal")
    assert value(server, "bnserve_rows_total", model="chirp") == 6
    assert value(server, "bnserve_samples_total", model="chirp") == 6 * 9
    assert value(server, "bnserve_errors_total", code="model-unknown") == 1
    assert value(server, "bnserve_request_duration_seconds_count", route=route) == 4
    assert value(server, "bnserve_queue_samples") == 0
    assert value(server, "bnserve_model_info", name="chirp", version="1.0.0", digest="sha256:0") == 1
    assert value(server, "bnserve_ready") == 1


def test_labels_do_not_grow_with_what_callers_invent(start):
    server = start(ChirpModel())
    for index in range(50):
        ask(server.address, "GET", f"/invented/{index}")
        ask(server.address, "GET", f"/v1/models/invented-{index}")
        ask(server.address, f"M{'ABCDEFGHIJ'[index % 10]}", "/v1/models")
    text = ask(server.address, "GET", "/metrics").body.decode()
    assert "invented" not in text
    labelled = {labels for name, labels in samples(text) if name == "bnserve_requests_total"}
    assert len(labelled) < 10


def test_what_several_workers_have_counted_is_told_by_each(tmp_path):
    workers = [Metrics(SharedMetrics(tmp_path, place)) for place in range(2)]
    for place, worker in enumerate(workers):
        worker.observe_request("/v1/models", "GET", 200, 0.003 + place)
        worker.publish()
    for worker in workers:
        told = samples(worker.exposition().decode())
        labels = {("route", "/v1/models"), ("method", "GET"), ("status", "200")}
        assert told["bnserve_requests_total", frozenset(labels)] == 2
        seconds = "bnserve_request_duration_seconds"
        assert told[f"{seconds}_sum", frozenset({("route", "/v1/models")})] == pytest.approx(1.006)
        assert told[f"{seconds}_bucket", frozenset({("route", "/v1/models"), ("le", "0.005")})] == 1


def test_units_are_base_units(server):
    text = ask(server.address, "GET", "/metrics").body.decode()
    names = {family.name for family in text_string_to_metric_families(text) if family.name.startswith("bnserve")}
    assert names
    assert not [name for name in names if name.endswith(("_ms", "_milliseconds", "_mb", "_kb"))]


def test_grids_are_measured(start):
    import hashlib

    server = start(ChirpModel())
    body = np.arange(1.0, 101.0).tobytes()
    ask(server.address, "PUT", f"/v1/grids/{hashlib.sha256(body).hexdigest()}", body)
    assert value(server, "bnserve_grids_bytes") == 800


def test_on_a_port_of_its_own_the_metrics_are_not_beside_the_waveforms(start):
    server = start(ChirpModel(), metrics_port=0)
    assert ask(server.address, "GET", "/metrics").status == 404
    with urllib.request.urlopen(server.metrics_address) as answer:
        assert b"bnserve_ready" in answer.read()
    assert "/metrics" not in json.loads(ask(server.address, "GET", "/openapi.json").body)["paths"]


def test_the_port_of_the_metrics_is_no_wider_a_door_than_that_of_the_waveforms(start):
    server = start(ChirpModel(), metrics_port=0, host="0.0.0.0", header_timeout=0.3, keep_alive=0.3)
    address = server.metrics_address.removesuffix("/metrics")
    assert address.startswith("http://127.0.0.1:"), "nobody asked for another, and it asks for no token"
    assert ask(address, "GET", "/metrics", host="rebound.example").code == "forbidden"
    assert ask(address, "GET", "/v1/limits").status == 404
    assert ask(address, "POST", "/metrics", b"x").status == 405
    threads = threading.active_count()
    half_open = [raw_connection(address) for _ in range(200)]
    for connection in half_open:
        connection.sendall(b"GET /metrics HTTP/1.1\r\n")
    assert ask(address, "GET", "/metrics").status == 200
    assert threading.active_count() <= threads + 4, "none of them has a thread"
    for connection in half_open:
        with contextlib.suppress(ConnectionError):
            assert connection.recv(100) == b"", "each is cut off"
        connection.close()
    with raw_connection(address) as connection:
        connection.sendall(b"GET /metrics HTTP/1.1\r\nHost: localhost\r\nX: " + b"x" * 2**17 + b"\r\n\r\n")
        assert read_response(connection).status == 400


def test_the_port_of_the_metrics_listens_where_it_is_told_and_for_whoever_can_connect(start):
    server = start(ChirpModel(), metrics_port=0, metrics_host="0.0.0.0")
    port = server.metrics_address.removesuffix("/metrics").rpartition(":")[2]
    assert ask(f"http://127.0.0.2:{port}", "GET", "/metrics", host="10.1.2.3:9090").status == 200


def test_the_content_type_is_prometheus(server):
    assert ask(server.address, "GET", "/metrics").headers["content-type"].startswith("text/plain; version=")


@pytest.mark.parametrize("outcome", ["changed", "unchanged"])
def test_looks_at_the_stores_are_counted(start, outcome):
    server = start(ChirpModel())
    until(lambda: (value(server, "bnserve_reloads_total", outcome=outcome) or 0) > 0, outcome)


def test_operators_have_a_socket_of_their_own(start, tmp_path):
    path = tmp_path / "operators.sock"
    operator = Token.of("the token of somebody", "a", ("admin", "evaluate"))
    server = start(ChirpModel(), metrics_uds=path, uds_mode="600", tokens=(operator,))

    def curl(*arguments):
        command = ["curl", "-sS", "--unix-socket", str(path), *arguments]
        return subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout

    assert path.stat().st_mode & 0o777 == 0o600
    assert "bnserve_ready 1.0" in curl("http://localhost/metrics")
    assert json.loads(curl("-X", "POST", "http://localhost/v1/reload"))["failures"] == {}
    assert json.loads(curl("http://localhost/v1/models"))["status"] == 404
    authorized = {"authorization": "Bearer the token of somebody"}
    assert ask(server.address, "GET", "/metrics", **authorized).status == 404
    assert ask(server.address, "POST", "/v1/reload", **authorized).status == 404
    server.__exit__()
    assert not path.exists()


def test_operators_may_have_an_address_of_their_own_where_tokens_count(start):
    operator, alice = "the token of an operator", "the token of alice, who asks"
    tokens = Token.of(operator, "operator", ("admin", "evaluate")), Token.of(alice, "alice")
    server = start(ChirpModel(), metrics_port=0, metrics_reload=True, tokens=tokens)
    apart = server.metrics_address.removesuffix("/metrics")

    def status(method, path, token=None, address=apart, **headers):
        return ask(address, method, path, **({"authorization": f"Bearer {token}"} if token else {}), **headers).status

    assert status("GET", "/metrics") == 200, "a Prometheus needs no token"
    assert [status("POST", "/v1/reload", token) for token in (None, alice, operator)] == [401, 403, 200]
    assert status("POST", "/v1/reload", operator, origin="http://elsewhere.example") == 403
    assert status("POST", "/v1/reload", operator, server.address) == 404, "it is not beside the waveforms"
    assert status("GET", "/v1/models", operator) == 404


def test_looking_at_the_stores_stays_beside_the_waveforms_unless_told_otherwise(start):
    server = start(ChirpModel(), metrics_port=0)
    assert ask(server.address, "POST", "/v1/reload").status == 200
    assert ask(server.metrics_address.removesuffix("/metrics"), "POST", "/v1/reload").status == 404


def test_when_tokens_end_is_told(start):
    soon, late = datetime(2037, 1, 1, tzinfo=UTC), datetime(2038, 1, 1, tzinfo=UTC)
    texts = [f"the token number {number} of several" for number in range(4)]
    tokens = (
        Token.of(texts[0], "alice", expires=late), Token.of(texts[1], "alice", expires=soon), Token.of(texts[2], "bob"),
        Token.of(texts[3], "carol", ("metrics",), expires=late),
    )  # fmt: skip
    server = start(ChirpModel(), tokens=tokens)
    page = ask(server.address, "GET", "/metrics", authorization=f"Bearer {texts[3]}").body.decode()
    name = "bnserve_token_expires_timestamp_seconds"
    told = {dict(labels)["token"]: seconds for (found, labels), seconds in samples(page).items() if found == name}
    assert told == {"alice": soon.timestamp(), "carol": late.timestamp()}


def test_of_what_several_workers_say_of_one_thing_the_largest_counts(tmp_path):
    workers = [Metrics(SharedMetrics(tmp_path, place)) for place in range(2)]
    for worker in workers:
        worker.watch_each("ends", "When", "token", lambda: {"alice": 5.0})
        worker.publish()
    assert samples(workers[0].exposition().decode())["ends", frozenset({("token", "alice")})] == 5.0
