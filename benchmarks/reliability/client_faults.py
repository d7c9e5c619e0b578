"""Our client with one of its mechanisms taken away: measurements with it should fail. In this process alone."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

from bnserve_client import _blocking, _session
from bnserve_client._messages import HttpResponse

_trusted_body = _session.trusted_body


def _body_as_it_came(response: HttpResponse, where: str, asked: str | None) -> bytes | memoryview:
    return response.body if 200 <= response.status < 300 else _trusted_body(response, where, asked)


def _whole_body(response: HttpResponse, where: str, asked: str | None) -> bytes | memoryview:
    return _trusted_body(response, where, None)


_ONE_PROCESS = SimpleNamespace(getpid=lambda: 1, environ={})
"""``os`` for somebody who believes that there is one process."""


def _raise(self: Any, error: Exception) -> float:
    raise error


INJECTED_FAULTS = {
    "no-digests": (_session, "trusted_body", _body_as_it_came),
    "no-echo": (_session, "trusted_body", _whole_body),
    "no-retries": (_session.RetryPolicy, "pause_after", _raise),
    "shared-sockets": (_blocking, "os", _ONE_PROCESS),
}


@contextmanager
def injecting(fault: str | None) -> Iterator[None]:
    """A client with a fault, in this process and in those that are forked from it; None changes nothing."""
    if fault is None:
        yield
        return
    where, name, value = INJECTED_FAULTS[fault]
    with patch.object(where, name, value):
        yield
