"""Asking a server as somebody would who has never seen our client: http.client, msgpack, ten lines of numpy."""

import http.client
import json
import socket
import ssl
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import msgpack
import numpy as np

GW170817 = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0, "distance_mpc": 40.0,
    "inclination": 2.5, "total_mass": 2.76,
}  # fmt: skip
GRID = {"f_min": 20.0, "f_max": 40.0, "delta_f": 2.5}
MSGPACK = "application/msgpack"
JSON = "application/json"


@dataclass(frozen=True)
class Answer:
    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def document(self) -> Any:
        return json.loads(self.body)

    @property
    def code(self) -> str:
        """The code of a problem answer, after checking that it is one."""
        assert self.headers["content-type"] == "application/problem+json", self.body
        problem = self.document
        assert problem["status"] == self.status
        assert {"type", "title", "detail", "code", "request_id", "error"} <= set(problem)
        assert problem["error"] == problem["detail"]
        assert problem["request_id"] == self.headers["x-request-id"]
        return problem["code"]


def ask(
    address: str, method: str, path: str, body: Any = None, *, trusted: Path | None = None, **headers: str
) -> Answer:
    """One request on a connection of its own; underscores in header names become dashes."""
    with closing_connection(address, trusted) as connection:
        return ask_on(connection, method, path, body, **headers)


def ask_on(connection, method: str, path: str, body: Any = None, **headers: str) -> Answer:
    names = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request(method, path, body=body, headers=names)
    response = connection.getresponse()
    content = response.read()
    return Answer(response.status, {name.lower(): value for name, value in response.getheaders()}, content)


class closing_connection:  # noqa: N801  # used like contextlib.closing
    def __init__(self, address: str, trusted: Path | None = None) -> None:
        parts = urlsplit(address)
        if trusted is None:
            self.connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=60)
        else:  # the authority of its certificate
            context = ssl.create_default_context(cafile=trusted)
            self.connection = http.client.HTTPSConnection(parts.hostname, parts.port, timeout=60, context=context)

    def __enter__(self) -> http.client.HTTPConnection:
        return self.connection

    def __exit__(self, *_) -> None:
        self.connection.close()


def raw_connection(address: str) -> socket.socket:
    parts = urlsplit(address)
    return socket.create_connection((parts.hostname, parts.port), timeout=60)


class _Shared:
    """A buffered reader that several responses read from: none of them may close it, nor keep what is another's."""

    def __init__(self, connection: socket.socket) -> None:
        self._file = connection.makefile("rb")

    def makefile(self, mode: str) -> "_Shared":
        return self

    def __getattr__(self, name: str) -> Any:
        return getattr(self._file, name)

    def close(self) -> None:
        """Left to the connection."""


def read_responses(connection: socket.socket, count: int) -> list[Answer]:
    """The next responses on a raw connection, where they may come in one piece."""
    shared = _Shared(connection)
    answers = []
    for _ in range(count):
        response = http.client.HTTPResponse(shared)
        response.begin()
        content = response.read()
        answers.append(Answer(response.status, {k.lower(): value for k, value in response.getheaders()}, content))
    shared._file.close()
    return answers


def read_response(connection: socket.socket) -> Answer:
    """The next response on a raw connection."""
    return read_responses(connection, 1)[0]


def question(parameters=None, grid=None, **rest) -> dict:
    return {"parameters": parameters or GW170817, "grid": grid or GRID, **rest}


def evaluate(address: str, message: dict, model: str = "chirp", **headers: str) -> Answer:
    """Send a question as MessagePack."""
    headers.setdefault("content_type", MSGPACK)
    return ask(address, "POST", f"/v1/models/{model}/waveforms", msgpack.packb(message), **headers)


def evaluate_json(address: str, message: dict, model: str = "chirp", **headers: str) -> Answer:
    headers.setdefault("content_type", JSON)
    return ask(address, "POST", f"/v1/models/{model}/waveforms", json.dumps(message), **headers)


def read_msgpack(body: bytes) -> dict:
    """A reader that we did not write, and ten lines of numpy."""

    def text(key):
        return key.decode() if isinstance(key, bytes) else key

    def value(item):
        if not isinstance(item, dict):
            return item
        named = {text(key): entry for key, entry in item.items()}
        if "nd" not in named:
            return {key: value(entry) for key, entry in named.items()}
        return np.frombuffer(named["data"], dtype=named["type"]).reshape(named["shape"])

    return value(msgpack.unpackb(body))


def as_array(array: np.ndarray) -> dict:
    """As msgpack-numpy would send it."""
    return {b"nd": True, b"type": array.dtype.str, b"kind": b"", b"shape": array.shape, b"data": array.tobytes()}
