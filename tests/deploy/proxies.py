"""Debian's HAProxy with the configuration that ships, in front of real servers."""

import csv
import os
import shutil
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tests.running_server import free_port, running

CONFIGURATION = Path(__file__).parents[2] / "deploy" / "haproxy" / "haproxy.cfg"
NOBODY = "http://127.0.0.1:9"
"""Where nothing listens."""


def haproxy() -> str:
    """The program; Debian keeps it where only root's PATH looks."""
    found = shutil.which("haproxy", path=os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin", "/usr/local/sbin"]))
    assert found, "HAProxy is not installed: apt-get install haproxy (tests/run.sh does)"
    return found


@dataclass
class Proxy:
    """A running HAProxy."""

    address: str
    admin: str

    def states(self) -> list[str]:
        """What it thinks of each server: ``UP``, ``DOWN``, ..."""
        with urllib.request.urlopen(f"{self.admin}/;csv", timeout=10) as answer:
            rows = list(csv.DictReader(answer.read().decode().removeprefix("# ").splitlines()))
        return [row["status"] for row in rows if row["pxname"] == "servers" and row["svname"] != "BACKEND"]


def proxy_environment(servers: list[str], port: int, admin: int) -> dict[str, str]:
    """What the configuration reads: three servers, of which some may be nobody; only root can change the user."""
    padded = [*servers, NOBODY, NOBODY, NOBODY][:3]
    addresses = {f"BNSERVE_{number}": server.partition("://")[2] for number, server in enumerate(padded, start=1)}
    places = {"BNSERVE_BIND": f"127.0.0.1:{port}", "BNSERVE_ADMIN": f"127.0.0.1:{admin}"}
    return os.environ | addresses | places | ({} if os.getuid() == 0 else {"HAPROXY_UNPRIVILEGED": "1"})


@contextmanager
def proxy_before(
    folder: Path, servers: list[str], states: list[str], environment: dict[str, str] | None = None
) -> Iterator[Proxy]:
    """The proxy in front of up to three addresses, as soon as it has seen them in these states."""
    port, admin, more = free_port(), free_port(), environment or {}
    proxy = Proxy(f"{'https' if 'BNSERVE_PEM' in more else 'http'}://127.0.0.1:{port}", f"http://127.0.0.1:{admin}")

    def ready() -> bool:
        try:
            return proxy.states()[: len(states)] == states
        except OSError:
            return False

    command = [haproxy(), "-db", "-f", str(CONFIGURATION)]
    with running(command, folder / "haproxy.log", ready, env=proxy_environment(servers, port, admin) | more):
        yield proxy
