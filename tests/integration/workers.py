"""A server of several worker processes, and what can be done to them."""

from __future__ import annotations

import http.client
import os
import re
import signal
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from prometheus_client.parser import text_string_to_metric_families

from tests.integration.conftest import ServerProcess, serving
from tests.running_server import TIMEOUT


def until(condition, what, seconds=TIMEOUT):
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, f"did not happen: {what}"
        time.sleep(0.05)
    return found


def exists(pid: int) -> bool:
    """Whether there is such a process, not counting one that has only not been buried yet."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def children(pid: int) -> dict[int, str]:
    """The processes below one, by number, with their names."""
    found = {}
    with suppress(OSError):
        for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
            with suppress(OSError):
                found[int(child)] = Path(f"/proc/{child}/comm").read_text().strip()
    return {child: name for child, name in found.items() if exists(child)}


@dataclass
class Workers:
    """A running ``bnserve serve --workers N``."""

    server: ServerProcess
    count: int
    metrics_address: str

    @property
    def address(self) -> str:
        return self.server.address

    @property
    def supervisor(self) -> int:
        return self.server.process.pid

    @property
    def shared(self) -> Path:
        """The folder that they share, or shared before somebody removed it."""
        for descriptor in Path(f"/proc/{self.supervisor}/fd").iterdir():
            with suppress(OSError):
                file = descriptor.readlink()
                if file.name.removesuffix(" (deleted)") == "alive":
                    return file.parent
        raise FileNotFoundError

    @property
    def fork_server(self) -> int | None:
        """The process that workers are copies of; None while there is none."""
        found = (pid for pid, name in children(self.supervisor).items() if name.startswith("bnserve-forksrv"))
        return next(found, None)

    def pids(self) -> dict[str, int]:
        """The worker processes by name."""
        return {name: pid for pid, name in children(self.supervisor).items() if name.startswith("bnserve-work-")}

    def wait_until_complete(self) -> dict[str, int]:
        """Wait until as many as wanted serve."""
        until(lambda: self.value("bnserve_workers_serving") == self.count == len(self.pids()), "all workers serve")
        return self.pids()

    def metrics(self) -> dict[tuple, float]:
        text = until(self._scrape, "the metrics are told")
        return {
            (sample.name, frozenset(sample.labels.items())): sample.value
            for family in text_string_to_metric_families(text)
            for sample in family.samples
        }

    def _scrape(self) -> str:
        try:
            with urllib.request.urlopen(self.metrics_address, timeout=10) as answer:
                return answer.read().decode()
        except (OSError, http.client.HTTPException):
            return ""  # whoever was asked has just been killed

    def value(self, name: str, **labels: str) -> float:
        return self.metrics().get((name, frozenset(labels.items())), 0.0)

    @contextmanager
    def all_but_one_stopped(self, name: str) -> Iterator[None]:
        """For a moment, only this worker answers."""
        others = [pid for other, pid in self.pids().items() if other != name]
        for pid in others:
            os.kill(pid, signal.SIGSTOP)
        try:
            yield
        finally:
            for pid in others:
                os.kill(pid, signal.SIGCONT)


def own_memory(pid: int) -> float:
    """KiB of a process that no file backs; what it shares with others counts in part."""
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    return sum(float(line.split()[1]) for line in lines if line.startswith(("Pss_Anon:", "Pss_Shmem:")))


@contextmanager
def serving_with(log: Path, count: int, *arguments: str, trusted: Path | None = None) -> Iterator[Workers]:
    """``bnserve serve --workers N`` on a free port, with all of its workers, and metrics on another port."""
    with serving(log, "--workers", str(count), "--metrics-port", "0", *arguments, trusted=trusted) as server:
        metrics = re.search(r"^bnserve metrics on (\S+)$", log.read_text(), re.MULTILINE)
        assert metrics is not None
        workers = Workers(server, count, metrics.group(1))
        workers.wait_until_complete()
        yield workers
