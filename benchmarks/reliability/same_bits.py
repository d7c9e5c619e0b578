"""The same question has the same bits."""

from __future__ import annotations

import hashlib
import json
import tempfile
import urllib.request
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.questions import EXPLICIT, UNIFORM, Questions
from benchmarks.reliability.serving import Server, serving
from benchmarks.reliability.stores import NAME, Versions
from bnserve_client import Model
from bnserve_protocol import GridLike, ParameterBatch
from bnserve_surrogate import Model as LocalModel

MECHANISM = (
    "The kernel evaluates one row at a time in vectors of fixed size, so that neither the batch around a row nor the "
    "number of threads reaches its bits; workers and replicas run the same code on the same tensors. Every row of a "
    "ring of binaries is asked for in batches of every size and at every place in them."
)
BAR = "one digest per (model, row): every batch size and position, threads, replicas, reloads, workers, local model"
INJECTED_FAULTS = {"batch-bits": "batches are rounded otherwise than single waveforms, as matrix libraries do it"}
_GRIDS: tuple[GridLike, ...] = (UNIFORM, EXPLICIT)


class Census:
    """The digests that each (model, grid, row) was seen with, and where."""

    def __init__(self) -> None:
        self.seen: defaultdict[tuple[str, int, int], set[bytes]] = defaultdict(set)
        self.rows = 0
        self.by_place: dict[str, int] = {}

    def add(self, model: Any, grid: int, ring: ParameterBatch, rows: list[int]) -> None:
        """Ask for some rows of the ring, in one batch."""
        answer = model.predict_batch(_GRIDS[grid], ParameterBatch(ring.values[rows]))
        for place, row in enumerate(rows):
            digest = hashlib.sha256(answer.plus[place].tobytes() + answer.cross[place].tobytes()).digest()
            self.seen[model.description.digest, grid, row].add(digest)
        self.rows += len(rows)

    @property
    def torn(self) -> int:
        """How many have more than one."""
        return sum(len(digests) > 1 for digests in self.seen.values())


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Ask everybody for the same rows in every way."""
    size = 9 if short else 33
    census = Census()
    with tempfile.TemporaryDirectory() as folder:
        store = Versions(Path(folder), "default")
        store.publish("1.0.0")
        local = LocalModel.load(NAME, version="1.0.0", store=store.folder)
        ring = Questions(local, seed=20170817).batch(size)
        for name, model, together in _places(short, store, local, injected):
            before = census.torn
            _ask_all(census, model, ring, together)
            log(f"{name}: {census.torn - before} rows with another digest than before")
            census.by_place[name] = census.torn - before
    figures: Figures = {"rows asked": census.rows, "keys": len(census.seen), "keys with two digests": census.torn}
    figures |= {f"new digests: {name}": count for name, count in census.by_place.items()}
    summary = (
        f"{len(census.seen)} rows in every batch size up to {size} and every position, asked {census.rows:,} times in "
        f"{len(census.by_place)} places: {census.torn} with two digests"
    )
    return Outcome(figures, census.torn == 0, summary)


def _ask_all(census: Census, model: Any, ring: ParameterBatch, together: int) -> None:
    """Every batch size, at every place of the ring; several requests at once where ``together`` says so."""
    count = len(ring)
    batches = [
        [(start + step) % count for step in range(rows)] for rows in range(1, count + 1) for start in range(count)
    ]
    order = np.random.default_rng(1).permutation(len(batches))
    tasks = [(index % len(_GRIDS), batches[index]) for index in order]
    if together == 1:
        for grid, rows in tasks:
            census.add(model, grid, ring, rows)
        return
    with ThreadPoolExecutor(together) as threads:
        list(threads.map(lambda task: census.add(model, task[0], ring, task[1]), tasks))


def _places(short: bool, store: Versions, local: LocalModel, injected: str | None) -> Iterator[tuple[str, Any, int]]:
    """Where to ask: a name, a model, and how many requests at once."""
    yield "local model", local, 1
    settings: dict[str, dict[str, Any]] = {"1 thread": {"threads": 1}, "4 threads": {"threads": 4}}
    if not short:
        settings |= {"another replica": {"threads": 2}, "2 workers": {"workers": 2, "threads": 2}}
    for name, options in settings.items():
        with _connected(store, injected, options) as (server, model):
            yield name, model, 1
            yield f"{name}, 8 requests at once", model, 8
            if name == "4 threads":
                _reload(store, server)
                with Model.connect(server.url, NAME, version="1.0.0") as again:
                    yield "after a reload", again, 1


@contextmanager
def _connected(store: Versions, injected: str | None, options: dict[str, Any]) -> Iterator[tuple[Server, Model]]:
    with ExitStack() as stack:
        server = stack.enter_context(
            serving("--store", str(store.folder), "--model", NAME, injected=injected, poll_seconds=0.1, **options)
        )
        yield server, stack.enter_context(Model.connect(server.url, NAME, version="1.0.0"))


def _reload(store: Versions, server: Server) -> None:
    """Publish and serve another version, and read the first one anew."""
    store.publish("1.0.1", shipped="fast")
    request = urllib.request.Request(f"{server.url}/v1/reload", method="POST")
    with urllib.request.urlopen(request, timeout=60) as answer:
        json.load(answer)
