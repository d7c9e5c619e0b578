"""What concerns whole processes: the first waveform of a fresh one, the memory of a server, two threads against one."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

from bnserve_protocol import BnserveError, WaveformModel
from bnserve_service.bench.binaries import Questions

_FIRST = """
import sys, time
import numpy as np
from bnserve_surrogate import Model, ParametersWithExtrinsic
imported = time.monotonic()
model = Model.load(sys.argv[1], sys.argv[2], sys.argv[3] or None)
loaded = time.monotonic()
model.predict(np.linspace(20.0, 2000.0, 277), ParametersWithExtrinsic.gw170817())
print(imported, loaded, time.monotonic())
"""


class ProcessFailed(BnserveError):
    """A process that was to be measured ended with an error."""

    code = "process-failed"
    title = "A measured process failed"


def first_waveform(name: str, version: str, store: Path | None, repetitions: int) -> dict[str, float]:
    """Seconds from the start of an interpreter until imports, the model, and the first waveform were there: medians."""
    # -P: no module of the current directory can take the place of an installed one.
    command = [sys.executable, "-P", "-c", _FIRST, name, version, str(store or "")]
    found = []
    for repetition in range(repetitions + 1):
        started = time.monotonic()  # the same clock in every process
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            last = (done.stderr.strip().splitlines() or ["no message"])[-1]
            raise ProcessFailed(f"A fresh process could not compute a waveform: {last}")
        if repetition > 0:  # the first one reads the files from the disk
            found.append([float(moment) - started for moment in done.stdout.split()])
    imported, loaded, finished = (median(column) for column in zip(*found, strict=True))
    return {"imported": imported, "loaded": loaded, "first_waveform": finished}


def resident_bytes(process_id: int) -> int | None:
    """Memory that a process has in use; None where the system does not tell."""
    try:
        status = Path(f"/proc/{process_id}/status").read_text(encoding="utf-8")
    except OSError:
        return None
    return next((1024 * int(line.split()[1]) for line in status.splitlines() if line.startswith("VmRSS:")), None)


def server_memory() -> dict[str, Any] | None:
    """Bytes of a ``bnserve serve`` after single requests and a batch; None where the system does not tell."""
    from bnserve_client import Model
    from bnserve_service.demo.server_process import ServerProcess

    with ServerProcess() as server, Model.connect(server.address) as model:
        questions = Questions(model.description)
        for seed in range(100):
            model.predict(questions.grid(277), questions.binary(seed))
        model.predict_batch(questions.grid(277), questions.batch(256))
        found = resident_bytes(server.process_id)
    return None if found is None else {"bytes": found}


def threads_against_one(model: WaveformModel, questions: Questions, threads: int, repetitions: int) -> dict[str, Any]:
    """How many times as many rows several threads compute as one thread: batches of 256 x 1,000, medians."""
    grid, batch = questions.grid(1_000), questions.batch(256)
    work: Callable[[], object] = partial(model.predict_batch, grid, batch)
    work()
    ratios = []
    for _ in range(repetitions):
        one, several = (_seconds(work, count) for count in (1, threads))
        ratios.append(threads * one / several)
    return {"threads": threads, "speedup": median(ratios)}


def _seconds(work: Callable[[], object], threads: int, calls: int = 6) -> float:
    """Seconds until every thread has made its calls."""

    def repeat() -> None:
        for _ in range(calls):
            work()

    workers = [threading.Thread(target=repeat) for _ in range(threads)]
    started = time.perf_counter()
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return time.perf_counter() - started
