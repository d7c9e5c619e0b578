"""What begins and what stays: the first waveform in a fresh process, and the memory of a process that serves."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from benchmarks.environments import find_python
from benchmarks.servers import bnserve_server
from benchmarks.speed.setup import Setup
from benchmarks.workers import ONE_THREAD
from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_protocol import ParameterBatch

_ASK = """
import time, numpy as np
from {module} import Model, ParametersWithExtrinsic
binary = ParametersWithExtrinsic(mass_ratio=1.2, lambda_1=400.0, lambda_2=600.0, chi_1=0.01, chi_2=0.0,
                                 distance_mpc=40.0, inclination=2.5, total_mass=2.8)
Model.default().predict(np.linspace(5.0, 2048.0, 277), binary)
print(time.monotonic())
"""
_ANEW = "bnserve without kept machine code"
_WHERE = {
    "bnserve": ("", "bnserve_surrogate"),
    _ANEW: ("", "bnserve_surrogate"),
    "mlgw_bns": ("mlgw_bns-0.12.1", "mlgw_bns"),
}


def first_waveform(setup: Setup, repetitions: int) -> dict[str, Any]:
    """Seconds from the start of an interpreter to the first waveform: median of processes that take turns.

    A process before them has left its machine code behind, as for every process but the first that a user starts.
    """
    pythons = {name: find_python(setup.peers, environment) for name, (environment, _) in _WHERE.items()}
    seconds: dict[str, list[float]] = {name: [] for name, python in pythons.items() if python}
    for repetition in range(repetitions + 1):
        for name, found in seconds.items():
            code = _ASK.format(module=_WHERE[name][1])
            caches = {"XDG_CACHE_HOME": os.devnull} if name == _ANEW else {}  # nothing can be kept there
            elapsed = _seconds_until_printed([str(pythons[name]), "-W", "ignore", "-c", code], caches)
            if repetition > 0:  # the first one reads files from the disk and leaves machine code
                found.append(elapsed)
    medians = {name: median(found) for name, found in seconds.items()}
    return {"value": medians.pop("bnserve"), "peers": medians}


def _seconds_until_printed(command: Sequence[str], also: dict[str, str]) -> float:
    started = time.monotonic()  # the same clock in every process
    environment = os.environ | ONE_THREAD | also
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return float(done.stdout.split()[-1]) - started


def worker_memory(setup: Setup) -> dict[str, Any]:
    """Resident megabytes of a server of ``default`` with one worker thread, after single requests and a batch."""
    grid = np.linspace(5.0, 2048.0, 277)
    one = ParametersWithExtrinsic.gw170817()
    with bnserve_server(cpus=setup.cpus, threads=1) as (url, pid), Model.connect(url) as model:
        for _ in range(200):
            model.predict(grid, one)
        model.predict_batch(grid, ParameterBatch.coerce([one] * 256))
        return {"value": resident_megabytes(pid), "peers": {}}


def resident_megabytes(pid: int) -> float:
    """What the system says that a process has in memory, in units of 10^6 bytes."""
    status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    line = next(line for line in status.splitlines() if line.startswith("VmRSS:"))
    return int(line.split()[1]) * 1024 / 1e6
