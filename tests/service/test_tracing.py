"""Spans for OpenTelemetry: a request is a part of its caller's trace, and nothing is told that nobody wants."""

import sys

import msgpack
import numpy as np
import pytest
from opentelemetry.sdk.trace import TracerProvider

from bnserve_client import AsyncModel, Model, ParametersWithExtrinsic
from bnserve_protocol import PackageMissing
from bnserve_service import BackgroundServer, Settings, Token, create_app
from tests.collector import Collector, attributes
from tests.integration.workers import serving_with
from tests.service.asking import GW170817, MSGPACK, ask, evaluate, question
from tests.service.chirp import ChirpModel, QuickChirpModel, until

ONE = ParametersWithExtrinsic(**GW170817)
PARENT = "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01"
UNWANTED = PARENT[:-2] + "00"
TRACE, SPAN = (bytes.fromhex(part) for part in PARENT.split("-")[1:3])


@pytest.fixture(autouse=True)
def soon(monkeypatch):
    """Spans are sent at once, and not after the usual seconds."""
    monkeypatch.setenv("OTEL_BSP_SCHEDULE_DELAY", "20")


@pytest.fixture
def collector():
    with Collector().serving() as it:
        yield it


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def server(start, collector, request):
    return start(request.param(), otlp_endpoint=collector.url)


def by_name(spans):
    assert len({span.name for span in spans}) == len(spans)
    return {span.name: span for span in spans}


def test_a_request_is_a_part_of_its_callers_trace(server, collector):
    body = msgpack.packb(question(GW170817 | {"total_mass": [2.5, 2.6]}))
    for _ in range(3):  # the later ones on one connection are for the fast path
        answer = ask(
            server.address, "POST", "/v1/models/chirp/waveforms", body, content_type=MSGPACK, x_request_id="mine",
            traceparent=PARENT, tracestate="vendor=some",
        )  # fmt: skip
    assert answer.status == 200
    found = by_name(collector.wait_for(9)[-3:])
    request, queue, evaluation = found["POST /v1/models/{name}/waveforms"], found["queue"], found["evaluation"]
    assert {span.trace_id for span in collector.spans} == {TRACE}
    assert (request.parent_span_id, request.trace_state) == (SPAN, "vendor=some")
    assert queue.parent_span_id == evaluation.parent_span_id == request.span_id
    assert request.kind == request.SPAN_KIND_SERVER
    times = [
        request.start_time_unix_nano, queue.start_time_unix_nano, queue.end_time_unix_nano,
        evaluation.start_time_unix_nano, evaluation.end_time_unix_nano, request.end_time_unix_nano,
    ]  # fmt: skip
    assert times == sorted(times)
    [identity] = [loaded.identity for loaded in server.app.parts.registry.catalogue.models.values()]
    assert attributes(request) == {
        "http.request.method": "POST", "http.route": "/v1/models/{name}/waveforms",
        "url.path": "/v1/models/chirp/waveforms", "http.response.status_code": 200, "http.request.body.size": len(body),
        "http.response.body.size": len(answer.body), "client.address": "127.0.0.1", "bnserve.request_id": "mine",
        "bnserve.caller": "anonymous", "bnserve.model": f"chirp {identity.version}",
        "bnserve.model_digest": identity.digest, "bnserve.rows": 2,
    }  # fmt: skip
    assert collector.resource["service.name"] == "bnserve"


def test_our_client_passes_its_callers_span_on(server, collector):
    tracer = TracerProvider().get_tracer("a sampler")
    with Model.connect(server.address, "chirp", chunk_samples=1000) as model:
        with tracer.start_as_current_span("a step") as span:
            model.predict_batch(np.linspace(20.0, 40.0, 500), [ONE] * 8)  # several requests, some in threads
            with tracer.start_as_current_span("another") as within:
                model.predict([20.0, 30.0], ONE)
        model.predict([20.0, 40.0], ONE)

    def parents():
        return [each.parent_span_id for each in collector.spans if each.name.endswith("/waveforms")]

    until(lambda: b"" in parents(), "the last is there")
    outer, inner = (each.get_span_context().span_id.to_bytes(8) for each in (span, within))
    *of_the_batch, single, outside = parents()
    assert len(of_the_batch) > 2
    assert (set(of_the_batch), single, outside) == ({outer}, inner, b"")
    assert len({each.trace_id for each in collector.spans if each.parent_span_id in (outer, inner)}) == 1


async def _ask_async(address, tracer):
    async with await AsyncModel.connect(address, "chirp") as model:
        with tracer.start_as_current_span("a step") as span:
            await model.predict([20.0, 30.0], ONE)
    return span.get_span_context()


def test_so_does_the_asynchronous_one(server, collector):
    import asyncio

    span = asyncio.run(_ask_async(server.address, TracerProvider().get_tracer("a sampler")))
    end = [each for each in collector.wait_for(3) if each.trace_id == span.trace_id.to_bytes(16)]
    assert span.span_id.to_bytes(8) in {each.parent_span_id for each in end}


