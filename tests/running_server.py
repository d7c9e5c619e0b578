"""Help for tests that start a server as its users do: a process of its own, asked over its port."""

import socket
import ssl
import subprocess
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.error import HTTPError, URLError

TIMEOUT = 120.0
"""Seconds until a server that is still not ready counts as broken; a cold start on a busy machine takes a few."""


def free_port() -> int:
    """A port that nobody uses now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def is_ready(address: str, trusted: Path | None = None) -> bool:
    """Whether the server at ``address`` says that it is ready; ``trusted`` is the authority of its certificate."""
    context = ssl.create_default_context(cafile=trusted) if address.startswith("https") else None
    try:
        with urllib.request.urlopen(f"{address}/v2/health/ready", timeout=5, context=context) as answer:
            return answer.status == 200
    except HTTPError as error:
        error.close()  # or Python 3.14 warns that nobody does
        return False
    except (URLError, OSError):
        return False


@contextmanager
def running(command: list[str], log: Path, ready: Callable[[], bool], **options) -> Iterator[subprocess.Popen]:
    """Start a server, wait until it is ready, and end it afterwards; its output is in ``log``."""
    with log.open("wb") as output:
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, **options)
    try:
        deadline = time.monotonic() + TIMEOUT
        while not ready():
            assert process.poll() is None, f"the server ended with {process.returncode}:\n{log.read_text()}"
            assert time.monotonic() < deadline, f"the server did not become ready:\n{log.read_text()}"
            time.sleep(0.2)
        yield process
    finally:
        if process.poll() is None:
            process.terminate()
            time.sleep(0.05)
            process.terminate()  # a second signal ends a server at once, without the grace of a drain
            try:
                process.wait(TIMEOUT)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
