"""A killed worker or replica loses nothing for our client."""

from __future__ import annotations

import random
import tempfile
import time
from pathlib import Path

from benchmarks.reliability.balancer import balancing
from benchmarks.reliability.callers import Callers, Task
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.replicas import Replica, replicas

MECHANISM = (
    "Replicas share nothing and evaluations change nothing, so that every request may be sent again: by HAProxy, which "
    "sends what a dying server left unanswered to another one, and by our client, which tries again with growing, "
    "jittered pauses until its timeout. Here HAProxy runs with the configuration that ships in deploy/, in front of 3 "
    "replicas; 16 sampler processes ask through it, and every answer is compared with the local model bit by bit."
)
BAR = "lost 0, wrong 0, p99.9 <= 2 s"
INJECTED_FAULTS = {"no-retries": "neither HAProxy nor the client sends a request again"}

_SLOWEST = 2.0
_REPLICAS = 3
_PAUSE = 0.02
"""Seconds that a sampler spends on its own between two questions."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Kill one replica at random every few seconds; it is started again a second later."""
    seconds, count, every = (5.0, 6, 2.0) if short else (150.0, 16, 4.0)
    options = {"timeout": 120.0} | ({"retries": 0} if injected else {})
    with tempfile.TemporaryDirectory() as folder, replicas(Path(folder), _REPLICAS, "--model", "default") as servers:
        addresses = [server.address for server in servers]
        with balancing(addresses, retries=not injected) as balancer:
            log(f"{_REPLICAS} replicas are up behind HAProxy")
            task = Task(options=options, injected=injected, pause=_PAUSE)
            with Callers([balancer.url] * count, task) as callers:
                killed = _kill_for(seconds, every, servers, log)
    found = callers.log
    figures = {"kills": killed, "samplers": count} | found.figures()
    slow = float(figures["p99.9 ms"]) / 1e3
    passed = found.lost == found.wrong == 0 and slow <= _SLOWEST and found.right > 0 and killed > 0
    summary = f"{killed} kills, {found.asked:,} requests: lost {found.lost}, wrong {found.wrong}, p99.9 {slow:.2f} s"
    return Outcome(figures, passed, summary)


def _kill_for(seconds: float, every: float, servers: list[Replica], log: Log) -> int:
    """Kill and start again, never the last one that is ready; how many were killed."""
    chance, killed, until = random.Random(9), 0, time.monotonic() + seconds
    while time.monotonic() < until:
        time.sleep(every * chance.uniform(0.5, 1.0))
        ready = [server for server in servers if server.is_ready()]
        if len(ready) < 2:
            continue
        victim = chance.choice(ready)
        victim.kill()
        killed += 1
        log(f"killed replica {servers.index(victim) + 1}; {len(ready) - 1} others are ready")
        time.sleep(min(1.0, 0.5 * every))
        victim.start()
    return killed
