"""Spans for OpenTelemetry: each request continues the trace of its caller, from its ``traceparent`` (W3C).

A span is made when its request has been answered, from the times that are taken in any case: without a collector in the
settings there is nothing to do, and with one nothing is looked after while a request is under way.
"""

from __future__ import annotations

import os
import threading
import time
from typing import Any, Self

from bnserve_protocol import __version__, require
from bnserve_service.http.access_log import fields_of
from bnserve_service.http.requests import RequestContext
from bnserve_service.settings import Settings

_EXTRA = "otel"
_PURPOSE = "Traces (otlp_endpoint)"
_NAMES = {
    "method": "http.request.method",
    "route": "http.route",
    "path": "url.path",
    "status": "http.response.status_code",
    "bytes_in": "http.request.body.size",
    "bytes_out": "http.response.body.size",
    "peer": "client.address",
    "error": "error.type",
    **{
        name: f"bnserve.{name}"
        for name in ("request_id", "caller", "model", "model_digest", "analysis", "network", "rows")
    },
}
"""Attributes by the names of the log's fields: OpenTelemetry's conventions for HTTP servers, and those of our own."""
_NOBODY_ASKS = ("/v2/", "/metrics")
"""Probes and metrics, every few seconds: they have a span where they bring a trace alone."""
_FAREWELL_SECONDS = 1.0
"""For the last spans: a collector that does not answer must not hold up the end of a server."""


class Tracing:
    """Tells a collector of requests, in batches from a thread of its own; what it does not take in time is dropped.

    Its environment variables count as everywhere (``OTEL_SERVICE_NAME``, ``OTEL_RESOURCE_ATTRIBUTES``,
    ``OTEL_EXPORTER_OTLP_HEADERS``, ...), but for the address and the sampler.

    Parameters
    ----------
    endpoint
        URL of the collector, which speaks OTLP over HTTP.
    ratio
        The part of requests without a trace that begin one; those that bring one follow it.

    Raises
    ------
    PackageMissing
        The extra ``otel`` is not installed.
    """

    def __init__(self, endpoint: str, ratio: float) -> None:
        self._url = f"{endpoint.rstrip('/')}/v1/traces"
        self._ratio = ratio
        self._trace = require("opentelemetry.trace", _PURPOSE, _EXTRA)
        self._sdk = require("opentelemetry.sdk.trace", _PURPOSE, _EXTRA)
        self._export = require("opentelemetry.sdk.trace.export", _PURPOSE, _EXTRA)
        self._otlp = require("opentelemetry.exporter.otlp.proto.http.trace_exporter", _PURPOSE, _EXTRA)
        self._parents = require("opentelemetry.trace.propagation.tracecontext", _PURPOSE, _EXTRA)
        self._context = self._parents.TraceContextTextMapPropagator()
        self._provider: Any = None
        self._tracer: Any = None

    @classmethod
    def of(cls, settings: Settings) -> Self | None:
        """As the settings say; None where they name no collector. Raises as the class."""
        return None if settings.otlp_endpoint is None else cls(settings.otlp_endpoint, settings.traces_ratio)

    def start(self) -> None:
        """Begin; in the process that serves, after any fork."""
        from opentelemetry.sdk import resources
        from opentelemetry.sdk.trace import sampling

        described = resources.Resource({"service.name": "bnserve", "service.version": __version__,
                                        "process.pid": os.getpid()})  # fmt: skip
        sampler = sampling.ParentBased(sampling.TraceIdRatioBased(self._ratio))
        self._provider = self._sdk.TracerProvider(
            sampler, described.merge(resources.OTELResourceDetector().detect()), shutdown_on_exit=False
        )
        self._provider.add_span_processor(self._export.BatchSpanProcessor(self._otlp.OTLPSpanExporter(self._url)))
        self._tracer = self._provider.get_tracer("bnserve", __version__)

    def stop(self) -> None:
        """Send what is left; at most for one second."""
        if self._provider is not None:
            last = threading.Thread(target=self._provider.shutdown, name="bnserve-last-spans", daemon=True)
            last.start()
            last.join(_FAREWELL_SECONDS)

    def tell(self, method: str, context: RequestContext, seconds: float) -> None:
        """Make the spans of a request that has been answered, as :meth:`AccessLog.tell` writes its line."""
        headers = context.headers
        if b"traceparent" not in headers and context.route.startswith(_NOBODY_ASKS):
            return
        brought = {name: headers[name.encode()].decode("latin-1")
                   for name in ("traceparent", "tracestate") if name.encode() in headers}  # fmt: skip
        end = time.time_ns()
        begin = end - _ns(seconds)
        span = self._tracer.start_span(
            f"{method} {context.route}", self._context.extract(brought), self._trace.SpanKind.SERVER, start_time=begin
        )
        if not span.is_recording():
            return
        known = fields_of(method, context)
        span.set_attributes({attribute: known[name] for name, attribute in _NAMES.items() if name in known})
        if context.status >= 500:
            span.set_status(self._trace.StatusCode.ERROR, context.error)
        within = self._trace.set_span_in_context(span)
        if context.submitted:
            submitted = begin + _ns(context.submitted - context.arrived)
            taken = begin + _ns(context.started - context.arrived) if context.started else end
            self._tracer.start_span("queue", within, start_time=submitted).end(taken)
            if context.started:
                evaluation = self._tracer.start_span("evaluation", within, start_time=taken)
                evaluation.end(taken + _ns(context.evaluated))
        span.end(end)


def _ns(seconds: float) -> int:
    return int(seconds * 1e9)
