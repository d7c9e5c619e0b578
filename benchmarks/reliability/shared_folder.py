"""A server whose workers lose what they share is unready at once and whole again in seconds; our client loses nothing.

Somebody removes the folder in /dev/shm that the workers of a server share, as systemd does when a user logs out, while
samplers ask on uploaded grids, and grids are uploaded.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from benchmarks.reliability.asking import exchange, metric, status_of
from benchmarks.reliability.callers import Callers, Task
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving

MECHANISM = """Every worker says that it is unready while the folder is not there, and answers what needs it with
503 and Retry-After; our client asks again, and uploads what is not known. The supervisor looks for the folder five
times a second; when it is gone, or another, it makes a new one, and replaces the workers by others that have that
one, while those before finish what they have."""
BAR = "unready <= 0.5 s, all workers replaced and ready <= 10 s, lost 0, wrong 0, no upload answered with 500"
INJECTED_FAULTS = {"no-look": "the supervisor takes the folder for there"}

WORKERS = 2
UNREADY, WHOLE = 0.5, 10.0
_INJECTED = """
from bnserve_service.shared.folder import SharedFolder

SharedFolder.is_there = lambda self: True
"""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes two minutes."""
    times, count, pause = (1, 4, 1.0) if short else (12, 12, 3.0)
    options = {"timeout": 10.0 if injected else 60.0}
    unready: list[float] = []
    whole: list[float] = []
    statuses: list[int] = []
    with _environment(injected) as environment:
        serve = serving(
            "--model", "default", "--workers", str(WORKERS), "--workers-threads", "1", environment=environment
        )
        with serve as server, Callers([server.url] * count, Task(options=options, pause=0.01)) as callers:
            for number in range(times):
                time.sleep(pause)
                workers = server.workers()
                shutil.rmtree(_folder(server))
                removed = time.monotonic()
                unready.append(_seconds_until(lambda: status_of(server.address, "/v2/health/ready") == 503, removed))
                statuses += [_upload(server, 10 * number + each) for each in range(3)]
                whole.append(_seconds_until(lambda: _is_whole(server, workers), removed))  # noqa: B023  # at once
                statuses.append(_upload(server, 10 * number + 9))
                log(f"{number + 1}/{times}: unready after {unready[-1]:.3f} s, whole after {whole[-1]:.1f} s")
    found = callers.log
    figures: Figures = {
        "folders removed": times,
        "unready, s, longest": max(unready),
        "all workers replaced and ready, s, longest": max(whole),
        "samplers": count,
        "uploads answered with 500": statuses.count(500),
        "uploads kept when all was whole": sum(status == 201 for status in statuses[3::4]),
    }
    figures |= found.figures()
    passed = (
        max(unready) <= UNREADY
        and max(whole) <= WHOLE
        and found.lost == found.wrong == 0 < found.right
        and 500 not in statuses
        and statuses[3::4] == times * [201]
    )
    summary = (
        f"{times} folders removed under {found.asked:,} requests: unready within {max(unready):.2f} s, whole within "
        f"{max(whole):.1f} s, lost {found.lost}, wrong {found.wrong}, {statuses.count(500)} uploads answered with 500"
    )
    return Outcome(figures, passed, summary)


@contextlib.contextmanager
def _environment(injected: str | None) -> Iterator[dict[str, str]]:
    """What a server with the fault needs: every process of it is a program of its own."""
    with tempfile.TemporaryDirectory() as folder:
        if injected is None:
            yield {}
            return
        (Path(folder) / "sitecustomize.py").write_text(_INJECTED)
        yield {"PYTHONPATH": os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")])}


def _folder(server: Server) -> Path:
    """The folder that the workers share: the supervisor has a file open in it."""
    for descriptor in Path(f"/proc/{server.pid}/fd").iterdir():
        with contextlib.suppress(OSError):
            file = descriptor.readlink()
            if file.name == "alive":
                return file.parent
    raise FileNotFoundError("the supervisor has no folder")


def _is_whole(server: Server, before: set[int]) -> bool:
    """Whether all workers are others, and ready."""
    workers = server.workers()
    if workers & before or len(workers) != WORKERS:
        return False
    return metric(server.address, "bnserve_workers_serving") == WORKERS


def _seconds_until(condition: Callable[[], bool], since: float) -> float:
    """Seconds until something is so, twice :data:`WHOLE` at the most."""
    while not condition() and time.monotonic() - since < 2.0 * WHOLE:
        time.sleep(0.02)
    return time.monotonic() - since


def _upload(server: Server, number: int) -> int:
    """The status of the upload of a new grid."""
    body = np.linspace(20.0 + number, 2000.0, 100).tobytes()
    head = (
        f"PUT /v1/grids/{hashlib.sha256(body).hexdigest()} HTTP/1.1\r\nhost: localhost\r\nconnection: close\r\n"
        f"content-length: {len(body)}\r\n\r\n"
    )
    return exchange(server.address, head.encode() + body).status
