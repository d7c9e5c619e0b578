"""How each server is asked: over HTTP with bytes made before, or through a client in its own environment."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, TypeAlias

from benchmarks.workers import Worker
from bnserve_service.bench.load import Target, answers_per_second, round_trips

Encode: TypeAlias = Callable[[int, bytes], bytes]
"""From the number of points and the rows to a complete HTTP request."""

OCTETS = "application/octet-stream"
_ANY = Target(("127.0.0.1", 0))


def local_target(port: int) -> Target:
    """A server on this machine."""
    return Target(("127.0.0.1", port))


class Asker(Protocol):
    """A client of one server."""

    def round_trips(self, points: int, values: bytes, calls: int) -> tuple[list[float], bytes]:
        """Seconds of each of some calls, one after the other, and the bytes of the last answer."""

    def answers_per_second(self, points: int, values: list[bytes], seconds: float) -> float:
        """Answers per second when each of many clients repeats its request."""


@dataclass(frozen=True, slots=True)
class HttpAsker:
    """Raw sockets and prepared bytes: the least that a client can cost."""

    port: int
    encode: Encode

    def round_trips(self, points: int, values: bytes, calls: int) -> tuple[list[float], bytes]:
        """See :class:`Asker`."""
        return round_trips(local_target(self.port), self.encode(points, values), calls)

    def answers_per_second(self, points: int, values: list[bytes], seconds: float) -> float:
        """See :class:`Asker`."""
        requests = [self.encode(points, each) for each in values]
        return answers_per_second(local_target(self.port), requests, seconds)


@dataclass(frozen=True, slots=True)
class WorkerAsker:
    """A client process."""

    worker: Worker

    def round_trips(self, points: int, values: bytes, calls: int) -> tuple[list[float], bytes]:
        """See :class:`Asker`."""
        answer = self.worker.ask("round_trips", points=points, values=_text(values), calls=calls)
        return answer["seconds"], base64.b64decode(answer["body"])

    def answers_per_second(self, points: int, values: list[bytes], seconds: float) -> float:
        """See :class:`Asker`."""
        request = {"points": points, "values": _text(values[0]), "clients": len(values), "for": seconds}
        return float(self.worker.ask("answers_per_second", **request)["per_second"])


def _text(values: bytes) -> str:
    return base64.b64encode(values).decode()


def raw(points: int, values: bytes) -> bytes:
    """Raw numbers to a path that names the grid."""
    return _ANY.request(f"/evaluate/{points}", values, {"Content-Type": OCTETS})


def json_base64(points: int, values: bytes) -> bytes:
    """LitServe's ``/predict``."""
    body = json.dumps({"points": points, "values": _text(values)}).encode()
    return _ANY.request("/predict", body, {"Content-Type": "application/json"})


def open_inference(points: int, values: bytes) -> bytes:
    """Triton's HTTP with the binary extension of the Open Inference Protocol."""
    tensor = {
        "name": "values",
        "shape": [len(values) // 80, 10],
        "datatype": "FP64",
        "parameters": {"binary_data_size": len(values)},
    }
    head = json.dumps({"inputs": [tensor], "outputs": [{"name": "h", "parameters": {"binary_data": True}}]}).encode()
    headers = {"Inference-Header-Content-Length": str(len(head)), "Content-Type": OCTETS}
    return _ANY.request(f"/v2/models/waveforms_{points}/infer", head + values, headers)
