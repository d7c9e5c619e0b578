"""bnserve itself, in process: ``Model.predict`` and ``Model.predict_batch`` of a shipped model, h+ and hx, complex128.

Arguments: the model's name, and which modes: ``all`` or such as ``22,33``; else the (2, 2), as its peers have it.

Install: it is what this checkout installs; the benchmarks run it with their own interpreter.

    pip install .
"""

from __future__ import annotations

import os
import sys
import threading
import time
from typing import Any

from worker import Peer, draw, serve

from bnserve_surrogate import EvaluationOptions, Model, ParameterBatch, ParametersWithExtrinsic


class Bnserve(Peer):
    """The local model."""

    packages = ("bnserve-surrogate",)

    def __init__(self, name: str, modes: str = "22") -> None:
        self.name = f"bnserve {name}"
        self._model = Model.load(name)
        chosen = None if modes == "all" else tuple((int(mode[0]), int(mode[1])) for mode in modes.split(","))
        self._options = EvaluationOptions(modes=chosen)
        self.f_min = self._model.description.frequency_band[0]
        self._model.warm_up()

    def binary(self, parameters: dict[str, float]) -> ParametersWithExtrinsic:
        """Our dataclass."""
        return ParametersWithExtrinsic(**parameters)

    def waveform(self, grid: Any, binary: Any) -> Any:
        """Plus and cross polarisations."""
        return self._model.predict(grid, binary, options=self._options)

    def binaries(self, rows: list[dict[str, float]]) -> ParameterBatch:
        """A struct of arrays."""
        return ParameterBatch.coerce([self.binary(row) for row in rows])

    def batch(self, grid: Any, binaries: Any) -> Any:
        """All rows in one call."""
        return self._model.predict_batch(grid, binaries, options=self._options)

    def threads(self, request: dict[str, Any]) -> dict[str, Any]:
        """Seconds that the threads on each of ``cpus`` take for ``calls`` batches, all begun at the same moment.

        Each thread stays on its processor: left to itself, the system may keep both on one for longer than this takes.
        """
        grid = self.grid(request["points"])
        rows = self.binaries([draw(seed) for seed in range(request["rows"])])
        barrier = threading.Barrier(len(request["cpus"]))
        seconds: list[float] = []

        def work(cpu: int) -> None:
            os.sched_setaffinity(0, {cpu})
            self.batch(grid, rows)
            barrier.wait()
            begun = time.perf_counter()
            for _ in range(request["calls"]):
                self.batch(grid, rows)
            seconds.append(time.perf_counter() - begun)

        workers = [threading.Thread(target=work, args=(cpu,)) for cpu in request["cpus"]]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        return {"seconds": seconds}


if __name__ == "__main__":
    peer = Bnserve(*sys.argv[1:])
    serve(peer, {"threads": peer.threads})
