"""No body crashes the service, or bloats it."""

from __future__ import annotations

import hashlib
import http.client
import importlib.util
import multiprocessing
import os
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random

from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from benchmarks.workers import ROOT
from tests.fuzz.targets import TARGETS, Target

MECHANISM = (
    "Bodies are decoded by schema: what does not fit is refused where it stands, before anything is made of it, and "
    "lengths are compared with limits before they take memory. Tried with changes of valid messages in their "
    "structure (sent to a server, and timed here), with what schemathesis makes of the OpenAPI document, "
    "and by atheris, guided by coverage, on every reader of foreign bytes, those of the client and the store included. "
    "What once broke a reader is kept in tests/fuzz/corpus and tried by the test suite."
)
BAR = ">= 10^5 mutations: 5xx 0, crashes 0, RSS <= +64 MiB, decoding <= 5 ms; schemathesis and atheris: findings 0"
INJECTED_FAULTS = {"bare-errors": "what goes wrong while a body is decoded comes out as it is, without a name"}

_fork = multiprocessing.get_context("fork")
_MEMORY = 64 * 2**20
_SLOWEST = 5e-3
_PATHS = {
    "request": ("POST", "/v1/models/default/waveforms", "application/msgpack"),
    "request_json": ("POST", "/v1/models/default/waveforms", "application/json"),
    "likelihood": ("POST", "/v1/models/default/likelihoods/{sha256}", "application/msgpack"),
    "likelihood_json": ("POST", "/v1/models/default/likelihoods/{sha256}", "application/json"),
    "analysis": ("PUT", "/v1/analyses/{sha256}", "application/msgpack"),
    "grid": ("PUT", "/v1/grids/{sha256}", "application/octet-stream"),
}


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Mutations against a server and against a clock; schemathesis; atheris."""
    count, examples, fuzzing = (180, 2, 0) if short else (102_000, 6, 10)
    statuses, slowest = Counter[int](), 0.0
    with serving("--model", "default", injected=injected) as server:
        for name in _PATHS:  # warm-up
            _send(server.address, name, _bodies(TARGETS[name], min(count, 600) // len(_PATHS), first=10**9))
        before = _start_over(server)
        with _fork.Pool(len(_PATHS), initializer=os.setsid) as pool:  # scheduled as different callers are
            tasks = [(name, server.address, count // len(_PATHS)) for name in _PATHS]
            for name, seen, took in pool.imap_unordered(_measure, tasks):
                statuses += seen
                slowest = max(slowest, took)
                log(f"{name}: {dict(seen)}, slowest {1e3 * took:.2f} ms, +{(_peak(server) - before) / 2**20:.0f} MiB")
        grown = _peak(server) - before
        violations = _schemathesis(server, examples, statuses, log) if not short else []
        alive = server.process.poll() is None
    runs, found = _atheris(fuzzing, log) if fuzzing else (0, 0)
    bad = sum(number for status, number in statuses.items() if status != 503 and not 0 < status < 500)
    figures: Figures = {"mutations": count, "5xx and broken connections": bad, "crashes": int(not alive)}
    figures |= {"MiB more": grown / 2**20, "slowest decoding ms": 1e3 * slowest, "violations": len(violations)}
    figures |= {"inputs of atheris": runs, "findings of atheris": found}
    figures |= {f"status {status}": number for status, number in sorted(statuses.items())}
    summary = (
        f"{count:,} mutations, {runs:,} inputs by atheris: 5xx {bad}, crashes {int(not alive)}, findings "
        f"{found + len(violations)}, +{grown / 2**20:.0f} MiB, slowest decoding {1e3 * slowest:.1f} ms"
    )
    passed = bad == found == len(violations) == 0 and alive and grown <= _MEMORY and slowest <= _SLOWEST
    return Outcome(figures, passed, summary)


def _bodies(target: Target, count: int, first: int = 0) -> list[bytes]:
    seeds = target.seeds()
    return [target.mutate(seeds[number % len(seeds)], Random(first + number)) for number in range(count)]


def _measure(task: tuple[str, tuple[str, int], int]) -> tuple[str, Counter[int], float]:
    """Try one kind of body; its name, the statuses, and the seconds of the slowest decoding."""
    name, address, count = task
    bodies = _bodies(TARGETS[name], count)
    return name, _send(address, name, bodies), max(_seconds_of(TARGETS[name], body) for body in bodies)


def _send(address: tuple[str, int], kind: str, bodies: list[bytes]) -> Counter[int]:
    """Send bodies one after another; a connection that breaks counts as status 0."""
    statuses: Counter[int] = Counter()
    method, path, media_type = _PATHS[kind]
    known = hashlib.sha256(TARGETS["analysis"].seeds()[0]).hexdigest()
    connection = http.client.HTTPConnection(*address, timeout=60)
    connection.request(
        "PUT", f"/v1/analyses/{known}", TARGETS["analysis"].seeds()[0], {"content-type": "application/msgpack"}
    )
    connection.getresponse().read()
    for body in bodies:
        name = known if method == "POST" else hashlib.sha256(body).hexdigest()
        try:
            connection.request(method, path.format(sha256=name), body, {"content-type": media_type})
            answer = connection.getresponse()
            answer.read()
            statuses[answer.status] += 1
        except (OSError, http.client.HTTPException):
            statuses[0] += 1
            connection.close()
    connection.close()
    return statuses


def _seconds_of(target: Target, body: bytes) -> float:
    """Processor time of decoding; what seems slow is timed again, because machines pause."""
    took = _seconds(target, body)
    return took if took < 0.2 * _SLOWEST else min(took, *(_seconds(target, body) for _ in range(4)))


def _seconds(target: Target, body: bytes) -> float:
    started = time.thread_time()
    target(body)
    return time.thread_time() - started


def _start_over(server: Server) -> int:
    """Have the system count the peak of memory anew; what it is now."""
    Path(f"/proc/{server.pid}/clear_refs").write_text("5")
    return _peak(server)


def _peak(server: Server) -> int:
    found = re.search(r"VmHWM:\s+(\d+) kB", Path(f"/proc/{server.pid}/status").read_text())
    assert found is not None, "Linux states the peak of memory"
    return int(found[1]) * 1024


def _schemathesis(server: Server, examples: int, statuses: Counter[int], log: Log) -> list[str]:
    from benchmarks.reliability.fuzzing.openapi import exercise

    seen, violations = exercise(server.url, {"name": "default", "version": "1.0.0"}, examples)
    statuses += seen
    log(f"schemathesis: {seen.total()} requests, {dict(seen)}, {violations or 'nothing'} against the document")
    return violations


def _atheris(seconds: int, log: Log) -> tuple[int, int]:
    """Fuzz every reader for a while; how many inputs were tried, and how many readers broke."""
    if importlib.util.find_spec("atheris") is None:
        log("atheris is not there for this Python: not run")
        return 0, 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(4) as threads:

        def fuzz(name: str) -> tuple[int, bool]:
            command = [sys.executable, "-m", "benchmarks.reliability.fuzzing", name, "--seconds", str(seconds)]
            done = subprocess.run(
                [*command, "--found", folder],
                cwd=ROOT,
                capture_output=True,
                text=True,
                check=False,
                start_new_session=True,
            )
            tried = re.search(r"stat::number_of_executed_units: (\d+)", done.stdout + done.stderr)
            log(f"atheris, {name}: {tried[1] if tried else done.stderr[-800:]} inputs, exit status {done.returncode}")
            return int(tried[1]) if tried else 0, done.returncode != 0

        ended = list(threads.map(fuzz, TARGETS))
    return sum(runs for runs, _ in ended), sum(broken for _, broken in ended)
