"""What else happens to a server in its days: new versions, new grids, broken bodies, clients that go away."""

from __future__ import annotations

import hashlib
import random
import time
from concurrent.futures import Future
from typing import Any

import numpy as np

from benchmarks.reliability.asking import connected, exchange
from benchmarks.reliability.load import waveforms_request
from benchmarks.reliability.serving import Server
from benchmarks.reliability.stores import NAME, Versions
from bnserve_service.bench.load import Target

RELOAD_EVERY = 20
"""Visits between two new versions."""


class Churn:
    """Visits a server about once a second.

    Parameters
    ----------
    server, versions:
        Who is visited, and the store it follows.
    draw:
        Where chance comes from.
    pace:
        Visits per second.
    """

    def __init__(self, server: Server, versions: Versions, draw: random.Random, pace: float) -> None:
        self._server = server
        self._versions = versions
        self._draw = draw
        self._pause = 1.0 / pace
        self._visits = 0
        self._began = time.monotonic()
        self.counts = {"reloads": 0, "grids": 0, "bad bodies": 0, "vanished": 0, "bad bodies let in": 0}

    @property
    def seconds(self) -> float:
        """Since the beginning."""
        return time.monotonic() - self._began

    def until(self, over: Future[Any]) -> None:
        """Visit until something else is over."""
        while not over.done():
            self._visits += 1
            self._send_bad_body()
            self._vanish()
            if self._visits % 5 == 0:
                self._upload_grid()
            if self._visits % RELOAD_EVERY == 0:
                self._reload()
            time.sleep(self._pause)

    def settle(self) -> None:
        """Wait until the server has closed what was left open, so that readings are of the same state."""
        time.sleep(2.0 * min(self._pause, 0.5))

    def _send_bad_body(self) -> None:
        head, _, body = waveforms_request(self._server.url, 1, 64, model=NAME).partition(b"\r\n\r\n")
        broken = bytearray(body)
        for _ in range(self._draw.randint(1, 8)):
            broken[self._draw.randrange(len(broken))] = self._draw.randrange(256)
        answer = exchange(self._server.address, head + b"\r\nConnection: close\r\n\r\n" + broken)
        self.counts["bad bodies"] += 1
        self.counts["bad bodies let in"] += answer.status == 200  # a flipped digit of a mass is a good question

    def _vanish(self) -> None:
        request = waveforms_request(self._server.url, 16, 4096, model=NAME)
        with connected(self._server.address) as connection:
            connection.sendall(request[: self._draw.randint(1, len(request))])
        self.counts["vanished"] += 1

    def _upload_grid(self) -> None:
        grid = np.linspace(20.0, 1000.0 + self._draw.random(), 4096)
        body = grid.astype("<f8").tobytes()
        path = f"/v1/grids/{hashlib.sha256(body).hexdigest()}"
        headers = {"Content-Type": "application/octet-stream", "Connection": "close"}
        answer = exchange(self._server.address, Target.parse(self._server.url).request(path, body, headers, "PUT"))
        self.counts["grids"] += answer.status == 201

    def _reload(self) -> None:
        """Publish the next version, and delete the one before the last."""
        self.counts["reloads"] += 1
        number = self.counts["reloads"]
        self._versions.publish(f"1.0.{number}")
        if number >= 2:
            self._versions.remove(f"1.0.{number - 2}")
