"""The access log: who asked for what, from where, how much it was, and what came of it."""

from __future__ import annotations

import logging
from typing import Any

from bnserve_service.http.requests import RequestContext
from bnserve_service.telemetry.log import FIELDS, log_word

logger = logging.getLogger("bnserve.access")

_OWNER = 16
"""Digits of a token's digest that name it where several have one name."""


class AccessLog:
    """One line for each request that has been answered: of words, or with all that is known where the log is JSON."""

    def tell(self, method: str, context: RequestContext, seconds: float) -> None:
        """Write it.

        Parameters
        ----------
        method
            Of the request; one that we know.
        context
            What is known about it.
        seconds
            From its headers to the end of its answer.
        """
        traceparent = log_word(context.headers.get(b"traceparent", b"-"))
        logger.info(
            "%s %s %s %d %.1f ms caller=%s traceparent=%s",
            context.request_id, method, context.route, context.status, seconds * 1e3, context.caller, traceparent,
            extra={FIELDS: fields_of(method, context, seconds)},
        )  # fmt: skip


def fields_of(method: str, context: RequestContext, seconds: float | None = None) -> dict[str, Any]:
    """What auditors ask for, of :meth:`AccessLog.tell`; what there is not is left out."""
    model = context.model
    found = {
        "request_id": context.request_id,
        "caller": context.caller,
        "token": context.owner[:_OWNER],
        "peer": context.peer,
        "forwarded_for": log_word(context.headers.get(b"x-forwarded-for", b"")),
        "method": method,
        "route": context.route,
        "path": context.route.format(**context.path) if context.path else "",
        "model": "" if model is None else f"{model.name} {model.version}",
        "model_digest": "" if model is None else model.digest,
        "analysis": context.path.get("sha256", "") if "likelihoods" in context.route else "",
        "network": context.path.get("sha256", "") if "forecasts" in context.route else "",
        "rows": context.rows,
        "bytes_in": context.bytes_in,
        "bytes_out": context.bytes_out,
        "seconds": "" if seconds is None else round(seconds, 6),
        "status": context.status,
        "error": context.error,
        "traceparent": log_word(context.headers.get(b"traceparent", b"")),
    }
    return {name: value for name, value in found.items() if value != ""}
