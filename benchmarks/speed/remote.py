"""Over HTTP: the client's round trips to ``bnserve serve``, and the floor below them."""

from __future__ import annotations

import http.client
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from typing import Any

import numpy as np

from benchmarks.peers.worker import draw
from benchmarks.servers import bare_server, bnserve_server
from benchmarks.speed.local import PREDECESSOR, Cases
from benchmarks.speed.setup import Setup
from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_protocol import EvaluationOptions, ParameterBatch
from bnserve_protocol.wire import MSGPACK, WaveformRequest, encode_request
from bnserve_service.bench.load import open_connection
from bnserve_service.bench.timing import timed

SHAPES = ((1, 277), (256, 277), (64, 10_000), (1, 253_056))
"""Rows, points."""
DTYPES = ("complex64", "complex128")
ALONE = EvaluationOptions(modes=((2, 2),))
"""What is asked for, because it is all that the predecessor and the other servers have."""
ENVELOPE = 400
"""Bytes of an answer beside its arrays, about."""


def grid_of(points: int) -> Any:
    """The uniform grid of all local comparisons."""
    return np.linspace(5.0, 2048.0, points)


def batch_of(rows: int, first: int = 0) -> ParameterBatch:
    """Binaries as drawn for all peers."""
    return ParameterBatch.coerce([ParametersWithExtrinsic(**draw(seed)) for seed in range(first, first + rows)])


def answer_bytes(rows: int, points: int, itemsize: int = 16) -> int:
    """About the size of an answer of one array."""
    return rows * (points * itemsize + 33) + ENVELOPE


@contextmanager
def remote_cases(setup: Setup) -> Iterator[Cases]:
    """Start the servers and connect to them; a case is ``http``, rows, points, dtype, or ``floor``, rows, points."""
    with ExitStack() as stack:
        url, _ = stack.enter_context(bnserve_server(cpus=setup.cpus))
        cases = _client_cases(stack.enter_context(Model.connect(url)))
        address = stack.enter_context(bare_server([answer_bytes(*shape) for shape in SHAPES], cpus=setup.cpus))
        connection = http_client_connection(address)
        stack.callback(connection.close)
        for rows, points in SHAPES:
            calls = 20 if rows * points < 1_000 else 1
            ask = partial(post, connection, rows, points, request_body(rows, points))
            cases["floor", rows, points] = timed(ask, calls)
        yield cases


def _client_cases(model: Model) -> Cases:
    cases: Cases = {}
    for rows, points in SHAPES:
        grid, batch = grid_of(points), batch_of(rows)
        for dtype in DTYPES:
            if rows == 1:
                call = partial(model.predict, grid, ParametersWithExtrinsic(**draw(0)), options=ALONE, dtype=dtype)
            else:
                call = partial(model.predict_batch, grid, batch, options=ALONE, dtype=dtype)
            cases["http", rows, points, dtype] = timed(call, 20 if rows * points < 1_000 else 1)
    return cases


def request_body(rows: int, points: int) -> bytes:
    """What a client that has uploaded its grid sends, about: the parameters."""
    return encode_request(WaveformRequest(batch=batch_of(rows), grid=grid_of(2), options=ALONE))


def http_client_connection(address: tuple[str, int]) -> http.client.HTTPConnection:
    """A connection of the standard library."""
    connection = http.client.HTTPConnection(*address)
    connection.sock = open_connection(address)
    return connection


def post(connection: http.client.HTTPConnection, rows: int, points: int, body: bytes) -> bytes:
    """One request to the floor with the standard library."""
    connection.request("POST", f"/{answer_bytes(rows, points)}", body, {"Content-Type": MSGPACK})
    return connection.getresponse().read()


def remote_figures(seconds: dict[Any, float]) -> dict[str, dict[str, Any]]:
    """The rows over HTTP from the median seconds of all cases."""
    figures = {"http_floor": _ratio(seconds["http", 1, 277, "complex128"], seconds["floor", 1, 277], "floor")}
    if (PREDECESSOR, 1, 277) in seconds:
        for key, shape, dtype in (
            ("http_one", (1, 277), "complex128"),
            ("http_batch_277", (256, 277), "complex128"),
            ("http_batch_10000_c64", (64, 10_000), "complex64"),
            ("http_batch_10000_c128", (64, 10_000), "complex128"),
            ("http_full_c64", (1, 253_056), "complex64"),
            ("http_full_c128", (1, 253_056), "complex128"),
        ):
            rows, points = shape
            theirs, ours = seconds[PREDECESSOR, 1, points], seconds["http", rows, points, dtype] / rows
            figures[key] = {"value": theirs / ours, "ours": 1e6 * ours, "peers": {PREDECESSOR: 1e6 * theirs}}
    return figures


def _ratio(ours: float, theirs: float, name: str) -> dict[str, Any]:
    return {"value": ours / theirs, "ours": 1e6 * ours, "peers": {name: 1e6 * theirs}}
