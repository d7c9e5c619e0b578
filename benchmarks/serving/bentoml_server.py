"""BentoML 1.4: an endpoint of bytes, which is far faster than its own client's JSON.

Install:

    python3.11 -m venv $SERVING/bentoml
    $SERVING/bentoml/bin/pip install "bentoml>=1.4,<1.5" ./protocol ./model_store ./surrogate
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import bentoml

sys.path.insert(0, str(Path(__file__).parent))

from application import Waveforms


@bentoml.service(name="waveforms", workers=1, traffic={"timeout": 60, "max_concurrency": 64})
class WaveformService:
    """Raw numbers in, raw numbers out."""

    def __init__(self) -> None:
        self._waveforms = Waveforms()

    @bentoml.api(route="/evaluate/277")
    def evaluate_277(self, body: bytes, /) -> bytes:
        """On 277 points."""
        return self._waveforms.answer(277, body)

    @bentoml.api(route="/evaluate/10000")
    def evaluate_10000(self, body: bytes, /) -> bytes:
        """On 10,000 points."""
        return self._waveforms.answer(10_000, body)


if __name__ == "__main__":
    service = f"{Path(__file__).stem}:WaveformService"
    command = [sys.executable, "-m", "bentoml", "serve", service, "--port", sys.argv[1], "--host", "127.0.0.1"]
    os.chdir(Path(__file__).parent)
    os.execv(sys.executable, command)
