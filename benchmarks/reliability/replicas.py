"""Servers that are killed and come back at the same address."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from benchmarks.reliability import serving
from benchmarks.servers import ServerFailed
from benchmarks.workers import ONE_THREAD, ROOT
from tests.running_server import TIMEOUT, free_port, is_ready


class Replica:
    """One ``bnserve serve`` at one port; its processes come and go.

    Parameters
    ----------
    folder:
        For what it prints.
    *arguments:
        Of the command line.
    """

    def __init__(self, folder: Path, *arguments: str) -> None:
        self.port = free_port()
        self.url = f"http://127.0.0.1:{self.port}"
        self._arguments = arguments
        self._log = folder / f"replica-{self.port}.log"
        self._process: subprocess.Popen[bytes] | None = None

    @property
    def address(self) -> tuple[str, int]:
        """Host and port."""
        return "127.0.0.1", self.port

    @property
    def pid(self) -> int:
        """Of the process that runs now."""
        assert self._process is not None, "a replica is started before it is asked"
        return self._process.pid

    def start(self) -> None:
        """Start it, without waiting until it is ready."""
        program, *options = serving.PROGRAM
        command = [sys.executable, "-m", program, "serve", "--port", str(self.port), *options, *self._arguments]
        with self._log.open("ab") as output:
            self._process = subprocess.Popen(
                command, stdout=output, stderr=subprocess.STDOUT, env=os.environ | ONE_THREAD, cwd=ROOT
            )

    def kill(self) -> None:
        """As ``kill -9`` does."""
        if self._process is not None:
            self._process.send_signal(signal.SIGKILL)
            self._process.wait()

    def is_ready(self) -> bool:
        """Whether it says so."""
        return is_ready(self.url)

    def wait(self) -> None:
        """Return when it is ready.

        Raises
        ------
        ServerFailed
        """
        until = time.monotonic() + TIMEOUT
        while not self.is_ready():
            assert self._process is not None, "a replica is started before it is waited for"
            if self._process.poll() is not None or time.monotonic() > until:
                raise ServerFailed(f"A server did not become ready:\n{self._log.read_text()[-2000:]}")
            time.sleep(0.1)


@contextmanager
def replicas(folder: Path, count: int, *arguments: str) -> Iterator[list[Replica]]:
    """Several, ready; killed at the end."""
    made = [Replica(folder, *arguments) for _ in range(count)]
    try:
        for replica in made:
            replica.start()
        for replica in made:
            replica.wait()
        yield made
    finally:
        for replica in made:
            with suppress(ProcessLookupError):
                replica.kill()
