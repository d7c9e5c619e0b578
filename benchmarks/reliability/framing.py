"""A request is what its caller sent as one, also behind a proxy: nothing is smuggled, and nobody speaks for another.

Conversations with odd framing (trailers, upgrades, methods, paths, hosts, pipelining, damage) with a server that asks
for tokens, half of them through HAProxy with the configuration that ships. Every answer is compared with what a second
reading of the bytes expects (:mod:`tests.fuzz.framing`), and every line of the server's log with who had sent what.
"""

from __future__ import annotations

from typing import Any

from benchmarks.reliability.balancer import balancing
from benchmarks.reliability.fuzzing.framing import Found, fuzz, misread, tokens
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving

MECHANISM = """What another recipient could read otherwise is refused: what frames a body in two ways, has no host or
two, or an old or new version. Trailers are never headers, an offer to upgrade is ignored and its body stays a body, and
one matcher of paths decides about access and endpoint. HAProxy passes on an allow-list of decoded paths."""
BAR = ">= 10^5 requests, half behind HAProxy: 0 answers that do not belong, 0 requests smuggled or of another caller"
INJECTED_FAULTS = {"trailers-as-headers": "trailers are headers, as uvicorn has them"}

MIB = 2**20
_LARGEST_GROWTH = 64 * MIB
"""That of :mod:`.decode`, for the same reason: caches and buffers fill."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes a quarter of an hour."""
    count = 200 if short else 51_000
    settings: dict[str, Any] = {"tokens": tokens(), "access_log": True}
    with (
        serving("--model", "default", injected=injected, **settings) as server,
        balancing([server.address]) as balancer,
    ):
        found = fuzz(server.address, count // 10)  # warm-up, and part of it
        before = server.rss()
        for name, address, behind in (("itself", server.address, False), ("HAProxy", balancer.address, True)):
            found.add(fuzz(address, count, behind, first=10**7 + 10**7 * behind))
            log(
                f"{name}: {found.requests:,} requests so far, {dict(found.kinds())}, {_growth(server, before):+.1f} MiB"
            )
        alive, grown = server.process.poll() is None, _growth(server, before)
        others = misread(server.log.read_text(errors="replace"), found)
    for line in [*others[:20], *(fault for fault, _ in found.faults[:20])]:
        log(line[:300])
    return _judge(found, others, alive, grown)


def _growth(server: Server, before: int) -> float:
    return (server.rss() - before) / MIB


def _judge(found: Found, others: list[str], alive: bool, grown: float) -> Outcome:
    figures: Figures = {
        "requests": found.requests,
        "connections": found.conversations,
        "answers that do not belong": len(found.faults),
        "requests that nobody sent, or another": len(others),
        "crashes": int(not alive),
        "MiB more": grown,
        **{f"fault: {kind}": count for kind, count in sorted(found.kinds().items())},
    }
    summary = (
        f"{found.requests:,} requests on {found.conversations:,} connections: {len(found.faults)} answers that do not "
        f"belong, {len(others)} smuggled or of another caller, {grown:+.0f} MiB"
    )
    return Outcome(figures, not found.faults and not others and alive and grown * MIB <= _LARGEST_GROWTH, summary)
