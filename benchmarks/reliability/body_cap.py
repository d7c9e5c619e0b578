"""A body is capped while it streams in, whatever it declares.

Bodies far over the limit: declared, declared as something else, and in chunks without any declaration. The server says
413 at the latest when the limit and 64 KiB have arrived, and its memory is watched while a GiB is poured in after that.
"""

from __future__ import annotations

import contextlib
import http.client
import socket
import threading
import time
from pathlib import Path

from benchmarks.reliability.asking import Answer, connected, read_answer, status_of
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.serving import Server, serving

MECHANISM = """A declared length over the limit is refused before the body is read; what is not declared is counted as
it arrives, and refused when the count passes the limit. What follows is read and thrown away, so that the answer
reaches its reader."""
BAR = "413 after the limit and 64 KiB at the latest, memory <= limit + 16 MiB"
PLANTS = {"no-cap": "bodies are read to their end, as uvicorn does"}

MIB = 2**20
LIMIT = 16 * MIB
CHUNK = b"%x\r\n" % 2**16 + b"x" * 2**16 + b"\r\n"
HEAD = b"POST /v1/models/default/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/msgpack\r\n"
CHUNKED = HEAD + b"transfer-encoding: chunked\r\n\r\n"


def run(short: bool, log: Log, plant: str | None = None) -> Outcome:
    """Measure; the long form takes a minute."""
    poured = (64 if short or plant else 1024) * MIB
    with serving("--model", "default", "--workers-threads", "1", plant=plant, max_body_bytes=LIMIT) as server:
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
        alive = status_of(server.address, "/v2/health/ready") == 200
    wrong = sum(status != 413 for status in at_limit.values())
    worst = max(grown.values())
    figures: dict[str, float] = {f"status, {name}": status for name, status in at_limit.items()}
    figures |= {f"memory, MiB, {name}": round(value / MIB, 2) for name, value in grown.items()}
    figures |= {"poured in, MiB": poured // MIB, "limit, MiB": LIMIT // MIB, "ready afterwards": int(alive)}
    summary = (
        f"{len(at_limit) - wrong} of {len(at_limit)} refused with 413 by limit + 64 KiB; memory at most "
        f"{worst / MIB:+.1f} MiB while {poured // MIB} MiB are poured in"
    )
    return Outcome(figures, not wrong and alive and worst <= LIMIT + 16 * MIB, summary)


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


def _swallow(connection: socket.socket) -> None:
    """Take the answer from the socket, so that it does not fill up."""
    with contextlib.suppress(OSError):
        while connection.recv(2**16):
            pass


def _highest(server: Server) -> int:
    lines = Path(f"/proc/{server.pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith("VmHWM:"))
