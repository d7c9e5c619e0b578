"""``python -m benchmarks.reliability.cpu_worker CPU``: the default model with machine code for another processor.

CPU is a name of LLVM's, such as ``x86-64-v3``, or ``host``. A worker of :mod:`benchmarks.workers`.
"""

from __future__ import annotations

import json
import sys
from typing import Any

import numpy as np

from bnserve_protocol import GridLike, ParameterBatch, UniformGrid
from bnserve_surrogate import Model
from bnserve_surrogate.kernel import _loader

GRIDS: dict[str, GridLike] = {
    "short": np.geomspace(20.0, 2000.0, 277),
    "long": UniformGrid(20.0, 2020.0, 0.5),
}
"""Below 2,048 frequencies each is evaluated by itself, above in cells of the band."""


def binaries(model: Model, rows: int) -> ParameterBatch:
    """Binaries all over the trained box, the same in every process."""
    draw = np.random.Generator(np.random.PCG64(1))
    columns = {}
    for entry in model.description.parameters:
        low, high = entry.minimum, entry.maximum
        if entry.name == "total_mass" and model.description.frequency_band_masses:
            low, high = model.description.frequency_band_masses
        columns[entry.name] = draw.uniform(-1.0 if low is None else low, 1.0 if high is None else high, rows)
    columns |= {"distance_mpc": draw.uniform(20.0, 400.0, rows), "inclination": draw.uniform(0.0, np.pi, rows)}
    columns["time_shift"] = draw.uniform(-0.01, 0.01, rows)
    return ParameterBatch.coerce(columns)


def main() -> None:
    """Answer ``{"do": "evaluate", "grid": ..., "rows": ..., "file": ...}`` by writing h of all modes there."""
    name = sys.argv[1]
    if name != "host":
        _loader.processor_at_hand = lambda: (name, "")
    model = Model.default()
    for line in sys.stdin:
        command: dict[str, Any] = json.loads(line)
        modes = model.predict_modes(GRIDS[command["grid"]], binaries(model, command["rows"])).h
        h = modes.reshape(-1, modes.shape[-1])
        np.save(command["file"], h)
        print(json.dumps({"shape": h.shape}), flush=True)


if __name__ == "__main__":
    main()
