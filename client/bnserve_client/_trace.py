"""The trace that a caller's program is in, passed on to the service (W3C Trace Context)."""

from __future__ import annotations

import sys


def trace_headers() -> tuple[tuple[str, str], ...]:
    """``traceparent`` and ``tracestate`` of OpenTelemetry's active span; none where the program does not use it.

    A program that has a span has imported ``opentelemetry.trace``, so that it is neither imported here nor needed.
    """
    current = getattr(sys.modules.get("opentelemetry.trace"), "get_current_span", None)
    if current is None:
        return ()
    span = current().get_span_context()
    if not span.is_valid:
        return ()
    parent = ("traceparent", f"00-{span.trace_id:032x}-{span.span_id:016x}-{span.trace_flags:02x}")
    return (parent, ("tracestate", span.trace_state.to_header())) if span.trace_state else (parent,)
