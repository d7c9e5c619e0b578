"""The measurements: one function for each thing that can grow."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import partial
from statistics import median
from typing import Any

import numpy as np

from benchmarks.peers.worker import draw
from benchmarks.servers import bnserve_server
from benchmarks.speed.clients import encoded_body, upload_grid
from benchmarks.speed.fresh import resident_megabytes
from benchmarks.speed.remote import batch_of, grid_of
from bnserve_service.bench.load import Target, answers_per_second
from bnserve_service.bench.timing import seconds_of, shuffled, timed
from bnserve_store import ModelStore
from bnserve_surrogate import Model, ParameterBatch, ParametersWithExtrinsic

BYTES_PER_SAMPLE = 32
"""h+ and hx, complex128."""
GRID = 277


def write(size: int) -> Callable[[], object]:
    """Do nothing but write as many fresh bytes as an answer has: what no evaluation can be faster than."""

    def fill() -> None:
        np.empty(size // 8).fill(1.0)

    return fill


def grow_batch(rows: Sequence[int], epochs: int) -> list[dict[str, Any]]:
    """Batches of one size after another on 277 points."""
    model = _model()
    grid = grid_of(GRID)
    return _against_writing(
        rows, lambda count: partial(model.predict_batch, grid, batch_of(count)), lambda count: count * GRID, epochs
    )


def grow_grid(points: Sequence[int], epochs: int) -> list[dict[str, Any]]:
    """One waveform on one grid after another."""
    model = _model()
    row: ParameterBatch = batch_of(1)
    return _against_writing(
        points, lambda count: partial(model.predict_batch, grid_of(count), row), lambda count: count, epochs
    )


def _model() -> Model:
    model = Model.default()
    model.warm_up()
    return model


def _against_writing(
    sizes: Sequence[int],
    call: Callable[[int], Callable[[], object]],
    samples: Callable[[int], int],
    epochs: int,
) -> list[dict[str, Any]]:
    cases: dict[Any, Callable[[], Sequence[float]]] = {}
    for size in sizes:
        calls = max(1, min(20, 200_000 // samples(size)))
        cases["evaluate", size] = timed(call(size), calls)
        cases["write", size] = timed(write(BYTES_PER_SAMPLE * samples(size)), calls)
    found = {case: median(values) for case, values in shuffled(cases, epochs).items()}
    return [
        {
            "size": size,
            "samples": samples(size),
            "seconds": found["evaluate", size],
            "seconds_to_write": found["write", size],
        }
        for size in sizes
    ]


def grow_clients(clients: Sequence[int], seconds: float) -> list[dict[str, Any]]:
    """More and more clients that each ask for one waveform after another over HTTP."""
    with bnserve_server() as (url, pid):
        grid, target = upload_grid(url, GRID), Target.parse(url)
        requests = [encoded_body(grid, batch_of(1, seed)) for seed in range(max(clients))]
        found = []
        for count in clients:
            answers_per_second(target, requests[:count], min(0.3, seconds))
            rate = answers_per_second(target, requests[:count], seconds)
            found.append(
                {"size": count, "rows_per_second": rate, "seconds": count / rate, "megabytes": resident_megabytes(pid)}
            )
    return found


def grow_models(counts: Sequence[int], epochs: int) -> list[dict[str, Any]]:
    """More and more copies of the model in one process, asked in turns, so that each has left the caches meanwhile."""
    store, grid, binary = ModelStore.default(), grid_of(GRID), ParametersWithExtrinsic(**draw(0))
    models: list[Model] = []
    found = []
    for count in counts:
        while len(models) < count:
            models.append(Model.from_artifact(store.load("default")))
            models[-1].predict(grid, binary)
        rounds: list[float] = []
        for _ in range(epochs):
            rounds += seconds_of(lambda: [model.predict(grid, binary) for model in models], max(1, 64 // count))
        found.append({"size": count, "seconds": median(rounds) / count, "megabytes": resident_megabytes(os.getpid())})
    return found
