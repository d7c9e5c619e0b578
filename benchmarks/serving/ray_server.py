"""Ray Serve 2.60 over HTTP, with its batching.

Install:

    python3.11 -m venv $SERVING/ray
    $SERVING/ray/bin/pip install "ray[serve]==2.60.0" ./protocol ./model_store ./surrogate
"""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path
from typing import Any

import ray
from ray import serve
from starlette.requests import Request
from starlette.responses import Response

HERE = str(Path(__file__).parent)


@serve.deployment(num_replicas=1, max_ongoing_requests=64, ray_actor_options={"num_cpus": 0})
class WaveformDeployment:
    """Requests of one grid that arrive together are evaluated together."""

    def __init__(self) -> None:
        sys.path.insert(0, HERE)
        from application import Waveforms

        self._waveforms = Waveforms()

    @serve.batch(max_batch_size=32, batch_wait_timeout_s=0.0)
    async def evaluate(self, requests: list[tuple[int, bytes]]) -> list[bytes]:
        """Raw numbers to raw numbers."""
        answers: list[Any] = [None] * len(requests)
        for points in {points for points, _ in requests}:
            places = [place for place, (each, _) in enumerate(requests) if each == points]
            together = self._waveforms.answer(points, b"".join(requests[place][1] for place in places))
            at = 0
            for place in places:
                size = len(requests[place][1]) // 80 * points * 16
                answers[place] = together[at : at + size]
                at += size
        return answers

    async def __call__(self, request: Request) -> Response:
        """One request over HTTP."""
        points = int(request.url.path.rpartition("/")[2])
        return Response(await self.evaluate((points, await request.body())), media_type="application/octet-stream")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, _temp_dir=os.environ.get("RAY_TMPDIR"))
    serve.start(http_options={"host": "127.0.0.1", "port": int(sys.argv[1])})
    serve.run(WaveformDeployment.bind())  # type: ignore[attr-defined]  # the decorator's
    signal.pause()
