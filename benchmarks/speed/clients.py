"""Single requests from many clients at once, and batches, in rows per second: bnserve, and the model servers."""

from __future__ import annotations

import urllib.request
from functools import partial
from typing import Any

from benchmarks.load import answers_per_second, http_request
from benchmarks.speed.remote import batch_of, grid_of
from bnserve_protocol import MSGPACK, GridDigest, WaveformRequest, encode_request, grid_digest

PATH = "/v1/models/default/waveforms"


def upload_grid(url: str, points: int) -> GridDigest:
    """Give a server the grid of a comparison; its name."""
    grid = grid_of(points)
    digest = grid_digest(grid)
    request = urllib.request.Request(f"{url}/v1/grids/{digest}", grid.tobytes(), method="PUT")
    request.add_header("Content-Type", "application/octet-stream")
    with urllib.request.urlopen(request, timeout=30):
        return GridDigest(sha256=digest)


def encoded_request(grid: Any, rows: int, first: int = 0) -> bytes:
    """The bytes of one question over HTTP, as our client asks it."""
    body = encode_request(WaveformRequest(batch=batch_of(rows, first), grid=grid))
    return http_request(PATH, body, {"Content-Type": MSGPACK, "Accept": MSGPACK})


def rows_per_second(url: str, points: int, rows: int, clients: int, seconds: float) -> float:
    """Rows per second of a server that is asked by many clients at once, each with one request under way."""
    host, _, port = url.removeprefix("http://").partition(":")
    grid = upload_grid(url, points)
    requests = [encoded_request(grid, rows, first=client) for client in range(clients)]
    load = partial(answers_per_second, (host, int(port)), requests)
    load(min(0.3, seconds))
    return rows * load(seconds)
