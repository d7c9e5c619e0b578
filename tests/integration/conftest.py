"""The real server with the model that ships, started as its users start it."""

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

from bnserve_surrogate import Model
from tests.running_server import is_ready, running

COMMAND = [sys.executable, "-m", "bnserve_service"]


@dataclass
class ServerProcess:
    """A running ``bnserve serve``."""

    address: str
    process: subprocess.Popen
    log: Path


@contextmanager
def serving(log: Path, *arguments: str, trusted: Path | None = None) -> Iterator[ServerProcess]:
    """``bnserve serve`` on a free port, which it prints; ``trusted`` is the authority of its certificate."""

    def address() -> str | None:
        found = re.search(r"^bnserve listens on (https?://\S+)$", log.read_text(), re.MULTILINE)
        return found.group(1) if found else None

    def ready() -> bool:
        known = address()
        return known is not None and is_ready(known, trusted)

    command = [*COMMAND, "serve", "--port", "0", *arguments]
    with running(command, log, ready, env=os.environ | {"PYTHONUNBUFFERED": "1"}) as process:
        known = address()
        assert known is not None
        yield ServerProcess(known, process, log)


def bnserve(*arguments: str) -> subprocess.CompletedProcess:
    """Run another subcommand to its end."""
    return subprocess.run([*COMMAND, *arguments], capture_output=True, text=True, check=False, timeout=300)


@pytest.fixture(scope="session")
def local() -> Model:
    """The shipped model in this process."""
    return Model.default()


@pytest.fixture(scope="session")
def bnserve_server(tmp_path_factory) -> Iterator[ServerProcess]:
    """A server of the shipped models, shared by the tests that leave it as it is."""
    with serving(tmp_path_factory.mktemp("server") / "server.log") as server:
        yield server
