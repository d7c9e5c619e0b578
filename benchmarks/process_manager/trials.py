"""What the promises do not measure, and a manager of processes decides."""

from __future__ import annotations

import os
import signal
import tempfile
import time
from pathlib import Path

from benchmarks.reliability.asking import metric, status_of
from benchmarks.reliability.serving import Server, resident, serving
from benchmarks.reliability.stores import NAME, Versions

WORKERS = 4
PAUSE = 8.0
SLOW_STORE = 12.0
"""Seconds that a store takes to hand out the second version, as a bucket does that is far away."""
_PLANTED = f"""
import time
from bnserve_store import ModelStore

sound = ModelStore.load

def load(self, name, version):
    time.sleep({SLOW_STORE} if version == "0.0.1" else 0.0)
    return sound(self, name, version)

ModelStore.load = load
"""


def paused(times: int = 6) -> str:
    """All processes of a server stop for a while, as when a machine is suspended or a container is frozen."""
    lost = []
    with serving("--workers", str(WORKERS), "--workers-threads", "1") as server:
        before = _whole(server, set())
        size, largest = resident(server.pid) / 2**20, max(map(resident, before)) / 2**20
        for number in range(times):
            everybody = server.processes()
            for pid in everybody:
                os.kill(pid, signal.SIGSTOP)
            time.sleep(PAUSE)
            for pid in everybody[:: 1 if number % 2 else -1]:
                os.kill(pid, signal.SIGCONT)
            time.sleep(3.0)
            after = _whole(server, set())
            lost.append(len(before - after))
            before = after
    return (
        f"of {WORKERS} workers killed after {PAUSE:.0f} s of pause: {lost}; "
        f"the process that all depend on has {size:.0f} MiB, a worker {largest:.0f} MiB"
    )


def published() -> str:
    """A worker dies after a version was published that takes the store long to hand out."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "sitecustomize.py").write_text(_PLANTED)
        versions = Versions(Path(folder) / "store")
        versions.publish("0.0.0")
        path = os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")])
        options = "--store", str(versions.folder), "--model", NAME, "--workers", "2", "--workers-threads", "1"
        with serving(*options, environment={"PYTHONPATH": path}) as server:
            _whole(server, set(), 2)
            versions.publish("0.0.1")
            while {status_of(server.address, f"/v1/models/{NAME}/versions/0.0.1") for _ in range(20)} != {200}:
                time.sleep(0.5)
            time.sleep(SLOW_STORE)  # whoever else wants to know the new version has it now
            victim = min(_whole(server, set(), 2))
            began = time.monotonic()
            os.kill(victim, signal.SIGKILL)
            _whole(server, {victim}, 2)
            return f"a killed worker is replaced after {time.monotonic() - began:.1f} s"


def _whole(server: Server, gone: set[int], count: int = WORKERS) -> set[int]:
    """Wait until all are there and serve, without those that are gone."""
    while len(found := server.workers() - gone) != count or metric(server.address, "bnserve_workers_serving") != count:
        time.sleep(0.1)
    return found
