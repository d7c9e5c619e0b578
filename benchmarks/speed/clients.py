"""Questions to bnserve as bytes, for clients that cost next to nothing."""

from __future__ import annotations

import urllib.request

from benchmarks.speed.remote import ALONE, grid_of
from bnserve_protocol import ParameterBatch, grid_digest
from bnserve_protocol.wire import MSGPACK, WANTED_DIGEST, GridDigest, WaveformRequest, encode_request
from bnserve_service.bench.load import Target

PATH = "/v1/models/default/waveforms"
_AS_OUR_CLIENT = {"Content-Type": MSGPACK, "Accept": MSGPACK, "Want-Content-Digest": WANTED_DIGEST}


def upload_grid(url: str, points: int) -> GridDigest:
    """Give a server the grid of a comparison; its name."""
    grid = grid_of(points)
    digest = grid_digest(grid)
    request = urllib.request.Request(f"{url}/v1/grids/{digest}", grid.tobytes(), method="PUT")
    request.add_header("Content-Type", "application/octet-stream")
    with urllib.request.urlopen(request, timeout=30):
        return GridDigest(sha256=digest)


def encoded_body(grid: GridDigest, batch: ParameterBatch) -> bytes:
    """The bytes of one question over HTTP, as our client asks it."""
    body = encode_request(WaveformRequest(batch=batch, grid=grid, options=ALONE))
    return Target(("127.0.0.1", 0)).request(PATH, body, _AS_OUR_CLIENT)
