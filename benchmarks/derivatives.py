"""What derivatives cost beside the waveform: ``python -m benchmarks.derivatives``.

CPU time of one thread, a batch of 256 binaries; the median of several rounds, in which both take turns.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from bnserve_protocol import EvaluationOptions, ParameterBatch
from bnserve_surrogate import Model

_ROWS = 256
_CHOICES = {"(2, 2)": ((2, 2),), "all modes": None}


def _batch(model: Model) -> ParameterBatch:
    random, values = np.random.default_rng(1), ParameterBatch.one(model.typical_binary()).values.repeat(_ROWS, axis=0)
    batch = ParameterBatch(values)
    for entry in model.description.parameters:
        if entry.minimum is not None and entry.maximum is not None and entry.name != "total_mass":
            batch[entry.name][:] = random.uniform(entry.minimum, entry.maximum, _ROWS)
    batch["total_mass"][:] = random.uniform(2.4, 3.4, _ROWS)
    return batch


def _seconds(call: Callable[[], Any]) -> float:
    started = time.process_time()
    call()
    return time.process_time() - started


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.derivatives", description=__doc__.splitlines()[0])
    parser.add_argument("--model", default="default", help="(default)")
    parser.add_argument("--rounds", type=int, default=15, help="(15)")
    options = parser.parse_args(arguments)
    model = Model.load(options.model)
    batch = _batch(model)
    print(f"{model.description.name} {model.description.version}, 256 binaries, us a waveform, CPU time, one thread\n")
    print("| modes | points | waveform | with derivatives | ratio | as polarisations, 22 arrays | ratio |")
    print("|---|---|---|---|---|---|---|")
    for label, modes in _CHOICES.items():
        for points in (277, 1000):
            f, asked = np.geomspace(5.0, 2000.0, points), EvaluationOptions(modes=modes)
            calls = (
                lambda f=f, asked=asked: model.predict_modes(f, batch, options=asked),
                lambda f=f, asked=asked: model.predict_derivatives(f, batch, options=asked),
                lambda f=f, asked=asked: model.predict_derivatives(f, batch, options=asked).polarizations(),
            )
            rounds = np.array([[_seconds(call) for call in calls] for _ in range(options.rounds)])
            plain, both, whole = 1e6 / _ROWS * np.median(rounds, axis=0)
            print(
                f"| {label} | {points} | {plain:.1f} | {both:.1f} | {both / plain:.1f} | {whole:.1f} | "
                f"{whole / plain:.1f} |"
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
