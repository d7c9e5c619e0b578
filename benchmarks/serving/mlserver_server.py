"""MLServer 1.7 over gRPC, with its adaptive batching.

Install:

    python3.11 -m venv $SERVING/mlserver
    $SERVING/mlserver/bin/pip install mlserver==1.7.1 "tritonclient[grpc]" ./protocol ./model_store ./surrogate
"""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from application import GRIDS, PARAMETERS, Waveforms
from mlserver import MLModel, MLServer, ModelSettings, Settings
from mlserver.codecs import NumpyCodec
from mlserver.settings import ModelParameters
from mlserver.types import InferenceRequest, InferenceResponse


class WaveformRuntime(MLModel):
    """Its name ends with the number of points; two real numbers for each complex one."""

    async def load(self) -> bool:
        """Load the model."""
        self._waveforms = Waveforms()
        self._points = int(self.name.rpartition("_")[2])
        return True

    async def predict(self, payload: InferenceRequest) -> InferenceResponse:
        """Evaluate one request, or several that MLServer has put together."""
        values = NumpyCodec.decode_input(payload.inputs[0]).reshape(-1, PARAMETERS)
        h = self._waveforms.evaluate(self._points, np.ascontiguousarray(values, dtype=np.float64))
        output = NumpyCodec.encode_output("h", h.view(np.float64))
        return InferenceResponse(model_name=self.name, outputs=[output])


async def main(port: int) -> None:
    """Serve until told to stop."""
    server = MLServer(Settings(host="127.0.0.1", http_port=port, grpc_port=port + 1, parallel_workers=0, debug=False,
                               metrics_endpoint=None, grpc_max_message_length=2**28))  # fmt: skip
    models = [
        ModelSettings(
            name=f"waveforms_{points}",
            implementation=WaveformRuntime,
            parameters=ModelParameters(uri="."),
            max_batch_size=32,
            max_batch_time=0.0005,
        )
        for points in GRIDS
    ]
    await server.start(models)


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1])))
