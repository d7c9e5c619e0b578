"""Debian's HAProxy and nginx with the configurations that ship, in front of real servers; and callers of these."""

import csv
import json
import os
import re
import shutil
import threading
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tests.certificates import Certificates
from tests.running_server import free_port, running
from tests.service.asking import GW170817, JSON, ask, ask_on, closing_connection, question

DEPLOY = Path(__file__).parents[2] / "deploy"
CONFIGURATION = DEPLOY / "haproxy" / "haproxy.cfg"
NGINX = DEPLOY / "nginx" / "bnserve.conf"
NOBODY = "http://127.0.0.1:9"
"""Where nothing listens."""


QUESTION = json.dumps(question(GW170817, {"f_min": 20, "f_max": 2048, "delta_f": 16}))


def program(name: str) -> str:
    """A program that Debian keeps where only root's PATH looks."""
    found = shutil.which(name, path=os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin", "/usr/local/sbin"]))
    assert found, f"{name} is not installed: apt-get install {name} (tests/run.sh does)"
    return found


def haproxy() -> str:
    return program("haproxy")


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


def nginx_configuration(folder: Path, servers: list[str], made: Certificates, port: int) -> Path:
    """The file that ships with what its EDIT lines ask for, in the least that nginx needs around it."""
    ours = NGINX.read_text()
    places = "\n".join(f"    server {server} max_fails=2 fail_timeout=2s;" for server in servers)
    for pattern, value in (
        (r"^    server unix:.*$", places),
        (r"listen 443 ssl;", f"listen 127.0.0.1:{port} ssl;"),
        (r"server_name \S+;", "server_name localhost;"),
        (r"ssl_certificate \S+;", f"ssl_certificate {made.chain};"),
        (r"ssl_certificate_key \S+;", f"ssl_certificate_key {made.key};"),
    ):
        ours, count = re.subn(pattern, value, ours, flags=re.MULTILINE)
        assert count == 1, pattern
    (folder / "bnserve.conf").write_text(ours)
    temporary = "".join(f"    {kind}_temp_path {folder}/{kind};\n"
                        for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))  # fmt: skip
    file = folder / "nginx.conf"
    user = "user root;" if os.getuid() == 0 else ""
    within = f"access_log off;\n{temporary}    include {folder}/bnserve.conf;"
    file.write_text(
        f"daemon off;\n{user}\npid {folder}/nginx.pid;\nworker_processes 2;\nerror_log stderr;\n"
        f"events {{}}\nhttp {{\n    {within}\n}}\n"
    )
    return file


@contextmanager
def nginx_before(folder: Path, servers: list[str], made: Certificates) -> Iterator[str]:
    """nginx in front of servers (``host:port`` or ``unix:/path``), as soon as it listens: its address."""
    port = free_port()
    command = [program("nginx"), "-c", str(nginx_configuration(folder, servers, made, port))]
    address = f"https://127.0.0.1:{port}"

    def listens() -> bool:
        try:
            return ask(address, "GET", "/nothing", trusted=made.trusted).status == 404
        except OSError:
            return False

    with running(command, folder / "nginx.log", listens):
        yield address


class Callers:
    """Threads that ask through the proxy without ever asking twice, and keep what they see."""

    def __init__(self, address, count=4, trusted=None):
        self.statuses, self.failures = [], []
        self._address, self._trusted, self._stopping = address, trusted, threading.Event()
        self._threads = [threading.Thread(target=self._ask) for _ in range(count)]

    def __enter__(self):
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *error):
        self._stopping.set()
        for thread in self._threads:
            thread.join()

    def wait_for(self, count):
        """Until so many more answers have come."""
        wanted, end = len(self.statuses) + count, time.monotonic() + 60.0
        while len(self.statuses) < wanted and not self.failures:
            assert time.monotonic() < end, "the callers do not come forward"
            time.sleep(0.01)

    def _ask(self):
        try:
            with closing_connection(self._address, self._trusted) as connection:
                while not self._stopping.is_set():
                    answer = ask_on(
                        connection, "POST", "/v1/models/default/waveforms", QUESTION, content_type=JSON, accept=JSON
                    )
                    self.statuses.append(answer.status)
        except Exception as error:
            self.failures.append(repr(error))
