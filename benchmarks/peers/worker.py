"""The other side of :mod:`benchmarks.workers`: a peer in a process and an environment of its own, timed on request.

It must run with the oldest numpy and Python of any peer, so it uses the standard library and numpy alone, and is found
beside the peer's script. One JSON object per line on stdin asks, one per line on stdout answers:

    {"do": "about"}                                                 -> {"peer": ..., "versions": {...}}
    {"do": "time", "points": 277, "rows": 1, "calls": 5, "seed": 3} -> {"seconds": [..., ..., ..., ..., ...]}

The grid is uniform from the peer's ``f_min`` to 2048 Hz. Every call has other parameters; one call that does not count
goes before, so that what depends on the grid alone, and every compilation for a new shape, is not in the times.
"""

from __future__ import annotations

import json
import random
import sys
import time
from abc import ABC, abstractmethod
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

F_MAX = 2048.0
TOTAL_MASS = 2.8
"""Solar masses: that of the predecessor's training, so that every peer has the whole band."""
SEEDS = 20
"""Parameter draws, as in the paper."""


def draw(seed: int) -> dict[str, float]:
    """Parameters of one binary, uniform where all peers are defined; the same in every environment."""
    uniform = random.Random(seed).uniform
    return {
        "mass_ratio": uniform(1.0, 2.0),
        "lambda_1": uniform(5.0, 5000.0),
        "lambda_2": uniform(5.0, 5000.0),
        "chi_1": uniform(-0.5, 0.5),
        "chi_2": uniform(-0.5, 0.5),
        "distance_mpc": uniform(20.0, 200.0),
        "inclination": uniform(0.0, 3.14),
        "total_mass": TOTAL_MASS,
        "reference_phase": uniform(-3.0, 3.0),
        "time_shift": uniform(-0.1, 0.1),
    }


class Peer(ABC):
    """What a peer's script provides: derive, and hand an instance to :func:`serve`."""

    name = ""
    """As in the tables."""
    packages: tuple[str, ...] = ()
    """Distributions whose versions belong beside the figures."""
    f_min = 5.0
    """Hz."""

    def grid(self, points: int) -> Any:
        """What :meth:`waveform` takes as its frequencies: ``points`` of them, uniform."""
        return np.linspace(self.f_min, F_MAX, points)

    def binary(self, parameters: dict[str, float]) -> Any:
        """One binary in the form that :meth:`waveform` takes, made before the clock starts."""
        return parameters

    @abstractmethod
    def waveform(self, grid: Any, binary: Any) -> Any:
        """Compute h+ and hx of one binary."""

    def binaries(self, rows: list[dict[str, float]]) -> Any:
        """Several binaries in the form that :meth:`batch` takes, made before the clock starts."""
        return [self.binary(parameters) for parameters in rows]

    def batch(self, grid: Any, binaries: Any) -> Any:
        """Compute h+ and hx of several binaries, in the fastest way that the peer offers."""
        return [self.waveform(grid, binary) for binary in binaries]


def serve(peer: Peer, more: dict[str, Callable[[dict[str, Any]], dict[str, Any]]] | None = None) -> None:
    """Answer until stdin ends. Whatever the peer prints goes to stderr.

    Parameters
    ----------
    peer:
        The waveforms.
    more:
        Further commands.
    """
    answers, sys.stdout = sys.stdout, sys.stderr
    commands = {
        "about": lambda request: _about(peer),
        "time": lambda request: {"seconds": _seconds(peer, **request)},
        **(more or {}),
    }
    for line in sys.stdin:
        request = json.loads(line)
        try:
            answer = commands[request.pop("do")](request)
        except Exception as error:  # the driver says which peer failed, and goes on with the others
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), file=answers, flush=True)


def _about(peer: Peer) -> dict[str, Any]:
    versions = {"python": "{}.{}.{}".format(*sys.version_info[:3])}
    for package in ("numpy", *peer.packages):
        try:
            versions[package] = version(package)
        except PackageNotFoundError:
            versions[package] = "not installed"
    return {"peer": peer.name, "f_min": peer.f_min, "versions": versions}


def _seconds(peer: Peer, points: int, rows: int = 1, calls: int = 1, seed: int = 0) -> list[float]:
    grid = peer.grid(points)
    if rows == 1:
        arguments: list[Any] = [peer.binary(draw((seed + call) % SEEDS)) for call in range(calls + 1)]
        function: Callable[[Any, Any], Any] = peer.waveform
    else:
        arguments = [peer.binaries([draw(seed + call + row) for row in range(rows)]) for call in range(calls + 1)]
        function = peer.batch
    function(grid, arguments[0])
    seconds = []
    for each in arguments[1:]:
        started = time.perf_counter()
        function(grid, each)
        seconds.append(time.perf_counter() - started)
    return seconds
