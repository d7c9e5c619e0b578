"""Slow readers do not keep others from their answers: what is taken too slowly is cut off, what has left makes room.

Two clients ask for answers of 33 MB, take them at 150 KiB/s, and ask again as soon as they are cut off; the server has
room for both and for most of an answer of somebody else, who asks again and again, without retries.
"""

from __future__ import annotations

import contextlib
import http.client
import socket
import threading
import time
from dataclasses import dataclass, field

from benchmarks.reliability.asking import connected, exchange
from benchmarks.reliability.load import waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving

MECHANISM = """A connection has a time that waiting for its peer uses up, and that what the peer takes earns back:
write_timeout, and the size over write_rate, for an answer in all. The memory of an answer is promised before it is
computed; for a reader that takes more than a second, what is left is copied into pieces, and the promise shrinks
with every piece that has left."""
BAR = "cut off after write_timeout + size / write_rate (2 s more at most), others wait for <= 22.5 s"
INJECTED_FAULTS = {
    "timeout-restarts": "whatever is taken starts the time again",
    "room-to-the-end": "an answer takes its room until all of it has left",
}

MIB = 2**20
ROWS, POINTS = 64, 32_000
SIZE = ROWS * POINTS * 16
OTHER = (32, 32_000)
ROOM = 2 * SIZE + SIZE // 2 - 8 * MIB
"""For both slow readers, and for somebody else's answer once 8 MiB have left."""
TOLERANCE = 2.0


@dataclass(frozen=True, slots=True)
class Size:
    """How long it is measured, the settings of the server, and how slow is slow."""

    seconds: float
    write_timeout: float
    write_rate: int
    rate: int
    """Of the readers, bytes per second."""

    @property
    def allowed(self) -> float:
        """Seconds that one answer may take."""
        return self.write_timeout + SIZE / self.write_rate

    @property
    def wait(self) -> float:
        """Seconds that others may wait: a reader at that rate has let go of something, and nobody was cut off yet."""
        return 0.75 * self.write_timeout


LONG, SHORT = Size(240.0, 30.0, 2**19, 150 * 2**10), Size(30.0, 8.0, 2**22, 400 * 2**10)


@dataclass(slots=True)
class _Seen:
    """What came of the questions."""

    held: list[float] = field(default_factory=list)
    """Seconds that a slow reader had one answer."""
    whole: int = 0
    """Answers that a slow reader got in full."""
    answered: int = 0
    refused: int = 0
    wrong: int = 0
    longest_wait: float = 0.0
    """Seconds from one answer of the others to the next."""


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes four minutes."""
    size = SHORT if short else LONG
    settings = {"write_timeout": size.write_timeout, "write_rate": size.write_rate, "max_answer_bytes": ROOM}
    seen = _Seen()
    with serving("--model", "default", "--workers-threads", "1", injected=injected, **settings) as server:  # type: ignore[arg-type]  # of the settings
        stop = time.monotonic() + size.seconds
        readers = [
            threading.Thread(target=_read_slowly, args=(server, size.rate, number, stop, seen)) for number in range(2)
        ]
        for reader in readers:
            reader.start()
        time.sleep(1.0)
        _ask(server, stop, seen, log)
        for reader in readers:
            reader.join()
    figures: Figures = {
        "slow readers": len(readers),
        "answers that they began to take": len(seen.held),
        "answers that they got": seen.whole,
        "one answer was held, s, longest": max(seen.held),
        "allowed, s": size.allowed,
        "answers of others": seen.answered,
        "of these wrong": seen.wrong,
        "refusals of others": seen.refused,
        "others waited, s, longest": seen.longest_wait,
    }
    in_time = max(seen.held) <= size.allowed + TOLERANCE and seen.longest_wait <= size.wait
    summary = (
        f"{len(seen.held)} answers of {SIZE / 1e6:.0f} MB held for {max(seen.held):.1f} s at the longest, allowed are "
        f"{size.allowed:.0f} s; others waited for {seen.longest_wait:.1f} s at the longest, {seen.answered} answers, "
        f"{seen.wrong} wrong"
    )
    return Outcome(figures, in_time and seen.answered > 0 and not seen.wrong, summary)


def _read_slowly(server: Server, rate: int, number: int, stop: float, seen: _Seen) -> None:
    question = waveforms_request(server.url, ROWS, POINTS, delta=0.001 * number)
    while time.monotonic() < stop:
        with connected(server.address, timeout=5.0) as connection, contextlib.suppress(OSError):
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2**16)
            connection.sendall(question)
            received = len(connection.recv(2**12))
            began, whole = time.monotonic(), False
            with contextlib.suppress(OSError):
                while time.monotonic() < stop and (piece := connection.recv(2**14)):
                    received += len(piece)
                    time.sleep(max(0.0, began + received / rate - time.monotonic()))
                    whole = received > SIZE
            if received > 2**14:  # and not a refusal
                seen.held.append(time.monotonic() - began)
                seen.whole += whole
        time.sleep(0.1)


def _ask(server: Server, stop: float, seen: _Seen, log: Log) -> None:
    """Ask as somebody else does, one question after another."""
    question = waveforms_request(server.url, *OTHER, Connection="close")
    first: bytes | None = None
    last = time.monotonic()
    while time.monotonic() < stop:
        with contextlib.suppress(OSError, http.client.HTTPException):
            answer = exchange(server.address, question)
            if answer.status == 200:
                first = first or answer.body
                seen.wrong += answer.body != first
                seen.answered += 1
                if time.monotonic() - last > 1.0:
                    log(f"an answer after {time.monotonic() - last:.1f} s")
                seen.longest_wait = max(seen.longest_wait, time.monotonic() - last)
                last = time.monotonic()
            else:
                seen.refused += 1
        time.sleep(0.25)
    seen.longest_wait = max(seen.longest_wait, time.monotonic() - last)
