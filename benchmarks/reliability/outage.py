"""A sampler outlives an outage."""

from __future__ import annotations

import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from benchmarks.reliability.client_faults import injecting
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.replicas import Replica, replicas
from benchmarks.workers import ROOT
from bnserve_client import BnserveError, Model

MECHANISM = (
    "A request is tried again until its timeout (here 15 minutes), with pauses that grow to 5 s, so that an outage is "
    "a pause for a sampler and not an exception; and the same question has the same bits whichever replica answers it. "
    "examples/samplers/with_emcee.py samples the same seeded posterior twice through 3 replicas; in the second run all "
    "of them are killed in the middle, and started again later."
)
BAR = "exceptions that reach the sampler 0; chain and log-posterior identical to the last bit"
INJECTED_FAULTS = {"no-retries": "the client asks once"}

_AT = 20
"""The request before which the servers vanish."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """A seeded run without and one with an outage."""
    walkers, steps, seconds = (16, 30, 3.0) if short else (64, 150, 120.0)
    options: dict[str, Any] = {"timeout": 900.0} | ({"retries": 0} if injected else {})
    with tempfile.TemporaryDirectory() as folder, replicas(Path(folder), 3, "--model", "default") as servers:
        addresses = [server.url for server in servers]
        with Model.connect(addresses, **options) as model, _example() as (problem, with_emcee):
            posed = problem.Problem.pose(model, [])
            expected = with_emcee.sample(posed, walkers=walkers, steps=steps)
            log(f"without an outage: {posed.requests} requests")
            interrupted = _interrupted(problem.Problem, posed.likelihood, servers, seconds, log)
            exceptions, same = 0, 0
            started = time.monotonic()
            try:
                with injecting(injected):
                    found = with_emcee.sample(interrupted, walkers=walkers, steps=steps)
                same = int(_bits(found) == _bits(expected))
            except BnserveError as error:
                exceptions = 1
                log(f"the sampler ended: {error.detail}")
            took = time.monotonic() - started
            interrupted.wait()
    figures: Figures = {"outage s": seconds, "requests": interrupted.requests, "exceptions": exceptions}
    figures |= {"same bits": same, "seconds of the run": took}
    summary = f"all 3 replicas away for {seconds:.0f} s: exceptions {exceptions}, same posterior bits: "
    summary += "yes" if same else "no"
    return Outcome(figures, exceptions == 0 and same == 1 and took > seconds, summary)


def _bits(sampler: Any) -> bytes:
    return bytes(sampler.get_chain().tobytes() + sampler.get_log_prob().tobytes())


@contextmanager
def _example() -> Iterator[tuple[Any, Any]]:
    """The modules of the example, which is a script beside the others of its folder."""
    folder, before = str(ROOT / "examples" / "samplers"), set(sys.modules)
    sys.path.insert(0, folder)
    try:
        import problem
        import with_emcee

        yield problem, with_emcee
    finally:
        sys.path.remove(folder)
        for name in set(sys.modules) - before:
            if folder in str(getattr(sys.modules[name], "__file__", "")):
                del sys.modules[name]


def _interrupted(kind: type[Any], likelihood: Any, servers: list[Replica], seconds: float, log: Log) -> Any:
    """The same problem, whose servers vanish in the middle, and come back after a while."""

    def come_back() -> None:
        time.sleep(seconds)
        for server in servers:
            server.start()
        log("the replicas are started again")

    revival = threading.Thread(target=come_back)

    class Interrupted(kind):  # a dataclass of the example
        def log_likelihood(self, points: Any) -> Any:
            """As without an outage."""
            if self.requests == _AT:
                for server in servers:
                    server.kill()
                log(f"all replicas are killed, for {seconds:.0f} s")
                revival.start()
            return super().log_likelihood(points)

        def wait(self) -> None:
            """Until the servers have been started again."""
            if revival.ident is not None:
                revival.join()

    return Interrupted(likelihood)
