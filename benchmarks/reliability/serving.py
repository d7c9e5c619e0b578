"""Servers of this checkout as processes, as their operators start them, sound or with a fault injected."""

from __future__ import annotations

import contextlib
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.workers import ONE_THREAD, ROOT
from tests.running_server import is_ready, running

PROGRAM: list[str] = ["bnserve_service"]
"""What every server runs, and the first of its arguments; another manager of processes has another."""

_PAGE = resource.getpagesize()
_TICKS = os.sysconf("SC_CLK_TCK")


@dataclass(frozen=True, slots=True)
class Server:
    """A running ``bnserve serve``."""

    url: str
    process: subprocess.Popen[bytes]
    log: Path
    """What it prints."""

    @property
    def address(self) -> tuple[str, int]:
        """Host and port."""
        host, _, port = self.url.removeprefix("http://").rpartition(":")
        return host, int(port)

    @property
    def pid(self) -> int:
        """Its process number."""
        return self.process.pid

    def processes(self) -> list[int]:
        """Its own number and those of the processes that it has started, and they."""
        found, known = [], [self.pid]
        while known:
            found.append(known.pop())
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has just ended
                for task in Path(f"/proc/{found[-1]}/task").iterdir():
                    known += [int(child) for child in (task / "children").read_text().split()]
        return found

    def workers(self) -> set[int]:
        """The numbers of its worker processes, when it has several."""
        found = set()
        for pid in self.processes():
            with contextlib.suppress(OSError):  # it has just ended
                if Path(f"/proc/{pid}/comm").read_text().startswith("bnserve-work"):
                    found.add(pid)
        return found

    def rss(self) -> int:
        """Resident memory of all its processes, bytes; what they share counts for each."""
        return sum(resident(pid) for pid in self.processes())

    def fds(self) -> int:
        """Open files and connections of all its processes."""
        return sum(len(list(Path(f"/proc/{pid}/fd").iterdir())) for pid in self.processes())

    def cpu_seconds(self) -> float:
        """Processor time that its processes have used."""
        stats = [Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split() for pid in self.processes()]
        return sum(int(fields[11]) + int(fields[12]) for fields in stats) / _TICKS

    def stop(self, timeout: float = 60.0) -> int:
        """Send SIGTERM and wait; the exit status."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout)


def resident(pid: int) -> int:
    """Resident memory of a process, bytes."""
    return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * _PAGE


@contextmanager
def serving(
    *arguments: str,
    injected: str | None = None,
    cpus: set[int] | None = None,
    environment: dict[str, str] | None = None,
    port: int = 0,
    **settings: Any,
) -> Iterator[Server]:
    """Start ``bnserve serve``, wait until it is ready, and end it afterwards if it still runs.

    Parameters
    ----------
    *arguments:
        Of the command line.
    injected:
        A fault of :mod:`benchmarks.reliability.faulty_server` that the server has.
    cpus:
        The processors that it may use; None for those of this process.
    environment:
        Variables besides this process' own.
    port:
        0 takes a free one.
    **settings:
        Of :class:`bnserve_service.Settings`.
    """
    program = PROGRAM[:1] if injected is None else ["benchmarks.reliability.faulty_server", injected]
    with tempfile.TemporaryDirectory() as folder:
        config, log = Path(folder) / "settings.toml", Path(folder) / "server.log"
        config.write_text("".join(f"{key} = {_toml(value)}\n" for key, value in settings.items()))
        command = [sys.executable, "-m", *program, "serve", "--port", str(port), "--config", str(config)]
        command += [*PROGRAM[1:], *arguments]

        def ready() -> bool:
            found = _url(log)
            return found is not None and is_ready(found)

        environ = os.environ | ONE_THREAD | {"PYTHONUNBUFFERED": "1"} | (environment or {})
        with running(command, log, ready, env=environ, cwd=ROOT) as process:
            if cpus is not None:
                _pin(process.pid, cpus)
            url = _url(log)
            assert url is not None, "a server that is ready has said where it listens"
            yield Server(url, process, log)


def _pin(pid: int, cpus: set[int]) -> None:
    for thread in Path(f"/proc/{pid}/task").iterdir():
        os.sched_setaffinity(int(thread.name), cpus)


def _url(log: Path) -> str | None:
    found = re.search(r"^bnserve listens on (http://\S+)$", log.read_text(), re.MULTILINE)
    return found.group(1) if found else None


def _toml(value: Any) -> str:
    """A value in TOML: JSON but for tables."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_toml(each)}" for key, each in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(each) for each in value) + "]"
    return json.dumps(str(value) if isinstance(value, Path) else value)
