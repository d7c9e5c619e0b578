"""A server that is told to stop loses nothing: a rolling restart is not noticed, even by clients that never retry.

Replicas behind HAProxy, with its configuration that ships but all of its retries switched off, are restarted one after
another with SIGTERM, while requests of all sizes leave at a steady rate and none is sent twice.
"""

from __future__ import annotations

import time
from contextlib import ExitStack

from benchmarks.reliability.balancer import Balancer, balancing
from benchmarks.reliability.load import Came, Stream, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from bnserve_service import Settings
from tests.running_server import free_port

MECHANISM = """After SIGTERM the ready path says 503 at once, while everything is still answered for two seconds, each
answer closing its connection, so that a balancer goes elsewhere first; then what is in flight is finished, and the
process ends with 0."""
BAR = "0 failures, every exit with status 0 within 30 s"
INJECTED_FAULTS = {"no-drain": "SIGTERM ends the process as a program does that knows nothing of it"}

REPLICAS = 2
GRACE_OF_SHORT = 6.0
"""On a machine that is busy with other tests, HAProxy may take longer than the usual two seconds to look twice."""


class Replicas:
    """Servers on ports that stay theirs, one of which can be started again."""

    def __init__(self, injected: str | None, grace: float) -> None:
        self._injected, self._grace = injected, grace
        self._ports = [free_port() for _ in range(REPLICAS)]
        self._stacks = [ExitStack() for _ in self._ports]
        self.servers: list[Server] = [self._start(number) for number in range(REPLICAS)]

    def _start(self, number: int) -> Server:
        options = "--model", "default", "--workers-threads", "1"
        server = serving(*options, injected=self._injected, port=self._ports[number], drain_grace=self._grace)
        return self._stacks[number].enter_context(server)

    def restart(self, number: int) -> tuple[int, float]:
        """Stop one and start it again; its exit status and the seconds until it had ended."""
        began = time.monotonic()
        status = self.servers[number].stop()
        seconds = time.monotonic() - began
        self._stacks[number].close()
        self.servers[number] = self._start(number)
        return status, seconds

    def close(self) -> None:
        """Stop all."""
        for stack in self._stacks:
            stack.close()


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    restarts, seconds_of_load = (1, 5.0) if short else (16, 8.0)
    statuses: list[int] = []
    seconds: list[float] = []
    came: list[Came] = []
    with ExitStack() as stack:
        replicas = Replicas(injected, GRACE_OF_SHORT if short else Settings().drain_grace)
        stack.callback(replicas.close)
        balancer = stack.enter_context(balancing([server.address for server in replicas.servers], retries=False))
        load = stack.enter_context(load_process())
        for number in range(restarts):
            under_way = load.begin(balancer.address, _streams(balancer), seconds_of_load, timeout=40.0, seed=number)
            time.sleep(1.0)
            status, took = replicas.restart(number % REPLICAS)
            balancer.wait_for(REPLICAS)
            statuses.append(status)
            seconds.append(took)
            came += under_way.result().values()
            log(f"restart {number + 1}/{restarts}: exit {status} after {took:.1f} s, "
                f"{sum(each.errors for each in came)} of {sum(each.sent for each in came)} failed")  # fmt: skip
    sent, failed = sum(each.sent for each in came), sum(each.errors for each in came)
    reasons = sorted({reason for each in came for reason in (*each.failures, *each.seconds)} - {"200", "failed"})
    figures: Figures = {
        "restarts": restarts,
        "requests": sent,
        "failed": failed,
        "what failed": ", ".join(reasons) or "nothing",
        "exits with another status than 0": sum(status != 0 for status in statuses),
        "longest time to exit, s": max(seconds),
    }
    summary = f"{failed} of {sent:,} requests failed in {restarts} restarts, all ended within {max(seconds):.1f} s"
    return Outcome(figures, failed == 0 and not any(statuses) and max(seconds) <= 30.0, summary)


def _streams(balancer: Balancer) -> list[Stream]:
    return [
        Stream("small", waveforms_request(balancer.url, 1, 64), 40.0),
        Stream("middle", waveforms_request(balancer.url, 256, 64), 8.0),
        Stream("large", waveforms_request(balancer.url, 16, 2**14), 2.0),
    ]
