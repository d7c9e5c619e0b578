"""A body is capped while it streams in, whatever it declares.

Bodies far over the limit: declared, declared as something else, and in chunks without any declaration. The server says
413 at the latest when the limit and 64 KiB have arrived, and its memory is watched while a GiB is poured in after that.
Then many bodies that are allowed come at once, and none of them ends.
"""

from __future__ import annotations

import contextlib
import http.client
import json
import select
import socket
import threading
import time
from pathlib import Path

from benchmarks.reliability.asking import Answer, connected, exchange, read_answer, status_of
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.serving import Server, serving

MECHANISM = """A declared length over the limit is refused before the body is read; what is not declared is counted as
it arrives, and refused when the count passes the limit. What follows is read and thrown away, so that the answer
reaches its reader. Large bodies on their way have one room together; what does not fit is refused with 503, before it
is read if it states its size."""
BAR = (
    "413 after the limit and 64 KiB at the latest, memory <= limit + 16 MiB; bodies without end <= their room + "
    "32 MiB, a small question is answered meanwhile"
)
INJECTED_FAULTS = {"no-cap": "bodies are read to their end, as uvicorn does"}

MIB = 2**20
LIMIT = 16 * MIB
ROOM = 64 * MIB
MANY = 40
CHUNK = b"%x\r\n" % 2**16 + b"x" * 2**16 + b"\r\n"
HEAD = b"POST /v1/models/default/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/msgpack\r\n"
_QUESTION = {
    "parameters": {
        "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0, "chi_2": 0, "distance_mpc": 40,
        "inclination": 2.5, "total_mass": 2.76,
    },
    "grid": {"frequencies": [20, 50, 100]},
}  # fmt: skip
_BODY = json.dumps(_QUESTION).encode()
SMALL = HEAD.replace(b"msgpack", b"json") + b"content-length: %d\r\nconnection: close\r\n\r\n" % len(_BODY) + _BODY
CHUNKED = HEAD + b"transfer-encoding: chunked\r\n\r\n"


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes a minute."""
    poured = (64 if short or injected else 1024) * MIB
    with serving(
        "--model", "default", "--workers-threads", "1", injected=injected, max_body_bytes=LIMIT, max_incoming_bytes=ROOM
    ) as server:
        for _ in range(3):  # memory that reading a body of the allowed size takes is not bloat
            _send(server, HEAD + b"content-length: %d\r\n\r\n" % LIMIT, b"\xc1" * 2**16, LIMIT // 2**16)
        log(f"memory before: {server.rss() / 1e6:.0f} MB")
        at_limit = {
            "declared, body not sent": _send(server, HEAD + b"content-length: %d\r\n\r\n" % 2**40, b"", 0).status,
            "declared, expect: 100-continue": _send(
                server, HEAD + b"content-length: %d\r\nexpect: 100-continue\r\n\r\n" % 2**40, b"", 0
            ).status,
            "chunked, limit + 64 KiB": _send(server, CHUNKED, CHUNK, LIMIT // 2**16 + 1).status,
        }
        log(f"refused: {at_limit}")
        endless = {
            "declared": HEAD + b"content-length: %d\r\n\r\n" % 2**40,
            "lying": HEAD + b"content-length: 1000\r\n\r\n",
            "chunked": CHUNKED,
        }
        grown = {name: _growth(server, head, poured, log) for name, head in endless.items()}
        held, refused, answered = _bodies_without_end(server, log)
        alive = status_of(server.address, "/v2/health/ready") == 200
    wrong = sum(status != 413 for status in at_limit.values())
    worst = max(grown.values())
    figures: dict[str, float] = {f"status, {name}": status for name, status in at_limit.items()}
    figures |= {f"memory, MiB, {name}": round(value / MIB, 2) for name, value in grown.items()}
    figures |= {f"memory, MiB, {MANY} bodies without end": round(held / MIB, 1), "refused of them": refused}
    figures |= {"small questions answered meanwhile": answered, "room, MiB": ROOM // MIB}
    figures |= {"poured in, MiB": poured // MIB, "limit, MiB": LIMIT // MIB, "ready afterwards": int(alive)}
    summary = (
        f"{len(at_limit) - wrong} of {len(at_limit)} refused with 413 by limit + 64 KiB; memory at most "
        f"{worst / MIB:+.1f} MiB while {poured // MIB} MiB are poured in, {held / MIB:+.0f} MiB for {MANY} bodies of "
        f"{(LIMIT - MIB) // MIB} MiB without end"
    )
    bounded = worst <= LIMIT + 16 * MIB and held <= ROOM + 32 * MIB
    return Outcome(figures, not wrong and alive and bounded and answered == 1 and 0 < refused < MANY, summary)


def _send(server: Server, head: bytes, piece: bytes, count: int) -> Answer:
    """Send a head and some pieces, no more; the answer, or status 0 if none comes while the body is waited for."""
    with connected(server.address, timeout=20.0) as connection:
        try:
            connection.sendall(head)
            for _ in range(count):
                connection.sendall(piece)
            return read_answer(connection)
        except (OSError, http.client.HTTPException):
            return Answer(0, {}, b"")


def _growth(server: Server, head: bytes, size: int, log: Log) -> int:
    """How far memory rises, bytes, while ``size`` bytes are poured in after a head."""
    before = server.rss()
    Path(f"/proc/{server.pid}/clear_refs").write_text("5")  # forget the highest memory so far
    with connected(server.address, timeout=60.0) as connection:
        reading = threading.Thread(target=_swallow, args=(connection,))
        connection.sendall(head)
        reading.start()
        sent, began = 0, time.monotonic()
        with contextlib.suppress(OSError):
            while sent < size:
                connection.sendall(CHUNK)
                sent += len(CHUNK)
        with contextlib.suppress(OSError):
            connection.shutdown(socket.SHUT_RDWR)
        reading.join()
    grown = _highest(server) - before
    log(f"{sent / MIB:.0f} MiB taken in {time.monotonic() - began:.1f} s, memory {grown / MIB:+.1f} MiB at most")
    return grown


def _bodies_without_end(server: Server, log: Log) -> tuple[int, int, int]:
    """Many bodies whose last byte never comes: how far memory rises, how many are refused, and a small question."""
    before = server.rss()
    Path(f"/proc/{server.pid}/clear_refs").write_text("5")
    size = LIMIT - MIB
    with contextlib.ExitStack() as stack:
        connections = [stack.enter_context(connected(server.address, timeout=20.0)) for _ in range(MANY)]
        senders = [threading.Thread(target=_pour, args=(connection, size)) for connection in connections]
        for sender in senders:
            sender.start()
        for sender in senders:
            sender.join()
        held = _highest(server) - before
        answered = int(exchange(server.address, SMALL).status == 200)
        refused = sum(bool(select.select([connection], [], [], 0.0)[0]) for connection in connections)
    log(f"{MANY} bodies without end: memory {held / MIB:+.1f} MiB at most, {refused} refused")
    return held, refused, answered


def _pour(connection: socket.socket, size: int) -> None:
    """Send all of a body but its last byte."""
    with contextlib.suppress(OSError):
        connection.sendall(HEAD + b"content-length: %d\r\n\r\n" % size)
        for _ in range(size // 2**16):
            connection.sendall(b"\xc1" * (2**16 if _ else 2**16 - 1))


def _swallow(connection: socket.socket) -> None:
    """Take the answer from the socket, so that it does not fill up."""
    with contextlib.suppress(OSError):
        while connection.recv(2**16):
            pass


def _highest(server: Server) -> int:
    lines = Path(f"/proc/{server.pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith("VmHWM:"))
