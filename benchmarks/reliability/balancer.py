"""Debian's HAProxy with the configuration that ships, in front of some servers; with its retries or without."""

from __future__ import annotations

import csv
import os
import shutil
import subprocess
import tempfile
import time
import urllib.request
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from benchmarks.servers import ServerFailed
from benchmarks.workers import ROOT
from tests.running_server import free_port, is_ready, running

CONFIGURATION = ROOT / "deploy" / "haproxy" / "haproxy.cfg"
WITHOUT_RETRIES = {"    retries 3": "    retries 0", "    retry-on ": "    # without: retry-on "}
NOBODY = "127.0.0.1:9"
"""Where nothing listens: the configuration names three servers."""


@dataclass(frozen=True, slots=True)
class Balancer:
    """A running proxy."""

    url: str
    admin: str
    process: subprocess.Popen[bytes]

    @property
    def address(self) -> tuple[str, int]:
        """Host and port."""
        return "127.0.0.1", int(self.url.rpartition(":")[2])

    def up(self) -> int:
        """How many servers it sends requests to."""
        with urllib.request.urlopen(f"{self.admin}/;csv", timeout=10) as answer:
            rows = list(csv.DictReader(answer.read().decode().removeprefix("# ").splitlines()))
        servers = [row["status"] for row in rows if row["pxname"] == "servers" and row["svname"] != "BACKEND"]
        return sum(status.startswith("UP") for status in servers)

    def wait_for(self, count: int, timeout: float = 60.0) -> None:
        """Return when it sends requests to so many servers."""
        until = time.monotonic() + timeout
        while self.up() != count:
            if time.monotonic() > until:
                raise ServerFailed(f"HAProxy has {self.up()} servers, and should have {count}.")
            time.sleep(0.05)


@contextmanager
def balancing(addresses: Sequence[tuple[str, int]], *, retries: bool = True) -> Iterator[Balancer]:
    """Start HAProxy in front of at most three servers that run, wait until it has seen them.

    Raises
    ------
    ServerFailed
        HAProxy is not installed.
    """
    program = shutil.which("haproxy", path=os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin"]))
    if program is None:
        raise ServerFailed("HAProxy is not installed: apt-get install haproxy")
    places = [f"{host}:{port}" for host, port in addresses]
    port, admin = free_port(), free_port()
    environment = os.environ | {f"BNSERVE_{n}": place for n, place in enumerate([*places, NOBODY, NOBODY][:3], start=1)}
    environment |= {"BNSERVE_BIND": f"127.0.0.1:{port}", "BNSERVE_ADMIN": f"127.0.0.1:{admin}"}
    environment |= {} if os.getuid() == 0 else {"HAPROXY_UNPRIVILEGED": "1"}
    text = CONFIGURATION.read_text(encoding="utf-8")
    for line, without in {} if retries else WITHOUT_RETRIES.items():
        assert f"\n{line}" in text, f"{CONFIGURATION} has no line '{line}'"
        text = text.replace(f"\n{line}", f"\n{without}")
    with tempfile.TemporaryDirectory() as folder:
        configuration = Path(folder) / "haproxy.cfg"
        configuration.write_text(text)
        command = [program, "-db", "-f", str(configuration)]
        url = f"http://127.0.0.1:{port}"
        log = Path(folder) / "haproxy.log"
        with running(command, log, lambda: is_ready(url), env=environment) as process:
            balancer = Balancer(url, f"http://127.0.0.1:{admin}", process)
            balancer.wait_for(len(addresses))
            yield balancer
