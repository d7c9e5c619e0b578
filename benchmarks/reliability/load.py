"""Load from a process of its own: what is asked, at which rate, and what came of it."""

from __future__ import annotations

import base64
import sys
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field, replace

import msgspec
import numpy as np
from numpy.typing import NDArray

from benchmarks.workers import Worker
from bnserve_service.bench.load import Target

GW170817 = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0, "distance_mpc": 40.0,
    "inclination": 2.5, "total_mass": 2.76,
}  # fmt: skip
MSGPACK = "application/msgpack"
REFUSALS = ("429", "503")


@dataclass(frozen=True, slots=True)
class Stream:
    """Requests of one kind and how many of them leave in a second."""

    name: str
    request: bytes
    rate: float
    with_digests: bool = False
    """Whether the SHA-256 of every good answer is kept."""


@dataclass(frozen=True, slots=True)
class Came:
    """What came of a stream."""

    name: str
    sent: int
    seconds: Mapping[str, NDArray[np.float64]]
    """By status (``failed`` and ``timeout`` beside the numbers): from when each was due to its last byte."""
    due: Mapping[str, NDArray[np.float64]]
    """By status: when each was due, from the beginning."""
    failures: Mapping[str, int] = field(default_factory=dict)
    digests: Mapping[str, int] = field(default_factory=dict)
    unexplained: int = 0
    """Refusals without ``Retry-After``."""

    def count(self, *statuses: str) -> int:
        """How many came to one of these ends."""
        return sum(len(self.seconds.get(status, ())) for status in statuses)

    @property
    def errors(self) -> int:
        """How many did not get a good answer."""
        return self.sent - self.count("200")

    def quantile(self, fraction: float, *statuses: str) -> float:
        """Seconds, over all of these ends; NaN when there are none."""
        found = np.concatenate([[], *(self.seconds.get(status, ()) for status in statuses or ("200",))])
        return float(np.quantile(found, fraction)) if len(found) else float("nan")

    def since(self, moment: float) -> Came:
        """Without what was due before this moment (in seconds from the beginning)."""
        kept = {status: np.asarray(due) >= moment for status, due in self.due.items()}
        return replace(
            self,
            sent=int(sum(np.count_nonzero(each) for each in kept.values())),
            seconds={status: np.asarray(values)[kept[status]] for status, values in self.seconds.items()},
            due={status: np.asarray(values)[kept[status]] for status, values in self.due.items()},
        )

    def within(self, deadline: float) -> int:
        """Good answers that came in time."""
        return int(np.count_nonzero(np.asarray(self.seconds.get("200", ())) <= deadline))


class Load:
    """The other process; made by :func:`load_process`."""

    def __init__(self, worker: Worker, background: ThreadPoolExecutor) -> None:
        self._worker = worker
        self._background = background

    def send(
        self, address: tuple[str, int], streams: Sequence[Stream], seconds: float, timeout: float = 30.0, seed: int = 1
    ) -> dict[str, Came]:
        """Send for some seconds, wait for all answers (each at most ``timeout``)."""
        asked = [
            {
                "name": each.name, "request": base64.b64encode(each.request).decode(), "rate": each.rate,
                "with_digests": each.with_digests,
            }
            for each in streams
        ]  # fmt: skip
        told = self._worker.ask("load", address=address, streams=asked, seconds=seconds, timeout=timeout, seed=seed)
        return {
            each["name"]: Came(
                each["name"],
                each["sent"],
                {status: np.array(values) for status, values in each["seconds"].items()},
                {status: np.array(values) for status, values in each["due"].items()},
                each["failures"],
                each["digests"],
                each["unexplained"],
            )
            for each in told["streams"]
        }

    def begin(
        self, address: tuple[str, int], streams: Sequence[Stream], seconds: float, timeout: float = 30.0, seed: int = 1
    ) -> Future[dict[str, Came]]:
        """:meth:`send`, while the caller does something else; one at a time."""
        return self._background.submit(self.send, address, streams, seconds, timeout, seed)


@contextmanager
def load_process(cpus: set[int] | None = None) -> Iterator[Load]:
    """A process that sends load, on these processors."""
    command = [sys.executable, "-m", "benchmarks.reliability.open_loop"]
    with Worker(command, cpus=cpus) as worker, ThreadPoolExecutor(1) as background:
        yield Load(worker, background)


def waveforms_request(
    url: str,
    rows: int = 1,
    points: int = 16,
    *,
    model: str = "default",
    token: str | None = None,
    delta: float = 0.0,
    **headers: str,
) -> bytes:
    """The bytes of a request for waveforms, all different: as many rows, on a grid of as many frequencies from 20 Hz.

    ``delta`` moves all masses, for another question of the same size; underscores in header names become dashes.
    """
    masses = np.linspace(2.6 + delta, 2.9, rows) if rows > 1 else np.array([2.76 + delta])
    parameters = {name: [value] for name, value in GW170817.items()} | {"total_mass": masses.tolist()}
    width = 1000.0 / max(points - 1, 1)
    grid = {"f_min": 20.0, "f_max": 20.0 + width * (points - 0.5), "delta_f": width}
    body = msgspec.msgpack.encode(
        {
            "parameters": {k: v if len(v) > 1 else v[0] for k, v in parameters.items()},
            "grid": grid,
            "output": "factored",
            "modes": [[2, 2]],
        }
    )
    given = {name.replace("_", "-"): value for name, value in headers.items()}
    target = Target.parse(url, token)
    return target.request(f"/v1/models/{model}/waveforms", body, {"Content-Type": MSGPACK, "Accept": MSGPACK} | given)


def get_request(url: str, path: str) -> bytes:
    """The bytes of a GET."""
    return Target.parse(url).request(path, b"", {}, "GET")
