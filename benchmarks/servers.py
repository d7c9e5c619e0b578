"""Servers of this checkout as processes: bnserve, and the bare uvicorn that is the floor."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from benchmarks.workers import ONE_THREAD, ROOT
from bnserve_client import Model
from bnserve_protocol import BnserveError
from bnserve_service.bench.load import open_connection
from tests.running_server import free_port

TIMEOUT = 60.0
"""Seconds until a server that is not ready counts as broken."""


class ServerFailed(BnserveError):
    """A server did not start."""

    code = "server-failed"
    title = "The server failed"


@contextmanager
def running(
    command: Sequence[str | Path],
    is_ready: Callable[[], bool],
    *,
    cpus: set[int] | None = None,
    environment: dict[str, str] | None = None,
    timeout: float = TIMEOUT,
) -> Iterator[int]:
    """Start a server in a process group of its own, wait until it answers, yield its number, and stop all of it.

    Raises
    ------
    ServerFailed
        It ended, or was not ready in time; with the last lines of its output.
    """
    with tempfile.TemporaryFile() as log:
        process = subprocess.Popen(
            [str(part) for part in command],
            stdout=log,
            stderr=subprocess.STDOUT,
            cwd=ROOT,
            env=os.environ | ONE_THREAD | (environment or {}),
            process_group=0,
        )
        if cpus is not None:
            os.sched_setaffinity(process.pid, cpus)
        try:
            deadline = time.monotonic() + timeout
            while not is_ready():
                if process.poll() is not None or time.monotonic() > deadline:
                    log.seek(0)
                    lines = log.read().decode(errors="replace").splitlines()[-15:]
                    raise ServerFailed("\n    ".join([f"{command[0]} did not start:", *lines]))
                time.sleep(0.1)
            yield process.pid
        finally:
            _stop(process)


def _stop(process: subprocess.Popen[bytes]) -> None:
    """End a process in good order, and then whatever else is left of its group."""
    process.terminate()
    with suppress(subprocess.TimeoutExpired):
        process.wait(40.0)
    with suppress(ProcessLookupError):
        os.killpg(process.pid, 9)
    process.wait()


def listens(address: tuple[str, int]) -> bool:
    """Whether something accepts connections there."""
    try:
        open_connection(address).close()
    except OSError:
        return False
    return True


def _answers(url: str) -> bool:
    try:
        Model.connect(url, retries=0, timeout=5.0).close()
    except BnserveError:
        return False
    return True


@contextmanager
def bnserve_server(*, cpus: set[int] | None = None, threads: int | None = None) -> Iterator[tuple[str, int]]:
    """``bnserve serve --model default``; yields what a client connects to, and the process number."""
    port = free_port()
    url = f"http://127.0.0.1:{port}"
    command = [sys.executable, "-m", "bnserve_service", "serve", "--model", "default", "--port", str(port)]
    command += ["--workers-threads", str(threads)] if threads else []
    with running(command, lambda: _answers(url), cpus=cpus) as pid:
        yield url, pid


@contextmanager
def bare_server(sizes: Sequence[int], *, cpus: set[int] | None = None) -> Iterator[tuple[str, int]]:
    """The floor; yields its host and port."""
    address = ("127.0.0.1", free_port())
    command = [sys.executable, "-m", "benchmarks.bare_server", "--port", str(address[1])]
    command += [str(size) for size in sorted(set(sizes))]
    with running(command, lambda: listens(address), cpus=cpus):
        yield address
