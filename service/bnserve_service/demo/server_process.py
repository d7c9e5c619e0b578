"""``bnserve serve`` as a process of its own."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import threading
import time
from typing import IO, Self

from bnserve_protocol import BnserveError

TIMEOUT = 120.0
"""Seconds until a server that is not ready counts as broken; a cold start on a busy machine takes a few."""
DRAIN_TIMEOUT = 30.0
"""Seconds until a server that was told to stop is killed."""

# -P: no module of the current directory can take the place of an installed one.
_COMMAND = (sys.executable, "-P", "-m", "bnserve_service", "serve", "--port", "0")


class ServerFailed(BnserveError):
    """The server did not start, or did not end as it should."""

    code = "server-failed"
    title = "The server failed"


class ServerProcess:
    """A server of the shipped models on a free port: a context manager, ready when entered, stopped when left.

    Raises
    ------
    ServerFailed
        When entered: it ended, or was not ready in time; with the last lines that it logged.
    """

    def __init__(self) -> None:
        self.address = ""
        """What a client connects to."""
        self.seconds_to_start = 0.0
        """From the start of its interpreter until it was ready."""
        self.seconds_to_stop = 0.0
        """From SIGTERM until it had ended."""
        self.exit_code: int | None = None
        """0 after an orderly end."""

    @property
    def process_id(self) -> int:
        """The system's number of the process; once it has been entered."""
        return self._process.pid

    def __enter__(self) -> Self:
        started = time.perf_counter()
        self._log: IO[bytes] = tempfile.TemporaryFile()  # closed by stop()
        self._process = subprocess.Popen(_COMMAND, stdout=subprocess.PIPE, stderr=self._log, text=True)
        try:
            self._wait_until_ready()
        except BaseException:
            self.stop()
            raise
        self.seconds_to_start = time.perf_counter() - started
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def stop(self) -> None:
        """Send SIGTERM and wait for the end; a server that does not end is killed. Harmless when it has ended."""
        if self._log.closed:
            return
        started = time.perf_counter()
        self._process.terminate()
        try:
            self.exit_code = self._process.wait(DRAIN_TIMEOUT)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self.exit_code = self._process.wait()
        self.seconds_to_stop = time.perf_counter() - started
        assert self._process.stdout is not None
        self._process.stdout.close()
        self._log.close()

    def _wait_until_ready(self) -> None:
        """Read the announcements; the server's end, or ours of it, ends them."""
        assert self._process.stdout is not None
        watchdog = threading.Timer(TIMEOUT, self._process.kill)
        watchdog.daemon = True
        watchdog.start()
        try:
            for line in self._process.stdout:
                words = line.split()
                if words[:3] == ["bnserve", "listens", "on"]:
                    self.address = words[3]
                elif words[:3] == ["bnserve", "is", "ready:"]:
                    return
        finally:
            watchdog.cancel()
        raise ServerFailed(f"The server did not start. It logged:\n{self._last_lines()}")

    def _last_lines(self, count: int = 20) -> str:
        self._process.wait()
        self._log.seek(0)
        lines = self._log.read().decode(errors="replace").splitlines()
        return "\n".join(f"    {line}" for line in lines[-count:]) or "    nothing"
