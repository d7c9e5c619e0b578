"""PyTriton 0.7 (Triton 2.51): dynamic batching, raw numbers in and out; two real numbers for each complex one.

Install:

    python3.11 -m venv $SERVING/pytriton
    $SERVING/pytriton/bin/pip install nvidia-pytriton==0.7.0 "numpy<2" "msgspec>=0.19" "llvmlite>=0.48" "crc32c>=2.7"
    $SERVING/pytriton/bin/pip install "safetensors>=0.4"
    $SERVING/pytriton/bin/pip install --no-deps --ignore-requires-python ./protocol ./model_store ./surrogate

(PyTriton wants numpy 1, which evaluating a model happens to work with.)
"""

from __future__ import annotations

import os
import sys
import sysconfig
from typing import Any

import numpy as np
from application import GRIDS, PARAMETERS, Waveforms


def find_own_library() -> None:
    """Start again with the running interpreter's own library first: Triton's helper would load the system's Python."""
    folder = sysconfig.get_config_var("LIBDIR")
    path = os.environ.get("LD_LIBRARY_PATH", "")
    if path.split(os.pathsep)[0] != folder:
        environment = os.environ | {"LD_LIBRARY_PATH": os.pathsep.join([folder, path])}
        os.execve(sys.executable, [sys.executable, *sys.argv], environment)


def main(port: int) -> None:
    """Serve until told to stop."""
    from pytriton.decorators import batch
    from pytriton.model_config import DynamicBatcher, ModelConfig, Tensor
    from pytriton.triton import Triton, TritonConfig

    waveforms = Waveforms()
    config = TritonConfig(http_port=port, grpc_port=port + 1, allow_metrics=False, http_address="127.0.0.1")
    with Triton(config=config) as triton:
        for points in GRIDS:

            @batch
            def evaluate(values: Any, points: int = points) -> dict[str, Any]:
                return {"h": waveforms.evaluate(points, values).view(np.float64)}

            triton.bind(
                model_name=f"waveforms_{points}",
                infer_func=evaluate,
                inputs=[Tensor(name="values", dtype=np.float64, shape=(PARAMETERS,))],
                outputs=[Tensor(name="h", dtype=np.float64, shape=(2 * points,))],
                config=ModelConfig(max_batch_size=256, batcher=DynamicBatcher(max_queue_delay_microseconds=0)),
            )
        triton.serve()


if __name__ == "__main__":
    find_own_library()
    main(int(sys.argv[1]))
