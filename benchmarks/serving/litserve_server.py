"""LitServe: JSON with base64 in (it has no raw request bodies), raw numbers out, its own batching.

Install:

    python3.11 -m venv $SERVING/litserve
    $SERVING/litserve/bin/pip install litserve==0.2.19 numpy ./protocol ./model_store ./surrogate
"""

import base64
import sys
from typing import Any

import litserve
import numpy as np
from application import PARAMETERS, Waveforms
from fastapi import Request, Response


class WaveformApi(litserve.LitAPI):
    """Requests of one grid that arrive together are evaluated together."""

    def setup(self, device: str) -> None:
        """Load the model."""
        self.waveforms = Waveforms()

    def decode_request(self, request: Request) -> tuple[int, Any]:
        """From JSON."""
        values = np.frombuffer(base64.b64decode(request["values"])).reshape(-1, PARAMETERS)
        return request["points"], values

    def batch(self, inputs: list[tuple[int, Any]]) -> list[tuple[int, Any]]:
        """Keep them apart: grids may differ."""
        return inputs

    def predict(self, batch: list[tuple[int, Any]]) -> list[Any]:
        """One evaluation for each grid of a batch."""
        answers: list[Any] = [None] * len(batch)
        for points in {points for points, _ in batch}:
            places = [place for place, (each, _) in enumerate(batch) if each == points]
            h = self.waveforms.evaluate(points, np.concatenate([batch[place][1] for place in places]))
            ends = np.cumsum([len(batch[place][1]) for place in places])[:-1]
            for place, part in zip(places, np.split(h, ends), strict=True):
                answers[place] = part
        return answers

    def unbatch(self, output: list[Any]) -> list[Any]:
        """They are apart already."""
        return output

    def encode_response(self, output: Any) -> Response:
        """Raw numbers."""
        return Response(output.tobytes(), media_type="application/octet-stream")


if __name__ == "__main__":
    api = WaveformApi(max_batch_size=32, batch_timeout=0.0005)
    server = litserve.LitServer(api, accelerator="cpu", workers_per_device=1, timeout=60)
    server.run(port=int(sys.argv[1]), host="127.0.0.1", log_level="warning", generate_client_file=False)