def test_without_a_span_the_client_sends_nothing(start, caplog):
    caplog.set_level("INFO")
    server = start(ChirpModel(), access_log=True)
    with Model.connect(server.address, "chirp") as model:
        model.predict([20.0, 30.0], ONE)
        with pytest.MonkeyPatch.context() as patch:  # nor does it need the package
            patch.delitem(sys.modules, "opentelemetry.trace")
            model.predict([20.0, 30.0], ONE)
    assert "traceparent=-" in caplog.text
    assert "traceparent=0" not in caplog.text


def test_a_caller_who_wants_no_trace_has_none(server, collector):
    assert evaluate(server.address, question(), traceparent=UNWANTED).status == 200
    assert evaluate(server.address, question(), traceparent=PARENT).status == 200
    assert {span.trace_id for span in collector.wait_for(3)} == {TRACE}
    assert len(collector.spans) == 3


@pytest.mark.parametrize("odd", ["", "nonsense", f"{PARENT}, {PARENT}", PARENT.replace("0", "\xe9"), "00-" + "0" * 53])
def test_what_is_no_trace_is_as_if_it_were_not_there(server, collector, odd):
    assert evaluate(server.address, question(), traceparent=odd, tracestate="=;," * 100).status == 200
    request = by_name(collector.wait_for(3))["POST /v1/models/{name}/waveforms"]
    assert request.parent_span_id == b""


def test_probes_and_those_beyond_the_ratio_begin_none(start, collector):
    server = start(ChirpModel(), otlp_endpoint=collector.url, traces_ratio=0.0)
    assert ask(server.address, "GET", "/v2/health/ready").status == 200
    assert ask(server.address, "GET", "/metrics").status == 200
    assert evaluate(server.address, question()).status == 200
    assert ask(server.address, "GET", "/v2/health/live", traceparent=PARENT).status == 200
    assert [span.name for span in collector.wait_for(1)] == ["GET /v2/health/live"]


def test_a_refusal_is_one_of_the_caller_and_a_failure_one_of_the_server(start, collector, monkeypatch):
    model = ChirpModel()
    token = "the token of alice, who asks"
    server = start(model, otlp_endpoint=collector.url, tokens=(Token.of(token, "alice"),))
    assert evaluate(server.address, question(), traceparent=PARENT).status == 401
    monkeypatch.setattr(model, "predict_batch", lambda *arguments, **options: 1 / 0)
    headers = {"authorization": f"Bearer {token}", "traceparent": PARENT}
    assert evaluate(server.address, question(), **headers).status == 500
    spans = collector.wait_for(3)
    refused, failed = (span for span in spans if span.kind == span.SPAN_KIND_SERVER)
    unset = refused.status.STATUS_CODE_UNSET
    assert (attributes(refused)["error.type"], refused.status.code) == ("unauthorized", unset)
    assert (attributes(failed)["bnserve.caller"], failed.status.code) == ("alice", failed.status.STATUS_CODE_ERROR)
    assert token not in str(spans)


def test_a_collector_that_is_not_there_keeps_nobody_waiting(start, collector):
    collector.status = 503
    with BackgroundServer(Settings(port=0, otlp_endpoint=collector.url, drain_grace=0.0)) as server:
        for _ in range(5):
            assert evaluate(server.address, question(), "default", traceparent=PARENT).status == 200
    assert collector.spans == []


def test_workers_tell_it_too_and_the_last_spans_before_they_end(tmp_path, collector, monkeypatch):
    monkeypatch.setenv("OTEL_BSP_SCHEDULE_DELAY", "60000")
    with serving_with(tmp_path / "log", 2, "--otlp-endpoint", f"{collector.url}/") as server:
        assert evaluate(server.address, question(), "default", traceparent=PARENT).status == 200
        assert collector.spans == []
        server.server.process.terminate()
        assert server.server.process.wait(60) == 0
    assert len(collector.spans) == 3


def test_the_environment_of_opentelemetry_names_the_service(start, collector, monkeypatch):
    monkeypatch.setenv("OTEL_SERVICE_NAME", "waveforms")
    monkeypatch.setenv("OTEL_RESOURCE_ATTRIBUTES", "deployment.environment.name=test")
    server = start(ChirpModel(), otlp_endpoint=collector.url)
    evaluate(server.address, question())
    collector.wait_for(3)
    assert (collector.resource["service.name"], collector.resource["deployment.environment.name"]) == (
        "waveforms", "test",
    )  # fmt: skip


def test_without_the_packages_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "opentelemetry.exporter.otlp.proto.http.trace_exporter", None)
    assert create_app(Settings(), wait_for_models=False).parts.tracing is None
    with pytest.raises(PackageMissing, match=r"otlp_endpoint.*pip install '\.\[otel\]'"):
        create_app(Settings(otlp_endpoint="http://127.0.0.1:4318"), wait_for_models=False)


@pytest.mark.parametrize("wrong", ["127.0.0.1:4318", "grpc://127.0.0.1:4317", "http://", "http://a?b"])
def test_a_collector_is_named_by_its_url(wrong):
    with pytest.raises(ValueError, match="otlp_endpoint"):
        Settings(otlp_endpoint=wrong)
