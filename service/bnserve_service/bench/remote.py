"""A server over HTTP: where the time of one waveform goes, and what many clients at once get."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from functools import partial
from statistics import median
from typing import Any

from bnserve_protocol import ParameterBatch, WaveformModel, grid_digest
from bnserve_protocol.wire import MSGPACK, WANTED_DIGEST, GridDigest, WaveformRequest, encode_request
from bnserve_service.bench.binaries import Questions
from bnserve_service.bench.load import Target, answers_per_second, exchange
from bnserve_service.bench.timing import shuffled, timed

_TIMING = re.compile(rb"\r\nserver-timing:([^\r]*)", re.IGNORECASE)
_DURATION = re.compile(rb"(\w+);dur=([0-9.]+)")
_AS_OUR_CLIENT = {"Content-Type": MSGPACK, "Accept": MSGPACK, "Want-Content-Digest": WANTED_DIGEST}
PARTS = {
    "queue": "waiting in the server's queue",
    "eval": "evaluation",
    "pack": "packing the answer",
}
"""Of the header Server-Timing."""


class RawClient:
    """Asks a server with bytes made before, so that the client's own cost can be told from the rest.

    Parameters
    ----------
    target
        The server.
    model
        The same server through the client, which knows model and version.
    """

    def __init__(self, target: Target, model: WaveformModel) -> None:
        self._target = target
        self._path = f"/v1/models/{model.description.name}/versions/{model.description.version}/waveforms"

    def question(self, questions: Questions, points: int, batch: ParameterBatch) -> bytes:
        """A request as the client sends it, its grid by the digest under which it is uploaded here."""
        grid = questions.grid(points)
        digest = grid_digest(grid)
        octets = {"Content-Type": "application/octet-stream"}
        with self._target.connect() as connection:
            exchange(connection, self._target.request(f"/v1/grids/{digest}", grid.tobytes(), octets, "PUT"))
        body = encode_request(WaveformRequest(batch=batch, grid=GridDigest(sha256=digest)))
        return self._target.request(self._path, body, _AS_OUR_CLIENT)

    def timed_exchanges(self, request: bytes, calls: int) -> list[dict[str, float]]:
        """Seconds of each of some answers: ``total``, and what the server says of itself."""
        found = []
        with self._target.connect() as connection:
            for _ in range(calls):
                started = time.perf_counter()
                head, _ = exchange(connection, request)
                elapsed = time.perf_counter() - started
                found.append({"total": elapsed} | server_timing(head))
        return found


def server_timing(head: bytes) -> dict[str, float]:
    """Seconds by name from the header Server-Timing of an answer."""
    header = _TIMING.search(head)
    durations = _DURATION.findall(header.group(1)) if header else []
    return {name.decode(): 1e-3 * float(milliseconds) for name, milliseconds in durations}


def remote_breakdown(
    model: WaveformModel, raw: RawClient, questions: Questions, points: int, epochs: int
) -> dict[str, Any]:
    """Seconds of the parts of one waveform, from the call of the client to its answer.

    ``parts``: what the server says it did; the network and the server's HTTP, which is the rest of a request with
    prepared bytes; and the client, which is the rest of a call of its ``predict``.
    """
    request = raw.question(questions, points, questions.batch(1))
    answers: list[dict[str, float]] = []

    def ask() -> list[float]:
        fresh = raw.timed_exchanges(request, 52)[2:]
        answers.extend(fresh)
        return [answer["total"] for answer in fresh]

    call = partial(model.predict, questions.grid(points), questions.binary(0))
    cases: dict[str, Callable[[], list[float]]] = {"client": timed(call, 50), "raw": ask}
    total, bare = (median(values) for values in shuffled(cases, epochs).values())
    server = {text: median(answer.get(name, 0.0) for answer in answers) for name, text in PARTS.items()}
    parts = server | {
        "network and the server's HTTP": max(bare - sum(server.values()), 0.0),
        "client": max(total - bare, 0.0),
    }
    return {"points": points, "parts": parts, "total": total}


def concurrency(
    target: Target, raw: RawClient, questions: Questions, clients: tuple[int, ...], seconds: float, points: int = 277
) -> list[dict[str, Any]]:
    """Rows per second of one, two, ... clients that ask for one waveform after another."""
    requests = [raw.question(questions, points, questions.batch(1)) for _ in range(max(clients))]
    found = []
    for count in clients:
        answers_per_second(target, requests[:count], min(0.3, seconds))
        rate = answers_per_second(target, requests[:count], seconds)
        found.append({"clients": count, "points": points, "rows_per_second": rate})
    return found
