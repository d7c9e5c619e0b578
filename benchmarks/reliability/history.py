"""Over all faults at once, no question ever has two answers, and none is lost."""

from __future__ import annotations

import random
import tempfile
import time
from collections import Counter, defaultdict
from contextlib import ExitStack
from pathlib import Path

from benchmarks.reliability.callers import Callers, Task
from benchmarks.reliability.callers import Log as Found
from benchmarks.reliability.network import KINDS, Weather
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.proxy import FaultyProxy
from benchmarks.reliability.replicas import Replica, replicas
from benchmarks.reliability.stores import NAME, Versions

MECHANISM = (
    "Several clients ask several replicas the same 300 questions again and again, through proxies that delay, reset, "
    "truncate, damage, exchange and swallow, while replicas are killed and new versions (of other weights) are "
    "published; clients connect again now and then and follow the label. Every client keeps (digest of the question, "
    "digest of the model, digest of the answer); afterwards the logs are put side by side, and beside the local model."
)
BAR = "two answers to one question with one model: 0; wrong 0; lost 0"
INJECTED_FAULTS = {
    "no-digests": "the client believes every answer",
    "no-echo": "the client checks that an answer is whole, but not whose it is",
    "no-retries": "the client asks once",
}

_OFTEN = 0.04
_OFTEN_INJECTED = 0.4
"""So that the fault that is looked for is met in seconds."""
_REPLICAS = 3
_VERSIONS = 8
"""Published at most: replicas that start verify all of them first."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """All faults at once for a while; then compare the logs."""
    count, seconds = (4, 5.0) if short else (8, 120.0)
    options = {"silence": 1.0, "timeout": 300.0, "retries": 0 if injected == "no-retries" else 60}
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        store = Versions(Path(folder) / "store")
        store.publish("1.0.0")
        arguments = ("--store", str(store.folder), "--model", NAME)
        servers = stack.enter_context(replicas(Path(folder), _REPLICAS, *arguments))
        weather = [Weather([], _OFTEN_INJECTED if injected else _OFTEN, seed) for seed in range(_REPLICAS)]
        proxies = [
            stack.enter_context(FaultyProxy(server.address, each))
            for server, each in zip(servers, weather, strict=True)
        ]
        task = Task(NAME, store.folder, options, injected, pool=300, reconnect=100)
        with Callers([[proxy.url for proxy in proxies]] * count, task) as callers:
            for each in weather:
                each.kinds = list(KINDS)
            kills, versions = _disturb(seconds, servers, store, log)
            for each in weather:
                each.kinds = []
    met = Counter[str]()
    for proxy in proxies:
        met += proxy.counts
    del met["none"]
    return _outcome(callers.log, {"faults": met.total(), "kills": kills, "versions": versions, "clients": count})


def _disturb(seconds: float, servers: list[Replica], store: Versions, log: Log) -> tuple[int, int]:
    """Kill, start again, publish; how many kills and versions there were."""
    chance, kills, versions, until = random.Random(11), 0, 1, time.monotonic() + seconds
    while time.monotonic() < until:
        time.sleep(min(5.0, seconds / 6.0) * chance.uniform(0.5, 1.0))
        ready = [server for server in servers if server.is_ready()]
        if (kills < versions or versions == _VERSIONS) and len(ready) > 1:
            victim = chance.choice(ready)
            victim.kill()
            time.sleep(0.5)
            victim.start()
            kills += 1
            log(f"replica {servers.index(victim) + 1} was killed and started again")
        elif versions < _VERSIONS:
            versions += 1
            store.publish(f"1.0.{versions}", shipped=("fast", "default", "wide")[versions % 3])
            log(f"version 1.0.{versions} was published")
    while not any(server.is_ready() for server in servers):
        time.sleep(0.1)
    return kills, versions


def _outcome(found: Found, happened: dict[str, float | int | str]) -> Outcome:
    answers: defaultdict[tuple[str, str], set[str]] = defaultdict(set)
    for question, model, answer in found.answers:
        answers[question, model].add(answer)
    twice = sum(len(each) > 1 for each in answers.values())
    models = len({model for _, model in answers})
    figures = happened | {"keys": len(answers), "models": models, "keys with two answers": twice} | found.figures()
    summary = (
        f"{happened['faults']:,} faults, {happened['kills']} kills and {happened['versions']} versions in "
        f"{found.asked:,} requests: two answers {twice}, wrong {found.wrong}, lost {found.lost}"
    )
    return Outcome(figures, twice == found.wrong == found.lost == 0 and found.right > 0, summary)
