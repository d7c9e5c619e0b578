"""No code comes from data, neither in the server nor in the client.

Both run with Python's audit hooks while they do their work and while each is sent, by a hostile peer, pickles and other
programs in every place where a reader has ever run one; a damaged store offers the server a pickle as well.
"""

from __future__ import annotations

import base64
import hashlib
import re
import signal
import sys
import tempfile
import time
from pathlib import Path

import msgspec

from benchmarks.reliability.asking import exchange, metric
from benchmarks.reliability.auditing import Audit, auditing
from benchmarks.reliability.hostile import hostile_answers, hostile_bodies
from benchmarks.reliability.load import GW170817
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.proxy import Fault, FaultyProxy
from benchmarks.reliability.serving import Server, serving
from benchmarks.reliability.stores import NAME, Versions
from benchmarks.workers import Worker
from bnserve_service.bench.load import Target

MECHANISM = """Messages and manifests are decoded by schema into numbers, texts and arrays of types from a list; tensors
are a format without code. pickle, joblib, eval and their like are banned from the sources by a test."""
BAR = "0 events, server and client: no class unpickled, nothing imported, compiled, executed or started"
INJECTED_FAULTS = {
    "unpickle-bodies": "the server reads arrays of objects, as msgpack-numpy does",
    "unpickle-answers": "the client does",
}

QUESTION = {"parameters": GW170817, "grid": {"f_min": 20.0, "f_max": 40.0, "delta_f": 2.5}}


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes two minutes."""
    repeats = 1 if short else 20
    with auditing() as audit, tempfile.TemporaryDirectory() as folder:
        canary, versions = Path(folder) / "canary", Versions(Path(folder) / "store")
        versions.publish("1.0.0")
        of_server = injected if injected == "unpickle-bodies" else None
        stores = "--store", str(versions.folder)
        with serving(*stores, injected=of_server, environment=audit.environment("server"), poll_seconds=600) as server:
            counts = _attack_server(server, audit, versions, canary, repeats, log)
            client_counts = _attack_client(server, audit, canary, 4 * repeats, injected == "unpickle-answers", log)
        events = {who: audit.events(who) for who in ("server", "client")}
        ran = canary.exists()
    for who, found in events.items():
        for event in found[:5]:
            log(f"{who}: {event}")
    figures: Figures = {
        **counts,
        **client_counts,
        **{f"events, {who}": len(found) for who, found in events.items()},
        "programs that ran": int(ran),
    }
    total = sum(len(found) for found in events.values())
    summary = (
        f"{total} events in {counts['hostile requests']:,} hostile requests and "
        f"{client_counts['hostile answers']:,} hostile answers"
    )
    passed = not total and not ran and not counts["server errors"] and not client_counts["hostile answers believed"]
    return Outcome(figures, passed, summary)


def _attack_server(
    server: Server, audit: Audit, versions: Versions, canary: Path, repeats: int, log: Log
) -> dict[str, int]:
    """Send everything once, so that what is imported when first needed is there; then watch, and send it again."""
    bodies = hostile_bodies(canary, QUESTION)
    statuses: list[int] = []
    for watched in [False, *[True] * repeats]:
        audit.watch_all(watched)
        statuses += [_post(server, media_type, body) for media_type, body in bodies]
        statuses += [_post(server, "application/msgpack", msgspec.msgpack.encode(QUESTION)) for _ in range(10)]
        version = f"2.0.{len(statuses)}"
        versions.publish(version, labels=())
        tensors = versions.folder_of(version) / "tensors.safetensors"
        tensors.write_bytes(bodies[0][1].ljust(tensors.stat().st_size, b"\0"))
        before = metric(server.address, "bnserve_reloads_total")
        server.process.send_signal(signal.SIGHUP)
        while metric(server.address, "bnserve_reloads_total") == before:
            time.sleep(0.02)
        versions.remove(version)
    audit.watch_all(False)
    good = statuses.count(200)
    log(f"{len(statuses)} requests, {good} of them answered, {sum(status >= 500 for status in statuses)} server errors")
    return {
        "hostile requests": len(bodies) * (repeats + 1),
        "server errors": sum(status >= 500 or status == 0 for status in statuses),
        "hostile stores": repeats + 1,
    }


def _post(server: Server, media_type: str, body: bytes) -> int:
    headers = {"Content-Type": media_type, "Accept": "application/msgpack", "Connection": "close"}
    request = Target.parse(server.url).request(f"/v1/models/{NAME}/waveforms", body, headers)
    return exchange(server.address, request).status


def _attack_client(
    server: Server, audit: Audit, canary: Path, repeats: int, injected: bool, log: Log
) -> dict[str, int]:
    """Have a client ask through a proxy that puts hostile answers in the place of good ones, with right digests."""
    answers = hostile_answers(canary)
    chosen: list[bytes | None] = [None]

    def choose() -> Fault:
        body = chosen[0]
        return Fault() if body is None else Fault("hostile", answer=lambda message: _replaced(message, body))

    believed = asked = 0
    command = [sys.executable, "-m", "benchmarks.reliability.audited_client", *(["unpickle"] if injected else [])]
    with FaultyProxy(server.address, choose) as proxy, Worker(command, audit.environment("client")) as client:
        client.ask("connect", url=proxy.url, model=NAME)
        for watched in [False, *[True] * repeats]:
            audit.watch_all(watched)
            for body in [None, *answers]:
                chosen[0] = body
                good = client.ask("predict")["good"]
                asked += body is not None
                believed += good and body is not None
        audit.watch_all(False)
    log(f"{asked} hostile answers, {believed} believed")
    return {"hostile answers": asked, "hostile answers believed": believed}


def _replaced(message: bytes, body: bytes) -> bytes:
    """A message with another body, whose length and digest are right."""
    head = message.partition(b"\r\n\r\n")[0]
    head = re.sub(rb"(?i)\r\ncontent-(length|digest):[^\r]*", b"", head)
    digest = base64.b64encode(hashlib.sha256(body).digest())
    return head + b"\r\ncontent-length: %d\r\ncontent-digest: sha-256=:%s:\r\n\r\n" % (len(body), digest) + body
