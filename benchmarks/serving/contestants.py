"""The servers of the comparison, and starting them."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.environments import find_python
from benchmarks.servers import ServerFailed, bnserve_server, running
from benchmarks.serving.asking import Asker, Encode, HttpAsker, WorkerAsker, json_base64, open_inference, raw
from benchmarks.speed.clients import encoded_body, upload_grid
from benchmarks.speed.remote import batch_of
from benchmarks.workers import ROOT, Worker, WorkerFailed
from bnserve_protocol import ParameterBatch
from bnserve_protocol.wire import GridDigest
from bnserve_service.bench.load import LoadFailed
from tests.running_server import free_port

SCRIPTS = ROOT / "benchmarks" / "serving"
GRIDS = (277, 10_000)


@dataclass(frozen=True, slots=True)
class Contestant:
    """A model server: its environment, its script, and how it is asked (None: through ``NAME_client.py``)."""

    key: str
    name: str
    encode: Encode | None

    @property
    def script(self) -> Path:
        """What starts it, with a port as its argument."""
        return SCRIPTS / f"{self.key}_server.py"


CONTESTANTS = (
    Contestant("fastapi", "FastAPI + uvicorn", raw),
    Contestant("pytriton", "PyTriton", open_inference),
    Contestant("bentoml", "BentoML", raw),
    Contestant("ray", "Ray Serve", raw),
    Contestant("mlserver", "MLServer, gRPC", None),
    Contestant("litserve", "LitServe", json_base64),
)
MODEL_SERVERS = tuple(each.name for each in CONTESTANTS if each.key != "fastapi")
"""Those that somebody would choose for serving models; FastAPI is what one writes without them."""


def rows_of(rows: int, first: int = 0) -> bytes:
    """The parameters of a request."""
    return batch_of(rows, first).values.tobytes()


@contextmanager
def started(contestant: Contestant, folder: Path, cpus: set[int]) -> Iterator[Asker]:
    """Start a server in its environment and wait for its first answer.

    Raises
    ------
    ServerFailed, WorkerFailed
        It is not installed, or does not start.
    """
    python = find_python(folder, contestant.key)
    if python is None:
        raise ServerFailed(f"{contestant.name} is not installed: see benchmarks/serving/{contestant.script.name}.")
    port = free_port()
    with ExitStack() as stack:
        temporary = stack.enter_context(tempfile.TemporaryDirectory(prefix="ray", ignore_cleanup_errors=True))
        if contestant.encode is not None:
            asker: Asker = HttpAsker(port, contestant.encode)
        else:
            client: list[str | Path] = [python, SCRIPTS / f"{contestant.key}_client.py", f"127.0.0.1:{port + 1}"]
            asker = WorkerAsker(stack.enter_context(Worker(client, cpus=cpus)))
        command: list[str | Path] = [python, contestant.script, str(port)]
        environment = {"RAY_TMPDIR": temporary, "RAY_USAGE_STATS_ENABLED": "0", "BENTOML_DO_NOT_TRACK": "1"}
        stack.enter_context(
            running(command, lambda: _answers(asker), cpus=cpus, environment=environment, timeout=180.0)
        )
        yield asker


def _answers(asker: Asker) -> bool:
    try:
        for points in GRIDS:
            asker.round_trips(points, rows_of(1), 1)
    except (OSError, LoadFailed, WorkerFailed):
        time.sleep(0.5)
        return False
    return True


@contextmanager
def started_bnserve(cpus: set[int]) -> Iterator[Asker]:
    """``bnserve serve``, asked over HTTP with prepared bytes like the others, with its own messages."""
    with bnserve_server(cpus=cpus) as (url, _):
        grids: dict[int, GridDigest] = {points: upload_grid(url, points) for points in GRIDS}

        def encode(points: int, values: bytes) -> bytes:
            return encoded_body(grids[points], ParameterBatch(np.frombuffer(values).reshape(-1, 10)))

        yield HttpAsker(int(url.rpartition(":")[2]), encode)
